#!/usr/bin/env python3
"""The page of `glint report` in a headless Chromium, with the committed prices: what moves, moves; it fits narrow
screens; nothing complains.

    page_test.py --glint build/release/glint --browser /usr/bin/chromium [--pictures DIR]

Exit status: 0 if every check held. --pictures keeps a screenshot of each view, to be looked at.
"""

import argparse
import base64
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from browser import Browser

ROOT = Path(__file__).resolve().parents[2]
OPTIONS = argparse.Namespace()

POINTS = "document.getElementById('pareto').data.filter(t => t.customdata).reduce((sum, t) => sum + t.x.length, 0)"
ROWS = "[...document.querySelectorAll('#units tbody tr')].filter(row => !row.hidden)"


def column(name):
    """The values of a column of the visible rows of the table of units, as texts."""
    index = f"[...document.querySelectorAll('#units thead th')].findIndex(th => th.textContent === '{name}')"
    return f"{ROWS}.map(row => row.cells[{index}].textContent)"


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        folder = Path(cls.folder.name)
        glint = str(Path(OPTIONS.glint).resolve())
        subprocess.run([glint, "sweep", "--lobe", "bps,schlick", "--profile", "p8", "--cos", "0:65536:64", "--json", "s.json"],
                       cwd=folder, check=True, stdout=subprocess.DEVNULL)
        data = ROOT / "cost/data"
        subprocess.run([glint, "report", "--results", "s.json", "--cpu", data / "cpu.json", "--cpu-models",
                        data / "cpu-models.json", "--cost", data, "-o", "page"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        cls.page = folder / "page/index.html"
        cls.browser = Browser(OPTIONS.browser)
        cls.addClassCleanup(cls.browser.close)

    def setUp(self):
        self.browser.errors.clear()

    def tearDown(self):
        self.assertEqual(self.browser.errors, [])

    def open(self, name, **view):
        self.browser.open(self.page, **view)
        self.browser.wait("document.querySelectorAll('.js-plotly-plot .main-svg').length >= 9")  # three plots
        if OPTIONS.pictures:
            Path(OPTIONS.pictures).mkdir(parents=True, exist_ok=True)
            for part in range(3):
                shot = self.browser.call("Page.captureScreenshot", captureBeyondViewport=True, clip={
                    "x": 0, "y": 2600 * part, "width": view.get("width", 1280), "height": 2600, "scale": 1})
                (Path(OPTIONS.pictures) / f"{name}-{part}.png").write_bytes(base64.b64decode(shot["data"]))

    def set(self, name, value):
        self.browser.run(f"(s => {{ s.value = '{value}'; s.dispatchEvent(new Event('change')); }})"
                         f"(document.getElementById('filter-{name}'))")

    def test_filters(self):
        """Each filter leaves fewer units in the plot and in the table, and only those that it names."""
        self.open("light")
        self.assertLess(self.page.stat().st_size, 5_000_000)
        run = self.browser.run
        self.set("show", "all")
        everything = run(POINTS)
        self.assertGreater(everything, 50)
        self.assertEqual(run(f"{ROWS}.length"), everything)
        for name, value, head in (("profile", "p8", "profile"), ("lobe", "schlick", "lobe")):
            before = run(POINTS)
            self.set(name, value)
            self.assertTrue(0 < run(POINTS) < before, name)
            self.assertEqual(set(run(column(head))), {value})
        self.set("dsps", "some")  # the hx8k has none
        self.assertEqual((run(POINTS), run(f"{ROWS}.length")), (0, 0))
        self.set("device", "ecp5-25k")
        self.assertGreater(run(POINTS), 0)
        self.assertTrue(all(int(dsps) > 0 for dsps in run(column("DSPs"))))
        self.set("axis", "latency_ns")
        self.assertEqual(run("document.getElementById('pareto').layout.xaxis.title.text"), "latency, ns")
        self.set("axis", "latency_clocks")
        self.assertEqual(run("document.getElementById('pareto').layout.xaxis.title.text"), "latency, clocks")
        self.assertIn("Energy is not measured", run("document.body.textContent"))
        self.set("show", "best")
        self.assertTrue(0 < run(f"{ROWS}.length") <= run(POINTS))

    def test_hover_and_click(self):
        """A hover names the configuration, its price and the command that emits it; a click keeps it below the plot."""
        self.open("hover")
        unit, x, y = self.browser.run("""(() => {
            const plot = document.getElementById('pareto');
            plot.scrollIntoView({block: 'center'});
            const trace = plot.data.find(t => t.name === 'p12'), layout = plot._fullLayout, box = plot.getBoundingClientRect();
            const at = (axis, value) => axis._offset + axis.l2p(Math.log10(value));
            return [trace.text[0], box.left + at(layout.xaxis, trace.x[0]), box.top + at(layout.yaxis, trace.y[0])]; })()""")
        self.browser.move(x + 30, y + 30)
        self.browser.move(x, y)
        self.browser.wait("document.querySelector('.hoverlayer').textContent !== ''")
        hover = self.browser.run("document.querySelector('.hoverlayer').textContent")
        for text in ("p12", "error", "LUTs", "latency", "ns a result", "glint emit --lobe ", " -o out"):
            self.assertIn(text, hover)
        self.browser.click(x, y)
        self.browser.wait("document.querySelectorAll('tr.chosen').length === 1")
        self.assertEqual(self.browser.run("document.getElementById('chosen').innerHTML").split("<br>")[0], unit.split("<br>")[0])

    def test_sort(self):
        """A click on a heading sorts the table by it, another one turns the order; the rows stay the same."""
        self.open("sort")
        self.set("show", "all")
        before = sorted(self.browser.run(column("LUTs")))
        for turn in (1, -1):
            self.browser.run("[...document.querySelectorAll('#units thead th')].find(th => th.textContent === 'LUTs').click()")
            luts = [int(text) for text in self.browser.run(column("LUTs"))]
            self.assertEqual(luts, sorted(luts, reverse=turn < 0))
            self.assertGreater(len(set(luts)), 10)
            self.assertEqual(sorted(map(str, luts)), before)

    def test_narrow(self):
        """At 390 pixels nothing is wider than the screen, and the contents list stays in view."""
        self.open("narrow", width=390, height=844)
        self.assertLessEqual(self.browser.run("document.documentElement.scrollWidth"), 390)
        for target in ("accuracy", "commands"):
            self.browser.run(f"document.getElementById('{target}').scrollIntoView()")
            box = self.browser.run("(b => [b.top, b.bottom])(document.querySelector('nav').getBoundingClientRect())")
            self.assertTrue(0 <= box[0] < box[1] < 100, f"{target}: {box}")
            self.browser.wait(f"document.querySelector('nav a.here')?.hash === '#{target}'")

    def test_dark(self):
        """The dark theme has other colours, in the plots too; a change of theme draws them again."""
        colours = "[getComputedStyle(document.body).backgroundColor, document.getElementById('pareto').layout.font.color]"
        self.open("dark", dark=True)
        dark = self.browser.run(colours)
        self.browser.theme(False)
        self.browser.wait(f"{colours}[1] !== '{dark[1]}'")
        self.assertNotEqual(self.browser.run(colours)[0], dark[0])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--glint", required=True)
    parser.add_argument("--browser", required=True)
    parser.add_argument("--pictures", help="folder for screenshots")
    arguments, rest = parser.parse_known_args(namespace=OPTIONS)
    unittest.main(argv=[sys.argv[0], *rest])


if __name__ == "__main__":
    main()
