# Every dataset, table and figure of Chen & Horng (2024): snakemake -c2
include: "workflow/Snakefile"


# an included file cannot set the default target
rule paper:
    default_target: True
    input:
        rules.all.input,
