"""Periodic motions before stops by means of nothing of the program: matrices by hand, the closed-form flow between events,
events by bisection, Newton's method on the map of a period."""

import math

import numpy as np

STEPS = 1024  # of a forcing period, within which events are looked for
HALVINGS = 40  # of a step, to an event
MOST_EVENTS = 400  # in a forcing period


def matrices(system):
    """M, D, K of the `system` table of a scene."""
    if system["kind"] == "sdof":
        return (np.array([[float(system[key])]]) for key in ("mass", "damping", "stiffness"))
    if system["kind"] == "chain":
        return np.diag(system["masses"]), *(chained(system[key], system.get(f"ground_{key}")) for key in ("dampers", "springs"))
    if system["kind"] == "beam":
        return beam(system)
    raise ValueError(system["kind"])


def chained(links, ground=None):
    """Of the link from each mass to the one before it, the first to the ground, and from each to the ground."""
    result = np.diag(np.array(ground, dtype=float)) if ground else np.zeros((len(links), len(links)))
    for i, link in enumerate(links):
        result[i, i] += link
        if i:
            result[i - 1, i - 1] += link
            result[i, i - 1] = result[i - 1, i] = -link
    return result


def beam(system):
    """A cantilever of Euler and Bernoulli: deflection and slope of each node but the clamped one, modal damping."""
    count, h = system["elements"], system["length"] / system["elements"]
    bending = system["young"] * system["inertia"] / h**3
    mass = system["density"] * system["area"] * h / 420.0
    k = bending * np.array([[12, 6 * h, -12, 6 * h], [6 * h, 4 * h**2, -6 * h, 2 * h**2],
                            [-12, -6 * h, 12, -6 * h], [6 * h, 2 * h**2, -6 * h, 4 * h**2]])
    m = mass * np.array([[156, 22 * h, 54, -13 * h], [22 * h, 4 * h**2, 13 * h, -3 * h**2],
                         [54, 13 * h, 156, -22 * h], [-13 * h, -3 * h**2, -22 * h, 4 * h**2]])
    M, K = np.zeros((2, 2 * count + 2, 2 * count + 2))
    for element in range(count):
        place = slice(2 * element, 2 * element + 4)
        M[place, place] += m
        K[place, place] += k
    M, K = M[2:, 2:], K[2:, 2:]
    L = np.linalg.inv(np.linalg.cholesky(M))
    squares, modes = np.linalg.eigh(L @ K @ L.T)
    ratios = system["damping"]["modal"]
    zeta = np.array([ratios[min(i, len(ratios) - 1)] for i in range(len(squares))])
    modes = M @ L.T @ modes
    return M, modes @ np.diag(2.0 * zeta * np.sqrt(squares)) @ modes.T, K


class Lost(Exception):
    """Too many events."""


def laws_of(law, contacts):
    """Of each contact, a law as records have it being of all."""
    if "mixed" in law:
        return law["mixed"]
    if "penalty" in law:
        return [{**law, "penalty": stiffness} for stiffness in law["penalty"]]
    return [law] * contacts


class Flow:
    """State z: u, u', then cos and sin of each harmonic of the load. `law` as records have it."""

    def __init__(self, scene, law, most_events=MOST_EVENTS, steps=STEPS):
        self.most_events, self.steps = most_events, steps
        M, self.D, self.K = matrices(scene["system"])
        laws = laws_of(law, len(scene["contact"]))
        if any("damping" in one or "massless" in one for one in laws) or np.linalg.cond(M) > 1e12:
            raise ValueError("no law of this flow")
        self.size, self.inverse = len(M), np.linalg.inv(M)
        self.frequency = scene["forcing"]["frequency"]
        self.period = 2.0 * math.pi / self.frequency
        self.terms = scene["forcing"]["term"]
        contacts = scene["contact"]
        self.normals = np.zeros((len(contacts), self.size))
        for row, contact in zip(self.normals, contacts):
            for dof, factor in contact["normal"]:
                row[dof] = factor
        self.gaps = np.array([contact["gap"] for contact in contacts])
        self.restitution, self.spring = ([one.get(key) for one in laws] for key in ("restitution", "penalty"))
        self.harmonics = sorted({term["harmonic"] for term in self.terms})
        self.modes = {}

    def shifts(self, orbit):
        """What neither springs nor the contacts of an orbit hold, as its contacts see it, one column for each such
        motion: moved by any part of it the orbit is one, too, as long as it meets no other stop."""
        near = 0.01 * np.abs(orbit - self.gaps).max()
        touched = self.normals[(orbit - self.gaps).max(axis=0) > -near]
        return self.normals @ null_space(self.K, touched)

    def mode(self, closed):
        """Of a set of closed contacts: propagators over a step and its halves, and z -> what each contact presses with."""
        if closed not in self.modes:
            n, total = self.size, 2 * self.size + 2 * len(self.harmonics)
            force = np.zeros((n, total))
            force[:, :n], force[:, n:2 * n] = -self.K, -self.D
            for term in self.terms:
                at = 2 * n + 2 * self.harmonics.index(term["harmonic"])
                force[term["dof"], at] += term["cos"]
                force[term["dof"], at + 1] += term.get("sin", 0.0)
            constant = np.zeros(n)
            for c in closed:
                if self.spring[c] is not None:
                    force[:, :n] -= self.spring[c] * np.outer(self.normals[c], self.normals[c])
                    constant += self.spring[c] * self.gaps[c] * self.normals[c]
            held, pressed = self.held(closed), {}
            if held:  # of the forces and the springs' constant
                N = self.normals[held]
                part = np.linalg.solve(N @ self.inverse @ N.T, N @ self.inverse)
                pressed = dict(zip(held, np.column_stack([part @ force, part @ constant])))
                force, constant = force - N.T @ part @ force, constant - N.T @ part @ constant
            A = np.zeros((total + 1, total + 1))
            A[:n, n:2 * n] = np.eye(n)
            A[n:2 * n, :total], A[n:2 * n, total] = self.inverse @ force, self.inverse @ constant
            for k, harmonic in enumerate(self.harmonics):
                at, w = 2 * n + 2 * k, harmonic * self.frequency
                A[at, at + 1], A[at + 1, at] = -w, w
            steps = [exponential(A * (self.period / self.steps / 2**k)) for k in range(HALVINGS + 1)]
            self.modes[closed] = steps, pressed
        return self.modes[closed]

    def held(self, closed):
        return [c for c in closed if self.spring[c] is None]

    def start(self, u, v, time):
        z = np.concatenate([u, v, np.zeros(2 * len(self.harmonics)), [1.0]])
        for k, harmonic in enumerate(self.harmonics):
            turn = harmonic * self.frequency * time
            z[2 * self.size + 2 * k:2 * self.size + 2 * k + 2] = math.cos(turn), math.sin(turn)
        return z

    def event(self, z, closed):
        """The contact that has to change, or None."""
        n = self.size
        depth = self.normals @ z[:n] - self.gaps
        for c, push in self.mode(closed)[1].items():
            if push @ z < 0.0:
                return c
        speed = self.normals @ z[n:2 * n]
        for c, spring in enumerate(self.spring):
            if spring is not None and (depth[c] > 0.0) != (c in closed):
                return c
            if spring is None and c not in closed and depth[c] > 0.0 and speed[c] > 0.0:
                return c
        return None

    def change(self, z, c, closed):
        """State and closed contacts after an event of contact c."""
        if self.spring[c] is not None or c in closed:
            return z, tuple(sorted(set(closed) ^ {c}))
        n, normal = self.size, self.normals[c]
        fixed = self.normals[self.held(closed)]
        jump = self.inverse @ normal
        if len(fixed):
            jump = jump - self.inverse @ fixed.T @ np.linalg.solve(fixed @ self.inverse @ fixed.T, fixed @ jump)
        speed = normal @ z[n:2 * n]
        z = z.copy()
        scale = self.frequency * (abs(self.gaps[c]) + np.abs(z[:n]).max())
        rests = self.restitution[c] < 1.0 and speed < 1e-6 * scale
        z[n:2 * n] -= (1.0 + (0.0 if rests else self.restitution[c])) * speed / (normal @ jump) * jump
        if rests:
            z[:n] -= (normal @ z[:n] - self.gaps[c]) / (normal @ jump) * jump
            held = tuple(sorted({*closed, c}))
            if self.mode(held)[1][c] @ z > 0.0:
                return z, held
        return z, closed

    def period_map(self, z, periods, keep=None, struck=None):
        """z after so many forcing periods; the contact coordinates of each step go into `keep`, contact and instant (in forcing
        periods) of each event into `struck`."""
        events = 0
        closed = tuple(c for c, spring in enumerate(self.spring)
                       if spring is not None and self.normals[c] @ z[:self.size] > self.gaps[c])
        for step in range(periods * self.steps):
            events *= step % self.steps > 0
            if keep is not None:
                keep.append(self.normals @ z[:self.size])
            done = 0.0
            while done < 1.0:
                steps = self.mode(closed)[0]
                ahead = steps[0] @ z if done == 0.0 else z
                if done == 0.0 and self.event(ahead, closed) is None:
                    z, done = ahead, 1.0
                    continue
                for k in range(1, HALVINGS + 1):  # as far as nothing happens
                    part = 0.5**k
                    ahead = steps[k] @ z
                    if done + part <= 1.0 and self.event(ahead, closed) is None:
                        z, done = ahead, done + part
                if done >= 1.0 - 0.5**(HALVINGS - 2):
                    break
                z = steps[HALVINGS] @ z
                done += 0.5**HALVINGS
                events += 1
                if events > self.most_events:  # those at rest, too, that rounding takes for new ones
                    raise Lost
                changed = self.event(z, closed)
                if changed is not None:
                    z, closed = self.change(z, changed, closed)
                    if struck is not None:
                        struck.append((changed, (step + done) / self.steps))
        return z

    def orbit_from(self, u, v, time, periods):
        """Newton's method from a state; x of the orbit at its steps, from `time` on, or None where it finds none."""
        y, n = np.concatenate([u, v]), self.size
        scale = np.repeat([np.abs(u).max() + 1e-3, self.frequency * (np.abs(u).max() + 1e-3)], n)
        missed = lambda state: (self.period_map(self.start(state[:n], state[n:], time), periods)[:2 * n] - state) / scale
        try:
            off = missed(y)
            for _ in range(25):
                if np.linalg.norm(off) < 1e-7:
                    x = []
                    self.period_map(self.start(y[:n], y[n:], time), periods, x)
                    return np.array(x)
                J = np.column_stack([(missed(y + 1e-7 * scale * e) - off) / 1e-7 for e in np.eye(2 * n)])
                step = np.linalg.lstsq(J, -off, rcond=None)[0] * scale
                for _ in range(6):
                    further = missed(y + step)
                    if np.linalg.norm(further) < np.linalg.norm(off):
                        break
                    step *= 0.4
                else:
                    return None
                y, off = y + step, further
        except (Lost, np.linalg.LinAlgError, FloatingPointError):
            return None
        return None


def exponential(A):
    squarings = max(0, math.ceil(math.log2(max(1e-300, np.linalg.norm(A, 1)))) + 2)
    part, term, result = A / 2**squarings, np.eye(len(A)), np.eye(len(A))
    for k in range(1, 18):
        term = term @ part / k
        result = result + term
    for _ in range(squarings):
        result = result @ result
    return result


def null_space(*parts):
    """Of the rows of matrices, each in units of its own largest entry."""
    rows = np.vstack([part / max(np.abs(part).max(initial=0.0), 1e-300) for part in parts])
    _, values, right = np.linalg.svd(rows)
    return right[np.count_nonzero(values > 1e-9 * values.max(initial=0.0)):].T


def distance(x, orbit, shifts=None, least=1e-12):
    """Root mean square of the difference over that of the orbit about its mean, at the same phase, of the nearest orbit of its
    family (Flow.shifts). What moves by less than `least` rests."""
    periods = math.lcm(len(x), len(orbit))
    a, b = np.tile(x, (periods // len(x), 1)), np.tile(orbit, (periods // len(orbit), 1))
    if shifts is not None and shifts.size:
        b = b + shifts @ np.linalg.lstsq(shifts, (a - b).mean(axis=0), rcond=None)[0]
    size = math.sqrt(((orbit - orbit.mean(axis=0))**2).mean())
    return math.sqrt(((a - b)**2).mean()) / max(size, least)
