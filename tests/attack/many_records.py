#!/usr/bin/env python3
"""Runs of very many records, reported, merged and resumed: how much memory and time the program takes.

usage: many_records.py PROGRAM [--records N] [--fits] [--html] [--folder FOLDER]

Copies the records that are committed in results/ until there are N (1,000,000 unless told), each copy with a scene, a
key and a problem of its own and all else as it was measured, and calls

- `report` of the run: table.md, table.csv and measures.csv, with --html the pages too,
- `merge` of its two halves,
- `run --resume` of a run all of whose cases have such records.

Prints what each call took. Exit code 1 if one fails, loses a record, or takes MOST_MB or more. With --fits two reports, of
N / 5 and of N records, must differ by less than MOST_PER_RECORD bytes of memory per record; nothing else is called.
"""

import argparse
import hashlib
import json
import multiprocessing
import os
import pathlib
import random
import signal
import sys
import tempfile
import time

from attacked_program import Program
from load import METHODS, PER_SCENE, write_problems

ROOT = pathlib.Path(__file__).resolve().parents[2]
RUNS = ("catalogue", "hard", "article", "ablation", "sensitivity", "structures")
MOST_MB = 2048.0
MOST_PER_RECORD = 1500.0  # bytes; a whole record takes some 9 kB of memory
SECONDS = 3600.0  # of the processor, for any call


def committed(run):
    """The records of a committed run, without the motions that some keep."""
    lines = (ROOT / "results" / run / "records.jsonl").read_text().splitlines()
    records = [json.loads(line) for line in lines]
    for record in records:
        record.pop("waveforms", None)
        record["run"] = run
    return records


def digest(text):
    return hashlib.sha256(text.encode()).hexdigest()


def copy_of(record, number):
    """The record on copy `number` of its scene: no name, key or problem is of two copies."""
    fresh = dict(record)
    name, at, level = record["scene"].partition("@")
    fresh["scene"] = f"{name}-{fresh.pop('run')}-{number}{at}{level}"
    fresh["case"] = fresh["scene"] + record["case"][len(record["scene"]):]
    fresh["key"] = digest(f"{record['key']} {number}")
    if "problem" in fresh:
        fresh["problem"] = digest(f"{record['problem']} {number}")[:16]
    return fresh


class Writer:
    """A folder of a run: its records in any order, its plan and its manifest."""

    def __init__(self, folder, changes=None):
        folder.mkdir(parents=True)
        self.folder = folder
        manifest = json.loads((ROOT / "results/catalogue/manifest.json").read_text())
        (folder / "manifest.json").write_text(json.dumps(manifest | (changes or {})))
        self.records, self.plan = open(folder / "records.jsonl", "w"), open(folder / "plan.txt", "w")

    def add(self, record):
        self.records.write(json.dumps(record, separators=(",", ":")) + "\n")
        self.plan.write(f"{record['key']} {record['case']}\n")

    def close(self):
        self.records.close()
        self.plan.close()


def parts_of(folder, parts):
    return [folder / str(i + 1) for i in range(parts)] if parts > 1 else [folder]


def write_run(folder, count, parts=1):
    """So many records in FOLDER/1 to FOLDER/parts, scene by scene in turns. Of one part: in FOLDER itself."""
    templates = [record for run in RUNS for record in committed(run)]
    shards = [{"shard": f"{i + 1}/{parts}"} for i in range(parts)] if parts > 1 else [{}]
    writers = [Writer(part, shard) for part, shard in zip(parts_of(folder, parts), shards)]
    for number in range(count):
        copy = number // len(templates)
        writers[copy % parts].add(copy_of(templates[number % len(templates)], copy))
    for writer in writers:
        writer.close()


def apart(function, *arguments):
    """Calls it in a process of its own: the peak memory that the system tells of a program begins at that of the process
    which started it, and this one shall be small."""
    process = multiprocessing.Process(target=function, args=arguments)
    process.start()
    process.join()
    if process.exitcode != 0:
        raise RuntimeError(f"{function.__name__} failed")


def records_in(folder):
    """Lines of a run's records, and rows of its table without the header."""
    with open(folder / "records.jsonl", "rb") as lines, open(folder / "table.csv", "rb") as rows:
        return sum(1 for _ in lines), sum(1 for _ in rows) - 1


class Calls:
    """Calls of the program, printed and judged."""

    def __init__(self, program):
        self.program, self.failures = program, 0

    def call(self, words, arguments, folder, codes=(0,)):
        outcome = self.program.run(arguments, folder, SECONDS)
        print(f"{words}: {outcome.seconds:.1f} s, {outcome.processor_seconds:.1f} s of the processor, "
              f"{outcome.peak_mb:.0f} MiB", flush=True)
        found = self.program.violations(outcome, codes, MOST_MB)
        for violation in found:
            print(f"  {violation}: {outcome.err[-300:]!r}")
        self.failures += bool(found)
        return outcome

    def require(self, holds, words):
        if not holds:
            print(f"  {words}")
            self.failures += 1


def report(calls, folder, count, html):
    apart(write_run, folder / "run", count)
    formats = "md,csv,html" if html else "md,csv"
    calls.call(f"report of {count} records ({formats})", ["report", "run", "--format", formats], folder)
    calls.require(records_in(folder / "run") == (count, count), "the table does not hold every record")


def merge(calls, folder, count):
    apart(write_run, folder / "parts", count, 2)
    calls.call(f"merge of {count} records", ["merge", *map(str, parts_of(folder / "parts", 2)), "--out", "whole"], folder)
    calls.require(records_in(folder / "whole") == (count, count), "the merge does not hold every record")


def planned_run(program, folder, count):
    """Starts a run of so many cases, as load.py makes them, and kills it once it has written its plan."""
    write_problems(folder / "problems", count)
    program.environment["SIGNORINI_PROBLEMS"] = str(folder / "problems")
    methods = ":".join(f"{name}[{key}={'|'.join(map(str, values))}]" for name, (key, values) in METHODS.items())
    arguments = ["run", "load", "--methods", methods, "--resume", "--out", "resumed"]
    process = program.start(arguments, folder)
    while not (folder / "resumed/plan.txt").exists() and process.poll() is None:
        time.sleep(0.5)
    os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    return arguments


def resume(calls, folder, count):
    """A run that is complete: records of its keys, each as one of the same method was measured."""
    count = max(1, count // PER_SCENE) * PER_SCENE
    arguments = planned_run(calls.program, folder, count)
    apart(fill_records, folder)
    outcome = calls.call(f"resumption of a run of {count} records", arguments, folder)
    calls.require(b"0 cases run, %d already there" % count in b" ".join(outcome.out.split()), "a case was run again")
    calls.require(records_in(folder / "resumed") == (count, count), "a record is lost")


def fill_records(folder):
    """A record for each case of the plan in FOLDER/resumed."""
    templates = {}
    for record in committed("catalogue"):
        if record["status"] == "converged":
            templates.setdefault(record["method"], []).append(record)
    source = random.Random(1)
    with open(folder / "resumed/plan.txt") as plan, open(folder / "resumed/records.jsonl", "w") as lines:
        for line in plan:
            key, case = line.rstrip("\n").split(" ", 1)
            scene, resolution = case.split("/", 1)
            method, settings = resolution.rstrip("]").split("[")
            record = dict(source.choice(templates[method]), case=case, key=key, scene=scene, problem=digest(case)[:16])
            record.pop("run")
            record["settings"] = dict(setting.split("=") for setting in settings.split(","))
            lines.write(json.dumps(record, separators=(",", ":")) + "\n")


def fits(calls, folder, count):
    """Memory per record, from reports of fewer and of more."""
    peaks = []
    for records in (count // 5, count):
        apart(write_run, folder / str(records), records)
        arguments = ["report", str(records), "--format", "csv"]
        peaks.append(calls.call(f"report of {records} records (csv)", arguments, folder).peak_mb)
    per_record = (peaks[1] - peaks[0]) * 2.0**20 / (count - count // 5)
    print(f"{per_record:.0f} bytes per record")
    calls.require(per_record < MOST_PER_RECORD, f"more than {MOST_PER_RECORD:.0f} bytes of memory per record")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--records", type=int, default=1000000)
    parser.add_argument("--fits", action="store_true")
    parser.add_argument("--html", action="store_true")
    parser.add_argument("--folder", type=pathlib.Path, help="that has room for 6 kB per record; a temporary one")
    arguments = parser.parse_args()
    calls = Calls(Program(arguments.program))
    with tempfile.TemporaryDirectory(prefix="many-records-", dir=arguments.folder) as folder:
        folder = pathlib.Path(folder)
        if arguments.fits:
            fits(calls, folder, arguments.records)
        else:
            report(calls, folder, arguments.records, arguments.html)
            merge(calls, folder, arguments.records)
            resume(calls, folder, arguments.records)
    return 1 if calls.failures else 0


if __name__ == "__main__":
    sys.exit(main())
