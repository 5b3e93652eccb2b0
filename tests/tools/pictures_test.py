#!/usr/bin/env python3
"""tools/compare measures what was put in; tools/plot draws every usable row and the frontier."""
import json
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

TOOLS = pathlib.Path(__file__).resolve().parents[2] / "tools"


class InFolder(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def run_tool(self, *arguments):
        result = subprocess.run([TOOLS / arguments[0], *arguments[1:]], capture_output=True,
                                text=True, cwd=self.folder)
        return result.returncode, result.stdout, result.stderr


class CompareTest(InFolder):
    def picture(self, name, *operations):
        subprocess.run(["oiiotool", "--pattern", "constant:color=2e-5,0.5,1e9", "16x8", "3",
                        *operations, "-d", "float", "-o", name], cwd=self.folder, check=True)

    def test_a_known_difference(self):
        self.picture("a.exr")
        self.picture("b.exr", "--mulc", "1.01")
        status, output, _ = self.run_tool("compare", "a.exr", "b.exr")
        self.assertEqual(status, 0)
        rows = [line.split() for line in output.splitlines()[1:]]
        self.assertEqual(len(rows), 3)
        for row, level in zip(rows, (2e-5, 0.5, 1e9)):
            self.assertAlmostEqual(float(row[1]) / level, 1.0, places=4)
            self.assertAlmostEqual(float(row[4]) / level, 0.01, places=5)
            self.assertAlmostEqual(float(row[5]), 1.0, places=2)  # percent

    def test_limits(self):
        self.picture("a.exr")
        self.picture("b.exr", "--mulc", "1.01")
        self.assertEqual(self.run_tool("compare", "a.exr", "b.exr", "--limit-mean", "1.1%")[0], 0)
        self.assertEqual(self.run_tool("compare", "a.exr", "b.exr", "--limit-mean", "0.9%")[0], 1)
        self.assertEqual(self.run_tool("compare", "a.exr", "b.exr", "--limit-max", "1e6")[0], 1)

    def test_bad_input(self):
        self.picture("a.exr")
        self.picture("small.exr", "--resize", "8x8")
        status, _, error = self.run_tool("compare", "a.exr", "small.exr")
        self.assertEqual(status, 2)
        self.assertIn("16x8", error)
        self.assertEqual(self.run_tool("compare", "a.exr", "missing.exr")[0], 2)


class PlotTest(InFolder):
    ROWS = [{"ms": 1, "error": 10, "name": "fast"}, {"ms": 10, "error": 1, "name": "good"},
            {"ms": 20, "error": 2, "name": "beaten"}, {"ms": 0, "error": 3, "name": "free"}]

    def plot(self, content, *options):
        (self.folder / "t.json").write_text(content)
        return self.run_tool("plot", "t.json", "-o", "t.svg", "--x", "ms", "--y", "error", *options)

    def test_draws_rows_and_frontier(self):
        status, _, error = self.plot(json.dumps({"rows": self.ROWS}), "--label", "name")
        self.assertEqual(status, 0, error)
        self.assertIn("1 of 4 rows left out", error)  # no logarithm of zero
        svg = (self.folder / "t.svg").read_text()
        self.assertEqual(svg.count("<circle"), 3)
        frontier = re.search(r'points="([^"]*)"', svg)[1].split()
        self.assertEqual(len(frontier), 2)

    def test_writes_out_chosen_labels_and_pales_what_is_beaten(self):
        rows = [dict(r, on_front=r["name"] != "beaten") for r in self.ROWS]
        status, _, error = self.plot(json.dumps({"rows": rows}), "--label", "name",
                                     "--label-only", "good,free")
        self.assertEqual(status, 0, error)
        svg = (self.folder / "t.svg").read_text()
        self.assertIn(">good</text>", svg)
        self.assertNotIn(">fast</text>", svg)
        self.assertEqual(svg.count("fill-opacity"), 1)

    def test_bad_input_leaves_no_file(self):
        for content, message in (("{", "t.json:1"), ('{"a": 1}', "rows"), ("[]", "no row")):
            status, _, error = self.plot(content)
            self.assertEqual(status, 2)
            self.assertIn(message, error)
            self.assertFalse((self.folder / "t.svg").exists())


if __name__ == "__main__":
    unittest.main()
