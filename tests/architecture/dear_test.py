"""Tests of dear.py: each offence, planted in a small tree that has none, is refused and named."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).parent / "dear.py"
LIST = "tests/architecture/dear_includes.txt"

SOUND = {
    "problems/problem.hpp": "#pragma once\n#include <Eigen/SparseCore>\n",
    "methods/method.hpp": '#pragma once\n#include "problems/problem.hpp"\n',
    "methods/plugin/plugin.hpp": '#include "methods/method.hpp"\n#include "methods/plugin/interface.hpp"\n',
    "methods/solvers/lcp.hpp": "#pragma once\n",
    "methods/solvers/lcp.cpp": '#include "methods/solvers/lcp.hpp"\n\n#include <Eigen/LU>\n',
    "harness/page/html.cpp": "#include <regex>\n#include <boost/algorithm/string/split.hpp>\n",
    LIST: "# the list\n<Eigen/LU>  # 3 s\n  methods/solvers/lcp.cpp  # a solve\n<Eigen/Sparse[!C]*>\n\n"
          "<regex>\n  harness/page/  # patterns\n<boost/*>\n  harness/page/html.cpp  # split\n",
}


def check(planted):
    """Exit code and lines of the check on the sound tree with the planted files in place of its own."""
    with tempfile.TemporaryDirectory() as folder:
        for path, text in {**SOUND, **planted}.items():
            file = pathlib.Path(folder, path)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
        run = subprocess.run([sys.executable, "-B", SCRIPT, folder, f"{folder}/{LIST}"], capture_output=True, text=True, check=False)
        return run.returncode, run.stdout.splitlines() + run.stderr.splitlines()


class Dear(unittest.TestCase):
    def expect(self, planted, *lines):
        self.assertEqual(check(planted), (1 if lines else 0, list(lines)))

    def test_accept_a_sound_tree(self):
        self.expect({})

    def test_refuse_an_include_without_a_permission(self):
        self.expect({"methods/solvers/newton.cpp": "#include <vector>\n#  include <Eigen/LU>\n"},
                    "methods/solvers/newton.cpp:2: #include <Eigen/LU>: dear to compile, and not permitted by dear_includes.txt")

    def test_refuse_what_a_pattern_takes(self):
        self.expect({"methods/solvers/sparse.cpp": "#include <Eigen/SparseLU>\n#include <Eigen/SparseCore>\n"},
                    "methods/solvers/sparse.cpp:1: #include <Eigen/SparseLU>: dear to compile, and not permitted by dear_includes.txt")

    def test_permit_a_folder_and_what_is_below_it_alone(self):
        self.expect({"harness/page/deep/page.cpp": "#include <regex>\n"})
        self.expect({"harness/pages.cpp": "#include <regex>\n"},
                    "harness/pages.cpp:1: #include <regex>: dear to compile, and not permitted by dear_includes.txt")

    def test_refuse_a_permission_that_nothing_needs(self):
        self.expect({"methods/solvers/lcp.cpp": '#include "methods/solvers/lcp.hpp"\n'},
                    f"{LIST}:3: methods/solvers/lcp.cpp includes no <Eigen/LU>: no longer needed")
        self.expect({LIST: SOUND[LIST] + "<toml++/*>\n  problems/gone.cpp\n"},
                    f"{LIST}:11: problems/gone.cpp includes no <toml++/*>: no longer needed")

    def test_refuse_what_plugins_are_built_with_even_if_it_is_permitted(self):
        self.expect({"problems/problem.hpp": "#pragma once\n\n#include <Eigen/LU>\n",
                     LIST: SOUND[LIST].replace("  methods", "  problems/problem.hpp\n  methods")},
                    "problems/problem.hpp:3: #include <Eigen/LU>: dear to compile, and plugins are built with "
                    "methods/method.hpp -> problems/problem.hpp")

    def test_leave_a_header_that_no_plugin_reaches_to_the_list(self):
        self.expect({"methods/solvers/lcp.hpp": "#include <Eigen/LU>\n", "methods/solvers/lcp.cpp": "",
                     LIST: SOUND[LIST].replace("lcp.cpp", "lcp.hpp")})

    def test_refuse_a_list_that_is_none(self):
        self.expect({LIST: "<regex>\n  harness/page/ public\n"},
                    "dear_includes.txt:2: must be a header in <>, or below one, indented, a file or folder/")


if __name__ == "__main__":
    unittest.main()
