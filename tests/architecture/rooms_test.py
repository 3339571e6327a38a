"""Tests of rooms.py: each offence, planted in a small tree that has none, is refused and named."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).parent / "rooms.py"

SOUND = {
    "problems/problem.hpp": "#pragma once\n",
    "methods/method.hpp": '#pragma once\n#include "problems/problem.hpp"\n',
    "methods/solvers/zero.hpp": "#pragma once\n",
    "methods/solvers/zero.cpp": '#include "methods/solvers/zero.hpp"\n',
    "methods/first/first.hpp": '#pragma once\n#include "methods/solvers/zero.hpp"\n',
    "methods/second/second.hpp": '#pragma once\n#include "methods/solvers/zero.hpp"\n',
    "methods/catalogue.cpp": '#include "methods/first/first.hpp"\n#include "methods/second/second.hpp"\n',
    "harness/table.hpp": "#pragma once\n",
    "harness/report/report.cpp": '#include "harness/table.hpp"\n#include "methods/method.hpp"\n',
}


def check(planted):
    """Exit code and lines of the check on the sound tree with the planted files in place of its own."""
    with tempfile.TemporaryDirectory() as folder:
        for path, text in {**SOUND, **planted}.items():
            file = pathlib.Path(folder, path)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
        run = subprocess.run([sys.executable, SCRIPT, folder], capture_output=True, text=True, check=False)
        return run.returncode, run.stdout.splitlines() + run.stderr.splitlines()


class Rooms(unittest.TestCase):
    def expect(self, planted, *lines):
        self.assertEqual(check(planted), (1 if lines else 0, list(lines)))

    def test_accept_a_sound_tree(self):
        self.expect({})

    def test_refuse_a_circle_of_two_units(self):
        self.expect(
            {"methods/solvers/zero.hpp": '#pragma once\n#include "methods/solvers/newton.hpp"\n',
             "methods/solvers/newton.hpp": "#pragma once\n",
             "methods/solvers/newton.cpp": '#include "methods/solvers/newton.hpp"\n\n#include "methods/solvers/zero.hpp"\n'},
            'methods/solvers/newton.cpp:3: #include "methods/solvers/zero.hpp": '
            "circle methods/solvers/zero -> methods/solvers/newton -> methods/solvers/zero")

    def test_refuse_a_circle_of_three_units(self):
        self.expect(
            {"methods/flow/a.hpp": '#include "methods/flow/b.hpp"\n',
             "methods/flow/b.hpp": '#include "methods/flow/c.hpp"\n',
             "methods/flow/c.hpp": '#include "methods/flow/a.hpp"\n'},
            'methods/flow/c.hpp:1: #include "methods/flow/a.hpp": '
            "circle methods/flow/a -> methods/flow/b -> methods/flow/c -> methods/flow/a")

    def test_refuse_an_arrow_upward(self):
        self.expect(
            {"methods/solvers/zero.cpp": '#include "methods/solvers/zero.hpp"\n#include "methods/orbit/polish.hpp"\n'},
            'methods/solvers/zero.cpp:2: #include "methods/orbit/polish.hpp": methods/orbit stands above methods/solvers')

    def test_refuse_an_arrow_from_methods_to_the_harness(self):
        self.expect({"methods/first/first.cpp": '#include "methods/first/first.hpp"\n#include "harness/table.hpp"\n'},
                    'methods/first/first.cpp:2: #include "harness/table.hpp": harness stands above methods/first')

    def test_refuse_a_method_that_includes_another(self):
        self.expect({"methods/second/second.hpp": '#pragma once\n#include "methods/first/first.hpp"\n'},
                    'methods/second/second.hpp:2: #include "methods/first/first.hpp": '
                    "methods/first stands beside methods/second")

    def test_refuse_a_unit_that_stands_above_its_folder(self):
        self.expect({"methods/third/third.hpp": '#pragma once\n#include "methods/catalogue.hpp"\n'},
                    'methods/third/third.hpp:2: #include "methods/catalogue.hpp": '
                    "methods/catalogue stands above methods/third")

    def test_refuse_a_folder_without_a_place(self):
        self.expect({"harness/utils/a.hpp": "#pragma once\n", "harness/utils/b.hpp": "#pragma once\n"},
                    "harness/utils/a.hpp:1: harness/utils: the folder has no line in tests/architecture/rooms.txt")

    def test_refuse_a_source_that_does_not_begin_with_its_header(self):
        self.expect({"methods/solvers/zero.cpp": '#include <vector>\n#include "methods/solvers/zero.hpp"\n'},
                    'methods/solvers/zero.cpp:1: its first include must be "methods/solvers/zero.hpp"')

    def test_refuse_a_test_whose_namespace_is_not_its_own(self):
        self.expect({"tests/methods/solvers/zero_test.cpp": "namespace signorini::zero_test {\nnamespace {\n}\n}\n"})
        self.expect({"tests/methods/solvers/zero_test.cpp": "\nnamespace signorini {\nnamespace {\n}\n}\n"},
                    "tests/methods/solvers/zero_test.cpp:2: namespace signorini: what is a test's own lies in a namespace zero_test")

    def test_refuse_a_file_that_is_too_long(self):
        self.expect({"tests/long_test.cpp": "\n" * 400, "tests/longer_test.cpp": "\n" * 401},
                    "tests/longer_test.cpp:401: the file has 401 lines: at most 400")

    def test_refuse_a_folder_that_is_too_full(self):
        many = {f"methods/flow/f{number}.hpp": "" for number in range(26)}
        self.expect({**many, "methods/flow/CMakeLists.txt": ""},
                    "methods/flow:1: the folder holds 26 files: at most 25 beside CMakeLists.txt")
        root = {f"harness/f{number}.hpp": "" for number in range(20)}  # and table.hpp
        self.expect(root, "harness:1: the folder holds 21 files: at most 20 beside CMakeLists.txt")

    def test_refuse_a_long_class_in_a_source(self):
        def text(lines):
            body = ['  const char* brace = "}";  // }', *["  int x;"] * (lines - 3), "};"]
            return "\n".join(["class Path {", *body, "struct Later {", "};", ""])

        self.expect({"methods/flow/a.cpp": text(200), "methods/flow/b.cpp": text(201), "methods/flow/c.hpp": text(300)},
                    "methods/flow/b.cpp:1: class Path has 201 lines: at most 200 in a source")


if __name__ == "__main__":
    unittest.main()
