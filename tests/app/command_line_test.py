"""The program as its users run it: what it prints, how it exits, and which files it leaves."""

import os
import pathlib
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["ANTUMBRA"]
SCENES = pathlib.Path("configs/scenes")


def run(*arguments, **environment):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=120,
                          env={**os.environ, **environment})


class CommandLine(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)

    def scene(self, name, *changes):
        text = (SCENES / "luxor_dome.toml").read_text().replace("2048", "64")
        for old, new in changes:
            self.assertIn(old, text)
            text = text.replace(old, new)
        file = self.path / name
        file.write_text(text)
        return str(file)

    def refused(self, arguments, *words):
        """Exit 2, all words in the message, nothing but scenes left behind."""
        result = run(*arguments)
        self.assertEqual(result.returncode, 2, result.stderr)
        for word in words:
            self.assertIn(word, result.stderr)
        left = [p.name for p in self.path.iterdir() if p.suffix != ".toml"]
        self.assertEqual(left, [])

    def test_option_messages_say_what_is_allowed(self):
        years = ["eclipse", "list", "--to", "2000", "--from"]
        self.refused([*years, "abc"], "--from", '"abc"', "a whole number")
        self.refused([*years, "2000.5"], '"2000.5"', "a whole number")
        self.refused([*years, "2000", "--kind", "x"], "--kind", "solar", "jovian")
        self.refused(["eclipse", "foo"], '"foo"', "list, at, path, map, elements")
        self.refused([*years, "2000", "--form", "csv"], "--form", "allowed: ", "--format")

    def test_options_given_empty_twice_or_bare(self):
        sky = ["sky", "--medium", "catalogs/atmospheres/earth.toml", "--wavelengths", "550"]
        self.refused([*sky, "--sun-zenith", "60", "--sun-zenith", "50"], "--sun-zenith",
                     "found 2 times", "once")
        self.refused([*sky, "--sun-zenith"], "--sun-zenith", "found no value")
        self.refused(["sky", "--medium", "", "--sun-zenith", "60"], "--medium", 'found ""')
        self.refused([*sky, "--sun-zenith", "60", "--directions", ""], "--directions",
                     "standard input")
        for option in "--albedo", "--wavelengths", "--corona":
            self.refused(["sky", "--medium", "catalogs/atmospheres/earth.toml", "--sun-zenith", "60",
                          "--irradiance", "--luminance", "--occulter", "ratio=1,shift-km=0",
                          option, ""], option, 'found ""')

    def test_explains_without_drawing(self):
        result = run("render", str(SCENES / "luxor_dome.toml"), "--explain")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("Moon on Earth", result.stdout)
        self.assertIn("left out", result.stdout)

    def test_renders_both_files(self):
        png, exr = self.path / "a.png", self.path / "a.exr"
        result = run("render", self.scene("s.toml"), "-o", str(png), "-o", str(exr))
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(png.read_bytes()[:4], b"\x89PNG")
        self.assertEqual(exr.read_bytes()[:4], b"\x76\x2f\x31\x01")

    def test_off_line_pictures_repeat_exactly(self):
        for name in "a.exr", "b.exr":
            result = run("render", self.scene("s.toml"), "-o", str(self.path / name))
            self.assertEqual(result.returncode, 0, result.stderr)
        # The files hold their pixels after a header that may carry a date.
        a, b = ((self.path / n).read_bytes() for n in ("a.exr", "b.exr"))
        self.assertEqual(a[-4096:], b[-4096:])

    def test_the_drawing_programs_answer_for_the_sky(self):
        """Against the Monte Carlo row of tests/authorities/mc_spherical_bruneton2017.csv."""
        directions = self.path / "directions.toml"  # a name that `refused` does not count
        directions.write_text("view_zenith_deg,rel_azimuth_deg\n0,0\n75,90\n")
        arguments = ["sky", "--medium", "catalogs/atmospheres/reference_bruneton2017.toml",
                     "--sun-zenith", "60", "--directions", str(directions), "--wavelengths",
                     "440,550,680"]
        result = run(*arguments, "--method", "balanced")
        self.assertEqual(result.returncode, 0, result.stderr)
        rows = [line.split(",") for line in result.stdout.splitlines() if line[:1].isdigit()]
        self.assertEqual(len(rows), 6)
        expected = [0.020576, 0.0085291, 0.0039035, 0.050429, 0.024341, 0.011721]
        for row, value in zip(rows, expected):
            self.assertAlmostEqual(float(row[3]) / value, 1.0, delta=0.03)
        self.refused([*arguments, "--method", "exact"], "--method", "balanced")

    def test_takes_contacts_as_instants(self):
        scene = self.scene("s.toml")
        result = run("render", scene, "--time", "max 2027-08-02 @25.687,32.640,76", "--explain")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("Moon on Earth", result.stdout)
        self.refused(["render", scene, "--time", "C2 2027-08-03 @25.687,32.640", "--explain"],
                     "--time", "2027-08-02")
        self.refused(["render", scene, "--time", "C2 2027-08-02 @60,-100", "--explain"], "--time")

    def test_refuses_bad_scenes(self):
        out = str(self.path / "a.png")
        self.refused(["render", str(self.path / "none.toml"), "-o", out], "none.toml")
        self.refused(["render", self.scene("s.toml", ("field", "feild")), "-o", out],
                     "s.toml:", "field")
        self.refused(["render", self.scene("s.toml", ('"76 m"', '"76 deg"')), "-o", out],
                     "s.toml:", "wrong unit", "76 deg")
        self.refused(["render", self.scene("s.toml", ('"76 m"', '"nan m"')), "-o", out],
                     "finite")
        self.refused(["render", self.scene("s.toml", ('"76 m"', '"-100 km"')), "-o", out],
                     "inside Earth")
        self.refused(["render", self.scene("s.toml", ('"zenith"', '"Vulcan"')), "-o", out],
                     "s.toml:", "Vulcan", "Mercury")
        self.refused(["render", self.scene("s.toml", ("max 2027-08-02 @25.687,32.640,76", "2027-13-02T00:00:00Z")), "-o", out],
                     "s.toml:")
        self.refused(["render", self.scene("s.toml", ("max 2027-08-02 @25.687,32.640,76", "9999-08-02T00:00:00Z")), "-o", out],
                     "3000")

    def test_refuses_bad_options(self):
        scene, out = self.scene("s.toml"), str(self.path / "a.png")
        self.refused(["render", scene], "-o")
        self.refused(["render", scene, "-o", str(self.path / "a.jpg")], "-o", ".png")
        self.refused(["render", scene, "-o", str(self.path / "no" / "a.png")], "does not exist")
        self.refused(["render", scene, "-o", out, "--size", "0x0"], "--size", "0x0")
        self.refused(["render", scene, "-o", out, "--size", "65000x65000"], "--size", "pixels")
        self.refused(["render", scene, "-o", out, "--size", "big"], "--size", "big")
        self.refused(["render", scene, "-o", out, "--projection", "mercator"], "--projection")
        self.refused(["render", scene, "-o", out, "--frames", "1:2"], "--frames", "0:0")
        self.refused(["render", scene, "-o", out, "--time", "noon"], "--time", "noon")
        self.refused(["render", scene, "-o", out, "--quality", "best"], "best", "balanced")
        self.refused(["render", str(SCENES / "descent.toml"), "-o", out], "%02d")
        for value in "nan", "inf", "1e30", "foo":
            self.refused(["render", scene, "-o", out, "--delta-t", value], "--delta-t", value)
        self.refused(["render", scene, "-o", out, "-o", out], "-o", "twice")
        self.refused(["render", scene, "-o", str(self.path / "a_%d_%d.png")], "at most one")
        self.refused(["render", scene, "-o", str(self.path / "a_%99999999999d.png")], "%0Nd")
        self.refused(["paint"], "paint")

    def test_names_what_it_tried_without_a_device(self):
        result = run("render", self.scene("s.toml"), "-o", str(self.path / "a.png"),
                     ANTUMBRA_EGL="device")
        # On a machine with a hardware device this succeeds.
        if result.returncode != 0:
            self.assertEqual(result.returncode, 3, result.stderr)
            self.assertIn("EGL", result.stderr)

    def test_finds_no_display(self):
        environment = {k: "" for k in ("DISPLAY", "WAYLAND_DISPLAY")}
        result = run("view", self.scene("s.toml"), **environment)
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertIn("DISPLAY", result.stderr)


if __name__ == "__main__":
    unittest.main()
