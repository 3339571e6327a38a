#!/usr/bin/env python3
"""Each header compiles by itself: it includes all that it needs, whatever units are compiled as one.

usage: headers.py ROOT BUILD [--jobs N] [HEADER...]

Compiles every header below problems/, methods/, harness/ and tests/, or those named, alone, with the flags of the build
folder BUILD and without its precompiled header. Prints the first complaint of each that does not compile, and the
seconds of the five longest; exit code 1 if there is one.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import time

ROOMS = ("problems", "methods", "harness", "tests")
LONGEST = 5  # that are told


def flags_of(build):
    """The compiler and its flags, without what belongs to one source: input, output, precompiled header."""
    command = json.loads((build / "compile_commands.json").read_text())[0]["command"]
    words, kept = shlex.split(command), []
    skip = False
    for word in words:
        if skip:
            skip = False
        elif word in ("-o", "-c", "-include"):
            skip = True
        elif word != "-Winvalid-pch":
            kept.append(word)
    return [word for word in kept if os.path.basename(word) != "ccache"]


def headers_of(root):
    """All headers, by their paths from the root."""
    return sorted(str(file.relative_to(root)) for room in ROOMS for file in (root / room).rglob("*.hpp"))


def complaint_of(root, flags, header):
    """The first error of a unit of this header alone, or nothing; and the seconds that it takes."""
    began = time.monotonic()
    unit = f'#include "{header}"\n'
    result = subprocess.run([*flags, "-O0", f"-I{root}", "-fsyntax-only", "-x", "c++", "-"], input=unit, cwd=root,
                            capture_output=True, text=True)
    errors = [line for line in result.stderr.splitlines() if re.search(r"\berror\b", line)]
    complaint = None if result.returncode == 0 else (errors or result.stderr.splitlines() or ["no message"])[0]
    return complaint, time.monotonic() - began


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("header", nargs="*")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    arguments = parser.parse_args()
    root, flags = arguments.root.resolve(), flags_of(arguments.build)
    headers = arguments.header or headers_of(root)
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        results = list(pool.map(lambda header: complaint_of(root, flags, header), headers))
    failed = [(header, complaint) for header, (complaint, _) in zip(headers, results) if complaint]
    for header, complaint in failed:
        print(f"{header}: {complaint}")
    longest = sorted(zip((seconds for _, seconds in results), headers), reverse=True)[:LONGEST]
    print(f"{len(headers)} headers, {len(failed)} do not compile alone; longest: "
          + ", ".join(f"{header} {seconds:.1f} s" for seconds, header in longest))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
