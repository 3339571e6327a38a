"""Alternating frequency/time harmonic balance as a command method of signorini, and an example of one.

Reads a problem as JSON on stdin, prints a periodic motion as JSON. The linear structure is reduced to its
contacts, harmonic by harmonic:

    x_n = xf_n + C_n lambda_n,   C_n = W^T (K - (n w)^2 M + i n w D)^-1 W,   n = 0..H.

The force follows from the displacement in time, at N instants, and goes back to H harmonics (P):

    R(lambda) = lambda + P max(0, y) = 0,   y = c (x - g) - lambda   (rigid stop, dynamic Lagrangian)
                                            y = k (x - g)            (stop that is a spring of stiffness k).

Newton's method with a line search. It starts where the gaps are so wide that nothing touches, and follows the
motion while they close, in steps that shrink where Newton stalls: continuation in its plainest form, which cannot
turn back where the path does. Sources: [cameron1989], [nacivet2003].
"""

import json
import sys

import numpy as np


def dense(entries, size):
    matrix = np.zeros((size, size))
    np.add.at(matrix, (entries["row"], entries["column"]), entries["value"])
    return matrix


def reduce_to_contacts(problem, harmonics):
    """C_n, (H+1) x Nc x Nc, and the response without contact, (H+1) x Nc: x(t) = Re sum_n x_n exp(i n w t)."""
    size, contacts = problem["size"], problem["contacts"]
    mass, damping, stiffness = (dense(problem[key], size) for key in ("mass", "damping", "stiffness"))
    directions = np.zeros((size, len(contacts)))
    for j, contact in enumerate(contacts):
        for dof, coefficient in contact["normal"]:
            directions[dof, j] += coefficient
    load = np.zeros((harmonics + 1, size), dtype=complex)
    for term in problem["force"]:
        n = term["harmonic"] * problem["subharmonic"]
        if n <= harmonics:
            load[n, term["dof"]] += term["cos"] - 1j * term["sin"]
    base = problem["frequency"] / problem["subharmonic"]
    receptance = np.zeros((harmonics + 1, len(contacts), len(contacts)), dtype=complex)
    free = np.zeros((harmonics + 1, len(contacts)), dtype=complex)
    for n in range(harmonics + 1):
        w = n * base
        dynamic = stiffness - w * w * mass + 1j * w * damping
        solution = np.linalg.solve(dynamic, np.column_stack([directions, load[n]]))
        receptance[n] = directions.T @ solution[:, :-1]
        free[n] = directions.T @ solution[:, -1]
    return receptance, free


def to_real(coefficients):
    """Stacks a_0, a_1, b_1, a_2, b_2, ... of sum_n a_n cos(n w t) + b_n sin(n w t); rows are harmonics."""
    rows = [coefficients[0].real]
    for c in coefficients[1:]:
        rows += [c.real, -c.imag]
    return np.concatenate(rows)


def real_receptance(receptance):
    """The matrix that takes to_real(lambda) to to_real(C lambda)."""
    contacts = receptance.shape[1]
    size = (2 * len(receptance) - 1) * contacts
    matrix = np.zeros((size, size))
    matrix[:contacts, :contacts] = receptance[0].real
    for n, c in enumerate(receptance[1:], start=1):
        begin = (2 * n - 1) * contacts
        block = slice(begin, begin + 2 * contacts)
        matrix[block, block] = np.block([[c.real, c.imag], [-c.imag, c.real]])
    return matrix


def basis(harmonics, samples):
    """Columns 1, cos, sin, cos 2, ... at N instants, and the same of their derivatives by angle."""
    angle = 2 * np.pi * np.arange(samples) / samples
    columns, slopes = [np.ones(samples)], [np.zeros(samples)]
    for n in range(1, harmonics + 1):
        columns += [np.cos(n * angle), np.sin(n * angle)]
        slopes += [-n * np.sin(n * angle), n * np.cos(n * angle)]
    return np.column_stack(columns), np.column_stack(slopes)


class ContactLaw:
    """y of the module's comment as offset + slope lambda, in time."""

    def __init__(self, problem, options, receptance, free):
        harmonics = len(receptance) - 1
        contacts = len(problem["contacts"])
        samples = options["samples"]
        if samples < 2 * harmonics + 1:
            samples = 32 * harmonics
        gaps = np.array([contact["gap"] for contact in problem["contacts"]])
        if "penalty" in problem["law"]:
            stiffness, weight = np.array(problem["law"]["penalty"]), 0.0
        else:
            stiffness, weight = options["c"] / np.abs(np.diagonal(receptance[-1])), 1.0
        self.to_time = np.kron(basis(harmonics, samples)[0], np.eye(contacts))
        self.to_harmonics = self.to_time.T * (2.0 / samples)
        self.to_harmonics[:contacts] *= 0.5
        scale = np.tile(stiffness, 2 * harmonics + 1)[:, None]
        size = len(scale)
        self.slope = self.to_time @ (scale * real_receptance(receptance) - weight * np.eye(size))
        self.offset = self.to_time @ (scale[:, 0] * to_real(free)) - np.tile(stiffness * gaps, samples)

    def widest(self, free_force):
        """How far y exceeds zero without contact: where gaps are wider by this over c, or k, nothing touches."""
        return max(0.0, np.max(self.offset + self.slope @ free_force, initial=0.0))

    def residual(self, force, width):
        """R where y is less by `width`, its Jacobian, and the size of P max(0, y)."""
        y = self.offset - width + self.slope @ force
        pushed = self.to_harmonics @ np.maximum(0.0, y)
        jacobian = np.eye(len(force)) + self.to_harmonics @ ((y > 0.0)[:, None] * self.slope)
        return force + pushed, jacobian, np.linalg.norm(pushed)


class Newton:
    """Newton's method on R(lambda) = 0 with a limit on all of its steps together."""

    def __init__(self, law, options):
        self.law, self.tolerance, self.left = law, options["tolerance"], options["max_iterations"]
        self.steps = 0

    def solve(self, force, width):
        """lambda, and its relative residual; the answer if that is at most the tolerance."""
        residual, jacobian, pushed = self.law.residual(force, width)
        while True:
            error = np.linalg.norm(residual) / max(pushed, np.finfo(float).tiny) if residual.any() else 0.0
            if error <= self.tolerance or self.steps >= self.left:
                return force, error
            self.steps += 1
            direction = np.linalg.lstsq(jacobian, -residual, rcond=None)[0]
            for length in 0.5 ** np.arange(12):
                trial = self.law.residual(force + length * direction, width)
                if np.linalg.norm(trial[0]) < (1.0 - 1e-4 * length) * np.linalg.norm(residual):
                    break
            else:
                return force, error
            force = force + length * direction
            residual, jacobian, pushed = trial


def close_gaps(law, size, options):
    """lambda at the end of the path, its residual, the Newton steps, and how far the gaps were closed, 0 to 1."""
    newton = Newton(law, options)
    force = np.zeros(size)
    widest = law.widest(force)
    closed, step = 0.0, 0.25
    while closed < 1.0 and widest > 0.0:
        goal = min(1.0, closed + step)
        answer, error = newton.solve(force, (1.0 - goal) * widest)
        if error <= options["tolerance"]:
            force, closed, step = answer, goal, 1.5 * step
        elif step < 1e-4 or newton.steps >= newton.left:
            return force, error, newton.steps, closed
        else:
            step *= 0.5
    return force, newton.solve(force, 0.0)[1], newton.steps, 1.0


def motion(problem, law, receptance, free, force):
    """Displacement, velocity and force at the contacts, fine enough for cubics to join."""
    harmonics, contacts = len(receptance) - 1, len(problem["contacts"])
    samples = 64 * max(harmonics, 16)
    period = problem["period"]
    columns, slopes = basis(harmonics, samples)
    x = (to_real(free) + real_receptance(receptance) @ force).reshape(2 * harmonics + 1, contacts)
    # The force that pushes, max(0, y), is -lambda up to its higher harmonics, and unlike it never pulls.
    coefficients = law.to_harmonics @ (law.offset + law.slope @ force)
    push = np.maximum(0.0, columns @ coefficients.reshape(x.shape))
    return {
        "t": (period / samples * np.arange(samples)).tolist(),
        "x": (columns @ x).T.tolist(),
        "velocity": (2 * np.pi / period * slopes @ x).T.tolist(),
        "force": (-push).T.tolist(),
        "bandwidth": harmonics,
    }


def give_up(reason):
    json.dump({"verdict": "not-converged", "message": reason}, sys.stdout)


def main():
    request = json.load(sys.stdin)
    problem, options = request["problem"], request["options"]
    highest = problem["subharmonic"] * max((term["harmonic"] for term in problem["force"]), default=0)
    if highest > options["harmonics"]:
        give_up(f"the load reaches harmonic {highest}, above harmonics = {options['harmonics']}")
        return
    try:
        receptance, free = reduce_to_contacts(problem, options["harmonics"])
    except np.linalg.LinAlgError:
        give_up("the dynamic stiffness is singular at a harmonic")
        return
    law = ContactLaw(problem, options, receptance, free)
    size = (2 * options["harmonics"] + 1) * len(problem["contacts"])
    force, error, steps, closed = close_gaps(law, size, options)
    converged = closed == 1.0
    told = f"residual {error:.1e}"
    if not converged:
        reason = "the steps are used up" if steps >= options["max_iterations"] else "Newton stalls"
        told = f"{reason} where the gaps are closed by {100 * closed:.0f} %"
    json.dump(
        {
            "verdict": "converged" if converged else "not-converged",
            "message": told,
            "residual": float(error),
            "work": {"unknowns": size, "iterations": steps},
            "trajectory": motion(problem, law, receptance, free, force),
        },
        sys.stdout,
    )


if __name__ == "__main__":
    main()
