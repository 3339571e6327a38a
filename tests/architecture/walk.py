#!/usr/bin/env python3
"""Checks docs/architecture.md against the tree: every path or unit that it names exists, every function of its walk is defined
in the file named beside it, and every room has its line, in the order of rooms.txt.

usage: walk.py ROOT

Prints one line per offence and exits with 1 if there is one. A hop of the walk is a numbered line with a file and a
function, "3. `problems/scene/scene_file.cpp` `load_scene()`: ...".
"""

import pathlib
import re
import sys

MOST_HOPS = 12
PATH = re.compile(r"`((?:problems|methods|harness|tests|docs|examples|results)/[\w./*-]*)`")
PAIR = re.compile(r"`([\w./-]+\.[ch]pp)`,? `([\w:~]+)\(\)`")
HOP = re.compile(r"^\d+\. ", re.M)


def defines(text, function):
    """Whether a C++ text holds a definition, with a body, of a function or Class::function."""
    start = re.compile(rf"^[ \t]*(?:[\w:<>,&*\[\] ]+[\s&*])?{re.escape(function)}\(", re.M)
    for match in start.finditer(text):
        depth, end = 1, match.end()
        while depth and end < len(text):
            depth += {"(": 1, ")": -1}.get(text[end], 0)
            end += 1
        if re.match(r"\s*(?:const)?\s*(?:noexcept)?\s*(?:override|final)?\s*(?:[{:]|->)", text[end:]):
            return True
    return False


def offences(root):
    page = "docs/architecture.md"
    text = (root / page).read_text()
    for path in sorted(set(PATH.findall(text))):
        if not any(root.glob(path.rstrip("/"))) and not any(root.glob(path + ".[hc]pp")):
            yield f"{page}: {path} is not there"
    for file, function in PAIR.findall(text):
        if (root / file).is_file() and not defines((root / file).read_text(), function):
            yield f"{page}: {function}() is not defined in {file}"
    walk = text.partition("\n## A walk")[2].partition("\n## ")[0]
    hops = len(HOP.findall(walk))
    if not 1 <= hops <= MOST_HOPS or hops > len(PAIR.findall(walk)):
        yield f"{page}: the walk has {hops} hops, {len(PAIR.findall(walk))} with a file and a function (must be 1 to {MOST_HOPS}, all of them)"
    yield from room_offences(page, text, (root / "tests/architecture/rooms.txt").read_text())


def room_offences(page, text, rooms):
    """Rooms without a line "| `room` | ..." of the page, or in another order."""
    listed = re.findall(r"^\| `([\w/*]+)` ", text, re.M)
    expected = [room for line in rooms.splitlines() for room in line.split("#")[0].split()]
    for room in expected:
        if room not in listed:
            yield f"{page}: no line for the room {room}"
    for room in listed:
        if room not in expected:
            yield f"{page}: {room} is no room of tests/architecture/rooms.txt"
    if sorted(listed) == sorted(expected) and listed != expected:
        first = next(a for a, b in zip(listed, expected) if a != b)
        yield f"{page}: the rooms are not in the order of tests/architecture/rooms.txt, from {first} on"


def main():
    found = list(offences(pathlib.Path(sys.argv[1])))
    print(*found, sep="\n", end="\n" if found else "")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
