"""Tests of mirror.py: units without a test, and lines that have become untrue."""

import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import mirror  # noqa: E402


class Mirror(unittest.TestCase):
    def offences(self, covered):
        with tempfile.TemporaryDirectory() as folder:
            for path in ("harness/table.hpp", "harness/table.cpp", "harness/main.cpp", "tests/harness/table_test.cpp"):
                file = pathlib.Path(folder, path)
                file.parent.mkdir(parents=True, exist_ok=True)
                file.touch()
            return list(mirror.offences(pathlib.Path(folder), mirror.read_covered(covered)))

    def test_accepts_a_test_at_the_mirrored_path_or_a_line(self):
        self.assertEqual(self.offences("harness/main  tests/harness/table_test.cpp  # the program\n"), [])

    def test_refuses_a_unit_with_neither(self):
        self.assertEqual(self.offences(""), ["harness/main: no tests/harness/main_test.cpp, and no line in "
                                             "tests/architecture/covered.txt"])

    def test_refuses_lines_that_are_untrue(self):
        line = "harness/main tests/harness/table_test.cpp\n"
        self.assertEqual(self.offences(line + "harness/table tests/harness/table_test.cpp\n"),
                         ["harness/table: has its own test; its line in tests/architecture/covered.txt can go"])
        self.assertEqual(self.offences(line + "harness/gone tests/harness/table_test.cpp\n"),
                         ["harness/gone: in tests/architecture/covered.txt, but not in the tree"])
        self.assertEqual(self.offences("harness/main tests/none_test.cpp\n"),
                         ["harness/main: covered by tests/none_test.cpp, which is not there"])

    def test_refuses_a_test_that_no_program_is_made_of(self):
        with tempfile.TemporaryDirectory() as folder:
            tests = pathlib.Path(folder, "tests")
            (tests / "harness").mkdir(parents=True)
            for name in ("table_test.cpp", "stable_test.cpp"):
                (tests / "harness" / name).touch()
            (tests / "CMakeLists.txt").write_text("signorini_test(test_harness SOURCES\n  harness/stable_test.cpp)\n")
            self.assertEqual(list(mirror.unlisted(pathlib.Path(folder))),
                             ["tests/harness/table_test.cpp: in no CMakeLists.txt, so that nothing runs it"])


if __name__ == "__main__":
    unittest.main()
