"""`antumbra view` on a virtual screen, with real key presses, mouse drags and wheel turns."""

import os
import re
import subprocess
import tempfile
import time
import unittest

PROGRAM = os.environ["ANTUMBRA"]
STARTED = 90  # s, for the first picture on a slow machine


class Window(unittest.TestCase):
    def setUp(self):
        # The server chooses a free display and tells its number when it is ready.
        readable, writable = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writable), "-screen", "0", "800x600x24"],
            pass_fds=[writable], stderr=subprocess.DEVNULL)
        os.close(writable)
        self.addCleanup(self.server.wait)
        self.addCleanup(self.server.terminate)
        with os.fdopen(readable) as answer:
            number = answer.readline().strip()
        self.assertTrue(number, "Xvfb did not start")
        self.environment = {**os.environ, "DISPLAY": f":{number}"}

    def xdotool(self, *arguments):
        return subprocess.run(["xdotool", *arguments], env=self.environment, capture_output=True,
                              text=True, timeout=20)

    def title(self, window):
        return self.xdotool("getwindowname", window).stdout.strip()

    def until(self, window, pattern):
        deadline = time.monotonic() + STARTED
        while time.monotonic() < deadline:
            found = re.search(pattern, self.title(window))
            if found:
                return found
            time.sleep(0.05)
        self.fail(f"the title {self.title(window)!r} never matched {pattern!r}")

    def test_mouse_and_keys_move_camera_and_clock(self):
        program = subprocess.Popen(
            [PROGRAM, "view", "configs/scenes/luxor_dome.toml", "--size", "160x120",
             "--projection", "perspective", "--quality", "draft",
             "--time", "2027-08-02T10:05:06Z"],
            env=self.environment, stdout=subprocess.PIPE, text=True)
        self.addCleanup(program.stdout.close)
        self.addCleanup(program.kill)
        deadline = time.monotonic() + STARTED
        window = ""
        while not window and time.monotonic() < deadline:
            window = self.xdotool("search", "--name", "Luxor").stdout.split("\n")[0]
            time.sleep(0.1)
        self.assertTrue(window, "no window appeared")
        self.until(window, r"10:05:06Z.*paused.* 1 s/s, field 60\.00")
        self.xdotool("key", "--window", window, "bracketright")
        self.until(window, r" 5 s/s")
        self.xdotool("key", "--window", window, "period")
        self.until(window, r"10:05:11Z")
        self.xdotool("key", "--window", window, "comma")
        self.until(window, r"10:05:06Z")
        self.xdotool("key", "--window", window, "space")
        self.until(window, r"10:(?!05:0[0-7])\d\d:\d\dZ(?!.*paused)")
        self.xdotool("mousemove", "--window", window, "60", "60", "click", "4")
        self.until(window, r"field 54\.00")
        self.xdotool("mousemove", "--window", window, "60", "60", "mousedown", "1")
        self.xdotool("mousemove", "--window", window, "90", "80", "mouseup", "1")
        self.xdotool("key", "--window", window, "q")
        output, _ = program.communicate(timeout=STARTED)
        self.assertEqual(program.returncode, 0)
        self.assertIn("last instant 2027-08-02T10:", output)


if __name__ == "__main__":
    unittest.main()
