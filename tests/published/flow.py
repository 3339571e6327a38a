"""Motion of a piecewise linear system by Taylor series: an integrator that shares nothing with the program under test.

Between events M u'' + C u' + K u = f(t) is linear, so that the coefficients of u(t) follow from each other; steps are as long as the series allows, events are
zeros of its polynomials. Stops are springs, with a damper beside them or without, or rigid with a coefficient of restitution.
"""

import math
from dataclasses import dataclass, field
from operator import mul

ORDER = 30
REACH = 5.0  # of a step, in units of the shortest 1 / omega: the series then ends below 1e-13 of its largest term
PROBES = 16  # points of a step between which a gap may change its sign


def dot(a, b):
    return sum(map(mul, a, b))


def times(matrix, vector):
    return [dot(row, vector) for row in matrix]


def solve(matrix, right):
    """Gauss's elimination with row pivots."""
    n = len(right)
    rows = [[*row, value] for row, value in zip(matrix, right)]
    for j in range(n):
        pivot = max(range(j, n), key=lambda i: abs(rows[i][j]))
        rows[j], rows[pivot] = rows[pivot], rows[j]
        for i in range(j + 1, n):
            factor = rows[i][j] / rows[j][j]
            if factor:
                rows[i] = [a - factor * b for a, b in zip(rows[i], rows[j])]
    x = [0.0] * n
    for i in reversed(range(n)):
        x[i] = (rows[i][n] - dot(rows[i][i + 1:n], x[i + 1:])) / rows[i][i]
    return x


def inverse(matrix):
    n = len(matrix)
    columns = [solve(matrix, [float(i == j) for i in range(n)]) for j in range(n)]
    return [list(row) for row in zip(*columns)]


@dataclass
class Stop:
    """x = normal . u <= gap: a spring [N/m] with a damper [N s/m], or rigid where there is none."""

    normal: list
    gap: float
    spring: float = 0.0
    damper: float = 0.0
    restitution: float = 1.0


@dataclass
class System:
    mass: list
    damping: list
    stiffness: list
    load: list = field(default_factory=list)  # (coordinate, angular frequency, cos, sin)
    stops: list = field(default_factory=list)

    def __post_init__(self):
        self.flexibility = inverse(self.mass)
        self.parts = {}

    def part(self, closed):
        """M^-1 K, M^-1 C, the constant M^-1 f and the shortest time scale while these stops press."""
        if closed not in self.parts:
            stiffness, damping = [row[:] for row in self.stiffness], [row[:] for row in self.damping]
            constant = [0.0] * len(self.mass)
            for j in closed:
                stop = self.stops[j]
                for a, wa in enumerate(stop.normal):
                    constant[a] += stop.spring * stop.gap * wa
                    for b, wb in enumerate(stop.normal):
                        stiffness[a][b] += stop.spring * wa * wb
                        damping[a][b] += stop.damper * wa * wb
            scaled = [[dot(row, column) for column in zip(*stiffness)] for row in self.flexibility]
            damped = [[dot(row, column) for column in zip(*damping)] for row in self.flexibility]
            rate = max([math.sqrt(max(sum(map(abs, row)) for row in scaled)), max(sum(map(abs, row)) for row in damped),
                        *(omega for _, omega, _, _ in self.load), 1e-3])
            self.parts[closed] = scaled, damped, times(self.flexibility, constant), 1.0 / rate
        return self.parts[closed]


def load_series(system, t):
    """Taylor coefficients of M^-1 f at t."""
    n = len(system.mass)
    series = [[0.0] * n for _ in range(ORDER)]
    for coordinate, omega, cos, sin in system.load:
        c, s, factor = math.cos(omega * t), math.sin(omega * t), 1.0
        value, slope = cos * c + sin * s, sin * c - cos * s
        for j in range(ORDER):
            term = (value, slope, -value, -slope)[j % 4] * factor
            for i in range(n):
                series[j][i] += system.flexibility[i][coordinate] * term
            factor *= omega / (j + 1)
    return series


def motion_series(system, t, u, v, closed):
    scaled, damped, constant, _ = system.part(closed)
    loads = load_series(system, t)
    loads[0] = [a + b for a, b in zip(loads[0], constant)]
    series = [u, v]
    for j in range(ORDER):
        pull, drag = times(scaled, series[j]), times(damped, series[j + 1])
        series.append([(f - k - (j + 1) * d) / ((j + 1) * (j + 2)) for f, k, d in zip(loads[j], pull, drag)])
    return series


def horner(series, h):
    value = [0.0] * len(series[0])
    for term in reversed(series):
        value = [a * h + b for a, b in zip(value, term)]
    return value


def derivative(series):
    return [[(j + 1) * a for a in term] for j, term in enumerate(series[1:])]


def polynomial(coefficients, h):
    value = 0.0
    for a in reversed(coefficients):
        value = value * h + a
    return value


def first_rise(coefficients, step):
    """Least h in (0, step] at which the polynomial passes 0 upwards, by bisection; None if it does not."""
    before, low = polynomial(coefficients, 0.0), 0.0
    for i in range(1, PROBES + 1):
        high = step * i / PROBES
        after = polynomial(coefficients, high)
        if before <= 0.0 < after:
            for _ in range(80):
                middle = 0.5 * (low + high)
                low, high = (middle, high) if polynomial(coefficients, middle) <= 0.0 else (low, middle)
            return high
        before, low = after, high
    return None


def turns(coefficients, step):
    """Values of the polynomial at both ends of [0, step] and where it turns between them."""
    slope = [(j + 1) * a for j, a in enumerate(coefficients[1:])]
    yield polynomial(coefficients, 0.0)
    yield polynomial(coefficients, step)
    for sign in (1.0, -1.0):
        h = first_rise([sign * a for a in slope], step)
        if h is not None:
            yield polynomial(coefficients, h)


@dataclass
class Event:
    t: float
    stop: int
    kind: str  # "close", "open" or "impact"
    value: float = 0.0  # impulse of an impact [N s]


class Flow:
    """The motion from a state, and its events."""

    def __init__(self, system, u, v, t=0.0):
        self.system, self.t, self.u, self.v = system, t, list(u), list(v)
        self.events = []
        self.least, self.most = math.inf, -math.inf
        self.closed = frozenset(j for j, stop in enumerate(system.stops) if stop.spring and
                                (dot(stop.normal, u) - stop.gap, dot(stop.normal, v)) > (0.0, 0.0))

    def signals(self, series):
        """For each stop what must not rise through 0: the gap, or of one that presses minus its force."""
        for j, stop in enumerate(self.system.stops):
            x = [dot(stop.normal, term) for term in series]
            x[0] -= stop.gap
            if j in self.closed:
                rate = [(i + 1) * a for i, a in enumerate(x[1:])] + [0.0]
                yield j, [-stop.spring * a - stop.damper * b for a, b in zip(x, rate)]
            else:
                yield j, x

    def advance(self, end, watched=None):
        """Displacement and velocity at `end`; the extremes of `watched` . u on the way are noted."""
        while self.t < end:
            step = min(end - self.t, REACH * self.system.part(self.closed)[3])
            series = motion_series(self.system, self.t, self.u, self.v, self.closed)
            hits = [(h, j) for j, signal in self.signals(series) if (h := first_rise(signal, step)) is not None]
            h, stop = min(hits, default=(step, None))
            self.t = end if stop is None and self.t + step >= end else self.t + h
            self.u, self.v = horner(series, h), horner(derivative(series), h)
            if watched:
                values = list(turns([dot(watched, term) for term in series], h))
                self.least, self.most = min(self.least, *values), max(self.most, *values)
            if stop is not None:
                self.meet(stop)
        return self.u, self.v

    def meet(self, j):
        stop = self.system.stops[j]
        if j in self.closed:
            self.closed = self.closed - {j}
            self.events.append(Event(self.t, j, "open"))
        elif stop.spring:
            self.closed = self.closed | {j}
            self.events.append(Event(self.t, j, "close"))
        else:
            answer = times(self.system.flexibility, stop.normal)
            impulse = -(1.0 + stop.restitution) * dot(stop.normal, self.v) / dot(stop.normal, answer)
            self.v = [a + impulse * b for a, b in zip(self.v, answer)]
            self.u = [a - (dot(stop.normal, self.u) - stop.gap) * b / dot(stop.normal, answer) for a, b in zip(self.u, answer)]
            self.events.append(Event(self.t, j, "impact", impulse))
