"""Reading the YAML files of ``config/`` and judging them before anything is computed.

``plain_yaml`` reads, ``schema`` judges by the schema beside each file and by the named ``rules``,
``inputs`` gives the inputs of the model and ``settings`` what the workflow takes.  This room may
import ``thirdbody.model`` alone, and what needs numpy only where parameters are made: the workflow is
read without.  Begin with ``schema``, and with ``config/config.schema.yaml`` to see what a schema says.
"""

from thirdbody.extras import require

require("data", "yaml", "jsonschema")
