"""A periodic motion as a method gives it, and as a method may start from."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np


@dataclass(frozen=True)
class Motion:
    """Nc contacts at the N instants i T / N, i = 0..N-1; t = 0 is the time origin of the load.

    x: displacements [m], velocity: x' [m/s], force: contact force on the structure without impulses, <= 0 [N]; each Nc x N.
    Between the instants x is a cubic through values and velocities, the others are straight lines.
    period: T [s]; None: that of the problem.
    impulses: (contact, time [s], impulse <= 0 [N s]), in time order; of methods that keep impacts.
    bandwidth: harmonics that the method resolves.  residual: of the method's own equations, relative [-].
    work: counts "unknowns", "iterations", "pivots", "rhs_evaluations", "factorisations", "points" of a curve followed to it.  message: one sentence.
    """

    x: np.ndarray
    velocity: np.ndarray
    force: np.ndarray
    period: float | None = None
    impulses: Sequence[tuple[int, float, float]] = ()
    bandwidth: int | None = None
    residual: float | None = None
    work: Mapping[str, int] = field(default_factory=dict)
    message: str = ""

    @classmethod
    def from_json(cls, text: Mapping) -> Motion:
        """The `start` of a request of the program."""
        motion = text["trajectory"]
        signals = {key: np.array(motion[key], dtype=float) for key in ("x", "velocity", "force")}
        impulses = [(item["contact"], item["time"], item["value"]) for item in motion.get("impulses", ())]
        return cls(**signals, period=text["period"], impulses=impulses, bandwidth=motion.get("bandwidth"))

    def to_json(self, period: float) -> dict:
        """What a command prints, but its verdict. period: that of the problem [s].

        Raises ValueError for signals of other shapes, or that are not finite.
        """
        period = float(self.period or period)
        signals = {key: np.asarray(getattr(self, key), dtype=float) for key in ("x", "velocity", "force")}
        shapes = {signal.shape for signal in signals.values()}
        if len(shapes) != 1 or len(next(iter(shapes))) != 2 or next(iter(shapes))[1] == 0:
            told = ", ".join(f"{key} {signal.shape}" for key, signal in signals.items())
            raise ValueError(f"motion: {told} (must each be Nc x N)")
        for key, signal in signals.items():
            if not np.isfinite(signal).all():
                raise ValueError(f"motion: {key} has values that are not finite")
        instants = signals["x"].shape[1]
        trajectory: dict = {"t": (period / instants * np.arange(instants)).tolist()}
        trajectory |= {key: signal.tolist() for key, signal in signals.items()}
        if self.impulses:
            trajectory["impulses"] = [{"contact": int(contact), "time": float(time), "value": float(value)}
                                      for contact, time, value in self.impulses]
        if self.bandwidth is not None:
            trajectory["bandwidth"] = int(self.bandwidth)
        result: dict = {"period": period, "trajectory": trajectory}
        if self.message:
            result["message"] = self.message
        if self.residual is not None:
            result["residual"] = float(self.residual)
        if self.work:
            result["work"] = {key: int(count) for key, count in self.work.items()}
        return result
