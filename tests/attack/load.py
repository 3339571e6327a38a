#!/usr/bin/env python3
"""A run of very many short cases: killed and resumed, its memory, and what a case costs beside its solve.

usage: load.py PROGRAM [--cases N] [--jobs N] [--kill-every SECONDS] [--seed N] [--sanitized]

Runs N cases (20,000 unless told) once undisturbed and once killed every so many seconds and resumed; both must end with
the same records. References are not marched to: they cost once per scene. Prints processor time per case over all
processes, stage by stage, and the memory of the harness as the run goes on. Exit code 1 if the records differ, the
memory grows, or a case costs more than 10 ms besides its stages.
"""

import argparse
import os
import pathlib
import random
import shutil
import signal
import sys
import tempfile
import threading
import time

from attacked_program import Campaign, Program
from generators import one_mass
from run_attacks import answers
from solve_attacks import read_records

METHODS = {"hat-lcp": ("samples", range(64, 184, 12)), "fourier-lipschitz": ("harmonics", range(2, 12, 2)),
           "penalty-hbm": ("harmonics", range(2, 12, 2))}
PER_SCENE = sum(len(values) for _, values in METHODS.values())
MOST_GROWTH = 1.3  # of the memory of the harness from a tenth of the run to its end, beside a constant
GROWTH_MB = 40.0
MOST_REST_MS, ENOUGH_CASES = 10.0, 1000  # of processor time per case, besides its stages, over that many cases
SUITE = """schema = 1
name = "load"
title = "Short cases"
scenes = ["*"]
[limits]
timeout = 5.0
memory = 1024
repetitions = 1
certificate_timeout = 2.0
reference_timeout = 0.001
"""


def write_problems(folder, cases):
    """A folder for SIGNORINI_PROBLEMS with so many scenes of one mass."""
    for part in ("catalogue", "families", "suites"):
        (folder / part).mkdir(parents=True)
    (folder / "suites/load.toml").write_text(SUITE)
    for number in range(max(1, cases // PER_SCENE)):
        text = one_mass(gaps=(0.05 + 0.3 * number / max(1, cases // PER_SCENE),), law="restitution = 0.8")
        (folder / f"catalogue/load-{number}.toml").write_text(text.replace('"scene"', f'"load-{number}"'))


class Memory(threading.Thread):
    """The resident memory and the open files of a process, ten times a second."""

    def __init__(self, process):
        super().__init__(daemon=True)
        self.process, self.samples = process, []
        self.start()

    def run(self):
        while True:
            try:
                lines = pathlib.Path(f"/proc/{self.process}/status").read_text().splitlines()
                resident = next((int(line.split()[1]) / 1024.0 for line in lines if line.startswith("VmRSS")), None)
                files = len(os.listdir(f"/proc/{self.process}/fd"))
            except OSError:
                return
            if resident is None:
                return
            self.samples.append((resident, files))
            time.sleep(0.1)


class Load:
    """Runs of the same many cases in one folder."""

    def __init__(self, program, folder, cases, jobs):
        self.program, self.folder = program, folder
        write_problems(folder / "problems", cases)
        program.environment["SIGNORINI_PROBLEMS"] = str(folder / "problems")
        # What the address sanitizer keeps of freed memory, 256 MB unless told, is no growth of the program.
        program.environment["ASAN_OPTIONS"] += ":quarantine_size_mb=8"
        self.cases = max(1, cases // PER_SCENE) * PER_SCENE
        self.jobs = jobs

    def start(self, out):
        methods = ":".join(f"{name}[{key}={'|'.join(map(str, values))}]" for name, (key, values) in METHODS.items())
        arguments = ["run", "load", "--methods", methods, "--jobs", str(self.jobs), "--resume", "--out", out]
        return self.program.start(arguments, self.folder)

    def undisturbed(self):
        """Its outcome and the memory over time."""
        process = self.start("whole")
        memory = Memory(process.pid)
        return self.program.finish(process, 3.0 * self.cases), memory.samples

    def killed(self, seconds, source):
        """Killed every so many seconds, give or take a half, and resumed until it is done. How often it was killed."""
        for kills in range(100000):
            process = self.start("killed")
            ended = threading.Event()
            timer = threading.Timer(seconds * source.uniform(0.5, 1.5),
                                    lambda: ended.is_set() or os.kill(process.pid, signal.SIGKILL))
            timer.start()
            outcome = self.program.finish(process, 3.0 * self.cases)
            ended.set()
            timer.cancel()
            if outcome.code != -signal.SIGKILL:
                return outcome, kills
        raise RuntimeError("it does not come to an end")


def processor_account(records, outcome):
    """Milliseconds of processor time per case: in each stage of the case, and in all the rest of the run."""
    stages = dict.fromkeys(("solve", "timing", "measures", "certificate"), 0.0)
    for record in records:
        for stage, seconds in record.get("processor", {}).items():
            stages[stage] += seconds
    stages["rest"] = outcome.processor_seconds - sum(stages.values())
    return {stage: 1e3 * seconds / max(1, len(records)) for stage, seconds in stages.items()}


def report(campaign, load, outcome, samples, kills):
    """What a run of so many cases costs, as lines."""
    account = processor_account(read_records(load.folder / "whole"), outcome)
    tenth = samples[len(samples) // 10:]
    campaign.notes.append((
        f"{load.cases} cases, `--jobs {load.jobs}`: {outcome.seconds:.0f} s; processor time per case in all processes "
        f"{sum(account.values()):.1f} ms, of which set-up and first solve {account['solve']:.1f}, timing (two calls repeated "
        f"for 1 to 10 ms each) {account['timing']:.1f}, measures {account['measures']:.1f}, certificate "
        f"{account['certificate']:.1f}, all the rest (processes, records) {account['rest']:.1f} ms; harness "
        f"{tenth[0][0]:.0f} MiB after a tenth, {tenth[-1][0]:.0f} MiB at the end, at most {max(m for m, _ in samples):.0f} "
        f"MiB and {max(f for _, f in samples)} open files; killed {kills} times", []))


def attack(program, source, folder, cases, jobs, kill_every):
    """Both runs, judged."""
    campaign = Campaign(f"runs of many short cases, killed and resumed, `--jobs {jobs}`")
    load = Load(program, folder, cases, jobs)
    outcome, samples = load.undisturbed()
    campaign.count(outcome)
    found = program.violations(outcome, (0, 1))
    tenth = samples[len(samples) // 10:] or samples
    if tenth[-1][0] > MOST_GROWTH * tenth[0][0] + GROWTH_MB:
        found.append(f"memory grows from {tenth[0][0]:.0f} to {tenth[-1][0]:.0f} MiB")
    rest = processor_account(read_records(folder / "whole"), outcome)["rest"]
    if rest > MOST_REST_MS and load.cases >= ENOUGH_CASES and program.slower == 1.0:
        found.append(f"{rest:.1f} ms of processor time per case besides its stages")
    campaign.judge(found, f"{load.cases} cases")
    last, kills = load.killed(kill_every, source)
    campaign.count(last)
    whole, killed = read_records(folder / "whole"), read_records(folder / "killed")
    found = program.violations(last, (0, 1))
    before, after = answers(whole), answers(killed)
    found += [f"{after.get(key)} where the undisturbed run has {before.get(key)}" for key in before.keys() | after.keys()
              if before.get(key) != after.get(key)][:20]
    if len(killed) != load.cases or len(whole) != load.cases:
        found.append(f"{len(whole)} and {len(killed)} records of {load.cases} cases")
    campaign.judge(found, f"{load.cases} cases, killed {kills} times")
    report(campaign, load, outcome, samples, kills)
    shutil.rmtree(folder / "problems")
    program.environment.pop("SIGNORINI_PROBLEMS")
    return campaign


def campaign_of(program, random_source, count, folder, findings):
    """As attack.py calls it."""
    del findings
    yield attack(program, random_source, folder, count, 2, max(1.0, min(60.0, count / 200.0)))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--cases", type=int, default=20000)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--kill-every", type=float, default=60.0)
    parser.add_argument("--seed", type=int, default=20261123)
    parser.add_argument("--sanitized", action="store_true")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="attack-load-") as folder:
        program = Program(arguments.program, arguments.sanitized)
        campaign = attack(program, random.Random(arguments.seed), pathlib.Path(folder), arguments.cases, arguments.jobs,
                          arguments.kill_every)
    for line, _ in campaign.notes:
        print(line)
    for violation in campaign.violations:
        print(violation[:2000])
    return 1 if campaign.violations else 0


if __name__ == "__main__":
    sys.exit(main())
