#!/usr/bin/env python3
"""Checks who includes what is dear to compile: only files that dear_includes.txt names, and no header that plugins are
built with.

usage: dear.py [ROOT [PERMISSIONS]]

Prints one line per offence, "file:line: what: the rule", and exits with 1 if there is one. A permission that nothing uses
is one too, so that the list only shrinks. dear_includes.txt beside this script says how it is written.
"""

import fnmatch
import pathlib
import re
import sys

import rooms

ANY_INCLUDE = re.compile(r'^\s*#\s*include\s+[<"]([^>"]+)[>"]')
PUBLIC_ROOTS = ("methods/method.hpp", "methods/plugin/")  # what a plugin includes: a header, a folder


class Permission:
    """A line of the list: who (a file, or a folder with its slash) may include what matches the pattern."""

    def __init__(self, pattern, who, line):
        self.pattern, self.who, self.line, self.used = pattern, who, line, False

    def covers(self, path):
        return path == self.who or self.who.endswith("/") and path.startswith(self.who)


def read_permissions(text):
    """The patterns, and the permissions below each."""
    patterns, permissions = [], []
    for number, line in enumerate(text.splitlines(), 1):
        words = line.split("#")[0].split()
        if not words:
            continue
        if not line[0].isspace():
            patterns.append(words[0].strip("<>"))
            continue
        if not patterns or len(words) > 1:
            sys.exit(f"dear_includes.txt:{number}: must be a header in <>, or below one, indented, a file or folder/")
        permissions.append(Permission(patterns[-1], words[0], number))
    return patterns, permissions


def public_headers(files):
    """Header -> how a plugin comes to include it, from a root of the interface down."""
    chains = {path: [path] for path in files if path.endswith(".hpp") and path.startswith(PUBLIC_ROOTS)}
    pending = list(chains)
    while pending:
        path = pending.pop(0)
        for _, target in rooms.includes_of(files[path]):
            if target in files and target not in chains:
                chains[target] = [*chains[path], target]
                pending.append(target)
    return chains


def dear_includes(files, patterns):
    """File, line, header and pattern of each include of a dear header."""
    for path, text in files.items():
        for number, line in enumerate(text.splitlines(), 1):
            match = ANY_INCLUDE.match(line)
            if match:
                for pattern in patterns:
                    if fnmatch.fnmatchcase(match[1], pattern):
                        yield path, number, match[1], pattern
                        break


def offences(files, text):
    patterns, permissions = read_permissions(text)
    public = public_headers(files)
    for path, number, header, pattern in dear_includes(files, patterns):
        given = [p for p in permissions if p.pattern == pattern and p.covers(path)]
        for permission in given:
            permission.used = True
        if path in public:
            yield f"{path}:{number}: #include <{header}>: dear to compile, and plugins are built with " + " -> ".join(public[path])
        elif not given:
            yield f"{path}:{number}: #include <{header}>: dear to compile, and not permitted by dear_includes.txt"
    for permission in permissions:
        if not permission.used:
            yield (f"tests/architecture/dear_includes.txt:{permission.line}: {permission.who} includes no "
                   f"<{permission.pattern}>: no longer needed")


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    listed = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else pathlib.Path(__file__).parent / "dear_includes.txt"
    found = list(offences(rooms.sources(root, rooms.PARTS), listed.read_text()))
    print(*found, sep="\n", end="\n" if found else "")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
