"""The command ``thirdbody``: each question of an engineer as a sub-command.

``questions`` has the sub-commands with their options, ``main`` runs them and prints the answer.  It
imports the rest of the library when a question is asked: ``thirdbody --help`` is quick.
"""
