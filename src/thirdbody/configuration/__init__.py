"""Reading the YAML files of ``config/`` and checking them before anything is computed.

``plain_yaml`` reads, ``schema`` checks by the schema beside each file and by ``rules``, ``inputs`` gives
the inputs of the model and ``settings`` what the workflow takes.  Begin with ``schema`` and with
``config/config.schema.yaml``.  The workflow is read without numpy, which is imported where it is used.
"""
