#!/usr/bin/env python3
"""Runs the fuzzers of a build with the preset fuzz, one after another, and says what they found.

usage: fuzz.py FOLDER [--seconds N] [--only NAME] [--record FILE] [--minimise]

FOLDER holds the programs fuzz_scene, fuzz_matrix and so on, one of each reader (build/fuzz/tests/attack).
Inputs that broke a promise are kept in FOLDER/findings, what reached new code in FOLDER/found. The record, results/fuzz.json
unless told, has one entry for each fuzzer and program, from which attack.py makes its table. Each fuzzer runs for so many
seconds of processor time, an hour unless told, which are added to the record every ten minutes at most. Several may run at
once, each with --only. With --minimise the smallest inputs that reach what was reached are added to tests/attack/corpus.
Exit code 1 if something was found.
"""

import argparse
import fcntl
import hashlib
import json
import os
import pathlib
import re
import resource
import subprocess
import sys
import tempfile

ATTACK = pathlib.Path(__file__).resolve().parents[1]
TREE = ATTACK.parents[1]
# What else a fuzzer begins with.
SEEDS = {"scene": ["problems/families"], "matrix": ["problems/catalogue/matrices-cantilever"],
         "mesh": [], "records": [], "answer": [], "branches": [], "archive": [], "pack": [], "options": [], "curves": [], "suite": ["problems/suites"]}
LONGEST = 8192  # of an input [bytes]
SECONDS, MEMORY_MB = 25, 4096  # of one input, with sanitizers
MOST_FILES = 24  # of a corpus in the tree
DICTIONARY = re.compile(rb"[A-Za-z][A-Za-z0-9_-]{2,30}")


def write_dictionary(reader, file):
    """The words of the corpus, which the fuzzer would otherwise have to guess letter by letter."""
    texts = b" ".join(path.read_bytes() for path in (ATTACK / "corpus" / reader).iterdir())
    words = sorted(set(DICTIONARY.findall(texts)))
    file.write_bytes(b"".join(b'"' + word + b'"\n' for word in words))


def figure(name, text):
    found = re.findall(rf"stat::{name}:\s+(\d+)", text)
    return int(found[-1]) if found else 0


def command_of(folder, reader, seconds):
    """The fuzzer for so many seconds by the clock, or until its first finding."""
    return [folder / f"fuzz_{reader}", folder / "found" / reader, ATTACK / "corpus" / reader,
            *(TREE / seed for seed in SEEDS[reader]), f"-max_total_time={max(1, int(seconds))}", f"-timeout={SECONDS}",
            f"-rss_limit_mb={MEMORY_MB}", f"-max_len={LONGEST}", f"-dict={folder}/{reader}.dict", "-close_fd_mask=3",
            "-print_final_stats=1", "-use_value_profile=1", f"-artifact_prefix={folder}/findings/{reader}-"]


def processor_seconds():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def is_slow(folder, reader, path):
    """Whether an input that was slow by the clock takes as much processor time alone, on a machine that does other things."""
    before = processor_seconds()
    try:
        subprocess.run([folder / f"fuzz_{reader}", path], cwd=folder, capture_output=True, timeout=20 * SECONDS)
    except subprocess.TimeoutExpired:
        return True
    return processor_seconds() - before > SECONDS


def new_findings(folder, reader, before):
    """What has been found since, without inputs that were slow because the machine was busy."""
    for path in set((folder / "findings").glob(f"{reader}-*")) - before:  # others may be running
        by_clock = path.name.startswith((f"{reader}-timeout-", f"{reader}-slow-unit-"))
        if by_clock and not is_slow(folder, reader, path):
            path.unlink()
        else:
            yield path.name


def commit():
    """Of the tree that the fuzzers are taken to be built from."""
    named = subprocess.run(["git", "-C", TREE, "describe", "--always", "--abbrev=12", "--dirty=, changed"],
                           capture_output=True, text=True)
    return named.stdout.strip()


class Record:
    """The entries of all fuzzers and programs in one file, which several processes may write to."""

    def __init__(self, path):
        self.path = path

    def entries(self):
        return json.loads(self.path.read_text()) if self.path.exists() else []

    def begun(self, folder, reader):
        """What this program has done so far."""
        program = hashlib.sha256((folder / f"fuzz_{reader}").read_bytes()).hexdigest()[:16]
        empty = {"reader": reader, "program": program, "commit": commit(), "seconds": 0.0, "executions": 0, "peak_mb": 0,
                 "findings": []}
        return next((entry for entry in self.entries() if is_same(entry, empty)), empty)

    def save(self, entry):
        """In place of what the same program did before."""
        lock = os.open(self.path.parent, os.O_RDONLY)
        try:
            fcntl.flock(lock, fcntl.LOCK_EX)
            entries = sorted([*(other for other in self.entries() if not is_same(other, entry)), entry],
                             key=lambda one: (list(SEEDS).index(one["reader"]), one["commit"], one["program"]))
            draft = self.path.with_suffix(".draft")
            draft.write_text(json.dumps(entries, indent=2) + "\n")
            draft.replace(self.path)
        finally:
            os.close(lock)


def is_same(one, other):
    return (one["reader"], one["program"]) == (other["reader"], other["program"])


def fuzz(folder, reader, seconds, record):
    """Runs one fuzzer for so many seconds, anew after each finding and every ten minutes."""
    for path in (folder / "found" / reader, folder / "findings"):
        path.mkdir(parents=True, exist_ok=True)
    write_dictionary(reader, folder / f"{reader}.dict")
    entry = record.begun(folder, reader)
    before = set((folder / "findings").iterdir())
    began, earlier, findings = processor_seconds(), entry["seconds"], set(entry["findings"])
    while (left := seconds - (processor_seconds() - began)) > 1:
        run = subprocess.run(command_of(folder, reader, min(600.0, left)), cwd=folder, capture_output=True)
        text = run.stderr.decode(errors="replace")
        (folder / f"{reader}.log").write_text(text[-200000:])
        entry["seconds"] = round(earlier + processor_seconds() - began, 1)
        entry["executions"] += figure("number_of_executed_units", text)
        entry["peak_mb"] = max(entry["peak_mb"], figure("peak_rss_mb", text))
        judged = {path.name for path in (folder / "findings").iterdir()}
        findings |= set(new_findings(folder, reader, before))
        # An input that was too slow once, and not when it was judged again, is none.
        findings -= {name for name in judged if not (folder / "findings" / name).exists()}
        entry["findings"] = sorted(findings)
        record.save(entry)


def minimise(folder, reader):
    """Of what reaches all that was reached, the smallest inputs join the corpus of the tree, up to its limit."""
    corpus = ATTACK / "corpus" / reader
    with tempfile.TemporaryDirectory() as merged:
        command = [folder / f"fuzz_{reader}", "-merge=1", "-close_fd_mask=3", merged, folder / "found" / reader]
        subprocess.run(command, check=True, capture_output=True)
        smallest = sorted(pathlib.Path(merged).iterdir(), key=lambda path: path.stat().st_size)
        for path in smallest[len(smallest) // 2:][:MOST_FILES - len(list(corpus.iterdir()))]:
            (corpus / f"found-{path.name[:8]}").write_bytes(path.read_bytes())


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--seconds", type=float, default=3600.0, help="of processor time, each, beside what the record has")
    parser.add_argument("--only", choices=list(SEEDS))
    parser.add_argument("--record", type=pathlib.Path, default=TREE / "results/fuzz.json")
    parser.add_argument("--minimise", action="store_true")
    arguments = parser.parse_args()
    folder = arguments.folder.resolve()
    record = Record(arguments.record)
    for reader in [arguments.only] if arguments.only else SEEDS:
        fuzz(folder, reader, arguments.seconds, record)
        entries = [entry for entry in record.entries() if entry["reader"] == reader]
        findings = [name for entry in entries for name in entry["findings"]]
        print(f"{reader}: in all {sum(entry['executions'] for entry in entries)} inputs in "
              f"{sum(entry['seconds'] for entry in entries):.0f} s, {len(findings)} findings, largest "
              f"{max((entry['peak_mb'] for entry in entries), default=0)} MiB", *findings, sep="\n  ", flush=True)
        if arguments.minimise:
            minimise(folder, reader)
    return 1 if any(entry["findings"] for entry in record.entries()) else 0


if __name__ == "__main__":
    sys.exit(main())
