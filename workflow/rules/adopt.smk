# What a calibration gives to the default run: the default by the rule of docs/calibration.md, and the inputs.

SUMMARISED = expand(
    "<results>/calibration/{interpretation}.yaml", interpretation=CALIBRATION["interpretations"]
)


rule choose_default:
    input:
        calibrated=SUMMARISED,
        claims=f"{CONFIG}/claims.yaml",
    output:
        chosen="<results>/calibration/chosen.json",
    log:
        "<logs>/choose_default.log",
    conda:
        "../envs/thirdbody.yaml"
    params:
        settings=CALIBRATION,
        parameters=settings["uncalibrated"],
        sources=sources_of("choose_default.py"),
    message:
        "Choosing the default, and what the headline numbers that it misses would cost"
    script:
        "../scripts/choose_default.py"


rule calibrate:
    input:
        calibrated=SUMMARISED,
        chosen="<results>/calibration/chosen.json",
    output:
        adopted="<results>/calibration/adopted.txt",
    log:
        "<logs>/calibrate.log",
    localrule: True
    conda:
        "../envs/thirdbody.yaml"
    params:
        sources=sources_of("adopt_calibration.py"),
    message:
        "Copying the calibrated inputs to config/calibrated"
    script:
        "../scripts/adopt_calibration.py"
