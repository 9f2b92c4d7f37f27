"""Reading the YAML files of ``config/`` and judging them before anything is computed.

``plain_yaml`` reads, ``schema`` judges by the schema beside each file, ``inputs`` gives the inputs of
the model and ``settings`` what the workflow takes.  This room may import ``thirdbody.model.parameters``
alone; begin with ``schema``.
"""

from thirdbody.extras import require

require("data", "yaml", "jsonschema")
