#!/usr/bin/env python3
"""Still plots, drawn by gnuplot: the papers' figures on the page, and the pictures of the README.

    stills.py PRICES.json -o DIR     what `glint cost --plots DIR` runs: error against price on one device

A plot is drawn once, as SVG. Its colours are names, which the page's style sheet resolves; for a picture in a file
they are replaced by the colours of the light or of the dark theme in style.css.
"""

import argparse
import json
import math
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
COLOURS = ("text", "axis", "grid", "target", "schlick", "bps", "outside", "1", "2", "3", "4")
WIDTH, HEIGHT = 520, 400
MAX_N = 1023


class Failure(Exception):
    """What stopped the page, in one line."""


def themes():
    """The custom properties of style.css by theme."""
    css = re.sub(r"/\*.*?\*/", "", (FOLDER / "style.css").read_text(), flags=re.DOTALL)
    light, dark = (dict(re.findall(r"--([\w-]+): (#\w+)", block)) for block in re.findall(r":root \{(.*?)\}", css, re.DOTALL))
    return {"light": light, "dark": {**light, **dark}}


def colour(name):
    """A colour that no plot has otherwise: it stands for the name."""
    return f"'#fe00{COLOURS.index(name):02x}'"


def resolved(svg, theme=None):
    """The SVG with the style sheet's names, or with the colours of a theme (a dictionary) for them."""
    def value(match):
        name = f"plot-{COLOURS[int(match[1])]}"
        return theme[name] if theme else f"var(--{name})"
    return re.sub(r"rgb\(\s*254,\s*0,\s*(\d+)\)", value, svg)


def inline(name, svg):
    """The SVG as a part of a page: no heading, identifiers of its own, and a size that the page decides."""
    svg = svg[svg.index("<svg"):]
    svg = re.sub(r'(<svg[^>]*?)\s+width="\d+" height="\d+"', r"\1", svg, count=1)
    svg = re.sub(r"<(title|desc)>.*?</\1>\s*", "", svg, flags=re.DOTALL)
    svg = re.sub(r"""(\bid=['"]|href=['"]#|url\(#)""", rf"\g<1>{name}-", svg)
    return resolved(svg)


def run_gnuplot(scripts, width=WIDTH, height=HEIGHT):
    """Draws scripts, by name; returns the SVGs by name. Raises Failure."""
    gnuplot = shutil.which("gnuplot")
    if not gnuplot:
        raise Failure("gnuplot is not on the PATH: install the package `gnuplot-nox` (Debian, Ubuntu) or `gnuplot`")
    with tempfile.TemporaryDirectory() as folder:
        text = ""
        for name, script in scripts.items():
            text += f"""reset
set encoding utf8
set terminal svg enhanced rounded font 'sans-serif,15' size {width},{height}
set output '{name}.svg'
set border 3 linecolor rgb {colour('axis')}
set tics nomirror out scale 0.6 textcolor rgb {colour('text')}
set grid linecolor rgb {colour('grid')} linewidth 1 linetype 1
set key tmargin horizontal left Left reverse samplen 2 textcolor rgb {colour('text')}
set title textcolor rgb {colour('text')}
set xlabel textcolor rgb {colour('text')}
set ylabel textcolor rgb {colour('text')}
{script}
unset output
"""
        (Path(folder) / "plots.gp").write_text(text)
        # -d: a user's own settings would change the pictures.
        done = subprocess.run([gnuplot, "-d", "plots.gp"], cwd=folder, capture_output=True, text=True)
        said = done.stderr.strip().splitlines()[-1:]
        if done.returncode != 0:
            raise Failure(": ".join([f"gnuplot failed with exit status {done.returncode}", *said]))
        out = {}
        for name in scripts:
            path = Path(folder) / f"{name}.svg"
            if not path.exists() or not path.stat().st_size:
                raise Failure(": ".join([f"gnuplot ended without writing '{name}.svg'", *said]))
            out[name] = path.read_text()
        return out


# ---- axes --------------------------------------------------------------------------------------------------------

def block(name, rows):
    return f"${name} << EOD\n" + "\n".join(" ".join(f"{x:.6g}" for x in row) for row in rows) + "\nEOD\n"


def round_down(x):
    """1, 2 or 5 times a power of ten: the nearest one at most x."""
    decade = 10.0 ** math.floor(math.log10(x))
    return next(step * decade for step in (5, 2, 1) if x >= step * decade)


def log_axis(axis, low, high):
    """A logarithmic axis with tics at 1, 2, 5, 10, ...; of a long one, at the powers of ten."""
    steps = (1,) if high / low > 150 else (1, 2, 5)
    tics = [step * 10.0 ** k for k in range(math.floor(math.log10(low)) - 1, math.ceil(math.log10(high)) + 1) for step in steps]
    tics = ", ".join(f"'{tic:g}' {tic:g}" for tic in tics if low * 0.9999 <= tic <= high * 1.0001)
    return f"set logscale {axis} 10\nset m{axis}tics 1\nset {axis}range [{low:g}:{high:g}]\nset {axis}tics ({tics})\n"


def n_axis(low=1):
    tics = ", ".join(str(n) for n in (1, 3, 10, 30, 100, 300, 1000) if n >= low)
    return (f"set logscale x 10\nset xrange [{low}:{MAX_N}]\nset xtics ({tics})\nset mxtics 1\n"
            "set xlabel 'specular exponent n'\n")


def key_name(name):
    return name.replace("_", "\\_")  # '_' would start a subscript


def lines(data, column, name, title, width=2, dash="solid"):
    return (f"${data} using 1:{column} with lines linewidth {width} dashtype {dash} linecolor rgb {colour(name)} "
            f"title '{title}'")


def plot(curves):
    return "plot " + ", ".join(curves) + "\n"


# ---- the highlight and the errors --------------------------------------------------------------------------------

def curves_plot(curves):
    columns = [curves[name][::10] for name in ("degrees", "blinn_phong", "schlick", "bps")]
    return (block("curves", zip(*columns)) +
            "set xrange [0:45]\nset yrange [0:1]\nset xtics 10\nset format x '%g°'\nset ytics 0.2\n"
            "set xlabel 'angle of normal and half vector'\nset ylabel 'highlight' offset 1\n" +
            plot([lines("curves", 3, "schlick", "f_s, Schlick", dash="(12,5)"),
                  lines("curves", 2, "target", "c^n, Blinn-Phong", 5), lines("curves", 4, "bps", "f_{bps}")]))


def approximation_plot(runs, schlick):
    """Of measured runs (name, rows): the largest error at each n, at the rounded cosine."""
    values = {name: [(row["n"], row["approximation"]["max"]) for row in rows] for name, rows in runs}
    positive = [y for points in values.values() for _, y in points if y > 0]  # a logarithmic axis has no place for 0
    low = round_down(min([0.1, *positive]))
    high = 1.2 * max([0.2, *schlick, *positive])
    out = block("schlick", enumerate(schlick, 1))
    drawn = [lines("schlick", 2, "schlick", "f_s", dash="(12,5)")]
    for i, (name, points) in enumerate(values.items()):
        out += block(f"run{i}", points)
        # Curves of one lobe lie almost on each other: wide, narrow, and broken on top, all of them can be seen.
        width = 2 if len(values) == 1 else 4.5 - 3 * i / (len(values) - 1)
        dash = "(5,7)" if i and i == len(values) - 1 else "solid"
        drawn.append(lines(f"run{i}", 2, str(i % 4 + 1), key_name(name), f"{width:.2g}", dash))
    return (out + n_axis() + log_axis("y", low, high) +
            "set ylabel 'largest absolute error against c^n' offset 1\n" + plot(drawn))


def map_plot(name, grid, low, high, value, top, zone=False):
    """A map over log n and log degrees, or with `zone` the part of the epicentre zone. Its colour is as opaque as the
    value is large, and `top` is full: so the page's own colour is 0 in both themes."""
    columns, rows = grid["columns"], grid["rows"]
    properties = themes()["light"]
    negative, positive = ([int(properties[f"map-{sign}"][i:i + 2], 16) for i in (1, 3, 5)] for sign in ("negative", "positive"))
    points = []
    for i, x in enumerate(value):
        row, column = divmod(i, columns)
        alpha = 8 * round(min(abs(x) / top, 1) * 31.875)  # 32 steps: the eye sees no more, and the picture is half as big
        points.append((low[0] + (high[0] - low[0]) * column / (columns - 1), low[1] + (high[1] - low[1]) * row / (rows - 1),
                       *(positive if x > 0 else negative), min(alpha, 255)))
    tics = ", ".join(f"'{n}' {math.log10(n):g}" for n in (1, 3, 10, 30, 100, 300, 1000) if math.log10(n) >= low[0])
    out = block(name, points) + "unset grid\nunset key\nset tics front\n"
    out += f"set xrange [{low[0]:g}:{high[0]:g}]\nset yrange [{low[1]:g}:{high[1]:g}]\nset xtics ({tics})\n"
    out += "set xlabel 'specular exponent n'\n"
    drawn = [f"${name} using 1:2:3:4:5:6 with rgbalpha"]
    if zone:
        out += "set ytics 0.2\nset ylabel 'angle as a part of the epicentre zone' offset 1\n"
    else:
        degrees = ", ".join(f"'{d:g}°' {math.log10(d):g}" for d in (0.3, 1, 3, 10, 30, 90))
        out += f"set ytics ({degrees})\nset ylabel 'angle of normal and half vector' offset 1\n"
        drawn.append(f"[{max(low[0], 0.001):g}:{high[0]:g}] log10(atan(1 / sqrt(10**x - 1)) * 180 / pi) with lines "
                     f"linewidth 1.5 dashtype (12,5) linecolor rgb {colour('outside')}")
    return out + plot(drawn)


# ---- paper 1 -----------------------------------------------------------------------------------------------------

def errors_plots(lobes, measure, first, last):
    """Figures 5 and 7 in two panels over n: the paper's five, and ours beside f_bps. c^n itself has no place there."""
    unit, label = (100, "largest δ in the epicentre, percent") if measure == "delta" else (1, "largest Δ")
    lobes = [lobe for lobe in lobes if not lobe["exact"]]
    # A lobe that is exact at one n falls to 0 there, and out of the plot.
    low = round_down(min(lobe[measure]["median"] for lobe in lobes) * unit / 3)
    high = 1.3 * max(lobe[measure]["largest"] for lobe in lobes) * unit
    panels = {}
    for panel, title in (("paper", "the five of the paper"), ("own", "lobes beyond the paper, beside bps")):
        shown = [lobe for lobe in lobes if lobe["name"] == "bps" or lobe["of_paper"] == (panel == "paper")]
        out, drawn, others = "", [], 0
        for lobe in shown:
            values, place = [], None
            for n in range(first, last + 1):
                # As many as the axis can show.
                if math.floor(100 * math.log10(n)) != place or n == last:
                    place = math.floor(100 * math.log10(n))
                    values.append((n, unit * lobe[measure]["by_n"][n - 1]))
            out += block(lobe["name"], values)
            if lobe["name"] == "bps":
                drawn.append(lines("bps", 2, "bps", "bps", 3))
                continue
            names = ("schlick", "1", "target", "4", "3")
            drawn.append(lines(lobe["name"], 2, names[others % 5], key_name(lobe["name"]), 2,
                               "solid" if others < 5 else "(8,4)"))
            others += 1
        panels[panel] = (out + n_axis(first) + "set key vertical maxrows 3 font ',13' samplen 1\nset tmargin 5.2\nset title offset 0,-0.6\n" +
                         log_axis("y", low, high) + f"set ylabel '{label}' offset 1\nset title '{title}'\n" + plot(drawn))
    return panels


# ---- paper 2 -----------------------------------------------------------------------------------------------------

def distribution_plot(figure):
    columns = [[math.degrees(x) for x in figure["x"]], figure["distribution"], figure["angle_cubic"], figure["half_cubic"]]
    top = max([1, *(max(column) for column in columns[1:])])
    return (block("d", [row for row in zip(*columns)][::5]) +
            f"set xrange [0:90]\nset yrange [0:{1.02 * top:g}]\nset xtics 30\nset format x '%g°'\nset ytics 0.2\n"
            f"set title 'm = {figure['m']:g}'\nset xlabel 'angle of N and H'\nset ylabel 'm^2 D' offset 1\n" +
            plot([lines("d", 2, "target", "Beckmann", 5), lines("d", 3, "schlick", "cubic in the angle", dash="(12,5)"),
                  lines("d", 4, "bps", "cubic in N.H")]))


def reflectance_plot(figures):
    out, drawn = "", []
    for i, figure in enumerate(figures):
        out += block(f"r{i}", list(zip(figure["x"], figure["reflectance"]))[::5])
        name = str(i % 4 + 1)
        drawn.append(lines(f"r{i}", 2, name, f"{figure['index']:g}"))
        drawn.append(f"[0.4:1] {figure['mean']:g} with lines linewidth 1.5 dashtype (5,5) linecolor rgb {colour(name)} notitle")
    return (out + "set xrange [0:1]\nset yrange [0:1]\nset xtics 0.2\nset ytics 0.2\nset xlabel 'V.H'\n"
            "set ylabel 'reflectance F' offset 1\n" + plot(drawn))


def phong_plot(figure):
    columns = [[math.degrees(x) for x in figure["x"]], figure["phong"], figure["blinn_phong"], figure["blinn_phong_4n"]]
    n = figure["n"]
    return (block("h", [row for row in zip(*columns)][::5]) +
            "set xrange [0:45]\nset yrange [0:1]\nset xtics 15\nset format x '%g°'\nset ytics 0.2\nset key vertical maxcols 1\n"
            "set xlabel 'angle of viewer and mirrored light'\nset ylabel 'highlight' offset 1\n" +
            plot([lines("h", 2, "target", f"Phong, n = {n:g}", 5),
                  lines("h", 3, "schlick", f"Blinn-Phong, n = {n:g}", dash="(12,5)"),
                  lines("h", 4, "bps", f"Blinn-Phong, n = {4 * n:g}")]))


# ---- cost --------------------------------------------------------------------------------------------------------

AXES = {"ns": ("ns_per_result", "ns a result"), "latency": ("latency_ns", "latency in ns"), "luts": ("luts", "LUTs")}
PROFILES = ("p8", "p12", "p16")


def front(points):
    """Of points (x, error, name), those that no other beats in both; of equal ones, one."""
    out = []
    for x, y, name in sorted(points):
        if not out or y < out[-1][1]:
            out.append((x, y, name))
    return out


def cost_plot(prices, axis):
    """Error over a price of every configuration of one device; a line joins the best."""
    key, label = AXES[axis]
    # What cannot stand on a logarithmic axis, or has no price, is left out.
    points = [(c[key], c["error"], f"{c['lobe']} {c['profile']}", c["profile"]) for c in prices["configurations"]
              if c[key] and c["error"]]
    if not points:
        raise Failure(f"no price of the device has a value for {label}: nothing to plot")
    cpu = [(p["ns_per_result"], p["error"]) for p in prices["cpu"] if p["error"]] if axis == "ns" else []
    x_low = round_down(0.9 * min(p[0] for p in points + cpu))
    x_high = 1.6 * max(p[0] for p in points + cpu)  # room for a name
    y_low, y_high = round_down(0.8 * min(p[1] for p in points)), 1.5 * max(p[1] for p in points)
    best = front([p[:3] for p in points])
    out = log_axis("x", x_low, x_high) + log_axis("y", y_low, y_high)
    out += f"set xlabel '{label}'\nset ylabel 'largest absolute error against c^n' offset 1\n"
    name_height = (y_low / y_high) ** 0.055  # as the ratio of two errors
    named = math.inf
    # Below and to the left of a point of the front there is no other. The first one's name has no room there.
    for i, (x, y, name) in enumerate(best):
        if y > name_height * named:
            continue  # it would lie on the name before
        named = y
        place = "left offset 0.4,0.5" if i == 0 else "right offset -0.6,-0.5"
        out += f"set label '{key_name(name)}' at {x:g},{y:g} {place} font ',12' textcolor rgb {colour('text')} front\n"
    out += block("front", [*((x, y) for x, y, _ in best), (x_high, best[-1][1])])
    drawn = [f"$front using 1:2 with steps linewidth 2 linecolor rgb {colour('axis')} title 'best for its cost'"]
    for k, profile in enumerate((*PROFILES, "custom")):
        own = [p[:2] for p in points if (p[3] if p[3] in PROFILES else "custom") == profile]
        if own:
            out += block(f"points{k}", own)
            drawn.append(f"$points{k} using 1:2 with points pointtype {6 if k == 3 else 7} pointsize 0.6 linewidth 1.5 "
                         f"linecolor rgb {colour(str(k + 1))} title '{profile}'")
    if cpu:
        out += block("cpu", cpu)
        drawn.append(f"$cpu using 1:2 with points pointtype 2 pointsize 0.6 linewidth 1.5 linecolor rgb {colour('schlick')} "
                     "title 'on a CPU'")
    return out + plot(drawn)


def beside(names):
    """A picture of two plots side by side: the script of each, by title."""
    return "set multiplot layout 1,2\n" + "set format x\nunset label\nunset logscale\n".join(
        (f"set title '{title}'\n" if title else "") + script for title, script in names) + "unset multiplot\n"


def for_files(svgs):
    """SVGs as files by name: light and dark."""
    return {f"{name}-{theme}.svg": resolved(svg, colours) for name, svg in svgs.items() for theme, colours in themes().items()}


def cost_pictures(prices):
    plots = {f"cost-{axis}": cost_plot(prices, axis) for axis in AXES}
    svgs = run_gnuplot(plots)
    svgs.update(run_gnuplot({"pareto": beside([("", plots["cost-luts"]), ("", plots["cost-latency"])])}, 1040, 440))
    return for_files(svgs)


def write_whole(path, text):
    """Writes a file whole or not at all, also when this program is interrupted."""
    temporary = path.with_name(f"{path.name}.{os.getpid()}.tmp")
    try:
        temporary.write_text(text)
        os.replace(temporary, path)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise


def end_tidily():
    """`kill` ends this program as an error does: what is temporary is removed."""
    signal.signal(signal.SIGTERM, lambda number, _: sys.exit(128 + number))


def write(folder, files):
    """Writes all files below a folder, and says so."""
    for name, text in files.items():
        path = Path(folder) / name
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            write_whole(path, text)
        except OSError as error:
            raise Failure(f"file '{path}' cannot be written: {error.strerror}") from None
        print(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("prices", help="JSON of `glint cost --json` for one device")
    parser.add_argument("-o", "--output", required=True, help="folder of the pictures")
    arguments = parser.parse_args()
    end_tidily()
    try:
        write(arguments.output, cost_pictures(json.loads(Path(arguments.prices).read_text())))
    except Failure as failure:
        sys.exit(f"{failure}")


if __name__ == "__main__":
    main()
