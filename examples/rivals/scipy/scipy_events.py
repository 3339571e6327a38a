"""What one writes first: scipy.integrate.solve_ivp with an event at each stop, from rest until the motion repeats."""

import numpy as np
from scipy.integrate import solve_ivp
from signorini import Curve, Motion, NotConverged, Option, Point, method

STEPS = 61  # of the frequency, one way
INSTANTS = 8192  # of the motion that is handed over: what the harness measures at, so that impacts between them cost nothing


class Structure:
    """y = (u, v), y' = A y + B f(t), and its stops."""

    def __init__(self, problem):
        n, inverse = problem.size, np.linalg.inv(problem.mass)
        self.rates = np.block([[np.zeros((n, n)), np.eye(n)], [-inverse @ problem.stiffness, -inverse @ problem.damping]])
        self.loads = [(h * problem.frequency, np.concatenate([np.zeros(n), inverse @ problem.load(h)]))
                      for h in sorted({load.harmonic for load in problem.loads})]
        self.normals, self.gap, self.size = problem.normals, problem.gap, n
        self.mobility = inverse @ problem.normals  # M^-1 W, n x Nc
        self.restitution = problem.law["restitution"]
        self.events = [self.event(j) for j in range(len(self.gap))]

    def derivative(self, t, y):
        f = self.rates @ y
        for frequency, load in self.loads:
            f += (load * np.exp(1j * frequency * t)).real
        return f

    def event(self, j):
        def reached(_, y):
            return self.normals[:, j] @ y[:self.size] - self.gap[j]
        reached.terminal, reached.direction = True, 1.0
        return reached

    def impact(self, t, y, j):
        """The state after an impact at stop j, and its impulse -lambda > 0. Raises NotConverged where the stop is not left."""
        normal, v = self.normals[:, j], y[self.size:]
        approach = normal @ v
        impulse = (1 + self.restitution) * approach / (normal @ self.mobility[:, j])
        after = np.concatenate([y[:self.size], v - self.mobility[:, j] * impulse])
        leaving = -self.restitution * approach
        if leaving > -1e-9 * np.abs(v).max() and normal @ self.derivative(t, after)[self.size:] >= 0:
            raise NotConverged("the contact lasts, and there is no event for its end")
        return after, impulse

    def period(self, y, T, settings, instants=()):
        """The state after a period, the impacts (contact, time, -impulse) in it, and the states at the instants."""
        t, impacts, states = 0.0, [], []
        while t < T:
            run = solve_ivp(self.derivative, (t, T), y, events=self.events, dense_output=len(instants) > 0, **settings)
            if not run.success:
                raise NotConverged(run.message)
            end = run.t[-1]
            if len(instants):
                now = instants[(instants >= t) & ((instants < end) | (end >= T))]
                states.append(run.sol(now) if len(now) else np.zeros((len(y), 0)))
            t, y = end, run.y[:, -1]
            for j, times in enumerate(run.t_events):
                if len(times):
                    y, impulse = self.impact(t, y, j)
                    impacts.append((j, t, -impulse))
            if len(impacts) > 1000:
                raise NotConverged("more than a thousand impacts in a period")
        return y, impacts, np.hstack(states) if states else None


@method(ladder="tolerance=1e-4|1e-6|1e-8", represents={"restitution": "scene"},
        options={"tolerance": Option("relative, of the integrator; a motion repeats to ten times that", least=1e-12, most=1e-2),
                 "integrator": Option("of scipy", choices=["DOP853", "RK45", "LSODA", "Radau"]),
                 "max_periods": Option("limit on the periods followed", least=1, most=100000)})
def scipy_events(problem, tolerance=1e-6, integrator="DOP853", max_periods=2000):
    """solve_ivp of scipy with an event at each stop, until the motion repeats."""
    structure, y, settings, periods, change = repeating(problem, None, tolerance, integrator, max_periods)
    instants = problem.period * np.arange(INSTANTS) / INSTANTS
    _, impacts, states = structure.period(y, problem.period, settings, instants)
    x, v = problem.normals.T @ states[:problem.size], problem.normals.T @ states[problem.size:]
    return Motion(x, v, np.zeros_like(x), impulses=impacts, residual=change, work={"iterations": periods},
                  message=f"the motion repeats after {periods} periods")


def repeating(problem, y, tolerance, integrator, max_periods):
    """The structure, the state of the motion that repeats, the integrator's settings, the periods followed and the last change.

    y: the state to begin with, at rest if None. Raises NotConverged.
    """
    if np.diag(problem.mass).min() <= 0:
        raise NotConverged("coordinates without mass have no velocity")
    structure, T = Structure(problem), problem.period
    y = np.zeros(2 * problem.size) if y is None else y
    length = np.abs(problem.gap).max(initial=0.0) or 1.0
    settings = {"method": integrator, "rtol": tolerance, "atol": tolerance * length}
    for periods in range(1, max_periods + 1):
        before, (y, _, _) = y, structure.period(y, T, settings)
        scale = np.maximum(np.abs(before).reshape(2, -1).max(axis=1), np.abs(y).reshape(2, -1).max(axis=1))
        change = (np.abs(y - before).reshape(2, -1).max(axis=1) / np.maximum(scale, 1e-300)).max()
        if change <= 10 * tolerance:
            return structure, y, settings, periods, change
    raise NotConverged(f"the motion does not repeat within {max_periods} periods")


@scipy_events.follow
def steps(problem, interval, tolerance=1e-6, integrator="DOP853", max_periods=2000):
    """Steps of the frequency up and down, each from the state before; a step that does not repeat ends a curve."""
    frequencies = np.sort(interval.at) if len(interval.at) else np.linspace(interval.start, interval.stop, STEPS)
    instants = interval.phases * problem.subharmonic or 256
    for way, order in (("up", frequencies), ("down", frequencies[::-1])):
        y, points = None, []
        for frequency in order:
            here = problem.at(frequency)
            try:
                structure, y, settings, _, _ = repeating(here, y, tolerance, integrator, max_periods)
                _, impacts, states = structure.period(y, here.period, settings, here.period * np.arange(instants) / instants)
            except NotConverged as reason:
                y = None
                if len(points) > 1:
                    yield Curve(points, ended=str(reason), kind=f"steps {way}", by_steps=True)
                points = []
                continue
            points.append(Point(frequency, x=here.normals.T @ states[:here.size], order=here.subharmonic, stable=True,
                                impacts=len(impacts)))
        if len(points) > 1:
            yield Curve(points, ended="end of the interval", kind=f"steps {way}", by_steps=True)
