"""The sums of all products."""

from thirdbody.data.files import atomic_write
from thirdbody.data.sums import sums_text
from thirdbody.job_log import logged


def write(products, folder, sums):
    """Write the ``sums`` of ``products``, named from their ``folder``."""
    text = sums_text(products, folder)
    with atomic_write(sums) as part:
        part.write_text(text, encoding="utf-8")
    print(f"{len(products)} products")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        write(snakemake.input, snakemake.params.folder, snakemake.output.sums)
