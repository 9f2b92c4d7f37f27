"""A home that can be written to, and a name, for the user of a container who has neither.

Python imports this when it starts (``container_home.pth``) in the environments that ``make`` and the
Dockerfile fill: Snakemake asks for both before it reads a Snakefile.
"""

import os
import pwd

if not os.access(os.path.expanduser("~"), os.W_OK):
    os.environ["HOME"] = "/tmp"
try:
    pwd.getpwuid(os.getuid())
except KeyError:
    os.environ.setdefault("USER", "nobody")
