#!/usr/bin/env python3
"""How time and memory grow with coordinates, contacts, events, nodes and harmonics: results/scaling, each line one run.

usage: scaling.py PROGRAM [--only LINE ...] [--timeout SECONDS] [--memory MIB] [--out FOLDER]

Makes scenes of one kind and growing size, runs a method on each and fits t ~ size^p to the upper half of the sizes that
converged. Lines, by name: coordinates, contacts, nodes, harmonics, points: the last of exact response curves, where the time
is the processor's for one point with its stability. Lines that are not measured keep what FOLDER/scaling.csv has of them.
Writes scaling.csv, table.md, scaling.svg (with Matplotlib) and manifest.json into FOLDER, results/scaling unless told. The
figure is drawn where Matplotlib is there. Only certified answers enter the fits, and points of curves.
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
import subprocess
import sys
import tempfile
import time
import tomllib
from typing import NamedTuple

from limits import commit_of

ROOT = pathlib.Path(__file__).resolve().parents[2]
COLUMNS = ("line", "what", "size", "coordinates", "contacts", "events", "status", "certificate", "error_bar", "setup", "solve",
           "iterations", "peak_mib", "commit")
SUITE = """schema = 1
name = "scaling"
title = "One kind of scene, growing"
scenes = ["*"]
[limits]
timeout = {timeout}
memory = {memory}
repetitions = 1
certificate_timeout = {timeout}
reference_timeout = 0.1
"""
SCENE = """schema = 1
name = "{name}"
title = "Of one size"
reference = "made by tests/benchmarks/scaling.py"
tags = ["block", "multi-point", "massless"]

[system]
kind = "block"
elements = [{elements}]
lengths = [{lengths}]
young = 2e11
poisson = 0.3
density = 7800.0
damping = {{ alpha = 0.5, beta = {beta} }}
contact_mass = "massless"

[forcing]
frequency = {frequency}

[[forcing.term]]
face = "x+"
direction = "z"
cos = {load}

[[contact]]
face = "z+"
patch = [{patch}]
gap = {gap}
"""


def bar(bricks):
    """The bar of block-large, of so many bricks along its axis, above one row of seven nodes."""
    return SCENE.format(name=f"bar-{bricks}", elements=f"{bricks}, 6, 6", lengths="3.5, 0.03, 0.03", beta=1e-3, frequency=10.0,
                        load=5.0, patch="[3.49999, 3.5], [0.0, 0.03]", gap=0.005)


def pad(bricks):
    """The same bar of 700 bricks above a pad under so many of its last bricks: seven contacts more for each."""
    return SCENE.format(name=f"pad-{bricks}", elements="700, 6, 6", lengths="3.5, 0.03, 0.03", beta=1e-3, frequency=10.0,
                        load=5.0, patch=f"[{3.5 - 0.005 * bricks - 1e-5}, 3.5], [0.0, 0.03]", gap=0.005)


class SweptScene(NamedTuple):
    """A scene, and the interval of the frequency over which its exact curves are followed [rad/s]."""
    scene: str
    begin: float
    end: float


ROD = """schema = 1
name = "rod-{elements}"
[system]
kind = "bar"
elements = {elements}
length = 0.13
area = 15.6e-4
young = 210e9
density = 7800.0
damping = {{ modal = 7.5e-3 }}
[forcing]
frequency = 64000.0
term = [{{ dof = {tip}, cos = 25e3 }}]
[[contact]]
dof = {tip}
gap = 0.2e-3
[law]
penalty = 1.008e9
"""
MASS = """schema = 1
name = "mass-{percent}"
system = {{ kind = "sdof", mass = 1.0, damping = 0.1, stiffness = 1.0 }}
forcing = {{ frequency = 0.1, term = [{{ dof = 0, cos = 1.0 }}] }}
contact = [{{ dof = 0, gap = 0.2 }}]
law = {{ restitution = {restitution} }}
"""


def rod(elements):
    """The rod of [vadcard2022] in so many elements, its tip before a spring of 0.4 of its own stiffness."""
    return SweptScene(ROD.format(elements=elements, tip=elements - 1), 6e4, 7e4)


def guarded_chain(contacts):
    """Twenty masses, the last of which presses; stops that the others never reach are watched, too."""
    each = lambda value: "[" + ", ".join([str(value)] * 20) + "]"
    stops = ", ".join(f"{{ dof = {19 - j}, gap = {4.0 if j else 0.4} }}" for j in range(contacts))
    return SweptScene(f'schema = 1\nname = "chain-{contacts}"\nsystem = {{ kind = "chain", masses = {each(1.0)}, springs = {each(1.0)}, '
                      f"dampers = {each(0.05)} }}\nforcing = {{ frequency = 0.1, term = [{{ dof = 19, cos = 0.05 }}] }}\n"
                      f"contact = [{stops}]\nlaw = {{ penalty = 2.0 }}\n", 0.06, 0.1)


def slow_mass(percent):
    """A mass that a slow load lays on its stop, after the more impacts the more of its speed each of them leaves it."""
    return SweptScene(MASS.format(percent=percent, restitution=percent / 100), 0.1, 0.15)


def of_catalogue(name):
    return (ROOT / f"problems/catalogue/{name}.toml").read_text()


# Of each line: what it is, the method, the option that grows or none, and (size, scene) of each step; of points a scene with the
# interval of its curve. A size of None is the mean number of events of its points.
LINES = {
    "coordinates": [("exact-orbit, bar of n x 6 x 6 bricks, 7 contacts: coordinates", "exact-orbit[samples=64]", None,
                     [(147 * n, bar(n)) for n in (100, 200, 400, 800, 1600, 3200, 6400)])],
    "contacts": [("exact-orbit, bar of 102,900 coordinates above a pad: contacts", "exact-orbit[samples=64]", None,
                  [(7 * (n + 1), pad(n)) for n in (0, 1, 3, 7, 15, 31, 63, 127)]),
                 ("hat-lcp by marching, N = 1024, the same pads: contacts", "hat-lcp[scheme=bdf2,samples=1024]", None,
                  [(7 * (n + 1), pad(n)) for n in (0, 1, 3, 7, 15, 31, 63, 127)])],
    "nodes": [("hat-lcp, one mass: nodes", "hat-lcp", "samples",
               [(2**k, of_catalogue("sdof-stop")) for k in range(8, 17)]),
              ("hat-lcp, ten stops on a chain: nodes", "hat-lcp", "samples",
               [(2**k, of_catalogue("chain10-stops")) for k in range(6, 13)]),
              ("hat-lcp by marching, block of nine contacts: nodes", "hat-lcp[scheme=bdf2]", "samples",
               [(2**k, of_catalogue("block-nine-contacts")) for k in range(8, 15)])],
    "harmonics": [("closed-hbm, one mass: harmonics", "closed-hbm", "harmonics",
                   [(20 * 2**k, of_catalogue("sdof-stop")) for k in range(7)]),
                  ("fourier-lipschitz, block of nine contacts: harmonics", "fourier-lipschitz", "harmonics",
                   [(20 * 2**k, of_catalogue("block-nine-contacts")) for k in range(5)])],
    "points": [("a point of an exact curve, rod: coordinates", "exact-orbit", None, [(n, rod(n)) for n in (10, 20, 50, 100, 200)]),
               ("a point of an exact curve, chain of twenty masses: contacts", "exact-orbit", None,
                [(n, guarded_chain(n)) for n in (1, 2, 5, 10, 20)]),
               ("a point of an exact curve, one mass: events", "exact-orbit", None,
                [(None, slow_mass(e)) for e in (10, 30, 50, 70, 80)])],
}


def with_option(method, key, value):
    if key is None:
        return method
    name, _, rest = method.partition("[")
    return f"{name}[{rest.rstrip(']') + ',' if rest else ''}{key}={value}]"


def record_of(program, method, scene, limits):
    """The record of one case, run in a folder of its own."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "suite.toml").write_text(SUITE.format(**limits))
        name = next(line.split('"')[1] for line in scene.splitlines() if line.startswith("name"))
        (folder / f"{name}.toml").write_text(scene)
        command = [program, "run", "./suite.toml", "--scenes", f"./{name}.toml", "--methods", method, "--out", "run"]
        outcome = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False,
                                 env=dict(os.environ, OPENBLAS_NUM_THREADS="1"))
        if outcome.returncode not in (0, 1):
            sys.exit(f"scaling: {outcome.stderr.strip()}")
        return json.loads((folder / "run/records.jsonl").read_text().splitlines()[0])


def curve_row(program, line, what, size, method, swept, commit, timeout):
    """The row of a response curve: `solve` is the processor's time of one of its points, `iterations` their number."""
    with tempfile.TemporaryDirectory() as folder:
        scene = pathlib.Path(folder) / "scene.toml"
        scene.write_text(swept.scene)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        outcome = subprocess.run([program, "sweep", scene, "--methods", method, "--from", str(swept.begin), "--to", str(swept.end),
                                  "--max-branches", "4", "--total-time", str(timeout), "--format", "json"], capture_output=True,
                                 text=True, check=False, env=dict(os.environ, OPENBLAS_NUM_THREADS="1"))
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if outcome.returncode not in (0, 6):
        sys.exit(f"scaling: {outcome.stderr.strip()}")
    branches = json.loads(outcome.stdout)["branches"]
    points = sum(len(branch["points"]) for branch in branches)
    events = sum(len(branch["points"]) * len(re.findall(r"\b[ICO]\d", branch["sequence"])) for branch in branches) / points
    spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    system = tomllib.loads(swept.scene)
    coordinates = system["system"].get("elements") or len(system["system"].get("masses", [1]))
    return {"line": line, "what": what, "size": size or round(events), "coordinates": coordinates, "contacts": len(system["contact"]),
            "events": round(events), "status": "converged", "certificate": "", "error_bar": "", "setup": "", "solve": spent / points,
            "iterations": points, "peak_mib": "", "commit": commit}


def row_of(line, what, size, record, commit):
    seconds, work, certificate = record.get("seconds") or {}, record.get("work") or {}, record["certificate"]
    converged = record["status"] == "converged"
    return {"line": line, "what": what, "size": size, "coordinates": record["coordinates"], "contacts": record["contacts"],
            "events": len(certificate.get("events", [])) or "", "status": record["status"],
            "certificate": certificate["status"], "error_bar": certificate.get("error_bar", ""),
            "setup": seconds.get("setup", "") if converged else "", "solve": seconds.get("solve", "") if converged else "",
            "iterations": work.get("iterations", "") if converged else "",
            "peak_mib": work.get("peak_memory_bytes", 0) / 2**20 if converged else "", "commit": commit}


def exponent(sizes, values):
    """The slope of log(value) over log(size) by least squares, of the upper half of the sizes, three at least."""
    pairs = [(math.log(float(s)), math.log(float(v))) for s, v in zip(sizes, values) if v not in ("", None) and float(v) > 0.0]
    pairs = pairs[-max(3, (len(pairs) + 1) // 2):]
    if len(pairs) < 3:
        return None
    x, y = (sum(column) / len(pairs) for column in zip(*pairs))
    return sum((a - x) * (b - y) for a, b in pairs) / sum((a - x)**2 for a, _ in pairs)


def series_of(rows):
    """The rows of each series, in the order of LINES."""
    names = [entry[0] for line in LINES.values() for entry in line]
    return [(name, found) for name in names if (found := [r for r in rows if r["what"] == name])]


def write_table(rows, file):
    """A table of exponents, then one of every measurement."""
    lines = ["| what grows | from | to | set-up | solve | memory | not certified |", "|---|---|---|---|---|---|---|"]
    for what, series in series_of(rows):
        curves = series[0]["line"] == "points"
        good = [r for r in series if curves or r["certificate"] == "certified"]
        fits = [exponent([r["size"] for r in good], [r[key] for r in good]) for key in ("setup", "solve", "peak_mib")]
        lines.append(f"| {what} | {series[0]['size']} | {series[-1]['size']} | "
                     + " | ".join("-" if p is None else f"{p:.2f}" for p in fits)
                     + (" | - |" if curves else f" | {len(series) - len(good)} of {len(series)} |"))
    lines += ["", "| what grows | size | coordinates | contacts | events | status | certificate | bar | set-up [s] | solve [s] | "
              "iterations | peak [MiB] |", "|---|---|---|---|---|---|---|---|---|---|---|---|"]
    for what, series in series_of(rows):
        for r in series:
            number = lambda key, form=".3g": format(float(r[key]), form) if r[key] not in ("", None) else "-"
            lines.append(f"| {what} | {r['size']} | {r['coordinates']} | {r['contacts']} | {r['events'] or '-'} | {r['status']} | "
                         f"{r['certificate']} | {number('error_bar', '.1e')} | {number('setup')} | {number('solve')} | "
                         f"{r['iterations'] or '-'} | {number('peak_mib', '.0f')} |")
    commits = sorted({r["commit"] for r in rows})
    file.write_text("# Scaling\n\nMeasured by tests/benchmarks/scaling.py, each size once; commits: " + ", ".join(commits)
                    + ". Exponents p of time and memory ~ size^p, fitted to the upper half of the sizes whose answers are "
                    "certified; of a few single runs, to a tenth at best. A line ends where it meets the limit of time or "
                    "memory. Events are those of the orbit that certifies the answer; of curves, which have no certificate, the "
                    "mean of their points, `solve` the processor's time of one of them and `iterations` their number."
                    "\n\n![Time over size](scaling.svg)\n\n"
                    + "\n".join(lines) + "\n")


def write_rows(rows, file):
    with file.open("w", newline="") as stream:
        writer = csv.DictWriter(stream, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def draw(rows, file):
    """Set-up and solve over size, one panel per line."""
    try:
        import matplotlib
    except ImportError:
        print("scaling: no Matplotlib, no figure")
        return
    matplotlib.use("svg")
    import matplotlib.pyplot as plt
    matplotlib.rcParams["svg.hashsalt"] = "scaling"
    names = [line for line in LINES if any(r["line"] == line for r in rows)]
    figure, panels = plt.subplots(1, len(names), figsize=(4.2 * len(names), 4.6), squeeze=False)
    for panel, line in zip(panels[0], names):
        for what, series in series_of([r for r in rows if r["line"] == line and r["solve"] not in ("", None)]):
            sizes = [float(r["size"]) for r in series]
            label = what.rsplit(":", 1)[0]
            (drawn,) = panel.loglog(sizes, [float(r["solve"]) for r in series], "o-", markersize=3, label=label)
            if series[0]["setup"] not in ("", None):
                panel.loglog(sizes, [float(r["setup"]) for r in series], ":", color=drawn.get_color())
        panel.set_xlabel(line)
        panel.legend(fontsize=6, loc="upper left")
        panel.grid(True, which="major", linewidth=0.3)
    panels[0][0].set_ylabel("solve; dotted: set-up [s]")
    figure.tight_layout()
    figure.savefig(file, metadata={"Date": None})


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--only", nargs="+", choices=LINES, default=list(LINES), metavar="LINE", help=", ".join(LINES))
    parser.add_argument("--timeout", type=float, default=300.0, help="of a solve, and of its certificate [s]")
    parser.add_argument("--memory", type=int, default=12000, help="of a case [MiB]")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "results/scaling")
    arguments = parser.parse_args()
    program = arguments.program.resolve()
    if not program.is_file():
        sys.exit(f"scaling: {program}: no such program")
    commit = commit_of(program)
    arguments.out.mkdir(parents=True, exist_ok=True)
    table = arguments.out / "scaling.csv"
    rows = list(csv.DictReader(table.open())) if table.exists() else []
    limits = {"timeout": arguments.timeout, "memory": arguments.memory}
    for line in arguments.only:
        rows = [r for r in rows if r["line"] != line]
        for what, method, option, steps in LINES[line]:
            for size, scene in steps:
                if isinstance(scene, SweptScene):
                    row = curve_row(program, line, what, size, method, scene, commit, arguments.timeout)
                else:
                    row = row_of(line, what, size, record_of(program, with_option(method, option, size), scene, limits), commit)
                print(f"{what} {row['size']}: {row['status']}, {row['setup']} + {row['solve']} s", flush=True)
                rows.append(row)
                write_rows(rows, table)
                if row["status"] in ("timeout", "out-of-memory"):
                    break  # what is larger would be so too
    write_table(rows, arguments.out / "table.md")
    draw(rows, arguments.out / "scaling.svg")
    manifest = {"program": commit, "cores": os.cpu_count(), "machine": platform.machine(), "system": platform.system(),
                "date": time.strftime("%Y-%m-%d"), "lines": arguments.only, **limits}
    (arguments.out / "manifest.json").write_text(json.dumps(manifest, indent=2) + "\n")


if __name__ == "__main__":
    main()
