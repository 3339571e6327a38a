"""Frequency responses as arrays."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import TYPE_CHECKING

import numpy as np

from .libraries import library

if TYPE_CHECKING:
    from .scene import Scene


@dataclass(frozen=True)
class Special:
    """Where a branch changes: "fold", "period-doubling", "neimark-sacker", "branch-point", "phase-resonance", "grazing" or "contact-change".

    frequency: [rad/s].  after: points of the branch before it.  multipliers: complex.  text: what happens, or "".
    """

    kind: str
    frequency: float
    after: int
    multipliers: np.ndarray
    text: str


@dataclass(frozen=True)
class Branch:
    """Points of a response in their order, P of them, of Nc contacts.

    frequency: P [rad/s].  amplitude: half of largest minus least displacement, P x Nc [m].  x_max: largest one, P x Nc [m];
    both NaN where there is no answer.  status: P words, docs/records.md.  stable, unstable: P truth values, both False where
    it is not known.  special: located points.  began, ended: why the branch has its ends.
    second, damping_ratio: P, of backbones the factor of the load and the damping ratio of the mode [-], NaN of others.
    """

    frequency: np.ndarray
    amplitude: np.ndarray
    x_max: np.ndarray
    status: np.ndarray
    stable: np.ndarray
    unstable: np.ndarray
    special: tuple[Special, ...] = ()
    began: str = ""
    ended: str = ""
    second: np.ndarray = field(default_factory=lambda: np.array([]))
    damping_ratio: np.ndarray = field(default_factory=lambda: np.array([]))

    @property
    def converged(self) -> np.ndarray:
        """P truth values."""
        return self.status == "converged"

    def __repr__(self) -> str:
        ends = f", {self.frequency[0]:.6g} to {self.frequency[-1]:.6g} rad/s" if len(self.frequency) > 0 else ""
        return f"Branch({len(self.frequency)} points{ends}, {self.stable.sum()} stable, {self.unstable.sum()} unstable)"

    @classmethod
    def of(cls, points: Sequence[Mapping], branch: Mapping = MappingProxyType({})) -> Branch:
        """Of the points of a way of `sweep --method`, or of a branch of `sweep --methods`; exact orbits have no status there."""
        contacts = max((len(point.get("amplitude", ())) for point in points), default=0)
        special = [Special(item["kind"], item["omega"], item["after"], complex_array(item["multipliers"]), item.get("text", ""))
                   for item in branch.get("special", ())]
        return cls(frequency=np.array([point.get("frequency", point.get("omega")) for point in points], dtype=float),
                   amplitude=table(points, "amplitude", contacts), x_max=table(points, "x_max", contacts),
                   status=np.array([point.get("status", "converged") for point in points], dtype=str),
                   stable=np.array([point.get("stable") is True for point in points], dtype=bool),
                   unstable=np.array([point.get("stable") is False for point in points], dtype=bool),
                   special=tuple(special), began=branch.get("began", ""), ended=branch.get("ended", ""),
                   **{key: np.array([point.get(key, np.nan) for point in points], dtype=float) for key in ("second", "damping_ratio")})


def table(points: Sequence[Mapping], key: str, columns: int) -> np.ndarray:
    return np.array([point.get(key, [np.nan] * columns) for point in points], dtype=float).reshape(len(points), columns)


@dataclass(frozen=True)
class Response:
    """A frequency response by one method.

    branches: of `Scene.branches` and `Scene.backbone` those found, of `Scene.sweep` one for each way that the frequency went.
    points: of each branch, as the program gives them, messages included.
    notes: what was met and not followed.
    other_law: the law that the method represents where it is not the scene's, as "e = 1"; else empty.
    incomplete: of `Scene.branches` the parts of the interval where no branch has a motion, (from, to) [rad/s].
    """

    scene: Scene = field(repr=False)
    method: str
    branches: tuple[Branch, ...]
    points: Sequence[Sequence[Mapping]] = field(repr=False)
    notes: Sequence[str] = ()
    other_law: str = ""
    incomplete: Sequence[tuple[float, float]] = ()

    @classmethod
    def from_steps(cls, scene: Scene, method: str, steps: Sequence[Mapping]) -> Response:
        ways = [[step for step in steps if step["way"] == way] for way in dict.fromkeys(step["way"] for step in steps)]
        return cls(scene, method, tuple(map(Branch.of, ways)), ways, other_law=next((step.get("other_law", "") for step in steps), ""))

    @classmethod
    def from_branches(cls, scene: Scene, method: str, answer: Mapping) -> Response:
        notes = [*answer["notes"], *filter(None, [answer["unfinished"]])]
        points = [branch["points"] for branch in answer["branches"]]
        return cls(scene, method, tuple(Branch.of(branch["points"], branch) for branch in answer["branches"]), points, notes,
                   incomplete=tuple((part["from"], part["to"]) for part in answer.get("incomplete", ())))

    @property
    def converged(self) -> bool:
        """Whether every point did."""
        return all(branch.converged.all() for branch in self.branches)

    def plot(self, contact: int = 0, axes=None, **style):
        """Amplitude over frequency, unstable parts dashed, special points marked; `style` as of matplotlib's plot.

        Returns the axes.
        """
        from .plotting import plot_response
        return plot_response(self, contact, axes, **style)

    def to_frame(self):
        """One row per point, columns flat: branch, frequency, status, amplitude.0, .. Needs pandas."""
        rows = [{"branch": number, **flat(point)} for number, points in enumerate(self.points) for point in points]
        return library("pandas", "Response.to_frame").DataFrame(rows)


def complex_array(pairs: Sequence[Sequence[float]]) -> np.ndarray:
    return np.array([complex(*pair) for pair in pairs], dtype=complex)


def flat(item: Mapping) -> dict:
    """A record or a point whose short lists of numbers are one entry each: {"amplitude": [1, 2]} has amplitude.0, amplitude.1."""
    result = {}
    for key, value in item.items():
        if isinstance(value, Mapping):
            result |= {f"{key}.{inner}": entry for inner, entry in flat(value).items()}
        elif isinstance(value, list) and value and all(isinstance(entry, (int, float)) for entry in value):
            result |= {f"{key}.{place}": entry for place, entry in enumerate(value)}
        else:
            result[key] = value
    return result
