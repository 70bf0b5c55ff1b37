#!/usr/bin/env python3
"""The page of the report, from one JSON file.

    report.py REPORT.json -o DIR

`glint report` writes that file and runs this script. DIR gets index.html, which needs nothing else, report.json,
figures/*.csv, and overview-light.svg and overview-dark.svg for the README when the results hold errors per n.
Exit status: 0, or 2 with one line that says what is missing.
"""

import argparse
import json
import math
import os
import shutil
import statistics
import subprocess
import sys
from pathlib import Path

import stills
from stills import Failure

DEBIAN = "/usr/bin/python3"  # has the packages of the system, where another Python comes first on the PATH


def modules():
    """Jinja2, and the text of plotly.js. Tries the system's own Python before it gives up."""
    try:
        import jinja2
        import plotly.offline
    except ImportError as error:
        if os.path.exists(DEBIAN) and not os.environ.get("GLINT_PAGE_PYTHON"):
            sys.stdout.flush()
            os.execve(DEBIAN, [DEBIAN, *sys.argv], {**os.environ, "GLINT_PAGE_PYTHON": DEBIAN})
        raise Failure(f"Python has no module `{error.name}`: install the package `python3-{error.name}`") from None
    return jinja2, plotly.offline.get_plotlyjs()


def minified(script):
    """Debian's plotly.js is 8.6 MB; what comes from elsewhere is minified already."""
    if len(script) < 5e6:
        return script
    esbuild = shutil.which("esbuild")
    if not esbuild:
        raise Failure("esbuild is not on the PATH, which makes plotly.js small: install the package `esbuild`")
    done = subprocess.run([esbuild, "--minify", "--charset=utf8"], input=script, capture_output=True, text=True)
    if done.returncode != 0:
        raise Failure(f"esbuild failed: {(done.stderr.strip().splitlines() or ['no message'])[0]}")
    return done.stdout


# ---- the numbers that several parts of the page need ---------------------------------------------------------------

def measured_runs(results):
    """For every lobe and profile the run that measured the most inputs, with the number of its command."""
    best = {}
    for number, file in enumerate(results, 1):
        for run in file["runs"]:
            name = f"{run['lobe']} {run['profile']}"
            old = best.get(name)
            if run.get("accuracy") and (not old or run["accuracy"]["total"]["inputs"] > old["total"]["inputs"]):
                best[name] = {"name": name, "lobe": run["lobe"], "F": run["F"], "exhaustive": run["exhaustive"], "total": run["accuracy"]["total"],
                              "rows": run["accuracy"]["rows"], "command": number, "text": file["command"]}
    return list(best.values())


def merged(rows):
    """The errors of several rows as one: the worst of each kind with its place, and the RMS over all."""
    out = {"inputs": sum(row["inputs"] for row in rows)}
    for kind, largest, rms in (("rounding", "max_ulp", "rms_ulp"), ("approximation", "max", "rms"),
                               ("approximation_exact_cosine", "max", None), ("epicentre", "max", None)):
        known = [row for row in rows if kind in row]
        if known:
            out[kind] = dict(max((row[kind] for row in known), key=lambda error: error[largest]))
            if rms:
                out[kind][rms] = math.sqrt(sum(row[kind][rms] ** 2 * row["inputs"] for row in known) / out["inputs"])
    return out


def accuracy(runs, first_n):
    """Rows of the table of errors: each run as a whole, and from first_n on where it has smaller ones too. f_bps was
    published for n from there on; the smaller ones, where it errs most, would hide its error."""
    out = []
    for run in runs:
        out.append({**run, "n": [row["n"] for row in run["rows"]], "errors": run["total"]})
        rows = [row for row in run["rows"] if row["n"] >= first_n]
        if 0 < len(rows) < len(run["rows"]):
            out.append({**run, "exhaustive": False, "n": [row["n"] for row in rows], "errors": merged(rows)})
    return out


def thinned(rows):
    """As many rows as a logarithmic axis of n can show: of those with one place, the worst of each error."""
    places = {}
    for row in rows:
        places.setdefault(math.floor(80 * math.log10(row["n"])), []).append(row)
    keys = (("rounded", "approximation", "max"), ("exact", "approximation_exact_cosine", "max"), ("rounding", "rounding", "max_ulp"))
    return {"n": [group[0]["n"] for group in places.values()],
            **{name: [float(f"{max(row[kind][value] for row in group):.5g}") for group in places.values()]
               for name, kind, value in keys}}


UNIT_KEYS = ("lobe", "profile", "architecture", "device", "dsp", "error", "luts", "registers", "dsps", "brams", "clock_mhz",
             "latency_clocks", "latency_ns", "ns_per_result", "dominated", "emit")


def unit_row(unit):
    """A unit's values in the order of UNIT_KEYS: names once, and no more digits than a plot can show."""
    return [float(f"{value:.5g}") if isinstance(value, float) else value for value in map(unit.get, UNIT_KEYS)]


def page_data(report, runs):
    """What page.js reads."""
    cost = report["cost"] or {"configurations": [], "cpu": []}
    schlick = report["study"]["schlick"]["largest"]
    return {
        "units": {"keys": UNIT_KEYS, "rows": [unit_row(unit) for unit in cost["configurations"]]},
        "software": [{"ns": point["ns_per_result"], "error": point["error"], "text": f"{point['lobe']} {point['profile']} on a CPU, "
                      f"{point['form']}: {short(point['ns_per_result'])} ns a result"} for point in cost["cpu"] if point["error"]],
        "runs": [{"name": run["name"], "lobe": run["lobe"], **thinned(run["rows"])} for run in runs if run["rows"]],
        "schlick": {"n": list(range(2, len(schlick) + 1)), "error": [float(f"{x:.5g}") for x in schlick[1:]]},  # exact at n = 1
    }


class Prices:
    """Prices on a processor: a file of bench/run.py."""

    def __init__(self, json_file, subject):
        self.command, self.machine, self.points = json_file["command"], json_file["machine"], json_file["points"]
        self.by_name = {}
        for point in self.points:
            optional = {"latency_ns": None, "instructions": None, "profile": None, **point}
            self.by_name[point[subject], point["type"], point["form"]] = optional

    def find(self, name, kind, form, profile=None):
        point = self.by_name.get((name, kind, form))
        return point if point and profile in (None, point["profile"]) else None

    def subjects(self):
        return list(dict.fromkeys((name, kind) for name, kind, _ in self.by_name))

    def no_slower(self, name, other, tolerance):
        """One evaluation at a time in double, in latency and in throughput."""
        ratios = [ratio(self.find(name, "double", "scalar"), self.find(other, "double", "scalar"), key)
                  for key in ("latency_ns", "throughput_ns")]
        return all(x is not None and x <= 1 + tolerance for x in ratios)


def ratio(own, other, key):
    """One price over another; None where either is not known."""
    return own[key] / other[key] if own and other and own[key] and other[key] else None


def forms_of_cook_torrance(effects):
    """The full form's prices with those of the modified one at the same profile on the same device."""
    points = [{**point, "clock_mhz": statistics.median(point["clock_mhz_seeds"]) if point["clock_mhz_seeds"] else None}
              for point in effects["points"]] if effects else []
    return [(full, modified) for full in points for modified in points
            if full["effect"] == "cook_torrance" and modified["effect"] == "cook_torrance_modified" and
            all(full[key] == modified[key] for key in ("profile", "device", "dsp"))]


# ---- formats -------------------------------------------------------------------------------------------------------

def short(x):
    """Three significant digits, '–' for what is not known."""
    if x is None:
        return "–"
    if x == 0:
        return "0"
    rounded = float(f"{x:.3g}")  # which may take it to the next decade
    return f"{rounded:.{max(0, 2 - math.floor(math.log10(abs(rounded))))}f}"


def fixed(x, digits, unit=""):
    """A number of so many digits after the point, '–' for what is not known."""
    return "–" if x is None else f"{x:.{digits}f}{unit}"


def exponents(numbers):
    """'8 to 1023', and how many where there are gaps."""
    if not numbers:
        return "–"
    first, last = numbers[0], numbers[-1]
    gaps = len(numbers) < last - first + 1
    return f"{first}" if first == last else f"{first} to {last}" + (f" ({len(numbers)} values)" if gaps else "")


def listed(items):
    """'a, b and c'; 'none' for nothing."""
    items = list(items)
    return " and ".join(filter(None, [", ".join(items[:-1]), items[-1]])) if items else "none"


FILTERS = {
    "short": short,
    "fixed": fixed,
    "exponents": exponents,
    "listed": listed,
    "grouped": lambda number: f"{number:,}",
    "degrees": lambda radians, digits=0: f"{math.degrees(radians):.{digits}f}°",
    "percent": lambda x, digits=0: f"{100 * x:.{digits}f}\N{NO-BREAK SPACE}%",
    "difference": lambda x, digits=1: f"{100 * x:+.{digits}f}\N{NO-BREAK SPACE}%",
    "ceiling": lambda x, digits: math.ceil(x * 10 ** digits) / 10 ** digits,
    "general": lambda x: f"{x:g}",
}


# ---- figures -------------------------------------------------------------------------------------------------------

MAP_SCALE, DELTA_SCALE = 0.03, 0.015  # where the colours of the maps end


def scripts(study):
    """The still plots of the page."""
    first, last = study["paper_1"]["first_n"], study["paper_1"]["last_n"]
    degrees = math.log10(study["least_degrees"]), math.log10(90)
    top_n = math.log10(study["map"]["last_n"])
    out = {"curves": stills.curves_plot(study["curves"]),
           "map": stills.map_plot("map", study["map"], (0, degrees[0]), (top_n, degrees[1]), study["map"]["error"], MAP_SCALE)}
    for number, name, scale in ((4, "highlight", 1.0), (6, "delta", DELTA_SCALE), (8, "absolute", MAP_SCALE)):
        surface = study["surfaces"][name]
        zone = name == "delta"
        low, high = math.log10(surface["n"][0]), math.log10(surface["n"][-1])
        out[f"figure-{number}"] = stills.map_plot(name, surface, (low, 0 if zone else degrees[0]),
                                                  (high, 1 if zone else degrees[1]), surface["value"], scale, zone)
    for number, measure in ((5, "delta"), (7, "absolute")):
        for panel, script in stills.errors_plots(study["lobes"], measure, first, last).items():
            out[f"figure-{number}-{panel}"] = script
    paper_2 = study["paper_2"]
    for i, figure in enumerate(paper_2["distributions"]):
        out[f"paper-2-figure-1-{i}"] = stills.distribution_plot(figure)
    out["paper-2-figure-2"] = stills.reflectance_plot(paper_2["reflectances"])
    out["paper-2-phong"] = stills.phong_plot(paper_2["highlight"])
    return out


def overview(study, runs):
    """The README's picture: the highlight beside the errors of the lobe that the page begins with."""
    runs = [run for run in runs if run["rows"]]
    if not runs:
        return {}
    shown = [(run["name"], run["rows"]) for run in runs if run["lobe"] == runs[0]["lobe"]][:4]
    script = stills.beside([(f"The highlight at n = {study['curves']['n']}", stills.curves_plot(study["curves"])),
                            ("Approximation error at the rounded cosine",
                             stills.approximation_plot(shown, study["schlick"]["largest"]))])
    return stills.for_files(stills.run_gnuplot({"overview": script}, 1040, 420))


def csv(heading, columns, formats):
    return "\n".join([",".join(heading), *(",".join(form % x for form, x in zip(formats, row)) for row in zip(*columns))]) + "\n"


def csv_files(study):
    """The papers' figures as data. A column's name ends with its unit."""
    curves, paper_2 = study["curves"], study["paper_2"]
    files = {"figure-3": csv(["theta_rad", "f_bps", "f_s", "f_b"],
                             [map(math.radians, curves["degrees"]), curves["bps"], curves["schlick"], curves["blinn_phong"]],
                             ["%.6f", "%.8f", "%.8f", "%.8f"])}
    for number, name, heading, scale in ((4, "highlight", "f_bps", 1), (6, "delta", "delta_bps_percent", 100),
                                         (8, "absolute", "Delta_bps", 1)):
        surface = study["surfaces"][name]
        files[f"figure-{number}"] = csv(["n", "theta_rad", heading],
                                        [surface["n"] * surface["rows"], surface["theta"], [scale * x for x in surface["value"]]],
                                        ["%.6g"] * 3)
    first, last = study["paper_1"]["first_n"], study["paper_1"]["last_n"]
    for number, measure, heading, scale in ((5, "delta", "delta_{}_percent", 100), (7, "absolute", "Delta_{}", 1)):
        columns = [[scale * x for x in lobe[measure]["by_n"][first - 1:last]] for lobe in study["lobes"]]
        files[f"figure-{number}"] = csv(["n", *(heading.format(lobe["name"]) for lobe in study["lobes"])],
                                        [range(first, last + 1), *columns], ["%d", *["%.6g"] * len(columns)])
    kinds = (("m2D_m{:g}", "distribution"), ("cubic_angle_m{:g}", "angle_cubic"), ("cubic_half_m{:g}", "half_cubic"))
    files["paper-2-figure-1"] = csv(["theta_rad", *(name.format(d["m"]) for d in paper_2["distributions"] for name, _ in kinds)],
                                    [paper_2["distributions"][0]["x"], *(d[key] for d in paper_2["distributions"] for _, key in kinds)],
                                    ["%.6f"] * (1 + 3 * len(paper_2["distributions"])))
    files["paper-2-figure-2"] = csv(["vh", *(f"F_index{r['index']:g}" for r in paper_2["reflectances"])],
                                    [paper_2["reflectances"][0]["x"], *(r["reflectance"] for r in paper_2["reflectances"])],
                                    ["%.6f"] * (1 + len(paper_2["reflectances"])))
    h = paper_2["highlight"]
    files["paper-2-phong"] = csv(["theta_rad", f"phong_n{h['n']:g}", f"blinn_phong_n{h['n']:g}", f"blinn_phong_n{4 * h['n']:g}"],
                                 [h["x"], h["phong"], h["blinn_phong"], h["blinn_phong_4n"]], ["%.6f"] * 4)
    return {f"figures/{name}.csv": text for name, text in files.items()}


# ---- the page ------------------------------------------------------------------------------------------------------

def page(report, jinja2, plotly):
    import markupsafe

    def code(text):
        """Markdown's `code`, which is all of it that occurs."""
        parts = str(markupsafe.escape(text)).split("`")
        return markupsafe.Markup("".join(part if i % 2 == 0 else f"<code>{part}</code>" for i, part in enumerate(parts)))

    def command(text):
        """A command line, which breaks between its words only."""
        return markupsafe.Markup("<code>") + markupsafe.Markup(" ").join(
            markupsafe.Markup("<span>{}</span>").format(word) for word in text.split(" ")) + markupsafe.Markup("</code>")

    runs = measured_runs(report["results"])
    figures = {name: markupsafe.Markup(stills.inline(name, svg)) for name, svg in stills.run_gnuplot(scripts(report["study"])).items()}
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(stills.FOLDER / "templates"), autoescape=True,
                                     undefined=jinja2.StrictUndefined, trim_blocks=True, lstrip_blocks=True)
    environment.filters.update(FILTERS, code=code, command=command)
    environment.globals.update(cos=math.cos, exp=math.exp, radians=math.radians, zip=zip)
    data = json.dumps(page_data(report, runs), separators=(",", ":")).replace("<", "\\u003c")
    return environment.get_template("page.html").render(
        report=report, study=report["study"], cost=report["cost"], runs=runs, accuracy=accuracy(runs, report["study"]["paper_1"]["first_n"]),
        all_runs=[run for file in report["results"] for run in file["runs"]],
        cpu=Prices(report["cpu"], "lobe") if report["cpu"] else None,
        cpu_models=Prices(report["cpu_models"], "model") if report["cpu_models"] else None,
        pairs=forms_of_cook_torrance(report["cost"] and report["cost"]["effects"]), ratio=ratio,
        figures=figures, map_scale=MAP_SCALE, delta_scale=DELTA_SCALE,
        style=markupsafe.Markup((stills.FOLDER / "style.css").read_text()), data=markupsafe.Markup(data),
        script=markupsafe.Markup((stills.FOLDER / "page.js").read_text()), plotly=markupsafe.Markup(plotly))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("report", help="JSON of `glint report`")
    parser.add_argument("-o", "--output", required=True, help="folder for index.html, report.json, the figures and pictures")
    arguments = parser.parse_args()
    stills.end_tidily()
    try:
        jinja2, plotly = modules()
        text = Path(arguments.report).read_text()
        report = json.loads(text)
        files = {**csv_files(report["study"]), **overview(report["study"], measured_runs(report["results"])),
                 "report.json": text, "index.html": page(report, jinja2, minified(plotly))}
        stills.write(arguments.output, files)
    except Failure as failure:
        print(failure, file=sys.stderr)
        sys.exit(2)


if __name__ == "__main__":
    main()
