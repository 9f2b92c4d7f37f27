"""The command ``thirdbody``: each engineering question is a sub-command.

``questions`` defines the sub-commands and their options; ``main`` runs them and prints the answer.  The
rest of the library is imported only to answer a question, so that ``thirdbody --help`` is quick.
"""
