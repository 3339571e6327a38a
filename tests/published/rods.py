"""A driven bar before an elastic stop, in its modes: the flow of a period by Taylor series, and Anderson's acceleration of it to the periodic motion."""

import math

from flow import derivative, horner, polynomial, solve

ELEMENTS, LENGTH, AREA, YOUNG, DENSITY, RATIO, FORCE, GAP = 20, 0.13, 15.6e-4, 210e9, 7800.0, 7.5e-3, 25e3, 0.2e-3
ORDER = 18  # of the series
REACH = 1.5  # step times the highest frequency
NEAR = 0.01  # change of a state in a period, in gaps, from which on the motion is extrapolated


def modes():
    """(mass, frequency) of each mode of linear elements with consistent masses, fixed at one end, whose displacement of the free end is 1."""
    width = LENGTH / ELEMENTS
    found = []
    for j in range(ELEMENTS):
        cosine = math.cos((2 * j + 1) * math.pi / (2 * ELEMENTS))
        mass = DENSITY * AREA * width / 6.0 * (4.0 + 2.0 * cosine) * ELEMENTS / 2.0
        spring = YOUNG * AREA / width * 2.0 * (1.0 - cosine) * ELEMENTS / 2.0
        found.append((mass, math.sqrt(spring / mass)))
    return found


class Rod:
    def __init__(self, stop, omega):
        self.stop, self.omega = stop, omega
        self.lightness = [1.0 / mass for mass, _ in modes()]
        self.damping, self.springs = [2.0 * RATIO * w for _, w in modes()], [w**2 for _, w in modes()]
        fastest = math.sqrt(max(self.springs) + stop * sum(self.lightness))
        self.steps = math.ceil(2.0 * math.pi / omega * fastest / REACH)

    def series(self, time, q, v, closed):
        """Taylor coefficients of all modes."""
        phase = self.omega * time
        turn = [math.cos(phase), -math.sin(phase), -math.cos(phase), math.sin(phase)]
        series, scale = [q, v], 1.0
        for k in range(ORDER - 1):
            load = FORCE * turn[k % 4] * scale
            if closed:
                load -= self.stop * (sum(series[k]) - (GAP if k == 0 else 0.0))
            load, drag, pull = load / ((k + 1) * (k + 2)), 1.0 / (k + 2), 1.0 / ((k + 1) * (k + 2))
            series.append([load * w - drag * d * b - pull * s * a for w, d, s, a, b in zip(self.lightness, self.damping, self.springs, series[k], series[k + 1])])
            scale *= self.omega / (k + 1)
        return series

    def period(self, state):
        """State after a period, and the largest distance of the tip from rest."""
        q, v, time, end = state[:ELEMENTS], state[ELEMENTS:], 0.0, 2.0 * math.pi / self.omega
        step, closed, far = end / self.steps, sum(state[:ELEMENTS]) > GAP, 0.0
        while end - time > 1e-12 * end:
            h = min(step, end - time)
            series = self.series(time, q, v, closed)
            tip = [sum(term) for term in series]
            if (polynomial(tip, h) > GAP) != closed:
                h = between(lambda x: (polynomial(tip, x) > GAP) != closed, 0.0, h)
                closed = not closed
            slope = [(k + 1) * a for k, a in enumerate(tip[1:])]
            if slope[0] * polynomial(slope, h) < 0.0:
                far = max(far, abs(polynomial(tip, between(lambda x: polynomial(slope, x) * slope[0] < 0.0, 0.0, h))))
            q, v, time = horner(series, h), horner(derivative(series), h), time + h
        return [*q, *v], far


def between(passed, low, high):
    """Where `passed` becomes true."""
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if passed(middle) else (middle, high)
    return high


def closed_orbit(rod, state):
    """The fixed point of a period, by Anderson's acceleration with the last six misses once the state changes little."""
    weights = [1.0] * ELEMENTS + [1.0 / rod.omega] * ELEMENTS
    states, misses = [], []
    for _ in range(300):
        gone, far = rod.period(state)
        miss = [(b - a) * w for a, b, w in zip(state, gone, weights)]
        size = math.sqrt(sum(x * x for x in miss))
        if size < 1e-11 * GAP:
            return state, far
        if size > NEAR * GAP:
            state = gone
            continue
        states, misses = [*states[-6:], gone], [*misses[-6:], miss]
        state = mixed(states, misses)
    raise ArithmeticError("no closed orbit")


def mixed(states, misses):
    """Of the affine combinations of the states, that of the least combined miss."""
    if len(states) == 1:
        return states[0]
    last = misses[-1]
    changes = [[a - b for a, b in zip(miss, last)] for miss in misses[:-1]]
    lengths = [math.sqrt(sum(x * x for x in change)) for change in changes]
    changes = [[x / length for x in change] for change, length in zip(changes, lengths)]
    normal = [[sum(x * y for x, y in zip(a, b)) + (1e-10 if a is b else 0.0) for b in changes] for a in changes]
    shares = solve(normal, [-sum(x * y for x, y in zip(a, last)) for a in changes])
    return [x + sum(share / length * (s[i] - x) for share, length, s in zip(shares, lengths, states)) for i, x in enumerate(states[-1])]


def rod_distance(ratio, omega):
    """Largest distance of the tip from rest [m] in the motion that rest leads to; the stop is `ratio` E A / L."""
    return closed_orbit(Rod(ratio * YOUNG * AREA / LENGTH, omega), [0.0] * (2 * ELEMENTS))[1]
