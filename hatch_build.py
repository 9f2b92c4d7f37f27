"""Writes the version into a wheel or sdist, which have no repository to ask."""

import json
import runpy
import tempfile
from pathlib import Path

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

STORED = "thirdbody/version.json"


class StoredVersion(BuildHookInterface):
    """Replaces ``version.json``; an editable installation keeps it and asks git."""

    def initialize(self, version, build_data):
        self.folder = tempfile.TemporaryDirectory()
        if version == "editable":
            return
        known = runpy.run_path(str(Path(self.root, "src/thirdbody/version.py")))["current"]()
        content = dict(zip(("version", "date", "commit"), known, strict=True))
        written = Path(self.folder.name, "version.json")
        written.write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")
        place = STORED if self.target_name == "wheel" else f"src/{STORED}"
        build_data["force_include"][str(written)] = place

    def finalize(self, version, build_data, artifact_path):
        self.folder.cleanup()
