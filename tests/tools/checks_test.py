#!/usr/bin/env python3
"""The checks of tools/ pass on a sound small tree and fail, naming the place, on each seeded fault."""
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

TOOLS = pathlib.Path(__file__).resolve().parents[2] / "tools"


class ChecksTest(unittest.TestCase):
    def setUp(self):
        self.root = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.root)
        self.write("src/quantity/length.h", "#pragma once\n")
        self.write("src/gl/program.h", '#pragma once\n#include "quantity/length.h"\n')
        self.write("src/app/bench.cpp", '#include "gl/program.h"\n')
        self.write("src/main.cpp", "int main() { return 0; }\n")
        self.write("shaders/shared/eclipse.glsl", '#include "shared/disc.glsl"\n')
        self.write("tests/quantity/length_test.cpp", '#include "quantity/length.h"\n')
        self.write("tools/build_rows", "\n")
        self.write("catalogs/README.md", "| File | Source | Tool |\n|---|---|---|\n"
                   "| `stars/*.csv` | somewhere | `tools/build_rows` |\n"
                   "| `bodies/*.toml` | by hand | by hand |\n")
        self.write("catalogs/stars/bright.csv", "1,2\n")
        self.write("catalogs/bodies/earth.toml", "name = 'Earth'\n")
        shutil.copy(TOOLS.parent / ".clang-format", self.root)
        for command in (["init", "-q"], ["add", "-A"],
                        ["-c", "user.name=t", "-c", "user.email=t@t", "commit", "-qm", "t"]):
            subprocess.run(["git", "-C", self.root, *command], check=True)
        self.run_tool("check_catalogs", "--update")

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def run_tool(self, tool, *options):
        place = [] if tool == "check_format" else ["--root", str(self.root)]
        result = subprocess.run([TOOLS / tool, *place, *options], capture_output=True, text=True,
                                env={**os.environ, "ROOT": str(self.root)})
        return result.returncode, result.stdout + result.stderr

    def assert_passes(self, tool, *options):
        status, output = self.run_tool(tool, *options)
        self.assertEqual(status, 0, output)

    def assert_fails(self, tool, message, *options):
        status, output = self.run_tool(tool, *options)
        self.assertEqual(status, 1, output)
        self.assertIn(message, output)

    def test_sound_tree_passes_every_check(self):
        for tool in ("check_layers", "check_format", "check_catalogs"):
            self.assert_passes(tool)

    def test_layers_an_include_of_a_later_room(self):
        self.write("src/quantity/length.h", '#pragma once\n#include "gl/program.h"\n')
        self.assert_fails("check_layers", "src/quantity/length.h:2: includes \"gl/program.h\"")

    def test_layers_a_graphics_header_in_the_core(self):
        self.write("src/plan/plan.cpp", "#include <GL/glcorearb.h>\n")
        self.assert_fails("check_layers", "src/plan/plan.cpp:1:")

    def test_layers_an_image_library_below_gl(self):
        self.write("src/passes/bodies.cpp", "\n#include <OpenImageIO/imageio.h>\n")
        self.assert_fails("check_layers", "src/passes/bodies.cpp:2:")

    def test_layers_the_benchmark_needs_no_window(self):
        self.write("src/app/bench.cpp", '#include "output/window.h"\n')
        self.assert_fails("check_layers", "src/app/bench.cpp:1:")

    def test_layers_an_unknown_room(self):
        self.write("src/util/strings.h", "#pragma once\n")
        self.assert_fails("check_layers", "unknown room 'util'")

    def test_layers_a_relative_include(self):
        self.write("src/gl/program.h", '#include "../quantity/length.h"\n')
        self.assert_fails("check_layers", "src/gl/program.h:1:")

    def test_layers_shared_shader_including_a_pass(self):
        self.write("shaders/shared/eclipse.glsl", '#include "passes/bodies.frag"\n')
        self.assert_fails("check_layers", "shaders/shared/eclipse.glsl:1:")

    def test_layers_a_long_main(self):
        self.write("src/main.cpp", "\n" * 100)
        self.assert_fails("check_layers", "src/main.cpp:100:")

    def test_format_a_misformatted_file(self):
        self.write("src/gl/program.h", "int   x ;\n")
        self.assert_fails("check_format", "src/gl/program.h:1:")

    def test_catalogs_changed_content(self):
        self.write("catalogs/stars/bright.csv", "1,3\n")
        self.assert_fails("check_catalogs", "catalogs/stars/bright.csv: SHA-256")

    def test_catalogs_missing_file(self):
        (self.root / "catalogs/stars/bright.csv").unlink()
        self.assert_fails("check_catalogs", "in checksums.txt but missing")

    def test_catalogs_unlisted_file(self):
        self.write("catalogs/stars/faint.csv", "1\n")
        self.assert_fails("check_catalogs", "catalogs/stars/faint.csv: not in checksums.txt")

    def test_catalogs_file_without_row(self):
        self.write("catalogs/maps/moon.jpg", "x\n")
        self.assert_fails("check_catalogs", "catalogs/maps/moon.jpg: no row", "--update")

    def test_catalogs_document_without_row(self):
        self.write("catalogs/atmospheres/earth.toml", "\n")
        self.assert_fails("check_catalogs", "catalogs/atmospheres/earth.toml: no row")

    def test_catalogs_row_with_an_empty_cell(self):
        self.write("catalogs/README.md", "| File | Source | Tool |\n|---|---|---|\n"
                   "| `stars/*.csv` `bodies/*.toml` | | `tools/build_rows` |\n")
        self.assert_fails("check_catalogs", "catalogs/README.md:3:")

    def test_catalogs_row_with_a_missing_tool(self):
        (self.root / "tools/build_rows").unlink()
        self.assert_fails("check_catalogs", "tools/build_rows does not exist")

    def test_catalogs_too_large_a_repository(self):
        self.assert_fails("check_catalogs", "allowed: below 10", "--limit-bytes", "10")


if __name__ == "__main__":
    unittest.main()
