# Extraction: windows of the turning point, and what the paper prints.


rule find_windows:
    input:
        modules=import_closure("workflow/scripts/find_windows.py"),
    output:
        windows="<results>/extracted/tpca_windows/all.csv",
    log:
        "<logs>/find_windows.log",
    benchmark:
        "<logs>/find_windows.tsv"
    priority: 1
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    params:
        windows=settings["windows"],
        load_axis=settings["load_axis"],
        parameters=settings["parameters"],
    message:
        "Searching the x_a/sigma windows of the turning point"
    script:
        "../scripts/find_windows.py"


rule gather_printed:
    input:
        claims=f"{CONFIG}/claims.yaml",
        schemas=[place_of("config/claims.schema.yaml"), place_of("config/conditions.schema.yaml")],
        modules=import_closure("workflow/scripts/gather_printed.py"),
    output:
        table="<results>/extracted/printed/all.csv",
    log:
        "<logs>/gather_printed.log",
    benchmark:
        "<logs>/gather_printed.tsv"
    priority: 1
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    message:
        "Gathering the numbers that the paper prints"
    script:
        "../scripts/gather_printed.py"


rule recompute_paper_table:
    input:
        printed=f"{CONFIG}/paper_tables.yaml",
        modules=import_closure("workflow/scripts/recompute_paper_table.py"),
    output:
        rows="<results>/extracted/{table}/all.csv",
    log:
        "<logs>/recompute_paper_table/{table}.log",
    benchmark:
        "<logs>/recompute_paper_table/{table}.tsv"
    wildcard_constraints:
        table="table[12]",
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    params:
        parameters=settings["parameters"],
    message:
        "Recomputing {wildcards.table} of the paper"
    script:
        "../scripts/recompute_paper_table.py"
