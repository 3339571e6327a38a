#!/usr/bin/env python3
"""Multipliers of orbits whose stops are struck at the same instant, against finite differences of another program's flow
(own_flow.py): symmetric.py PROGRAM --seed N. A neighbour of such an orbit strikes in one of two orders; each order has
differences of its own. Exit code 1 if a printed multiplier is off, or a stability that the differences contradict is claimed."""

import argparse
import json
import pathlib
import random
import subprocess
import sys
import tempfile
import tomllib

import numpy as np

import generators
import own_flow

TOGETHER = 1e-6  # of a forcing period, between impacts at one instant
AGREED = 1e-4  # of the largest multiplier, or of one


def symmetric_pair(random, number):
    """Two stops that the load strikes at the same instant: twins, a mirrored chain, a rigid bar in heave and pitch; coupled by
    nothing, springs, dampers too, or the mass."""
    kind, e = number % 3, [0.5, 0.8, 1.0][number // 3 % 3]
    coupling = number // 9 % 3  # of twins: none, springs, dampers too
    size = random.randint(3, 4) if kind == 1 else 2
    k, c, frequency = random.uniform(0.8, 1.5), random.uniform(0.05, 0.2), random.uniform(0.6, 3.0)
    link, damper = random.uniform(0.1, 0.6), random.uniform(0.02, 0.2)
    half = [random.uniform(0.5, 2.0) for _ in range(2)]
    masses, loads = [half[min(i, size - 1 - i)] for i in range(size)], range(size)
    normals = ("[[0, 1.0]]", f"[[{size - 1}, 1.0]]")
    if kind == 0:
        link, damper = (coupling > 0) * link, (coupling > 1) * damper
    if kind == 2:  # the second coordinate is the pitch times half the distance of the stops
        link, damper, masses, loads = 0.0, 0.0, [1.0, 1.0 if coupling == 0 else random.uniform(0.3, 0.8)], [0]
        normals = ("[[0, 1.0], [1, 1.0]]", "[[0, 1.0], [1, -1.0]]")
    rows = {"masses": masses, "springs": [0.0] + [link] * (size - 1), "dampers": [0.0] + [damper] * (size - 1),
            "ground_springs": [k] * size, "ground_dampers": [c] * size}
    M, D, K = own_flow.matrices({"kind": "chain", **rows})
    reach = abs(np.linalg.solve(K - frequency**2 * M + 1j * frequency * D, [float(i in loads) for i in range(size)])[0])
    system = 'kind = "chain"' + "".join(f"\n{key} = {[round(float(value), 5) for value in row]}" for key, row in rows.items())
    text = generators.scene_text(f"symmetric-{number:03}", system, frequency, [(dof, 1, 1.0, 0.0) for dof in loads], [], None)
    gap = random.uniform(0.05, 0.7) * reach
    return text + "".join(f"[[contact]]\nnormal = {normal}\ngap = {gap:.6g}\n" for normal in normals) + f"[law]\nrestitution = {e}\n"


class SymmetricFlow:
    """The flow of a scene, and the motions that its mirror image leaves alone."""

    def __init__(self, scene, law):
        self.flow = own_flow.Flow(scene, law, most_events=60)
        n = self.flow.size
        bar = n == 2 and np.ptp(np.abs(self.flow.normals)) == 0.0  # heave and pitch
        mirror = np.diag([1.0, -1.0]) if bar else np.eye(n)[::-1]
        values, vectors = np.linalg.eigh(0.5 * (mirror + mirror.T))
        self.alike = vectors[:, values > 0.5]

    def after(self, y, periods, struck=None):
        n = self.flow.size
        return self.flow.period_map(self.flow.start(y[:n], y[n:], 0.0), periods, struck=struck)[:2 * n]

    def orbits(self, draw, order, starts):
        """States of mirrored orbits, from Newton's method after marches from random mirrored states."""
        basis = np.kron(np.eye(2), self.alike)
        found = []
        for _ in range(starts):
            q = np.array([draw.uniform(-1.0, 1.0) for _ in range(basis.shape[1])])
            try:
                y = self.newton(basis, basis.T @ self.after(basis @ q, 40), order)
            except own_flow.Lost:
                continue
            if y is not None and not any(np.linalg.norm(y - other) < 1e-5 * (1.0 + np.linalg.norm(y)) for other in found):
                found.append(y)
        return found

    def newton(self, basis, q, order):
        missed = lambda state: basis.T @ self.after(basis @ state, order) - state
        for _ in range(15):
            off = missed(q)
            if np.linalg.norm(off) < 1e-10 * (1.0 + np.linalg.norm(q)):
                return basis @ q
            slope = np.column_stack([(missed(q + 1e-6 * e) - off) / 1e-6 for e in np.eye(len(q))])
            q = q - np.linalg.lstsq(slope, off, rcond=None)[0]
        return None

    def impacts(self, y, order):
        struck = []
        self.after(y, order, struck)
        return struck

    def multipliers(self, y, order, draw):
        """By the order of the impacts: eigenvalues of the linear part that all neighbours of that order have."""
        size, parts = len(y), {}
        scale = 1e-6 * (1.0 + np.abs(y).max())
        for _ in range(40):
            centre = np.array([draw.gauss(0.0, 1.0) for _ in range(size)])
            around = [centre] + [centre + 0.2 * np.linalg.norm(centre) * e for e in np.eye(size)]
            struck = [[] for _ in around]
            images = [self.after(y + scale * d, order, one) for d, one in zip(around, struck)]
            sequences = {tuple(contact for contact, _ in one) for one in struck}
            if len(sequences) != 1 or sequences & set(parts):
                continue
            moved = np.column_stack([image - images[0] for image in images[1:]]) / scale
            turned = np.column_stack([d - centre for d in around[1:]])
            parts[sequences.pop()] = np.linalg.eigvals(moved @ np.linalg.inv(turned))
        return parts


def instants(struck):
    return np.array(sorted(at for _, at in struck))


def same_events(printed, struck, period, order):
    """Whether the instants are those of the printed orbit, which may begin in another period of the load."""
    impacts = sorted(event["time"] / period for event in printed["events"] if event["kind"] == "impact")
    ours = instants(struck)
    if len(impacts) != len(ours):
        return False
    return any(np.abs(np.sort((ours + turn) % order) - np.array(impacts)).max() < 1e-5 for turn in range(order))


def apart(one, other):
    """Largest distance of two sets of multipliers, each paired with the nearest one left."""
    rest, worst = list(other), 0.0
    for value in sorted(one, key=abs, reverse=True):
        nearest = min(rest, key=lambda candidate: abs(candidate - value))
        rest.remove(nearest)
        worst = max(worst, abs(nearest - value))
    return worst / max(1.0, max(abs(value) for value in one))


def faults(printed, parts):
    """What the printed orbit claims against the differences of each order."""
    largest = {order: max(abs(values)) for order, values in parts.items()}
    wrong = []
    for said in printed.get("orders", []):
        told = [contact for group in said["contacts"] for contact in group]
        for order, size in largest.items():
            if list(order) == told and abs(said["largest"] - size) > AGREED * max(1.0, size):
                wrong.append(f"order {told}: {said['largest']:.6g}, by differences {size:.6g}")
    if printed.get("floquet"):
        values = [complex(*pair) for pair in printed["floquet"]]
        for order, ours in parts.items():
            if apart(ours, values) > AGREED:
                wrong.append(f"multipliers {np.round(values, 6)}, by differences in order {order} {np.round(ours, 6)}")
    if printed["stability"] == "stable" and any(size > 1.0 + AGREED for size in largest.values()):
        wrong.append(f"stable, by differences {largest}")
    if printed["stability"] == "unstable" and largest and all(size < 1.0 - AGREED for size in largest.values()):
        wrong.append(f"unstable, by differences {largest}")
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--scenes", type=int, default=40)
    parser.add_argument("--starts", type=int, default=4, help="of a scene, at each order")
    asked = parser.parse_args()
    counts = dict.fromkeys(("orbits compared", "with multipliers", "with those of each order", "undefined"), 0)
    wrong, none = [], []
    for number in range(asked.scenes):
        draw = random.Random(f"{asked.seed} {number}")
        text = symmetric_pair(draw, number)
        scene = tomllib.loads(text)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "scene.toml"
            path.write_text(text)
            out = subprocess.run([asked.program, "orbits", path, "--json", "--starts", "4", "--subharmonics", "2", "--timeout", "60"],
                                 capture_output=True, check=False).stdout
        printed = json.loads(out or b"[]")
        mirrored = SymmetricFlow(scene, scene["law"])
        compared = 0
        for order in (1, 2):
            for y in mirrored.orbits(draw, order, asked.starts):
                struck = mirrored.impacts(y, order)
                if len(struck) < 2 or np.diff(instants(struck)).min() > TOGETHER:
                    continue
                match = [one for one in printed if one["order"] == order and same_events(one, struck, mirrored.flow.period, order)]
                if not match:
                    continue
                one = match[0]
                compared += 1
                counts["orbits compared"] += 1
                counts["with those of each order" if one.get("orders") else
                       "with multipliers" if one.get("floquet") else "undefined"] += 1
                wrong += [f"{scene['name']} {one['orbit']}: {fault}" for fault in faults(one, mirrored.multipliers(y, order, draw))]
        if not compared:
            none.append(scene["name"])
        print(scene["name"], compared, file=sys.stderr, flush=True)
    print(f"seed {asked.seed}: {asked.scenes} scenes; " + ", ".join(f"{count} {name}" for name, count in counts.items()))
    print(f"without a common orbit: {', '.join(none) or 'none'}")
    print("\n".join(wrong) or "no fault")
    return int(bool(wrong) or not counts["orbits compared"])


if __name__ == "__main__":
    sys.exit(main())
