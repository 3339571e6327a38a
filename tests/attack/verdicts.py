#!/usr/bin/env python3
"""What `motion` says of fresh chains with light damping between two stops whose motion from rest never repeats, beside the march of
another program (own_flow.py): verdicts.py PROGRAM --seed N. The largest exponent is that of two neighbouring motions there. What
the program calls periodic is marched on, for chaos may end late. Exit code 1 if a verdict differs, or if exponents or impacts per
second of more than one scene in ten are apart by more than both errors together. Sixty scenes take an hour."""

import argparse
import contextlib
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile
import tomllib

import numpy as np

import generators
import own_flow

STEPS = 256  # of a forcing period: modes are slow
ORDERS, REPEATS = 32, 1e-7  # what repeats after so many periods, to this share of the motion, is periodic
FURTHER = 20  # times the transient: what the program says settles does so here, too
APART = 1e-7  # of the motion: the distance of neighbouring motions
BATCHES, QUANTILE = 20, 2.093  # Student's, of 95 %


def mean(values):
    """By batch means, with its error."""
    batches = np.array(values[:len(values) // BATCHES * BATCHES]).reshape(BATCHES, -1).mean(axis=1)
    return batches.mean(), QUANTILE * batches.std(ddof=1) / math.sqrt(BATCHES)


class March:
    """The motion of a scene from rest."""

    def __init__(self, scene, transient):
        law = scene["law"]
        if "penalty" in law:
            law = {"penalty": [law["penalty"]] * len(scene["contact"])}
        self.flow = own_flow.Flow(scene, law, steps=STEPS)
        n = self.flow.size
        self.state = self.flow.start(np.zeros(n), np.zeros(n), 0.0)
        self.follow(transient)

    def follow(self, periods):
        """Marches on; `order` is that of what is reached, None where nothing repeats."""
        n = self.flow.size
        for _ in range(periods):
            self.state = self.next(self.state)
        section = [self.state]
        for _ in range(ORDERS + 8):
            section.append(self.next(section[-1]))
        section = np.array(section)[:, :2 * n]
        self.scale = np.repeat(np.abs(section).reshape(-1, 2, n).max(axis=(0, 2)), n)  # of displacements, of velocities
        self.order = next((k for k in range(1, ORDERS + 1)
                           if (np.abs(section[k:k + 8] - section[:8]) / self.scale).max() < REPEATS), None)

    def next(self, state, struck=None):
        """A period later, with the phase of the load as it was."""
        after = self.flow.period_map(state, 1, struck=struck)
        after[2 * self.flow.size:] = state[2 * self.flow.size:]
        return after

    def distance(self, one, other):
        n = self.flow.size
        return float(np.linalg.norm((one - other)[:2 * n] / self.scale))

    def measure(self, periods):
        """The largest exponent and the impacts per second, each with its error."""
        n, one, logs, impacts = self.flow.size, self.state, [], []
        other = one.copy()
        other[:2 * n] += APART * self.scale / math.sqrt(2 * n)
        for _ in range(periods + periods // 10):
            before, struck = self.distance(one, other), []
            one, other = self.next(one, struck), self.next(other)
            after = self.distance(one, other)
            logs.append(math.log(after / before))
            closed = [contact for contact, _ in struck]
            impacts.append(len(closed) / (1.0 if self.flow.spring[0] is None else 2.0))  # springs open, too
            other[:2 * n] = one[:2 * n] + APART / after * (other - one)[:2 * n]
        turned = periods // 10  # of these the difference turns to the direction of growth
        period = self.flow.period
        return [np.array(mean(values[turned:])) / period for values in (logs, impacts)]


def agree(one, other):
    """Two values with their errors."""
    return abs(one[0] - other[0]) <= math.hypot(one[1], other[1])


def told(program, path):
    out = subprocess.run([program, "motion", path, "--json", "--timeout", "300"], capture_output=True, check=False).stdout
    return json.loads(out)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--scenes", type=int, default=60)
    parser.add_argument("--transient", type=int, default=600, help="forcing periods")
    parser.add_argument("--periods", type=int, default=1000, help="over which exponents are measured")
    asked = parser.parse_args()
    draw, remarks, found, settled, number = random.Random(f"{asked.seed} verdicts"), [], 0, 0, 0
    counts = {"verdicts": 0, "exponents": 0, "impacts": 0}
    with tempfile.TemporaryDirectory() as folder:
        while found < asked.scenes:
            path = pathlib.Path(folder, f"chain-{number}.toml")
            path.write_text(generators.chain_between_stops(draw, number))
            number += 1
            try:
                march = March(tomllib.loads(path.read_text()), asked.transient)
                if march.order is not None:
                    continue
                exponent, impacts = march.measure(asked.periods)
            except own_flow.Lost:
                continue
            found += 1
            said = told(asked.program, path)
            theirs = [(item["value"], item["error"]) for item in said["lyapunov"][:1]] or [(math.nan, 0.0)]
            rates = [contact["impacts_per_second"] for contact in said["contacts"]]
            rate = (sum(item["value"] for item in rates), sum(item["error"] for item in rates))
            expected = "irregular" if exponent[0] > exponent[1] else "quasi-periodic"
            if said["verdict"] == "periodic":
                with contextlib.suppress(own_flow.Lost):
                    march.follow(FURTHER * asked.transient)
                if march.order is not None and march.order % said["order"] == 0:
                    expected, settled = "periodic", settled + 1
            same = {"verdicts": said["verdict"] == expected}
            if expected != "periodic":
                same |= {"exponents": agree(theirs[0], exponent), "impacts": agree(rate, impacts)}
            for what, holds in same.items():
                counts[what] += holds
            if not all(same.values()):
                remarks.append(f"{path.stem}: {said['verdict']} {said['order'] or ''} {said['reason']}: exponent "
                               f"{theirs[0][0]:.4g} +- {theirs[0][1]:.1g}, impacts {rate[0]:.4g} +- {rate[1]:.1g}; here {expected}, "
                               f"{exponent[0]:.4g} +- {exponent[1]:.1g}, {impacts[0]:.4g} +- {impacts[1]:.1g}")
    print(f"seed {asked.seed}: {found} of {number} scenes do not repeat, {settled} of them settle later; of these agree "
          + ", ".join(f"{count} {what}" for what, count in counts.items()))
    print("\n".join(remarks))
    least = min(counts["exponents"], counts["impacts"])
    return int(counts["verdicts"] < found or 10 * least < 9 * (found - settled))


if __name__ == "__main__":
    sys.exit(main())
