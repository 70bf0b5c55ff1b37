"""The manifest of units: rtl/units.json, or one that `glint emit` wrote (docs/rtl.md, "The manifest")."""

import json
from pathlib import Path

RTL = Path(__file__).resolve().parents[2] / "rtl"


def read(folder=RTL, rtl=RTL):
    """A folder's manifest; what `files` and `modules` list are paths, those by hand in `rtl`; models for simulation first."""
    manifest = json.loads((Path(folder) / "units.json").read_text())
    if manifest["format"] != 1 or not manifest["units"]:
        raise ValueError(f"{folder}/units.json: format {manifest['format']}, {len(manifest['units'])} units")

    def paths(files):
        return [Path(folder) / file.replace("$(GLINT_RTL)", str(Path(rtl).resolve())) for file in files]

    for unit in manifest["units"]:
        unit["files"] = paths(unit.get("simulation", []) + unit["files"])
    manifest["modules"] = {name: paths(files) for name, files in manifest["modules"].items()}
    return manifest


def units(folder=RTL, rtl=RTL):
    """The units of a folder's manifest, by name."""
    return {unit["name"]: unit for unit in read(folder, rtl)["units"]}


def modules(folder=RTL):
    """The files of each module by hand and of all that it contains, in an order in which they compile."""
    return read(folder)["modules"]


def dividers():
    """The names of the dividers, in the order of the parameter DIVIDER."""
    return read()["dividers"]


def sources(folder=RTL):
    """Every file by hand."""
    return sorted({file for files in modules(folder).values() for file in files})
