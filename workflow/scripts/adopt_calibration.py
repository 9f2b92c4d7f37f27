"""Copy calibrated inputs to where the default run reads them."""

import shutil
from pathlib import Path

from thirdbody.data.files import whole
from thirdbody.job_log import logged

PLACE = Path("config/calibrated")


def adopt(calibrated, adopted):
    """Copy every file of ``calibrated`` to config/calibrated and list their names."""
    PLACE.mkdir(parents=True, exist_ok=True)
    for source in map(Path, calibrated):
        with whole(PLACE / source.name) as part:
            shutil.copyfile(source, part)
    with whole(adopted) as part:
        part.write_text("".join(f"{PLACE / Path(each).name}\n" for each in calibrated))


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        adopt(snakemake.input.calibrated, snakemake.output.adopted)
