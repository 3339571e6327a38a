"""Nonlinear modes, and the harmonics of motions: more of oracles.py."""

import functools
import math

from flow import Flow, Stop, System, dot, inverse, solve
from oracles import TWO_PI, beam, closed_orbit, extremes, without

CHAIN = [[2.0, -1.0], [-1.0, 1.0]]  # wall, spring, mass, spring, mass: all 1
UNIT = [[1.0, 0.0], [0.0, 1.0]]


def root(miss, guess):
    """Newton's method in two unknowns, slopes by differences."""
    for _ in range(30):
        at = miss(guess)
        columns = []
        for i in range(2):
            moved = [*guess]
            moved[i] += 1e-6
            columns.append([(a - b) / 1e-6 for a, b in zip(miss(moved), at)])
        change = solve([list(row) for row in zip(*columns)], at)
        guess = [a - b for a, b in zip(guess, change)]
        if max(map(abs, change)) < 1e-12:
            return guess
    raise ArithmeticError("no zero")


def mode_between_stops(frequency):
    """code_aster sdnd123: energy [J] of the second mode at a frequency [Hz]. It is odd and even, so that a quarter of its period leads from the turn to u = 0."""
    stops = [Stop([1.0, 0.0], 1.0, 30.0), Stop([-1.0, 0.0], 1.0, 30.0)]
    system = System(UNIT, [[0.0, 0.0], [0.0, 0.0]], CHAIN, [], stops)
    a, b = root(lambda turn: Flow(system, turn, [0.0, 0.0]).advance(0.25 / frequency)[0], [1.0046, -0.6173])
    return 0.5 * (a * a + (a - b)**2) + 15.0 * max(a - 1.0, 0.0)**2


def rounded_force(u, stop, roundness):
    """The root f of f (1 - (u - f / stop)^2) = roundness u that belongs to a stop at +-1: code_aster's law of a stop on both sides."""
    size = abs(u)

    def excess(w):
        return stop * (size - w) * (1.0 - w * w) - roundness * size

    high, step = min(size, 1.0), 1e-6
    while excess(high - step) < 0.0:
        step *= 2.0
    low = high - step
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if excess(middle) > 0.0 else (low, middle)
    return math.copysign(stop * (size - low), u) if size else 0.0


def mode_between_stops_told(frequency):
    """The same with stops that are rounded off by 0.005, by the rule of Runge and Kutta; all energy is kinetic where u = 0."""
    steps = 400
    h = 0.25 / frequency / steps

    def rate(y):
        return [y[2], y[3], y[1] - 2.0 * y[0] - rounded_force(y[0], 30.0, 0.005), y[0] - y[1]]

    def quarter(turn):
        y = [*turn, 0.0, 0.0]
        for _ in range(steps):
            k1 = rate(y)
            k2 = rate([a + 0.5 * h * b for a, b in zip(y, k1)])
            k3 = rate([a + 0.5 * h * b for a, b in zip(y, k2)])
            k4 = rate([a + h * b for a, b in zip(y, k3)])
            y = [a + h / 6.0 * (p + 2.0 * q + 2.0 * r + s) for a, p, q, r, s in zip(y, k1, k2, k3, k4)]
        return y

    *_, v, w = quarter(root(lambda turn: quarter(turn)[:2], [0.814, -0.5005]))
    return 0.5 * (v * v + w * w)


RATES = [math.sqrt(0.5 * (3.0 - math.sqrt(5.0))), math.sqrt(0.5 * (3.0 + math.sqrt(5.0)))]  # of the linear modes of CHAIN


def chain_mode(omega):
    """Energy [J] of a mode of one impact a period: two masses, a rigid stop 1 m before the second. Sums over the linear modes."""
    shapes = [1.0 / (1.0 + (2.0 - rate**2)**-2) for rate in RATES]  # squares at the second mass
    half = math.pi / omega
    impulse = -1.0 / sum(s / (2.0 * w * math.tan(w * half)) for w, s in zip(RATES, shapes))
    return impulse**2 / 8.0 * sum(s / math.sin(w * half)**2 for w, s in zip(RATES, shapes))


def mode_between_rigid_stops(omega):
    """The same of the mode that strikes a stop 1 m before and one 1 m behind the first mass in turn, half a period apart."""
    shapes = [1.0 / (1.0 + (2.0 - rate**2)**2) for rate in RATES]  # squares at the first mass
    quarter = 0.5 * math.pi / omega
    impulse = 1.0 / sum(s * math.tan(w * quarter) / (2.0 * w) for w, s in zip(RATES, shapes))
    return impulse**2 / 8.0 * sum(s / math.cos(w * quarter)**2 for w, s in zip(RATES, shapes))


# NLvib, example 03.

def two_masses(omega):
    damping = [[0.03, -0.03], [-0.03, 0.06]]
    return System(UNIT, damping, [[1.0, -1.0], [-1.0, 2.0]], [(1, omega, 0.1, 0.0)], [Stop([1.0, 0.0], 1.0, 100.0)])


@functools.lru_cache
def resonant_state(omega=0.7541):
    """State at t = 0 of the motion with contact and the largest amplitude, which is unstable there: followed from 0.7 rad/s, where a march finds it."""
    state, period = [0.0, 0.0, 2.0, 1.0], TWO_PI / 0.7
    for _ in range(150):
        u, v = Flow(two_masses(0.7), state[:2], state[2:]).advance(period)
        state = [*u, *v]
    for i in range(28):
        at = 0.7 + (omega - 0.7) * i / 27
        state = closed_orbit(two_masses(at), state, TWO_PI / at)
    return state


def root_mean_square_of_harmonics(samples, harmonics):
    """NLvib's measure: the mean counted half, as sqrt(sum of squares of all coefficients / 2)."""
    n = len(samples)
    total = (math.fsum(samples) / n)**2
    for h in range(1, harmonics + 1):
        total += (2.0 / n * math.fsum(x * math.cos(TWO_PI * h * i / n) for i, x in enumerate(samples)))**2
        total += (2.0 / n * math.fsum(x * math.sin(TWO_PI * h * i / n) for i, x in enumerate(samples)))**2
    return math.sqrt(0.5 * total)


@functools.lru_cache
def resonant_measure(omega, instants):
    state = resonant_state(omega)
    flow, samples = Flow(two_masses(omega), state[:2], state[2:]), []
    for i in range(instants):
        samples.append(flow.advance(TWO_PI / omega * i / instants)[0][0] if i else state[0])
    return root_mean_square_of_harmonics(samples, 21)


def resonant_amplitude(omega):
    state, flowing = resonant_state(omega), two_masses(omega)
    least, most = extremes(flowing, state, TWO_PI / omega, [1.0, 0.0])
    return 0.5 * (most - least)


# code_aster sdnl32: a hinged beam with modal damping.

NODES = [0.0, 0.0783, 0.1566, 0.2349, 0.3132, 0.3915, 0.462, 0.5481, 0.6264, 0.7047, 0.783]
THROWN = [-0.29754, -0.59508, -0.89262, -1.19016, -1.4877, -1.7556, -2.08278, -2.38032, -2.67786, -2.96786]


def cholesky(matrix):
    n = len(matrix)
    lower = [[0.0] * n for _ in range(n)]
    for i in range(n):
        for j in range(i + 1):
            rest = matrix[i][j] - dot(lower[i][:j], lower[j][:j])
            lower[i][j] = math.sqrt(rest) if i == j else rest / lower[j][j]
    return lower


def transposed(matrix):
    return [list(row) for row in zip(*matrix)]


def product(a, b):
    columns = transposed(b)
    return [[dot(row, column) for column in columns] for row in a]


def symmetric_modes(matrix):
    """Eigenvalues, and eigenvectors as rows, by Jacobi's rotations."""
    n = len(matrix)
    a, vectors = [row[:] for row in matrix], [[float(i == j) for j in range(n)] for i in range(n)]
    for _ in range(12):
        for p in range(n - 1):
            for q in range(p + 1, n):
                if abs(a[p][q]) <= 1e-18 * max(abs(a[p][p]), abs(a[q][q])):
                    continue
                angle = 0.5 * math.atan2(2.0 * a[p][q], a[q][q] - a[p][p])
                c, s = math.cos(angle), math.sin(angle)
                for rows in (a, vectors):
                    rows[p], rows[q] = [c * x - s * y for x, y in zip(rows[p], rows[q])], [s * x + c * y for x, y in zip(rows[p], rows[q])]
                for row in a:
                    row[p], row[q] = c * row[p] - s * row[q], s * row[p] + c * row[q]
    return [a[i][i] for i in range(n)], vectors


def modal_damping(mass, stiffness, ratio):
    lower = cholesky(mass)
    back = inverse(lower)
    squares, shapes = symmetric_modes(product(product(back, stiffness), transposed(back)))
    rates = [2.0 * ratio * math.sqrt(max(square, 0.0)) for square in squares]
    middle = product(transposed(shapes), [[rate * x for x in row] for rate, row in zip(rates, shapes)])
    return product(product(lower, middle), transposed(lower))


def hinged_beam():
    return [without(1, matrix) for matrix in beam(NODES, 0.014**2, 0.014**4 / 12.0, 6.7e10, 2400.0)]


def thrown_state():
    """Displacements and velocities: at rest, with the rotations and deflections that are published."""
    return [*[0.0] * 21, -3.8, *(x for speed in THROWN for x in (speed, -3.8))]


@functools.lru_cache
def hinged_flow(spring):
    mass, stiffness = hinged_beam()
    normal = [0.0] * 21
    normal[19] = -1.0
    system = System(mass, modal_damping(mass, stiffness, 0.01), stiffness, [], [Stop(normal, 0.0, spring)])
    flow, told = Flow(system, thrown_state()[:21], thrown_state()[21:]), {}
    for i in range(1, 13):
        told[i] = flow.advance(i * 1e-3)[0][19]
    return told


def falling_beam(spring, time):
    return hinged_flow(spring)[round(1e3 * time)]
