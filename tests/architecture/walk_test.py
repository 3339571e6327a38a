"""Tests of walk.py: what it takes for a definition, and what it refuses of a page."""

import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import walk  # noqa: E402

SOURCE = """
#include "a.hpp"
double area(double width);
std::vector<int> Grid::sizes(int count) const {
  return area(2.0) > 1.0 ? std::vector<int>{} : sizes(count - 1);
}
Grid::Grid(int n) : n_(n) {}
inline double area(double width,
                   double height) {
  if (width > height(1)) { return 0.0; }
}
"""

PAGE = """# Architecture

| `problems` | data |
| `methods/*` | methods |

## A walk

1. `problems/scene.cpp` `load()`: a file becomes a problem.

## After it
"""


class Definitions(unittest.TestCase):
    def test_are_functions_with_a_body(self):
        for function in ("area", "Grid::sizes", "Grid::Grid"):
            self.assertTrue(walk.defines(SOURCE, function), function)

    def test_are_neither_declarations_nor_calls(self):
        self.assertFalse(walk.defines("double area(double width);\nint x = area(1);\n", "area"))
        for function in ("height", "sizes", "Grid::area", "are"):
            self.assertFalse(walk.defines(SOURCE, function), function)


class Page(unittest.TestCase):
    def offences(self, page, rooms="problems\nmethods/*\n"):
        with tempfile.TemporaryDirectory() as folder:
            files = {"docs/architecture.md": page, "tests/architecture/rooms.txt": rooms,
                     "problems/scene.cpp": "Problem load() {\n}\n", "methods/first/first.cpp": ""}
            for path, text in files.items():
                file = pathlib.Path(folder, path)
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(text)
            return list(walk.offences(pathlib.Path(folder)))

    def test_may_name_what_is_there(self):
        self.assertEqual(self.offences(PAGE), [])

    def test_is_refused_a_file_that_is_not_there(self):
        self.assertEqual(self.offences(PAGE + "See `methods/none.cpp`.\n"),
                         ["docs/architecture.md: methods/none.cpp is not there"])

    def test_is_refused_a_function_that_its_file_does_not_define(self):
        self.assertEqual(self.offences(PAGE.replace("`load()`", "`save()`")),
                         ["docs/architecture.md: save() is not defined in problems/scene.cpp"])

    def test_is_refused_a_walk_without_hops_or_with_too_many(self):
        for hops in (0, 13):
            page = PAGE.replace("1. `problems/scene.cpp` `load()`: a file becomes a problem.\n",
                                "1. `problems/scene.cpp` `load()`\n" * hops)
            self.assertRegex(self.offences(page)[0], rf"the walk has {hops} hops")

    def test_is_refused_a_missing_room_a_strange_one_and_another_order(self):
        self.assertEqual(self.offences(PAGE, "problems\nmethods/*\nharness\n"),
                         ["docs/architecture.md: no line for the room harness"])
        self.assertRegex(self.offences(PAGE, "problems\n")[0], r"methods/\* is no room")
        self.assertRegex(self.offences(PAGE, "methods/*\nproblems\n")[0], "not in the order")


if __name__ == "__main__":
    unittest.main()
