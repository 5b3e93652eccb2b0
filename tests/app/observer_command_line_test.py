"""`antumbra render` for an eye and for a camera with brackets, as their users run it."""

import os
import pathlib
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["ANTUMBRA"]
DUSK = """title = "dusk"
time = "2027-08-10T16:40:00Z"
[camera]
body = "Earth"
latitude = "25.687 deg"
longitude = "32.640 deg"
height = "76 m"
target = "zenith"
up = "north"
[picture]
projection = "fisheye"
field = "180 deg"
width = 48
height = 48
[animation]
frames = 2
[[keyframe]]
frame = 0
time_offset = "0 s"
[[keyframe]]
frame = 1
time_offset = "1.5 s"
[display]
exposure = "auto"
"""


class Observer(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()

    def render(self, display, output, *arguments):
        scene = self.path / "dusk.toml"
        scene.write_text(DUSK + display)
        return subprocess.run([PROGRAM, "render", scene, "-o", self.path / output, "--quality",
                               "draft", *arguments], capture_output=True, text=True, timeout=300)

    def test_an_eyes_frame_is_the_same_alone_and_after_others(self):
        for output, frames in (("both_%d.png", "0:1"), ("alone_%d.png", "1:1")):
            result = self.render('observer = "eye"\n', output, "--frames", frames)
            self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual((self.path / "both_1.png").read_bytes(),
                         (self.path / "alone_1.png").read_bytes())
        self.assertNotEqual((self.path / "both_0.png").read_bytes(),
                            (self.path / "both_1.png").read_bytes())

    def test_each_bracket_is_a_picture_of_its_own(self):
        result = self.render("brackets = [-4, 0, 2.5]\n", "dusk.png", "--frames", "0:0")
        self.assertEqual(result.returncode, 0, result.stderr)
        files = [self.path / f"dusk{end}.png" for end in ("", "_ev-4", "_ev+0", "_ev+2.5")]
        pictures = [f.read_bytes() for f in files]
        self.assertEqual(pictures[0], pictures[2])
        self.assertEqual(len(set(pictures)), 3)

    def test_refuses_what_no_observer_is(self):
        for display, words in ((('observer = "owl"\n'), ["dusk.toml:25", "owl", "camera, eye"]),
                               (('observer = "eye"\nbrackets = [1]\n'), ["dusk.toml:26", "camera"]),
                               (('brackets = []\n'), ["dusk.toml:25", "1 to 15"])):
            result = self.render(display, "dusk.png", "--frames", "0:0")
            self.assertEqual(result.returncode, 2, result.stderr)
            for word in words:
                self.assertIn(word, result.stderr)
            self.assertEqual(list(self.path.glob("*.png")), [])


if __name__ == "__main__":
    unittest.main()
