#!/usr/bin/env python3
"""The tables of units in docs/, between marks, are those of rtl/units.json.

    docs_tables.py            fails where one is not current
    docs_tables.py --write    writes them

A table stands between `<!-- ports of UNIT -->` or `<!-- units of LOBE -->`, `<!-- units of effect_EFFECT -->` and `<!-- end -->`; in UNIT, P stands
for the profile. `<!-- words of effects -->` has the words of their AXI4-Stream units.
"""

import re
import sys

from units import RTL, units

DOCS = RTL.parent / "docs"
MARKED = re.compile(r"(<!-- (ports|units|words) of (\w+) -->\n)(.*?)(<!-- end -->\n)", re.DOTALL)
PROFILES = ("p8", "p12", "p16")
STREAM = ("clk_i", "rst_ni", "valid_i", "ready_o", "tag_i", "valid_o", "ready_i", "tag_o", "clamped_o")


def table(head, aligned, rows):
    lines = [head, aligned, *rows]
    return "".join("| " + " | ".join(cells) + " |\n" if cells != aligned else "|" + "|".join(cells) + "|\n" for cells in lines)


def by_profile(every, name):
    found = {profile: every[name[:-1] + profile] for profile in PROFILES if name[:-1] + profile in every}
    if not name.endswith("_P") or not found:
        raise ValueError(f"'{name}' is no unit of rtl/units.json, with P for its profile")
    return found


def ports(every, name):
    found = by_profile(every, name)
    widths = {tuple(port["width"] for port in unit["ports"]) for unit in found.values()}
    shown = found if len(widths) > 1 else {"bits": next(iter(found.values()))}
    rows = []
    for place, port in enumerate(found["p12"]["ports"]):
        bits = [f"{unit['ports'][place]['width']}" for unit in shown.values()]
        meaning = port["meaning"].replace(f"2^{found['p12']['F']}", "2^F").replace(f"2^{found['p12']['O']}", "2^O")
        rows.append([f"`{port['name']}`", port["direction"] + (", signed" if port["signed"] else ""), *bits, meaning])
    heads = [f"`{profile}`" for profile in shown] if shown is found else list(shown)
    return table(["port", "direction", *heads, "meaning"], ["---", "---", *["--:"] * len(shown), "---"], rows)


def about(unit):
    """What a table of units is of. The AXI4-Stream units are in none: they take two clocks more."""
    return {"lobe": unit["lobe"], "lobe_axis": None, "effect_axis": None, "effect": f"effect_{unit['effect']}"}[unit["kind"]]


def of(every, name):
    names = {re.sub(r"_p\d+$", "_P", unit["name"]): None for unit in every.values() if about(unit) == name}
    if not names:
        raise ValueError(f"'{name}' is no lobe or effect of rtl/units.json")
    rows = []
    for unit_name in names:
        found = by_profile(every, unit_name)
        for place, architecture in enumerate(found["p12"]["architectures"]):
            if ":" in architecture["name"]:
                continue
            clocks = [str(found[profile]["architectures"][place]["latency"]) if profile in found else "" for profile in PROFILES]
            interval = "1" if architecture["interval"] == 1 else "latency"
            shown = "" if architecture["name"] == "default" else f"`{architecture['name']}`"
            rows.append([f"`{unit_name}`" if place == 0 else "", shown, *clocks, interval])
    return table(["unit", "architecture", *(f"`{profile}`" for profile in PROFILES), "interval"],
                 ["---", "---", "--:", "--:", "--:", "---"], rows)


def words(every, _):
    """The AXI4-Stream units of effects: what their words hold, by the ports of the unit inside."""
    rows = []
    for unit in every.values():
        if unit["kind"] != "effect_axis":
            continue
        inside = every[unit["core"]["module"]]
        tdata = {port["name"]: port["width"] for port in unit["ports"]}
        named = {end: [f"`{port['name'][:-2]}`" for port in inside["ports"] if port["name"].endswith(end) and port["name"] not in STREAM]
                 for end in ("_i", "_o")}
        rows.append([f"`{re.sub(r'_p12$', '_P', unit['name'])}`", str(tdata["s_axis_tdata"]), ", ".join(named["_i"]),
                     str(tdata["m_axis_tdata"]), ", ".join(named["_o"])])
    return table(["unit", "bits in", "inputs", "bits out", "results"], ["---", "--:", "---", "--:", "---"], rows)


TABLES = {"ports": ports, "units": of, "words": words}


def main():
    every = units()
    write = sys.argv[1:] == ["--write"]
    done = stale = 0
    shown = set()
    for page in sorted(DOCS.rglob("*.md")):
        text = page.read_text()
        made = MARKED.sub(lambda m: m[1] + TABLES[m[2]](every, m[3]) + m[5], text)
        done += len(MARKED.findall(text))
        if made != text and write:
            page.write_text(made)
        elif made != text:
            print(f"FAILED: {page.relative_to(RTL.parent)}: its tables are not those of rtl/units.json: docs_tables.py --write")
            stale += 1
        shown.update(m[3] for m in MARKED.finditer(text) if m[2] == "units")
    for name in sorted({about(unit) for unit in every.values()} - {None} - shown):
        print(f"FAILED: no document has `<!-- units of {name} -->`")
        stale += 1
    print(f"{done} tables, {stale} pages that are not current")
    return 1 if stale or not done else 0


if __name__ == "__main__":
    sys.exit(main())
