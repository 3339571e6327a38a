#!/usr/bin/env python3
"""Checks that every unit has its test at the mirrored path, or a line that says what covers it.

usage: mirror.py ROOT

harness/judge/orbit.{hpp,cpp} has tests/harness/judge/orbit_test.cpp. A unit without one stands in covered.txt beside
this script, "harness/main  tests/harness/command_line_test.cpp", and the test named there must exist. Every *_test.cpp is
in the list of a program: a CMakeLists.txt in its folder or above it names it. Prints one line per offence and exits with 1
if there is one.
"""

import pathlib
import re
import sys

PARTS = ("problems", "methods", "harness")


def units(root):
    paths = (path for part in PARTS for path in (root / part).rglob("*.[hc]pp"))
    return {str(path.relative_to(root).with_suffix("")) for path in paths}


def offences(root, covered):
    present = units(root)
    for unit in sorted(present):
        tested = (root / "tests" / f"{unit}_test.cpp").is_file()
        if not tested and unit not in covered:
            yield f"{unit}: no tests/{unit}_test.cpp, and no line in tests/architecture/covered.txt"
        if tested and unit in covered:
            yield f"{unit}: has its own test; its line in tests/architecture/covered.txt can go"
    for unit, tests in covered.items():
        if unit not in present:
            yield f"{unit}: in tests/architecture/covered.txt, but not in the tree"
        for test in tests:
            if not (root / test).exists():
                yield f"{unit}: covered by {test}, which is not there"


def words_of(file):
    return re.split(r"[\s()]+", file.read_text())


def unlisted(root):
    """Tests that no program is made of."""
    for test in sorted((root / "tests").rglob("*_test.cpp")):
        folders = [folder for folder in test.parents if root / "tests" in (folder, *folder.parents)]
        lists = ((folder, folder / "CMakeLists.txt") for folder in folders)
        if not any(file.is_file() and str(test.relative_to(folder)) in words_of(file) for folder, file in lists):
            yield f"{test.relative_to(root)}: in no CMakeLists.txt, so that nothing runs it"


def read_covered(text):
    lines = (line.split("#")[0].split() for line in text.splitlines())
    return {words[0]: words[1:] for words in lines if words}


def main():
    text = (pathlib.Path(__file__).parent / "covered.txt").read_text()
    root = pathlib.Path(sys.argv[1])
    found = [*offences(root, read_covered(text)), *unlisted(root)]
    print(*found, sep="\n", end="\n" if found else "")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
