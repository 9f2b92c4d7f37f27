"""The settings of the workflow, all checked before anything is computed."""
