"""Figures by matplotlib, where it is installed."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .libraries import library

if TYPE_CHECKING:
    from .response import Branch, Response, Special
    from .results import Solution

STOP = {"color": "0.35", "linewidth": 1.2, "linestyle": (0, (6, 2))}
WALL = {"facecolor": "0.9", "edgecolor": "none", "zorder": 0}


def plot_solution(solution: Solution, contact: int, figure):
    """Left the waveform x(t) over one period, the stop at x = gap, impacts marked; right the phase portrait (x, x')."""
    require_contact(contact, len(solution.x))
    x, velocity = solution.x[contact], solution.velocity[contact]
    gap = solution.scene.problem.gap[contact]
    figure = figure or library("matplotlib.pyplot", "plot").figure(figsize=(8.0, 3.2), layout="constrained")
    wave, portrait = figure.subplots(1, 2, width_ratios=(1.6, 1))
    t = np.append(solution.t, solution.period)
    wave.plot(t, np.append(x, x[0]))
    low, high = wave.get_ylim()
    high = max(high, gap + 0.08 * (high - low))
    wave.axhline(gap, **STOP)
    wave.axhspan(gap, high, **WALL)
    wave.annotate("stop", (0.0, gap), (3, 2), textcoords="offset points", fontsize="small", color=STOP["color"])
    impacts = [event for event in solution.impacts if event.contact == contact]
    instants = [event.time % solution.period for event in impacts]
    wave.plot(instants, [gap] * len(impacts), "o", color="C3", zorder=3)
    if instants:
        wave.annotate("impact", (instants[0], gap), (6, -12), textcoords="offset points", fontsize="small", color="C3")
    wave.set(xlabel="t [s]", ylabel="x [m]", xlim=(0, solution.period), ylim=(low, high),
             title=f"{solution.method}, contact {contact}")
    portrait.plot(np.append(x, x[0]), np.append(velocity, velocity[0]))
    left, right = portrait.get_xlim()
    right = max(right, gap + 0.08 * (right - left))
    portrait.axvline(gap, **STOP)
    portrait.axvspan(gap, right, **WALL)
    portrait.set(xlabel="x [m]", ylabel="x' [m/s]", xlim=(left, right), title="phase portrait")
    for axes in (wave, portrait):
        axes.ticklabel_format(style="sci", scilimits=(-2, 4))
        axes.locator_params(axis="x", nbins=6)
    return figure


MARKS = {"fold": "s", "period-doubling": "D", "neimark-sacker": "^", "branch-point": "P", "phase-resonance": "v", "grazing": "o", "contact-change": "X"}


def plot_response(response: Response, contact: int, axes, **style):
    """Amplitude over frequency: solid where stable or not known, dashed where unstable, a gap where there is no answer."""
    require_contact(contact, min((branch.amplitude.shape[1] for branch in response.branches), default=0))
    axes = axes or library("matplotlib.pyplot", "plot").figure(layout="constrained").subplots()
    style = {"label": ", ".join(filter(None, [response.method, response.other_law])), **style}
    for branch in response.branches:
        amplitude = branch.amplitude[:, contact]
        for mask, line in ((~branch.unstable, "-"), (branch.unstable, "--")):
            if mask.any():
                drawn = axes.plot(branch.frequency, np.where(joined(mask), amplitude, np.nan), line, **style)
                style = {**style, "color": drawn[0].get_color(), "label": "_nolegend_"}
    mark_special(response, contact, axes)
    axes.set(xlabel="frequency of the load [rad/s]", ylabel="amplitude [m]")
    axes.legend(frameon=False)
    return axes


def mark_special(response: Response, contact: int, axes) -> None:
    """A mark for each special point, on the line between the two points of its branch beside it."""
    for kind, mark in MARKS.items():
        places = [(special.frequency, amplitude_at(branch, special, contact))
                  for branch in response.branches for special in branch.special if special.kind == kind]
        if places:
            axes.plot(*zip(*places), mark, label=kind, markersize=5, markerfacecolor="white", markeredgecolor="0.2", zorder=3)


def amplitude_at(branch: Branch, special: Special, contact: int) -> float:
    """Linear between the points beside it; where it lies beyond both in frequency, as a fold, that of the nearer one."""
    beside = slice(max(special.after - 1, 0), special.after + 1)
    order = np.argsort(branch.frequency[beside])
    return float(np.interp(special.frequency, branch.frequency[beside][order], branch.amplitude[beside, contact][order]))


def require_contact(contact: int, count: int) -> None:
    if not 0 <= contact < count:
        raise ValueError(f"contact = {contact} (must be below {count}, the number of contacts with an answer)")


def joined(mask: np.ndarray) -> np.ndarray:
    """The points of a mask and, so that lines have no gaps, the first one after each run of them."""
    result = mask.copy()
    result[1:] |= mask[:-1]
    return result
