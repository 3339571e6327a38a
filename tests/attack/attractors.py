#!/usr/bin/env python3
"""Whether exact responses of fresh scenes hold what starts settle to: attractors.py PROGRAM --seed N. Of each scene `sweep
--attractors` lists the periodic motions that its starts reach and says of each whether it lies on a branch; another program
(own_flow.py) marches starts of its own, whose periodic motions must be among those listed. Exit code 1 if fewer than 99 % of the
listed ones of order up to 6 lie on a branch, or one off the branches is not named, or more than one in a hundred of the other
program's is not listed."""

import argparse
import collections
import json
import pathlib
import random
import subprocess
import sys
import tomllib

import numpy as np

import generators
import own_flow

ORDERS = 6
WIDTH = 0.4  # of the interval to either side of the scene's frequency, relative to it
FREQUENCIES, STARTS = 41, 24
SETTLING, NEAR = 300, 1e-5  # forcing periods of a march; of its scale, from where a state counts as come back
own_flow.STEPS = 256  # of a forcing period: extremes are sampled there
SAME = 2e-3  # of the motion's size, for these


def scenes_of(asked, folder):
    """Files of the scenes of a seed."""
    kinds = {"masses": (generators.mass_before_stops, asked.masses), "structures": (generators.chain_or_beam, asked.structures)}
    for name, (make, count) in kinds.items():
        draw = random.Random(f"{asked.seed} {name}")
        (folder / name).mkdir(parents=True, exist_ok=True)
        for number in range(count):
            text = make(draw, number)
            file = folder / name / (text.split('"')[1] + ".toml")
            file.write_text(text)
            yield file


def swept(asked, file, frequency):
    out = subprocess.run([asked.program, "sweep", file, "--methods", "exact-orbit", "--from", str((1 - WIDTH) * frequency), "--to",
                          str((1 + WIDTH) * frequency), "--points", str(FREQUENCIES), "--attractors", str(STARTS), "--max-order",
                          str(ORDERS), "--total-time", str(asked.total_time), "--format", "json"],
                         capture_output=True, check=False, text=True)
    return out.returncode, json.loads(out.stdout) if out.stdout else None, out.stderr


def extremes(flow, draw, scale):
    """Order, least and largest x of the contacts of what a random start settles to, and how far samples are off; or None."""
    n = flow.size
    u, v = (np.array([draw.uniform(-1.0, 1.0) for _ in range(n)]) * size for size in (scale, scale * flow.frequency))
    try:
        z = flow.period_map(flow.start(u - flow.normals.sum(axis=0) * scale, v, 0.0), SETTLING)
        kept, come = [], z
        for order in range(1, ORDERS + 1):
            come = flow.period_map(come, 1, kept)
            away = (come - z)[:2 * n] / np.repeat([scale, scale * flow.frequency], n)
            if np.abs(away).max() < NEAR:
                # At an impact a sample is off by what x moves until the next one, half of it on the nearer side.
                return order, np.min(kept, axis=0), np.max(kept, axis=0), np.abs(np.diff(kept, axis=0)).max(axis=0) / 2
    except own_flow.Lost:
        pass
    return None


def not_listed(scene, law, listed, draw, starts):
    """Motions of the other program that are not among those listed at their frequency, and how many it found."""
    found, missing = 0, []
    for at in draw.sample([one for one in listed if not one["failure"]], 3):
        scene["forcing"]["frequency"] = at["value"]
        try:
            flow = own_flow.Flow(scene, law)
        except ValueError:  # massless contacts and springs with dampers
            return 0, []
        scale = max(max(map(abs, one["x_min"] + one["x_max"])) for one in at["attractors"])
        for _ in range(starts):
            settled = extremes(flow, draw, scale)
            if settled is None:
                continue
            found += 1
            order, least, largest, between = settled
            size = max(np.ptp([least, largest], axis=0).max(), 1e-3 * scale)
            same = SAME * size + between
            if not any(one["order"] == order and (np.abs(np.array(one["x_min"]) - least) < same).all() and
                       (np.abs(np.array(one["x_max"]) - largest) < same).all() for one in at["attractors"]):
                missing.append(f"order {order} at {at['value']:.6g}, x from {least} to {largest}")
    return found, missing


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--masses", type=int, default=40)
    parser.add_argument("--structures", type=int, default=16)
    parser.add_argument("--starts", type=int, default=4, help="of the other program, at each of three frequencies")
    parser.add_argument("--total-time", type=float, default=120.0, help="of a response [s]")
    parser.add_argument("--folder", type=pathlib.Path, help="attractors-SEED if absent")
    asked = parser.parse_args()
    folder = (asked.folder or pathlib.Path(f"attractors-{asked.seed}")).resolve()
    count = collections.Counter()
    for file in scenes_of(asked, folder):
        scene = tomllib.loads(file.read_text())
        code, answer, errors = swept(asked, file, scene["forcing"]["frequency"])
        count[f"exit code {code}"] += 1
        if answer is None:
            print(f"{file.stem}: exit code {code}: {errors.strip()}", flush=True)
            continue
        periodic = [one for at in answer["attractors"] for one in at["attractors"]
                    if one["verdict"] == "periodic" and one["order"] <= ORDERS]
        off = [one for one in periodic if not one["on_branch"]]
        count["periodic"] += len(periodic)
        count["off the branches"] += len(off)
        count["off the branches, not named"] += bool(off) and not answer.get("off_branches")
        law = dict(scene.get("law", {"massless": True}))
        if "penalty" in law:  # of each contact, as records have it
            law["penalty"] = [law["penalty"]] * len(scene["contact"])
        found, missing = not_listed(scene, law, answer["attractors"], random.Random(f"{asked.seed} {file.stem}"), asked.starts)
        count["of the other program"] += found
        count["not listed"] += len(missing)
        for line in answer.get("off_branches", []) + [f"not listed: {line}" for line in missing]:
            print(f"{file.stem}: {line}", flush=True)
        for line in answer.get("incomplete", []):
            print(f"{file.stem}: INCOMPLETE {line}", flush=True)
    print(f"seed {asked.seed}:", dict(count))
    return int(100 * count["off the branches"] > count["periodic"] or count["off the branches, not named"] > 0 or
               100 * count["not listed"] > count["of the other program"])


if __name__ == "__main__":
    sys.exit(main())
