"""The settings of the workflow, checked as a whole before anything is computed."""
