"""Values of the published cases by formulas and integrators of their own: nothing here runs the program under test.

A name of values.toml, `independent` or `reproduced`, is a function here, in modes.py or in rods.py, and its list the arguments. Functions that end
in `_told` are of the publisher's own method, with its mistake or its step: they show where a published number comes from.
"""

import functools
import math

from flow import Flow, Stop, System, inverse, solve, times

TWO_PI = 2.0 * math.pi


# Free motions of one mass.

def contact_of_touching_mass(what):
    """code_aster sdnd101: at 1 m/s into a stop of 1e6 N/m that touches at rest; m 100 kg, k 1e4 N/m."""
    mass, spring, stop = 100.0, 1e4, 1e6
    omega = math.sqrt((spring + stop) / mass)
    return {"duration": math.pi / omega, "impulse": 2.0 * stop / omega**2, "peak": stop / omega}[what]


def bilinear_frequency(mass, spring, stop, gap, energy):
    """[Hz], of a mass before an elastic stop: an arc of free flight, and one about the centre that the stop has moved."""
    amplitude, speed = math.sqrt(2.0 * energy / spring), math.sqrt((2.0 * energy - spring * gap**2) / mass)
    free, pressed = math.sqrt(spring / mass), math.sqrt((spring + stop) / mass)
    flight = (TWO_PI - 2.0 * math.acos(gap / amplitude)) / free
    contact = 2.0 / pressed * math.atan2(speed / pressed, gap * free**2 / pressed**2)
    return 1.0 / (flight + contact)


def bilinear_frequency_told(mass, spring, stop, gap, energy):
    """code_aster's formula for it: in the amplitude of the contact a term -k k_c g^2 under the root is left out."""
    free, pressed = math.sqrt(spring / mass), math.sqrt((spring + stop) / mass)
    flight = 2.0 / free * math.acos(-gap * math.sqrt(spring / (2.0 * energy)))
    contact = 2.0 / pressed * math.acos(spring * gap / math.sqrt(2.0 * energy * (spring + stop)))
    return 1.0 / (flight + contact)


def fall_on_spring(what):
    """Ansys VM65: m 0.5, g 386, from 1 in above a spring of 1973.92 lbf/in."""
    mass, gravity, spring = 0.5, 386.0, 1973.92
    speed, sag = math.sqrt(2.0 * gravity), mass * gravity / spring
    return {"speed": speed, "lowest": 1.0 + sag + math.hypot(sag, speed / math.sqrt(spring / mass))}[what]


# Marches.

def one_mass(mass, damping, spring, load, stops):
    return System([[mass]], [[damping]], [[spring]], load, stops)


def ball_on_damped_spring(damper, time):
    """code_aster sdnd108: thrown down at 1 m/s from 2 m above a spring of 100 N/m; the displacement."""
    flow = Flow(one_mass(1.0, 0.0, 0.0, [(0, 0.0, 10.0, 0.0)], [Stop([1.0], 2.0, 100.0, damper)]), [0.0], [1.0])
    return flow.advance(time)[0][0]


def ball_on_damped_spring_told(damper, time):
    """The same with a stop that pulls until the ball is back where it met it."""
    fall, sag, speed, rate = (-1.0 + math.sqrt(41.0)) / 10.0, 0.1, math.sqrt(41.0), 0.5 * damper
    omega = math.sqrt(100.0 - rate**2)
    slope = (speed - rate * sag) / omega

    def depth(t):
        return sag + math.exp(-rate * t) * (slope * math.sin(omega * t) - sag * math.cos(omega * t))

    low, high = math.pi / omega, 1.5 * math.pi / omega  # the depth passes 0 once between them
    for _ in range(80):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if depth(middle) > 0.0 else (low, middle)
    fading = math.exp(-rate * low)
    rebound = fading * ((omega * slope + rate * sag) * math.cos(omega * low) + (omega * sag - rate * slope) * math.sin(omega * low))
    rest = time - fall - low
    return 2.0 + rebound * rest + 5.0 * rest**2


@functools.lru_cache
def driven_against_stiff_stop(event):
    """code_aster sdnd121: instant of an event, counted from 0, closing and opening."""
    system = one_mass(156.0, 0.0, 2e6, [(0, 10.0 * math.pi, 0.0, 3e3)], [Stop([1.0], 1e-3, 1e10)])
    flow = Flow(system, [0.0], [0.0])
    while len(flow.events) <= event:
        flow.advance(flow.t + 0.2)
    return flow.events[event].t


SHAKEN = dict(mass=25.0, spring=98696.0, gap=5e-4, stop=5.76e7, omega=20.0 * math.pi)


def shaken_mass(damping_ratio, follows, time):
    """code_aster sdnd102: the displacement, told at rest, or from the shaken support that the stop follows."""
    m, k, omega = SHAKEN["mass"], SHAKEN["spring"], SHAKEN["omega"]
    c = 2.0 * damping_ratio * math.sqrt(k * m)
    if follows:
        flow = Flow(one_mass(m, c, k, [(0, omega, 0.0, -m)], [Stop([1.0], SHAKEN["gap"], SHAKEN["stop"])]), [0.0], [0.0])
    else:
        load = [(0, omega, -c / omega, -k / omega**2)]
        flow = Flow(one_mass(m, c, k, load, [Stop([1.0], SHAKEN["gap"], SHAKEN["stop"])]), [0.0], [-1.0 / omega])
    return flow.advance(time)[0][0]


def shaken_mass_told(damping_ratio, follows, step, time):
    """The same by central differences of that step, damping at the half steps."""
    m, k, omega = SHAKEN["mass"], SHAKEN["spring"], SHAKEN["omega"]
    c = 2.0 * damping_ratio * math.sqrt(k * m)

    def support(t):
        return -math.sin(omega * t) / omega**2

    def acceleration(x, v, t):
        depth = x + (0.0 if follows else support(t)) - SHAKEN["gap"]
        return -math.sin(omega * t) - (k * x + c * v + SHAKEN["stop"] * max(depth, 0.0)) / m

    x, half = 0.0, 0.5 * step * acceleration(0.0, 0.0, 0.0)
    for n in range(1, round(time / step) + 1):
        x += step * half
        half += (1.0 if n * step < time - 0.5 * step else 0.5) * step * acceleration(x, half, n * step)
    return x + (0.0 if follows else support(time))


def free_mass_between(time):
    """code_aster sdnd125: how deep the middle mass presses the left stop [m], times its stiffness."""
    mass = [[4.5, 0.0, 0.0], [0.0, 10.0, 0.0], [0.0, 0.0, 3.7]]
    spring = [[1e3, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 1e3]]
    stops = [Stop([1.0, -1.0, 0.0], 0.1, 1e7), Stop([0.0, 1.0, -1.0], 0.1, 3e6)]
    flow = Flow(System(mass, [[0.0] * 3 for _ in range(3)], spring, [(1, 4.0 * math.pi, 0.0, 60.0)], stops), [0.0] * 3, [0.0] * 3)
    u, _ = flow.advance(time)
    return 1e7 * (u[0] - u[1] - 0.1)


def beam(nodes, area, inertia, young, density):
    """Mass and stiffness of a slender beam, deflection and rotation of each node, by its four cubic shape functions."""
    n = 2 * len(nodes)
    mass, spring = [[0.0] * n for _ in range(n)], [[0.0] * n for _ in range(n)]
    for e, h in enumerate(b - a for a, b in zip(nodes, nodes[1:])):
        bend = [[12, 6 * h, -12, 6 * h], [6 * h, 4 * h * h, -6 * h, 2 * h * h], [-12, -6 * h, 12, -6 * h], [6 * h, 2 * h * h, -6 * h, 4 * h * h]]
        move = [[156, 22 * h, 54, -13 * h], [22 * h, 4 * h * h, 13 * h, -3 * h * h], [54, 13 * h, 156, -22 * h], [-13 * h, -3 * h * h, -22 * h, 4 * h * h]]
        for a in range(4):
            for b in range(4):
                mass[2 * e + a][2 * e + b] += density * area * h / 420.0 * move[a][b]
                spring[2 * e + a][2 * e + b] += young * inertia / h**3 * bend[a][b]
    return mass, spring


def without(first, matrix):
    """The matrix of the coordinates that are left where the first ones are held."""
    return [row[first:] for row in matrix[first:]]


def loaded_cantilever():
    """code_aster sdnl104."""
    return [without(2, matrix) for matrix in beam([i / 10 for i in range(11)], math.pi * 0.1**2, math.pi * 0.1**4 / 4.0, 1e10, 1e6)]


@functools.lru_cache
def loaded_beam_flow():
    """Displacement and velocity of its end at the two instants that are published."""
    mass, spring = loaded_cantilever()
    normal = [0.0] * 20
    normal[18] = -1.0
    system = System(mass, [[0.0] * 20 for _ in mass], spring, [(18, 0.0, -1e3, 0.0)], [Stop(normal, 1e-4, 1e8)])
    flow, told = Flow(system, [0.0] * 20, [0.0] * 20), {}
    for time in (0.1315, 0.1566):
        u, v = flow.advance(time)
        told["displacement", time], told["velocity", time] = u[18], v[18]
    return told


def suddenly_loaded_beam(what, time):
    return loaded_beam_flow()[what, time]


@functools.lru_cache
def suddenly_loaded_beam_told(what, time):
    """The same by Newmark's trapezoidal rule with the step 1e-4 s."""
    step, (mass, spring), end = 1e-4, loaded_cantilever(), 18
    matrix = [[k + 4.0 / step**2 * m for k, m in zip(*rows)] for rows in zip(spring, mass)]
    free = inverse(matrix)
    matrix[end][end] += 1e8
    pressed = inverse(matrix)
    load = [0.0] * 20
    load[end] = -1e3
    u, v, a = [0.0] * 20, [0.0] * 20, solve(mass, load)
    for _ in range(round(time / step)):
        kept = times(mass, [4.0 / step**2 * x + 4.0 / step * y + z for x, y, z in zip(u, v, a)])
        closed = u[end] < -1e-4
        for _ in range(3):
            right = [p + q for p, q in zip(load, kept)]
            right[end] -= 1e4 if closed else 0.0
            following = times(pressed if closed else free, right)
            if (following[end] < -1e-4) == closed:
                break
            closed = not closed
        change = [4.0 / step**2 * (x - y) - 4.0 / step * w - z for x, y, w, z in zip(following, u, v, a)]
        v = [w + 0.5 * step * (z + b) for w, z, b in zip(v, a, change)]
        u, a = following, change
    return u[end] if what == "displacement" else v[end]


# Bouncing balls: parabolas, and impacts that are the roots of them.

def ball(gravity, restitution, height, speed, time, ceiling=math.inf):
    """Height above the floor, thrown up at that speed."""
    t, x, v = 0.0, height, speed
    if x == 0.0 and v < 0.0:
        v = -restitution * v
    while True:
        down = (v + math.sqrt(v * v + 2.0 * gravity * x)) / gravity
        rising = v * v - 2.0 * gravity * (ceiling - x)
        up = (v - math.sqrt(rising)) / gravity if v > 0.0 and rising > 0.0 and x < ceiling else math.inf
        flight = min(down, up)
        if t + flight >= time or flight < 1e-15:
            rest = max(0.0, time - t) if flight >= 1e-15 else 0.0
            return x + v * rest - 0.5 * gravity * rest**2
        t, x, v = t + flight, (0.0 if down <= up else ceiling), -restitution * (v - gravity * flight)


def ball_told(step, time):
    """Siconos' ball, e = 0.9, by the rule of Moreau and Jean with theta = 1/2."""
    x, v = 1.0, 0.0
    for _ in range(round(time / step)):
        after = v - 9.81 * step
        if x + 0.5 * step * v <= 0.0:
            after = max(after, -0.9 * v)
        x, v = x + 0.5 * step * (v + after), after
    return x


def oscillator_on_floor(time):
    """Siconos, LinearOscillatorED: m 1 g, k 100 N/m, its weight, a floor at 0 with e = 0.9; the height."""
    system = one_mass(1e-3, 0.0, 100.0, [(0, 0.0, -9.81e-3, 0.0)], [Stop([-1.0], 0.0, restitution=0.9)])
    return Flow(system, [1.0], [0.0]).advance(time)[0][0]


# Periodic motions.

def one_impact(mass, damping, spring, load, omega, gap, restitution, what):
    """Of one impact a period, the stable one of two: speed after it, its instant, its impulse."""
    rate, free, period = 0.5 * damping / mass, math.sqrt(spring / mass - 0.25 * (damping / mass)**2), TWO_PI / omega
    fade, cosine, sine = math.exp(-rate * period), math.cos(free * period), math.sin(free * period)
    beta = (1.0 - fade * cosine) / (fade * sine)
    after = -rate + free * beta
    before = fade * (after * cosine - (rate * beta + free) * sine)
    gamma = (after + restitution * before) / (1.0 + restitution)
    answer = load / complex(spring - mass * omega**2, omega * damping)
    size, lag = abs(answer), math.atan2(answer.imag, answer.real)
    found = []
    for angle in (math.asin(gamma * gap / (size * math.hypot(omega, gamma))), None):
        phase = (math.pi - found[0][3] if angle is None else angle) - math.atan2(gamma, omega)
        speed = before * (gap - size * math.cos(phase)) - size * omega * math.sin(phase)
        found.append((speed, ((phase - lag) % TWO_PI) / omega, mass * (1.0 + restitution) * speed, angle))
    speed, instant, impulse, _ = max(found, key=lambda one: one[0])
    return {"speed after": restitution * speed, "instant": instant, "impulse": impulse}[what]


def weight(mass, gravity):
    return mass * gravity


def ball_on_table():
    """Holmes: one impact a period gives the ball its weight for a period."""
    return 9.81 * TWO_PI / 14.142135623730951


def after_a_period(system, state, period):
    n = len(system.mass)
    flow = Flow(system, state[:n], state[n:])
    u, v = flow.advance(period)
    return [*u, *v]


def closed_orbit(system, state, period):
    """Newton's method on the motion after a period, slopes by differences."""
    for _ in range(20):
        gone = after_a_period(system, state, period)
        miss = [a - b for a, b in zip(gone, state)]
        scale = max(map(abs, gone))
        columns = []
        for i, value in enumerate(state):
            moved = [*state]
            moved[i] = value + 1e-7 * scale
            columns.append([(a - b) / (1e-7 * scale) - float(i == j) for j, (a, b) in enumerate(zip(after_a_period(system, moved, period), gone))])
        change = solve([list(row) for row in zip(*columns)], miss)
        state = [a - b for a, b in zip(state, change)]
        if max(map(abs, change)) < 1e-12 * scale:
            return state
    raise ArithmeticError("no closed orbit")


def settled(system, state, period, periods):
    for _ in range(periods):
        state = after_a_period(system, state, period)
    return closed_orbit(system, state, period)


def extremes(system, state, period, normal):
    """Least and largest x = normal . u over a period."""
    n = len(system.mass)
    flow = Flow(system, state[:n], state[n:])
    flow.advance(period, normal)
    return flow.least, flow.most


PERIODIC = {
    "permas-008": (lambda: System([[1.0, 0.0], [0.0, 1.0]], [[0.1, 0.0], [0.0, 0.1]], [[1.0, -1.0], [-1.0, 2.0]], [(1, 1.44, 0.375, 0.0)],
                                  [Stop([1.0, 0.0], 0.0, 5.0)]), 1.44, 1),
    "permas-021": (lambda: one_mass(1.0, 0.06, 0.3, [(0, 0.0, 0.05, 0.0), (0, 0.75, 0.03, 0.0)],
                                    [Stop([1.0], 0.2, 0.5), Stop([-1.0], 0.2, 0.5)]), 0.75, 1),
    "permas-039": (lambda: one_mass(1.0, 0.25, 1.0, [(0, 2.6, 1.0, 0.0)], [Stop([1.0], 0.0, 15.0)]), 2.6, 1),
    "permas-046": (lambda: one_mass(1.0, 0.04, 0.25, [(0, 0.0, 1.2, 0.0), (0, 1.7, 0.0, 1.0)],
                                    [Stop([1.0], 4.0, 0.75), Stop([-1.0], 4.0, 0.75)]), 1.7, 2),
    "permas-059": (lambda: System([[1.0, 0.0], [0.0, 1.0]], [[0.03, 0.0], [0.0, 0.03]], [[1.1, -0.1], [-0.1, 1.1]], [(1, 1.2, 0.15, 0.0)],
                                  [Stop([1.0, -1.0], 0.0, 0.9)]), 1.2, 1),
    "shaken": (lambda: one_mass(25.0, 219.91143671942126, 98696.0, [(0, 20.0 * math.pi, -219.91143671942126 / (20.0 * math.pi), -98696.0 / (20.0 * math.pi)**2)],
                                [Stop([1.0], 5e-4, 5.76e7)]), 20.0 * math.pi, 1),
}


@functools.lru_cache
def periodic(name):
    build, omega, order = PERIODIC[name]
    system, period = build(), order * TWO_PI / omega
    return system, settled(system, [0.0] * (2 * len(system.mass)), period, 60), period


def amplitude(name):
    """Half of the largest less the least x of the first stop."""
    system, state, period = periodic(name)
    least, most = extremes(system, state, period, system.stops[0].normal)
    return 0.5 * (most - least)


@functools.lru_cache
def wall(omega, side):
    """Largest distance from rest of the mass before a wall (NLvib by shooting); `side` is a start near the orbit that is meant."""
    system = one_mass(1.0, 0.05, 1.0, [(0, omega, 0.02, 0.0)], [Stop([1.0], 0.1, 100.0)])
    state = closed_orbit(system, list(side), TWO_PI / omega)
    return max(map(abs, extremes(system, state, TWO_PI / omega, [1.0])))
