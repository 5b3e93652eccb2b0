"""`antumbra trade shadows` as its users run it."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["ANTUMBRA"]


def run(*arguments):
    return subprocess.run([PROGRAM, "trade", "shadows", *arguments], capture_output=True, text=True,
                          timeout=120)


class TradeShadows(unittest.TestCase):
    def test_measures_the_overlapping_shadows_of_two_moons(self):
        result = run("--points", "40", "--format", "json")
        self.assertEqual(result.returncode, 0, result.stderr)
        found = json.loads(result.stdout)
        self.assertIn("Callisto on Jupiter", found["shadows"])
        rows = {(r["disc"], r["several"]): r for r in found["rows"]}
        self.assertEqual(len(rows), 6)
        exact = rows["limb-darkened", "union"]
        self.assertTrue(exact["on_front"])
        self.assertLess(exact["error_percent"], 0.1)
        self.assertLess(exact["error_percent"], rows["limb-darkened", "minimum"]["error_percent"])
        self.assertLess(exact["half_light_edge_error_km"], 0.1)
        self.assertTrue(all(r["time_ns"] > 0 for r in found["rows"]))

    def test_refuses_what_it_cannot_measure(self):
        for arguments, words in (
                (["configs/scenes/luxor_sun.toml", "--time", "2027-07-20T10:00:00Z"],
                 ["luxor_sun.toml", "found no shadow", "--explain"]),
                (["--points", "3"], ["--points", "found 3", "20 to 100000"]),
                (["--format", "xml"], ["--format", "table, csv, json"]),
                (["nowhere.toml"], ["nowhere.toml"])):
            result = run(*arguments)
            self.assertEqual(result.returncode, 2, result.stderr)
            for word in words:
                self.assertIn(word, result.stderr)
            self.assertEqual(result.stdout, "")

    def test_leaves_no_half_written_file(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "missing" / "s.json"
            result = run("--points", "20", "-o", str(file))
            self.assertEqual(result.returncode, 2)
            self.assertIn("-o: folder", result.stderr)
            self.assertNotIn("rays to the Sun", result.stderr)  # before the measurement
            self.assertEqual(list(pathlib.Path(folder).rglob("*")), [])


if __name__ == "__main__":
    unittest.main()
