# The index page, the checksums of all products, and the last line of a run.


# measured by `snakemake -c2 accuracy`, and kept in the repository alone
PRECISION = [name for name in ["docs/work_precision.png"] if (HOME / name).is_file()]


rule write_index:
    input:
        figures=expand("<results>/figures/{figure}.json", figure=FIGURES),
        pictures=expand("<results>/figures/{figure}.png", figure=FIGURES),
        tables=expand("<results>/tables/{table}.html", table=TABLES),
        verdicts="<results>/claims/claims.json",
        explorer="<results>/explorer/index.html",
        datasets=expand("<results>/datasets/{figure}.nc", figure=SCENES),
        precision=[project_file(name) for name in PRECISION],
        page_template=project_file("workflow/templates/index.html"),
        captions_template=project_file("workflow/templates/captions.md"),
    output:
        page="<results>/index.html",
        captions="<results>/captions.md",
    log:
        "<logs>/write_index.log",
    params:
        *sources_of("write_index.py"),
        titles={figure: settings["scenes"][figure]["title"] for figure in SCENES},
    message:
        "Write the index page"
    script:
        "../scripts/write_index.py"


# each product must be as its job made it
rule write_sums:
    input:
        [product for product in rules.all.input if not product.endswith("SHA256SUMS")],
    output:
        sums="<results>/SHA256SUMS",
    log:
        "<logs>/write_sums.log",
    params:
        *sources_of("write_sums.py"),
    message:
        "Write the sums of all products"
    script:
        "../scripts/write_sums.py"


onsuccess:
    judged = Path(RESULTS, "claims/claims.json")
    if Path(RESULTS, "index.html").is_file() and judged.is_file():
        print(json.loads(judged.read_text(encoding="utf-8"))["score"].replace("**", ""))
        print(f"Open {RESULTS}/index.html in a browser")


onerror:
    print("Finished products are kept: the same command continues from there")
