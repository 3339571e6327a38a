#!/usr/bin/env python3
"""How near the program is to what cannot be left out: results/limits, each line measured in this one run.

usage: limits.py BUILD [--before PROGRAM] [--only LINE ...] [--repetitions N] [--records N] [--source FOLDER] [--out FOLDER]

BUILD is the folder of a Release build, in which the benchmarks are built if they are not yet. With --before an older `signorini` is measured beside it, in
turns. Lines, by name: exact-orbit, fourier, hat, curve, judge, case, records, build. `records` reports and merges N
synthetic records (1,000,000 unless told; some minutes), `build` compiles the tree FOLDER anew and runs its tests (half an
hour; no program of BUILD is needed): both only where they are named in --only. Lines that are not measured keep what FOLDER/limits.csv has of them.

Writes limits.csv, units.csv (of a build, the units that take longest), table.md and manifest.json into FOLDER, results/limits unless told. docs/performance.md says what each
limit is and what was tried.
"""

import argparse
import csv
import json
import math
import os
import pathlib
import platform
import re
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

import build_cost

ROOT = pathlib.Path(__file__).resolve().parents[2]
COLUMNS = ("line", "what", "limit", "limit_seconds", "seconds", "ratio", "before_seconds", "gain", "goal", "reached", "commit",
           "before", "wall_seconds", "load", "peak_mib")
UNIT_COLUMNS = ("unit", "seconds", "ratio", "mib", "commit")
SEED = 20261125
PATIENCE = 10.0  # for one solve [s]


class Bench:
    """The programs under measurement: `now`, and an older one where there is one."""

    def __init__(self, arguments):
        self.build = arguments.build.resolve()
        self.now = self.build / "harness/signorini"
        self.before = arguments.before.resolve() if arguments.before else None
        self.repetitions = arguments.repetitions
        self.records = arguments.records
        self.source = arguments.source
        self.google = {}
        self.units = None

    def programs(self):
        return [program for program in (self.now, self.before) if program]

    def in_turns(self, measure):
        """The smallest of some measurements of each program, in turns; None of a program that failed once."""
        times = {program: [] for program in self.programs()}
        for _ in range(self.repetitions):
            for program, measured in times.items():
                if None not in measured:
                    measured.append(measure(program))
        best = {program: None if None in measured else min(measured) for program, measured in times.items()}
        if best[self.now] is None:
            sys.exit("limits: the program did not converge on what it is measured by")
        return best[self.now], best.get(self.before)

    def solve(self, program, scene, method, **options):
        """The record of one solve without its judgement; None where it does not converge."""
        command = [program, "solve", scene, "--method", method, "--json"]
        for key, value in options.items():
            command += ["--set", f"{key}={value}"]
        try:
            answer = subprocess.run([*command, "--certificate", "0"], capture_output=True, text=True, check=False, timeout=PATIENCE)
            if answer.returncode == 2:  # older programs always judge as they did
                answer = subprocess.run(command, capture_output=True, text=True, check=False, timeout=PATIENCE)
        except subprocess.TimeoutExpired:
            return None
        record = json.loads(answer.stdout) if answer.stdout.startswith("{") else {}
        return record if record.get("status") == "converged" else None

    def whole(self, scene, method, **options):
        """Set-up and solve, of both programs."""

        def measure(program):
            record = self.solve(program, scene, method, **options)
            return record["seconds"]["setup"] + record["seconds"]["solve"] if record else None

        return self.in_turns(measure)

    def first(self, scene, method, **options):
        """Set-up and solve as the first of a process, of both programs; None of one that does not tell it."""

        def measure(program):
            record = self.solve(program, scene, method, **options)
            return record["seconds"].get("first") if record else None

        return self.in_turns(measure)

    def benchmark(self, program, name):
        """Seconds per iteration of a line of a Google Benchmark program, the fastest repetition."""
        if program not in self.google:
            subprocess.run(["cmake", "--build", self.build, "--target", program], stdout=subprocess.DEVNULL, check=True)
            command = [self.build / "tests" / program, "--benchmark_format=json", "--benchmark_repetitions=5"]
            answer = subprocess.run(command, capture_output=True, text=True, check=True)
            self.google[program] = json.loads(answer.stdout)["benchmarks"]
        unit = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}
        times = [entry["real_time"] * unit[entry["time_unit"]] for entry in self.google[program]
                 if entry.get("run_name", entry["name"]).split("/real_time")[0] == name and entry["run_type"] == "iteration"]
        return min(times)


def row(line, what, limit, limit_seconds, seconds, before, goal, reached):
    return {"line": line, "what": what, "limit": limit, "limit_seconds": limit_seconds, "seconds": seconds,
            "ratio": seconds / limit_seconds if limit_seconds else None, "before_seconds": before,
            "gain": before / seconds if before and seconds else None, "goal": goal, "reached": reached}


def run_suite(program, suite, *options):
    """The records of a run in a folder of its own, by case, its wall time and the processor time of all its processes."""
    with tempfile.TemporaryDirectory() as folder:
        command = [program, "run", suite, "--out", f"{folder}/run", *options]
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        begun = time.perf_counter()
        subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
        wall = time.perf_counter() - begun
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        processor = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        file = pathlib.Path(folder, "run/records.jsonl")
        lines = file.read_text().splitlines() if file.exists() else []
        return {record["case"]: record for record in map(json.loads, lines)}, wall, processor


def geometric_mean(values):
    return math.exp(statistics.fmean(math.log(value) for value in values))


def exact_orbit(bench):
    methods = "exact-orbit[samples=64]:event-driven[flow=cvode|modal,tolerance=1e-6]"
    seconds = {}
    for program in bench.programs():
        runs, _, _ = run_suite(program, "catalogue", "--methods", methods, "--seed", str(SEED))
        seconds[program] = {name: record["seconds"]["min"] for name, record in runs.items()
                            if record["status"] == "converged" and record.get("certificate", {}).get("status") != "refuted"}
    rows = []
    for flow, name, goal in (("cvode", "CVODE marching at 1e-6", 100), ("modal", "closed-form marching at 1e-6", 3.5)):
        pairs = {}
        for program, times in seconds.items():
            pairs[program] = {}
            for label, own in times.items():
                scene, method = label.split("/", 1)
                other = times.get(f"{scene}/event-driven[flow={flow},tolerance=1e-6]")
                if method.startswith("exact-orbit") and other:
                    pairs[program][scene] = (own, other)
        # Of two programs the scenes that both solve; fewer than before would be no gain.
        scenes = set.intersection(*(set(found) for found in pairs.values()))
        if not scenes or len(pairs[bench.now]) < len(pairs.get(bench.before, {})):
            sys.exit("limits: fewer scenes are solved than before")
        own, other = ([pairs[bench.now][scene][k] for scene in sorted(scenes)] for k in (0, 1))
        ratio = geometric_mean([b / a for a, b in zip(own, other)])
        before = geometric_mean([pairs[bench.before][scene][0] for scene in sorted(scenes)]) if bench.before else None
        rows.append(row("exact-orbit", f"exact-orbit on {len(scenes)} scenes of catalogue, geometric mean: {ratio:.3g} times as fast",
                        name, geometric_mean(other), geometric_mean(own), before, f"{goal} times as fast", ratio >= goal))
    # The limit proper: one coarse problem on 64 nodes.
    coarse, _ = bench.whole("sdof-stop", "hat-lcp", samples=64, solver="pivoting")
    orbit, before = bench.whole("sdof-stop", "exact-orbit", samples=64)
    first, first_before = bench.first("sdof-stop", "exact-orbit", samples=64)
    rows.append(row("exact-orbit", "sdof-stop, the least of a round", "one coarse problem on 64 nodes", coarse, orbit, before, "", ""))
    rows.append(row("exact-orbit", "sdof-stop, the first of a process", "the least of a round", orbit, first, first_before,
                    "5 times the least", first <= 5 * orbit))
    return rows


def fourier(bench):
    rows = []
    for harmonics in (20, 80, 320, 1280):
        limit = bench.benchmark("limits_benchmark", f"harmonic_step/{harmonics}")
        now, before = bench.whole("sdof-stop", "closed-hbm", harmonics=harmonics)
        steps = bench.solve(bench.now, "sdof-stop", "closed-hbm", harmonics=harmonics)["work"]["iterations"]
        goal, reached = "at most 60 steps", steps <= 60
        if harmonics == 1280:
            goal, reached = "at most 60 steps, 100 ms", reached and now <= 0.1
        rows.append(row("fourier", f"closed-hbm on sdof-stop, H = {harmonics}: {steps} Newton steps",
                        "60 times a pair of transforms and H solves", 60 * limit, now, before, goal, reached))
    return rows


def hat(bench):
    rows = []
    for nodes, goal in ((1024, None), (16384, None), (65536, 0.050)):
        limit = bench.benchmark("limits_benchmark", f"transform_pair/{nodes}")
        now, before = bench.whole("sdof-stop", "hat-lcp", samples=nodes)
        pivots = bench.solve(bench.now, "sdof-stop", "hat-lcp", samples=nodes)["work"]["pivots"]
        rows.append(row("hat", f"hat-lcp on sdof-stop, N = {nodes}: {pivots} pivots", "a pair of transforms", limit, now,
                        before, f"{1e3 * goal:g} ms" if goal else "", now <= goal if goal else ""))
    for scene in ("chain10-stops", "beam20-ten-stops"):
        limit = 10 * bench.benchmark("limits_benchmark", "transform_pair/1024")
        now, before = bench.whole(scene, "hat-lcp", samples=1024)
        rows.append(row("hat", f"hat-lcp on {scene}, N = 1024", "ten pairs of transforms", limit, now, before, "30 ms",
                        now <= 0.030))
    return rows


def curve(bench):
    """A branch with stability: points per second of the processor, search for its beginning included."""
    points = {}

    def measure(program):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        answer = subprocess.run([program, "sweep", "sdof-stop", "--methods", "exact-orbit", "--from", "1.5", "--to", "3"],
                                capture_output=True, text=True, check=False)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        found = sum(int(count) for count in re.findall(r": (\d+) points", answer.stdout))
        if not found:
            return None
        points[program] = found
        return (after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime) / found

    now, before = bench.in_turns(measure)
    two, _ = bench.whole("sdof-stop", "exact-orbit", samples=64)
    return [row("curve", f"a point of sdof-stop's branches by arc length, stability included ({points[bench.now]} points)",
                "a solve, the least of a round", two, now, before, "1,000 points a second", now <= 1e-3)]


def judge(bench):
    options = ("--seed", str(SEED), "--repetitions", "1", "--scenes", "sdof-stop:sdof-stop-e0*:chain2-stop:chain2-penalty")

    def measure(program, *more):
        """Least wall and processor time of three runs, the methods' own time, and the cases."""
        runs = [run_suite(program, "catalogue", *options, *more) for _ in range(3)]
        names = {frozenset(records) for records, _, _ in runs}
        if len(names) != 1 or not runs[0][0]:
            sys.exit("limits: a run has not all of its records")
        own = min(sum((record.get("seconds") or {}).get("min") or 0.0 for record in records.values()) for records, _, _ in runs)
        return min(wall for _, wall, _ in runs), min(used for _, _, used in runs), own, names.pop()

    wall, processor, own, names = measure(bench.now)
    both, _, _, in_two = measure(bench.now, "--jobs", "2")
    if names != in_two:
        sys.exit("limits: a run of two jobs has other records")
    before, gain = None, ""
    if bench.before:
        _, before, own_before, names_before = measure(bench.before)
        if names_before != names:
            print("limits: the older program runs other cases; the judge is not compared")
            before = None
        else:
            gain = processor - own <= 0.5 * (before - own_before)
    return [row("judge", f"{len(names)} cases of catalogue, one round, processor time of all processes", "the methods' own time", own,
                processor, before, "half of the judge's time saved", gain),
            row("judge", "the same with --jobs 2, wall time", "half the wall time of --jobs 1", wall / 2, both, None,
                "1.8 times the cases", wall / both >= 1.8)]


def case(bench):
    empty = bench.benchmark("harness_benchmark", "empty_process")
    whole = bench.benchmark("harness_benchmark", "overhead_per_case")
    return [row("case", "a case whose method gives up at once, wall time", "an empty process", empty, whole, None,
                "2 ms above it", whole - empty <= 2e-3)]


def records(bench):
    """`report` of N synthetic records; its memory is the goal."""
    command = [sys.executable, ROOT / "tests/attack/many_records.py", bench.now, "--records", str(bench.records)]
    begun = time.perf_counter()
    answer = subprocess.run(command, capture_output=True, text=True, check=False)
    print(answer.stdout)
    rows = []
    for name, seconds, mebibytes in re.findall(r"^([^:\n]+): ([\d.]+) s, [\d.]+ s of the processor, (\d+) MiB", answer.stdout, re.M):
        rows.append(row("records", f"{name}: {mebibytes} MiB", "", None, float(seconds), None, "2 GiB, minutes",
                        float(mebibytes) < 2048))
    if answer.returncode != 0 or not rows:
        sys.exit(f"limits: many_records.py ended with {answer.returncode} after {time.perf_counter() - begun:.0f} s")
    return rows


def build(bench):
    """The tree, cloned and compiled anew without a compiler cache, beside one fixed source; its units go into bench.units."""
    lines, units = build_cost.build_lines(bench.source)
    bench.units = [unit | {"commit": lines[0]["commit"]} for unit in units]
    return [row("build", line["what"], "one source with three decompositions", line["reference"], line["seconds"], None, line["goal"],
                line["reached"]) | {"wall_seconds": line["wall"], "load": line["load"], "peak_mib": line["mib"], "commit": line["commit"]}
            for line in lines]


LINES = {"exact-orbit": exact_orbit, "fourier": fourier, "hat": hat, "curve": curve, "judge": judge, "case": case,
         "records": records, "build": build}
UNASKED = [name for name in LINES if name not in ("records", "build")]


def short(seconds):
    if seconds in (None, ""):
        return ""
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("us", 1e-6)):
        if float(seconds) >= size:
            return f"{float(seconds) / size:.3g} {unit}"
    return f"{float(seconds) * 1e9:.3g} ns"


def plain(value):
    return "" if value in (None, "") else f"{float(value):.3g}"


def table(head, rows):
    return "\n".join(f"| {' | '.join(cells)} |" for cells in (head, ["---"] * len(head), *rows)) + "\n"


def write_table(rows, units, file):
    words = {"True": "yes", "False": "no", "": ""}
    commits = sorted({f"{r['commit']} after {r['before']}" if r["before"] else r["commit"] for r in rows})
    text = ("# Limits\n\nMeasured by tests/benchmarks/limits.py, the fastest of some repetitions in turns; commits: "
            f"{', '.join(commits)}. "
            "What the limits are and what was tried: [docs/performance.md](../../docs/performance.md).\n\n")
    text += table(["what", "beside its limit, or another way", "that takes", "takes", "ratio", "before", "gain", "goal", "reached"],
                  [[r["what"], r["limit"], short(r["limit_seconds"]), short(r["seconds"]), plain(r["ratio"]), short(r["before_seconds"]),
                    plain(r["gain"]), r["goal"], words[str(r["reached"])]] for r in rows if r["line"] != "build"])
    built = [r for r in rows if r["line"] == "build"]
    if built:
        text += "\n## Build\n\nProcessor time over that of one fixed source, compiled alone; two jobs.\n\n"
        # Older rows have the wall time alone.
        text += table(["what", "processor", "ratio", "wall", "load before", "largest process", "goal", "reached"],
                      [[r["what"], short(r["seconds"]) if r["wall_seconds"] else "", plain(r["ratio"]), short(r["wall_seconds"] or r["seconds"]),
                        plain(r["load"]), f"{float(r['peak_mib']):.0f} MiB" if r["peak_mib"] else "", r["goal"], words[str(r["reached"])]]
                       for r in built])
    if units:
        text += f"\nUnits that take more than {build_cost.DEAR} of that source:\n\n"
        text += table(["unit", "processor", "ratio", "memory"],
                      [[u["unit"], short(u["seconds"]), plain(u["ratio"]), f"{float(u['mib']):.0f} MiB"] for u in units])
    file.write_text(text)


def read_rows(file, columns):
    """The rows of a table, with empty cells for columns that it has not yet; none where there is no table."""
    if not file.exists():
        return []
    with file.open(newline="") as lines:
        return [dict.fromkeys(columns, "") | entry for entry in csv.DictReader(lines)]


def write_rows(file, columns, rows):
    with file.open("w", newline="") as lines:
        writer = csv.DictWriter(lines, columns, lineterminator="\n", restval="")
        writer.writeheader()
        writer.writerows(rows)


def commit_of(program):
    """The commit that a program was built of, as it says; none of a program that is not there."""
    if not program or not shutil.which(str(program)):
        return ""
    version = subprocess.run([program, "--version"], capture_output=True, text=True, check=False).stdout
    found = re.search(r"\(([^)]*)\)", version)
    return found[1] if found else "unknown"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=pathlib.Path, help="folder of a Release build")
    parser.add_argument("--before", type=pathlib.Path, help="an older program")
    parser.add_argument("--only", nargs="+", choices=LINES, default=UNASKED, metavar="LINE", help=", ".join(LINES))
    parser.add_argument("--repetitions", type=int, default=9)
    parser.add_argument("--records", type=int, default=1_000_000)
    parser.add_argument("--source", type=pathlib.Path, default=ROOT, help="the tree that `build` clones")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "results/limits")
    arguments = parser.parse_args()
    bench = Bench(arguments)
    for program in bench.programs() if arguments.only != ["build"] else ():
        if not shutil.which(str(program)):
            sys.exit(f"limits: {program}: no such program")
    arguments.out.mkdir(parents=True, exist_ok=True)
    rows = read_rows(arguments.out / "limits.csv", COLUMNS)
    units = read_rows(arguments.out / "units.csv", UNIT_COLUMNS)
    for name in arguments.only:
        commits = {"commit": commit_of(bench.now), "before": commit_of(bench.before) if name != "build" else ""}
        fresh = [dict.fromkeys(COLUMNS, "") | commits | entry for entry in LINES[name](bench)]
        for entry in fresh:
            print(f"{entry['what']}: {short(entry['seconds'])}, limit {short(entry['limit_seconds'])}, "
                  f"before {short(entry['before_seconds'])}", flush=True)
        rows = [entry for line in LINES for entry in (fresh if line == name else [r for r in rows if r["line"] == line])]
        if name == "build":
            units = bench.units
            write_rows(arguments.out / "units.csv", UNIT_COLUMNS, units)
        write_rows(arguments.out / "limits.csv", COLUMNS, rows)
        write_table(rows, units, arguments.out / "table.md")
    manifest = {"program": fresh[0]["commit"], "before": commit_of(bench.before),
                "cores": os.cpu_count(), "machine": platform.machine(), "system": platform.system(),
                "date": time.strftime("%Y-%m-%d"), "repetitions": bench.repetitions, "seed": SEED,
                "lines": arguments.only}
    (arguments.out / "manifest.json").write_text(json.dumps(manifest, indent=2) + "\n")


if __name__ == "__main__":
    main()
