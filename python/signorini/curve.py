"""Response curves as a method gives them: what `follow` is asked, and what it returns."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

KINDS = ("fold", "period-doubling", "neimark-sacker", "branch-point", "phase-resonance", "grazing", "contact-change")


@dataclass(frozen=True)
class Interval:
    """The frequencies of the load that a curve is asked over.

    start, stop: the ends [rad/s], start may be the larger one.  max_order: longest period [forcing periods].
    max_branches, max_points: of one branch.  at: frequencies at which every branch should have points.
    phases: instants of a forcing period at which motions are compared, 0 where they are not; points whose number of instants
    is a multiple of phases times their order are taken as they are.
    """

    start: float
    stop: float
    max_order: int = 1
    max_branches: int = 60
    max_points: int = 2000
    at: Sequence[float] = ()
    phases: int = 0

    @classmethod
    def from_request(cls, request: Mapping) -> Interval:
        """Of what the program hands to a command, docs/plugins.md."""
        keys = ("max_order", "max_branches", "max_points", "at", "phases")
        return cls(request["from"], request["to"], **{key: request[key] for key in keys})


@dataclass(frozen=True)
class Point:
    """One motion of a curve, of Nc contacts: either x or coefficients.

    frequency: omega of the load [rad/s].  order: forcing periods per period, k.
    x: displacements at the N instants i k 2 pi / (N omega), t = 0 being the time origin of the load, Nc x N [m].
    coefficients: Fourier series of base frequency omega / k, Nc x (1 + 2 H): a_0, a_1, b_1, a_2, b_2, .. of
    a_0 + sum of a_h cos(h omega t / k) + b_h sin(h omega t / k) [m].
    stable: None where it is not known.  impacts: in a period, or closings.
    """

    frequency: float
    x: np.ndarray | None = None
    coefficients: np.ndarray | None = None
    order: int = 1
    stable: bool | None = None
    impacts: int = 0

    def to_json(self) -> dict:
        """A point of a command's answer. Raises ValueError where it has not one of both, or no finite table."""
        name, values = ("x", self.x) if self.x is not None else ("coefficients", self.coefficients)
        if (self.x is None) == (self.coefficients is None):
            raise ValueError(f"point at {self.frequency:g} rad/s (must have either x or coefficients)")
        table = np.asarray(values, dtype=float)
        if table.ndim != 2 or not np.isfinite(table).all():
            raise ValueError(f"point at {self.frequency:g} rad/s: {name} {table.shape} (must be Nc rows of finite numbers)")
        result = {"omega": float(self.frequency), "order": int(self.order), name: table.tolist(), "impacts": int(self.impacts)}
        return result if self.stable is None else {**result, "stable": bool(self.stable)}


@dataclass(frozen=True)
class SpecialPoint:
    """A point of a curve that was located.

    kind: "fold", "period-doubling", "neimark-sacker", "branch-point", "phase-resonance", "grazing" or "contact-change".
    after: points of the curve before it.  text: more about it.
    """

    kind: str
    point: Point
    after: int = 0
    text: str = ""

    def to_json(self) -> dict:
        """A special point of a command's answer. Raises ValueError for an unknown kind."""
        if self.kind not in KINDS:
            raise ValueError(f"kind = {self.kind} (must be one of {', '.join(KINDS)})")
        return {"kind": self.kind, **self.point.to_json(), "after": int(self.after), "text": self.text}


@dataclass(frozen=True)
class Curve:
    """Motions that follow each other, two at least.

    points: in their order.  special: points that were located.  began, ended: why there.  kind: of what kind its motions are.
    by_steps: neighbours are steps of the frequency and may lie on different curves; else one continues the other.
    """

    points: Sequence[Point]
    special: Sequence[SpecialPoint] = ()
    began: str = ""
    ended: str = ""
    kind: str = ""
    by_steps: bool = False

    def to_json(self) -> dict:
        """A branch of a command's answer, or with "scene" beside it a line of a file of branches."""
        return {"sequence": self.kind, "began": self.began, "ended": self.ended, "by_steps": self.by_steps,
                "points": [point.to_json() for point in self.points], "special": [point.to_json() for point in self.special]}
