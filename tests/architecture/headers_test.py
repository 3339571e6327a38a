#!/usr/bin/env python3
"""headers.py on two headers of its own: one that compiles alone, one that leans on its neighbour."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).with_name("headers.py")


class Headers(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        (self.root / "problems").mkdir()
        (self.root / "problems/whole.hpp").write_text("#pragma once\n#include <string>\nstd::string whole();\n")
        (self.root / "problems/needy.hpp").write_text("#pragma once\nstd::string needy();\n")
        # As a build with a precompiled header and ccache writes it.
        command = "ccache c++ -std=c++20 -Winvalid-pch -include no-such-file.hxx -o x.o -c x.cpp"
        (self.root / "compile_commands.json").write_text(json.dumps([{"command": command}]))

    def run_on(self, *headers):
        return subprocess.run([sys.executable, "-B", SCRIPT, self.root, self.root, *headers], capture_output=True, text=True)

    def test_names_the_header_that_lacks_an_include(self):
        result = self.run_on()
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stdout, r"problems/needy.hpp: .*error")
        self.assertIn("2 headers, 1 do not compile alone", result.stdout)
        self.assertNotIn("problems/whole.hpp: ", result.stdout)

    def test_asks_only_those_that_are_named(self):
        result = self.run_on("problems/whole.hpp")
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertIn("1 headers, 0 do not compile alone", result.stdout)


if __name__ == "__main__":
    unittest.main()
