"""Motions and orbits as arrays. Keys of records: docs/records.md."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from .program import NotConverged
from .response import complex_array

if TYPE_CHECKING:
    from .scene import Scene


@dataclass(frozen=True)
class Event:
    """What happens at a contact.

    contact: from 0.  time: [s], from the time origin of the load.  kind: "impact", "close" or "open".
    impulse: of an impact, on the structure, <= 0 [N s].
    """

    contact: int
    time: float
    kind: str
    impulse: float


def events_of(certificate: Mapping) -> tuple[Event, ...]:
    return tuple(Event(event["contact"], event["time"], event["kind"], event.get("value", 0.0))
                 for event in certificate.get("events", ()))


def stability_of(certificate: Mapping) -> str:
    word, reason = certificate.get("stability", ""), certificate.get("stability_reason", "")
    return f"{word}: {reason}" if reason else word


@dataclass(frozen=True)
class Solution:
    """A periodic motion by one method, as the program judged it; Nc contacts, N instants.

    record: the program's record, docs/records.md.  scene: what was solved.
    """

    scene: Scene = field(repr=False)
    record: Mapping = field(repr=False)

    @property
    def method(self) -> str:
        return self.record["method"]

    @property
    def options(self) -> Mapping:
        """Complete, defaults included."""
        return self.record["options"]

    @property
    def status(self) -> str:
        """"converged", "inaccurate" (the program disagrees), "not-converged", "timeout", ..: docs/records.md."""
        return self.record["status"]

    @property
    def message(self) -> str:
        return self.record["message"]

    @property
    def converged(self) -> bool:
        return self.status == "converged"

    @property
    def certified(self) -> bool:
        """Whether an exact orbit stands behind the answer."""
        return self.record["certificate"]["status"] == "certified"

    @property
    def period(self) -> float:
        """T [s]."""
        self._require_motion()
        return self.record["period"]

    @cached_property
    def t(self) -> np.ndarray:
        """N instants i T / N [s]."""
        self._require_motion()
        return np.array(self.record["trajectory"]["t"], dtype=float)

    @cached_property
    def x(self) -> np.ndarray:
        """Displacement of the contacts, Nc x N [m]."""
        return self._signal("x")

    @cached_property
    def velocity(self) -> np.ndarray:
        """x', Nc x N [m/s]."""
        return self._signal("velocity")

    @cached_property
    def force(self) -> np.ndarray:
        """Contact force on the structure, impulses aside, <= 0, Nc x N [N]."""
        return self._signal("force")

    @cached_property
    def impacts(self) -> tuple[Event, ...]:
        """Impulses that the method lists; where it lists none, impacts of the orbit behind its answer."""
        self._require_motion()
        listed = tuple(Event(item["contact"], item["time"], "impact", item["value"])
                       for item in self.record["trajectory"].get("impulses", ()))
        return listed or tuple(event for event in self.events if event.kind == "impact")

    @cached_property
    def events(self) -> tuple[Event, ...]:
        """Impacts, closings and openings of the orbit behind the answer, in their order."""
        return events_of(self.record["certificate"])

    @cached_property
    def multipliers(self) -> np.ndarray:
        """Floquet multipliers of the orbit behind the answer, complex; empty where they are not known."""
        return complex_array(self.record["certificate"].get("floquet", ()))

    @property
    def stable(self) -> bool | None:
        """Whether all multipliers are inside the unit circle; None where that is not known."""
        return self.record["certificate"].get("stable")

    @property
    def stability(self) -> str:
        """"stable", "unstable", "undefined: " and why, or empty where it is not known."""
        return stability_of(self.record["certificate"])

    @property
    def seconds(self) -> float | None:
        """Time of set-up and solve, the median of the repetitions [s]; None of builds that are not timed."""
        return self.record.get("seconds", {}).get("median")

    @property
    def errors(self) -> Mapping[str, float]:
        """Distances from the orbit behind the answer, relative: "x_l2", "velocity_l2", "impulse", .."""
        return self.record.get("errors", {})

    @property
    def physics(self) -> Mapping:
        """"penetration", "energy_defect", "effective_restitution", .."""
        return self.record.get("physics", {})

    @cached_property
    def extremes(self) -> tuple[np.ndarray, np.ndarray]:
        """Least and largest displacement of each contact, two arrays of Nc [m].

        Between two instants x is the cubic through values and velocities; at an impact that the method lists, on a rigid
        stop, it is the gap.
        """
        impulses = self.record["trajectory"].get("impulses", ()) if "trajectory" in self.record else ()
        least, largest = [], []
        for contact, (x, velocity) in enumerate(zip(self.x, self.velocity)):
            times = np.array([item["time"] for item in impulses if item["contact"] == contact], dtype=float)
            values = np.concatenate([x, turning_points(self.period, x, velocity, times)])
            if len(times) > 0 and "restitution" in self.scene.problem.law:
                values = np.append(values, self.scene.problem.gap[contact])
            least.append(values.min())
            largest.append(values.max())
        return np.array(least), np.array(largest)

    @property
    def amplitude(self) -> np.ndarray:
        """Half of the largest minus the least displacement, Nc [m]."""
        least, largest = self.extremes
        return (largest - least) / 2

    def plot(self, contact: int = 0, figure=None):
        """Waveform with the stop and the impacts, and phase portrait, of one contact. Returns the matplotlib figure."""
        from .plotting import plot_solution
        return plot_solution(self, contact, figure)

    def __repr__(self) -> str:
        return f"Solution({self.record['case']}: {self.status})"

    def _signal(self, key: str) -> np.ndarray:
        self._require_motion()
        return np.array(self.record["trajectory"][key], dtype=float).reshape(-1, len(self.t))

    def _require_motion(self) -> None:
        if "trajectory" not in self.record:
            raise NotConverged(f"{self.record['case']}: {self.status}: {self.message}", self)


def turning_points(period: float, x: np.ndarray, v: np.ndarray, impacts: np.ndarray) -> np.ndarray:
    """Displacements where the velocity changes its sign within one of the N steps: of the cubic through both ends.

    Left out are the steps that hold one of the `impacts` (instants [s]), where the velocity jumps.
    """
    step, after, later = period / len(x), np.roll(v, -1), np.roll(x, -1)
    smooth = np.ones(len(x), dtype=bool)
    for shift in (-1e-9, 1e-9):  # of a step: an impact on an instant belongs to the steps on both sides
        smooth[np.floor(impacts / step + shift).astype(int) % len(x)] = False
    turn = np.flatnonzero((v * after < 0) & smooth)
    s = v[turn] / (v[turn] - after[turn])  # of the step; the cubic is stationary there up to the square of the step
    return ((1 + 2 * s) * (1 - s) ** 2 * x[turn] + s * (1 - s) ** 2 * step * v[turn]
            + s ** 2 * (3 - 2 * s) * later[turn] + s ** 2 * (s - 1) * step * after[turn])


@dataclass(frozen=True)
class Orbit:
    """A certified periodic orbit of a scene. record: docs/records.md, section Orbits."""

    scene: Scene = field(repr=False)
    record: Mapping = field(repr=False)

    @property
    def fingerprint(self) -> str:
        """Equal for equal orbits."""
        return self.record["orbit"]

    @property
    def order(self) -> int:
        """Least period in forcing periods."""
        return self.record["order"]

    @property
    def period(self) -> float:
        """[s]"""
        return self.record["period"]

    @property
    def amplitude(self) -> float:
        """Half of the largest minus the least x, the largest over contacts [m]."""
        return self.record["amplitude"]

    @property
    def stable(self) -> bool | None:
        """None where round-off would decide, or it is undefined."""
        return self.record.get("stable")

    @property
    def stability(self) -> str:
        """"stable", "unstable", "undefined: " and why, or empty where round-off would decide."""
        return stability_of(self.record)

    @property
    def from_rest(self) -> bool:
        """Marching from rest comes to this orbit."""
        return bool(self.record.get("from_rest"))

    @cached_property
    def events(self) -> tuple[Event, ...]:
        return events_of(self.record)

    @cached_property
    def impacts(self) -> tuple[Event, ...]:
        return tuple(event for event in self.events if event.kind == "impact")

    @cached_property
    def multipliers(self) -> np.ndarray:
        """Floquet multipliers, complex."""
        return complex_array(self.record.get("floquet", ()))

    def __repr__(self) -> str:
        told = {True: "stable", False: "unstable", None: f"of {self.record.get('stability', 'unknown')} stability"}[self.stable]
        return (f"Orbit({self.fingerprint}: order {self.order}, {len(self.impacts)} impacts, "
                f"amplitude {self.amplitude:.6g} m, {told})")
