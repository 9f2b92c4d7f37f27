# Every dataset, table and figure of Chen & Horng (2024): snakemake -c2
include: "workflow/Snakefile"


# an included file cannot set the default target
rule paper:
    default_target: True
    input:
        rules.all.input,


# no rule has these outputs: for them Snakemake itself would not list what there is
rule unknown_target:
    input:
        name_targets,
    output:
        "{target}",
    wildcard_constraints:
        target=rf"[a-z][\w-]*|{RESULTS}/figures/(?!({'|'.join(DRAWN)})[._]).+",
