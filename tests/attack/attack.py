#!/usr/bin/env python3
"""Attacks the built program as a stranger, an accident or a full disk would; counts what it promised and did not keep.

usage: attack.py PROGRAM [--share quick|hour] [--tests N] [--seed N] [--only GLOB] [--jobs N] [--sanitized] [--if-built]
                 [--table FILE] [--record FILE] [--findings FOLDER]

Prints one line per campaign, and each violation with what brings it about; exit code 1 if there is one, 77 where the program is
not there with --if-built. The same seed makes the same inputs. With --table the lines become a page, results/attack.md, which what fuzz.py recorded in
results/fuzz.json joins. An hour may be interrupted: --record keeps each campaign as it ends, with the program it was run
on, and those it holds of the same share and seed without a violation are not run again.
"""

import argparse
import concurrent.futures
import fcntl
import fnmatch
import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import time

import command_attacks
import documented
import file_attacks
import load
import method_attacks
import reproductions
import run_attacks
import solve_attacks
import surroundings
from attack_page import page_of
from attacked_program import Campaign, Program

FUZZED = pathlib.Path(__file__).resolve().parents[2] / "results/fuzz.json"
SKIPPED = 77
# How many tests of each campaign make some seconds, and how many an hour with sanitizers on two cores.
CAMPAIGNS = {
    "scenes": (file_attacks.scenes, 60, 1500),
    "matrices": (file_attacks.matrices, 30, 800),
    "suites": (file_attacks.suites, 10, 100),
    "descriptions": (file_attacks.descriptions, 20, 400),
    "records": (file_attacks.records, 20, 400),
    "responses": (file_attacks.responses, 20, 300),
    "special-files": (file_attacks.special_files, 40, 300),
    "command-lines": (file_attacks.command_lines, 40, 800),
    "random-scenes": (solve_attacks.random_scenes, 2, 300),  # 2,100 cases by seven methods
    "hand-made": (solve_attacks.hand_made, 3, 100),
    "kills": (run_attacks.kills, 2, 60),
    "no-room": (run_attacks.no_room, 2, 40),
    "folders": (run_attacks.folders, 6, 100),
    "damaged-folders": (run_attacks.resumed_damage, 4, 100),
    "commands": (method_attacks.ill_behaved_commands, 6, 100),
    "plugins": (method_attacks.ill_behaved_plugins, 6, 100),
    "searches": (command_attacks.searches, 3, 150),
    "new": (command_attacks.new, 10, 150),
    "references": (command_attacks.references, 2, 100),
    "starts": (command_attacks.starts, 5, 150),
    "reproductions": (reproductions.reproductions, 21, 21),
    "documented": (documented.pairs, 40, 1000),
    "crashed": (documented.crashed, 10, 10),
    "traps": (documented.traps, 40, 500),
    "busy": (run_attacks.busy, 1, 2),
    "surroundings": (surroundings.surroundings, 12, 200),
    "load": (load.campaign_of, 40, 1000),
}


def parsed():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--share", choices=["quick", "hour"], default="quick")
    parser.add_argument("--tests", type=int, help="so many of each campaign, in place of the share's")
    parser.add_argument("--seed", type=int, default=20261123)
    parser.add_argument("--only", default="*", help="campaigns by glob")
    parser.add_argument("--jobs", type=int, default=1, help="campaigns at the same time")
    parser.add_argument("--sanitized", action="store_true", help="the program is built with sanitizers: slower, larger")
    parser.add_argument("--if-built", action="store_true", help="skip it where the program has not been built")
    parser.add_argument("--table", type=pathlib.Path)
    parser.add_argument("--record", type=pathlib.Path, help="campaigns that have ended, as JSON; the table is of all")
    parser.add_argument("--findings", type=pathlib.Path, help="folder for the inputs of violations")
    return parser.parse_args()


def version_of(program):
    return subprocess.check_output([program, "--version"], text=True).strip()


def kind_of(arguments):
    """What campaigns on record must have in common to make one table."""
    share = arguments.share if arguments.tests is None else f"{arguments.tests} tests"
    return f"{share}, seed {arguments.seed}" + (", sanitized" if arguments.sanitized else "")


def recorded(arguments, name):
    """The campaign as it ended before; none where it was not run, or found something."""
    if not arguments.record or not arguments.record.exists():
        return []
    kept = json.loads(arguments.record.read_text() or "{}").get(kind_of(arguments), {}).get(name, [])
    campaigns = [Campaign.of_fields(fields) for fields in kept]
    return [] if any(campaign.violations for campaign in campaigns) else campaigns


def keep(arguments, name, campaigns):
    """Adds a campaign that has ended to the record, which others may do at the same time."""
    if not arguments.record:
        return
    folder = os.open(arguments.record.resolve().parent, os.O_RDONLY)
    try:
        fcntl.flock(folder, fcntl.LOCK_EX)
        record = json.loads(arguments.record.read_text() or "{}") if arguments.record.exists() else {}
        record.setdefault(kind_of(arguments), {})[name] = [campaign.fields() for campaign in campaigns]
        draft = arguments.record.with_suffix(".draft")
        draft.write_text(json.dumps(record, indent=1) + "\n", encoding="utf-8")
        draft.replace(arguments.record)  # whoever reads meanwhile sees the old one or the new one
    finally:
        os.close(folder)


def run_campaign(arguments, name):
    """The campaign of that name, with its own sequence of random numbers, or what is on record of it."""
    attack, quick, hour = CAMPAIGNS[name]
    if kept := recorded(arguments, name):
        return kept
    program = Program(arguments.program, arguments.sanitized)
    count = arguments.tests or (quick if arguments.share == "quick" else hour)
    campaigns, began = [], time.monotonic()
    with tempfile.TemporaryDirectory(prefix=f"attack-{name}-") as folder:
        source = random.Random(f"{arguments.seed} {name}")
        for campaign in attack(program, source, count, pathlib.Path(folder), arguments.findings):
            campaign.name, campaign.elapsed = name, time.monotonic() - began
            campaign.version = version_of(arguments.program)
            campaigns.append(campaign)
    keep(arguments, name, campaigns)
    return campaigns


def run_campaigns(arguments):
    """The campaigns of the names wanted, in the order of CAMPAIGNS, each in a process of its own."""
    names = [name for name in CAMPAIGNS if fnmatch.fnmatch(name, arguments.only)]
    with concurrent.futures.ProcessPoolExecutor(max(1, arguments.jobs)) as pool:  # an executor notices a killed process
        for campaigns in pool.map(run_campaign, [arguments] * len(names), names):
            yield from campaigns


def tell(campaign):
    """The campaign and its violations, one line each."""
    codes = ", ".join(f"{number} x {code}" for code, number in sorted(campaign.codes.items()))
    print(f"{campaign.name}: {campaign.what}: {campaign.tests} tests, {len(campaign.violations)} violations "
          f"({campaign.elapsed:.0f} s; exit codes {codes}; longest {campaign.seconds:.1f} s, largest "
          f"{campaign.peak_mb:.0f} MiB)")
    for violation in campaign.violations:
        print("  " + violation.encode("ascii", "backslashreplace").decode()[:600])
    for title, rows in campaign.notes if not campaign.violations else []:
        if not rows:
            print("  " + title)
    sys.stdout.flush()


def main():
    arguments = parsed()
    if arguments.if_built and not os.access(arguments.program, os.X_OK):
        print(f"skipped: {arguments.program} is not built")
        return SKIPPED
    print(f"seed {arguments.seed}, share {arguments.share}", flush=True)
    campaigns = []
    for campaign in run_campaigns(arguments):
        tell(campaign)
        campaigns.append(campaign)
    if not campaigns:
        sys.exit(f"only = {arguments.only} (must match one of {', '.join(CAMPAIGNS)})")
    if arguments.table:
        fuzzed = json.loads(FUZZED.read_text()) if FUZZED.exists() else []
        arguments.table.write_text(page_of(campaigns, fuzzed, arguments))
    return 1 if any(campaign.violations for campaign in campaigns) else 0


if __name__ == "__main__":
    sys.exit(main())
