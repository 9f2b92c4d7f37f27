"""The command ``thirdbody``: each question of an engineer as a sub-command.

This room knows how options are named and checked (``options``), what each sub-command asks of
``thirdbody.answers`` (``questions``), and how an answer is printed (``main``).  It may import every
room that the library has.  Begin with ``main``.
"""
