#!/usr/bin/env python3
"""Checks the shape of the tree: include circles, the order of the rooms, namespaces of tests, sizes of files, folders and classes.

usage: rooms.py [ROOT]

Prints one line per offence, "file:line: what: the rule", and exits with 1 if there is one. The order of the rooms is
read from rooms.txt beside this script.
"""

import pathlib
import re
import sys

PARTS = ("problems", "methods", "harness")
FILE_LINES = 400
CLASS_LINES = 200
FOLDER_FILES = 25
ROOT_FILES = 20  # of harness/ itself

INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"')
NAMESPACE = re.compile(r"^namespace ([\w:]+) \{$")
CLASS = re.compile(r"\b(?:class|struct)\s+(\w+)[^;(){}=]*\{")
# Comments, raw strings, strings and characters: what may hold a brace that opens nothing.
OPAQUE = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])*\'', re.S)


class Rooms:
    """The order of the rooms: `of(unit)` is the name of a unit's room and its level, counted from the bottom."""

    def __init__(self, text):
        lines = [line.split("#")[0].split() for line in text.splitlines()]
        self.levels = {room: level for level, rooms in enumerate(filter(None, lines)) for room in rooms}

    def of(self, unit):
        if unit in self.levels:
            return unit, self.levels[unit]
        folder, _, _ = unit.rpartition("/")
        if folder in self.levels:
            return folder, self.levels[folder]
        above, _, _ = folder.rpartition("/")
        if f"{above}/*" in self.levels:
            return folder, self.levels[f"{above}/*"]
        return folder, None


def unit_of(path):
    """x.hpp and x.cpp are one unit: the path without its ending."""
    return path.rsplit(".", 1)[0]


def includes_of(text):
    """Line number and path of every include of our own."""
    for number, line in enumerate(text.splitlines(), 1):
        match = INCLUDE.match(line)
        if match and match[1].split("/")[0] in PARTS:
            yield number, match[1]


def order_offences(files, rooms):
    """Includes against the order of the rooms, and folders that have no place in it."""
    placeless = set()
    for path, text in files.items():
        room, level = rooms.of(unit_of(path))
        if level is None:
            if room not in placeless:
                yield f"{path}:1: {room}: the folder has no line in tests/architecture/rooms.txt"
            placeless.add(room)
            continue
        for number, target in includes_of(text):
            target_room, target_level = rooms.of(unit_of(target))
            if target_level is None or target_room == room or target_level < level:
                continue
            rule = "stands beside" if target_level == level else "stands above"
            yield f'{path}:{number}: #include "{target}": {target_room} {rule} {room}'


def circle_offences(files):
    """Circles of includes between units; one for each arrow that closes one, found in depth first."""
    arrows = {}
    for path, text in files.items():
        for number, target in includes_of(text):
            if unit_of(path) != unit_of(target):
                arrows.setdefault(unit_of(path), []).append((unit_of(target), f'{path}:{number}: #include "{target}"'))
    done = set()
    for start in sorted(arrows):
        trail, pending = [start], [iter(arrows[start])]
        while trail and start not in done:
            for target, place in pending[-1]:
                if target in trail:
                    yield f"{place}: circle " + " -> ".join(trail[trail.index(target):] + [target])
                elif target not in done:
                    trail.append(target)
                    pending.append(iter(arrows.get(target, [])))
                    break
            else:
                done.add(trail.pop())
                pending.pop()


def own_header_offences(files):
    """A source includes its own header first, so that every such header is known to compile alone."""
    for path, text in files.items():
        header = unit_of(path) + ".hpp"
        if path == header or header not in files:
            continue
        first = next((match[1] for match in map(INCLUDE.match, text.splitlines()) if match), None)
        before = text.split(f'"{header}"')[0]
        if first != header or re.search(r"^\s*#\s*include\s*<", before, re.M):
            yield f'{path}:1: its first include must be "{header}"'


def blanked(text):
    """The text with comments and strings emptied, line breaks kept."""
    return OPAQUE.sub(lambda match: " " + "\n" * match[0].count("\n"), text)


def class_offences(path, text):
    """Classes of a source that are longer than CLASS_LINES."""
    code = blanked(text)
    for match in CLASS.finditer(code):
        depth, end = 1, match.end()
        while depth and end < len(code):
            depth += {"{": 1, "}": -1}.get(code[end], 0)
            end += 1
        first = code.count("\n", 0, match.start()) + 1
        lines = code.count("\n", match.start(), end) + 1
        if lines > CLASS_LINES:
            yield f"{path}:{first}: class {match[1]} has {lines} lines: at most {CLASS_LINES} in a source"


def namespace_offences(files):
    """Tests are compiled several to a unit: what is a file's own lies in a namespace with its name."""
    for path, text in files.items():
        name = pathlib.PurePath(path).stem
        if not name.endswith("_test"):
            continue
        for number, line in enumerate(text.splitlines(), 1):
            match = NAMESPACE.match(line)
            if match and match[1].split("::")[-1] != name:
                yield f"{path}:{number}: namespace {match[1]}: what is a test's own lies in a namespace {name}"


def size_offences(root, files):
    for path, text in files.items():
        lines = text.count("\n")
        if lines > FILE_LINES:
            yield f"{path}:{FILE_LINES + 1}: the file has {lines} lines: at most {FILE_LINES}"
        if path.endswith(".cpp"):
            yield from class_offences(path, text)
    for part in ("methods", "harness"):
        for folder in sorted(path for path in [root / part, *(root / part).rglob("*")] if path.is_dir()):
            count = sum(path.is_file() and path.name != "CMakeLists.txt" for path in folder.iterdir())
            most = ROOT_FILES if folder == root / "harness" else FOLDER_FILES
            if count > most:
                yield f"{folder.relative_to(root)}:1: the folder holds {count} files: at most {most} beside CMakeLists.txt"


def sources(root, parts):
    """Path from the root -> text, of every C++ file of these parts of the tree."""
    paths = [path for part in parts for path in sorted((root / part).rglob("*.[hc]pp"))]
    return {str(path.relative_to(root)): path.read_text() for path in paths}


def offences(root):
    rooms = Rooms((pathlib.Path(__file__).parent / "rooms.txt").read_text())
    files = sources(root, PARTS)
    yield from order_offences(files, rooms)
    yield from circle_offences(files)
    yield from own_header_offences(files)
    yield from namespace_offences(sources(root, ("tests",)))
    yield from size_offences(root, {**files, **sources(root, ("tests", "examples"))})


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    found = list(offences(root))
    print(*found, sep="\n", end="\n" if found else "")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
