#!/usr/bin/env python3
"""planted_faults.py BUILD [--faults N] [--seed S] [--only GLOB] [--table FILE]: can the tests fail?

Plants one fault at a time, a sign, an operator, a constant or a branch, in a source of methods/ or harness/judge of a copy of the tree,
builds, and runs the tests: first those of the mirrored file, then those of its folder, then all that are neither slow nor long. Programs are
built as their turn comes. A test finds a fault if it passes without it. A fault that no test finds survives. Exit code 1 where more than one
in ten survive that tests/attack/planted_faults.txt does not know with a reason; 77 where the copy cannot stand in the tree's place (mount
name spaces need root).
"""
import argparse
import fnmatch
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

TREE = pathlib.Path(__file__).resolve().parents[2]
KNOWN = pathlib.Path(__file__).with_name("planted_faults.txt")
FOLDERS = ("methods", "harness/judge")
MOST_SURVIVORS = 0.1
SKIPPED = 77
QUICK = "-LE 'slow|long'"  # of ctest

# What is planted: a pattern of one place in a line, and what it becomes.
FAULTS = (
    ("sign", re.compile(r"(?<=[\w)\]] )\+(?= [\w(])"), "-"),
    ("sign", re.compile(r"(?<=[\w)\]] )-(?= [\w(])"), "+"),
    ("sign", re.compile(r"(?<=return )-(?=[\w(])"), ""),
    ("operator", re.compile(r"(?<=[\w)\]] )\*(?= [\w(])"), "+"),
    ("operator", re.compile(r"(?<=[\w)\]] )<(?= [\w(-])"), ">"),
    ("operator", re.compile(r"(?<=[\w)\]] )>(?= [\w(-])"), "<"),
    ("operator", re.compile(r"&&"), "||"),
    ("operator", re.compile(r"\|\|"), "&&"),
    ("constant", re.compile(r"(?<![\w.])0\.5(?!\d)"), "0.25"),
    ("constant", re.compile(r"(?<![\w.])2\.0(?!\d)"), "3.0"),
    ("constant", re.compile(r"(?<![\w.])1\.0(?![\de])"), "1.5"),
    ("branch", re.compile(r"(?<=if \().+(?=\) (?:return|continue|break)\b)"), "false"),
)
SUITE = re.compile(r"^TEST(?:_F|_P)?\(\s*(\w+)", re.MULTILINE)
# Lines that hold no code of a function's body.
PASSED_OVER = re.compile(r"^\s*(?://|#|template|static_assert|namespace|using|throw|fmt::|///)|\bthrow\b|\"|constexpr")


class Fault:
    def __init__(self, file, number, kind, before, after):
        self.file, self.number, self.kind, self.before, self.after = file, number, kind, before, after

    def __str__(self):
        return f"{self.file}:{self.number}: {self.kind}: {self.before.strip()} -> {self.after.strip()}"

    def key(self):
        """What planted_faults.txt knows it by: lines move."""
        return f"{self.file}: {self.before.strip()} -> {self.after.strip()}"


def code_of(line):
    return line.split("//")[0]


def faults_of(file):
    found = []
    for number, line in enumerate((TREE / file).read_text().splitlines(), 1):
        if PASSED_OVER.search(line):
            continue
        for kind, pattern, replacement in FAULTS:
            for match in pattern.finditer(code_of(line)):
                found.append(Fault(file, number, kind, line, line[:match.start()] + replacement + line[match.end():]))
    return found


def all_faults(only):
    files = sorted(str(path.relative_to(TREE)) for folder in FOLDERS for path in (TREE / folder).rglob("*.cpp"))
    return {file: faults for file in files if fnmatch.fnmatch(file, only) and (faults := faults_of(file))}


def drawn(faults, random_numbers):
    """Of a file in proportion to its places, so that each place is as likely as any other."""
    file = random_numbers.choices(list(faults), [len(places) for places in faults.values()])[0]
    return random_numbers.choice(faults[file])


def mirrored_suites(file):
    """The suites of the test file that mirrors a source, then those of the folder."""
    folder = TREE / "tests" / pathlib.PurePath(file).parent
    files = sorted(folder.glob("*_test.cpp"))
    for chosen in ([path for path in files if path.stem == pathlib.PurePath(file).stem + "_test"], files):
        yield {suite for path in chosen for suite in SUITE.findall(path.read_text())}


class NotBuilt(Exception):
    pass


class Copy:
    """A copy of the tree and of its build, in the tree's own place in a mount name space: what is built stays built."""

    def __init__(self, folder, build):
        self.path = pathlib.Path(folder) / "tree"
        tracked = subprocess.run(["git", "-C", TREE, "ls-files", "-z"], capture_output=True, check=True).stdout.split(b"\0")
        for name in filter(None, (word.decode() for word in tracked)):
            if (TREE / name).is_file():
                (self.path / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(TREE / name, self.path / name)
        self.build = build.relative_to(TREE)
        (self.path / self.build.parent).mkdir(parents=True, exist_ok=True)
        subprocess.run(["cp", "-a", "--reflink=auto", build, self.path / self.build.parent], check=True)

    def run(self, command, limit):
        words = ["unshare", "--mount", "sh", "-c", 'mount --bind "$1" "$2" && cd "$2" && sh -c "$3"', "sh", self.path, TREE, command]
        try:
            return subprocess.run(words, capture_output=True, text=True, timeout=limit, stdin=subprocess.DEVNULL)
        except subprocess.TimeoutExpired:
            return subprocess.CompletedProcess(words, 124, "", "")

    def make(self, programs=()):
        targets = f"--target {' '.join(programs)}" if programs else ""
        return self.run(f"cmake --build {self.build} --parallel {targets}", 3600).returncode == 0

    def tests(self):
        """All that are neither slow nor long, by name: the program of each."""
        listed = json.loads(self.run(f"ctest --test-dir {self.build} {QUICK} --show-only=json-v1", 600).stdout)["tests"]
        return {test["name"]: os.path.basename(test["command"][0]) for test in listed if "command" in test}

    def failing(self, names=None):
        """The first test that fails, of these or of all; nothing where all pass."""
        chosen = "" if names is None else "-R '^(" + "|".join(map(re.escape, names)) + ")$'"
        result = self.run(f"ctest --test-dir {self.build} --stop-on-failure {QUICK} -j2 {chosen}", 3600)
        failed = re.search(r"\d+ - (.+) \((?!Skipped|Not Run)", result.stdout)
        return failed.group(1) if failed else "a test without end" if result.returncode == 124 else None

    def found_by(self, fault, tests):
        """The test that finds a planted fault, nothing where all pass; NotBuilt where it leaves no program."""
        for suites in mirrored_suites(fault.file):
            names = [name for name in tests if set(re.split(r"[/.]", name)) & suites]
            if names:
                if not self.make({tests[name] for name in names}):
                    raise NotBuilt
                if test := self.failing(names):
                    return test
        if not self.make():
            raise NotBuilt
        return self.failing()

    def try_fault(self, fault, tests):
        """found, survived or not built, and by which test."""
        target = self.path / fault.file
        text = target.read_text()
        lines = text.splitlines(keepends=True)
        lines[fault.number - 1] = fault.after + "\n"
        target.write_text("".join(lines))
        try:
            test = self.found_by(fault, tests)
            return ("found", test) if test else ("survived", "")
        except NotBuilt:
            return "not built", ""
        finally:
            target.write_text(text)


def known_reasons():
    """Faults that no test need find, by Fault.key: a reason each."""
    reasons = {}
    for line in KNOWN.read_text().splitlines():
        if line and not line.startswith("#"):
            key, _, reason = line.partition(" | ")
            reasons[key] = reason
    return reasons


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--faults", type=int, default=3)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="*", help="files by glob")
    parser.add_argument("--table", type=pathlib.Path, help="writes what became of each fault")
    asked = parser.parse_args()
    build = asked.build.resolve()
    if subprocess.run(["unshare", "--mount", "true"], capture_output=True).returncode != 0 or TREE not in build.parents:
        print("skipped: a copy cannot stand in the tree's place")
        return SKIPPED
    faults, reasons = all_faults(asked.only), known_reasons()
    random_numbers = random.Random(asked.seed)
    rows, tried = [], set()
    with tempfile.TemporaryDirectory(prefix="planted-faults-") as folder:
        copy = Copy(folder, build)
        if not copy.make():
            print("the copy does not build")
            return 1
        if test := copy.failing():
            print(f"{test} fails without a fault")
            return 1
        tests = copy.tests()
        while len(rows) < asked.faults and len(tried) < sum(map(len, faults.values())):
            fault = drawn(faults, random_numbers)
            if fault.key() in tried:
                continue
            tried.add(fault.key())
            outcome, test = copy.try_fault(fault, tests)
            if outcome == "not built":
                continue
            if outcome == "survived" and fault.key() in reasons:
                outcome = "known: " + reasons[fault.key()]
            rows.append((outcome, test, fault))
            print(f"{outcome:9} {fault}{' by ' + test if test else ''}", flush=True)
    survived = [row for row in rows if row[0] == "survived"]
    print(f"seed {asked.seed}: {len(rows)} faults, {len(survived)} survived")
    if asked.table:
        asked.table.write_text("| fault | outcome | test |\n|---|---|---|\n" + "".join(f"| `{fault}` | {outcome} | {test} |\n" for outcome, test, fault in rows))
    return 1 if len(survived) > MOST_SURVIVORS * len(rows) else 0


if __name__ == "__main__":
    sys.exit(main())
