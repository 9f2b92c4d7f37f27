"""Run at the start of a page: its examples write into a folder that goes away, and ``%%sh`` prints
at once.

The ``%%sh`` of IPython prints in pieces, which the site would show in separate blocks.
"""

import os
import shutil
import subprocess
import tempfile

from IPython.core.magic import register_cell_magic

folder = tempfile.TemporaryDirectory()
shutil.copy("examples/measured.csv", folder.name)
os.chdir(folder.name)


@register_cell_magic
def sh(line, cell):
    """Run the lines of a cell in a shell, which must not fail, and print what they print."""
    done = subprocess.run(cell, shell=True, check=True, stdout=subprocess.PIPE, text=True)
    print(done.stdout, end="")
