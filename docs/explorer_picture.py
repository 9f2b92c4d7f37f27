"""Takes the picture of the explorer that the README begins with: docs/explorer.png.

    python docs/explorer_picture.py

needs the page, `snakemake -c2 results/explorer/index.html`, and Chromium.
"""

import shutil
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

ROOT = Path(__file__).resolve().parents[1]
PAGE = ROOT / "results" / "explorer" / "index.html"
PICTURE = ROOT / "docs" / "explorer.png"
SHOWN = "figure=fig11&viscosity_cSt=100"  # what the page shows, as its links say it
SIZE = "1440,900"
MILLISECONDS = 8000  # of the page's own time, until statements are judged


def main():
    browser = shutil.which("chromium")
    if browser is None:
        sys.exit("Chromium is not installed; on Debian: apt-get install chromium")
    if not PAGE.is_file():
        sys.exit(
            f"{PAGE.relative_to(ROOT)} is absent; make it: snakemake -c2 {PAGE.relative_to(ROOT)}"
        )
    with TemporaryDirectory() as profile:
        command = [browser, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars"]
        command += [
            "--no-first-run",
            "--disable-background-networking",
            f"--user-data-dir={profile}",
        ]
        command += [f"--window-size={SIZE}", f"--virtual-time-budget={MILLISECONDS}"]
        command += [f"--screenshot={PICTURE}", f"{PAGE.as_uri()}#{SHOWN}"]
        subprocess.run(command, check=True, capture_output=True)
    print(f"{PICTURE.relative_to(ROOT)}: {PICTURE.stat().st_size} bytes")


if __name__ == "__main__":
    main()
