"""A scene as arrays: what methods are given, and what `Scene.problem()` reads from the program."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path

import numpy as np

from . import program
from .libraries import library
from .motion import Motion


@dataclass(frozen=True)
class Load:
    """One term of the load: f[dof] += cos * cos(harmonic omega t) + sin * sin(harmonic omega t).

    dof: coordinate, from 0.  cos, sin: [N].  harmonic: 0 (constant, without sin) or more.
    omega_power: at another frequency omega' cos and sin are those here times (omega' / omega)^omega_power.
    """

    dof: int
    cos: float = 0.0
    sin: float = 0.0
    harmonic: int = 1
    omega_power: int = 0

    def scaled(self, ratio: float) -> Load:
        """The term at `ratio` times the frequency."""
        factor = ratio ** self.omega_power
        return replace(self, cos=factor * self.cos, sin=factor * self.sin)


@dataclass(frozen=True)
class Contact:
    """One stop: x = sum of coefficient * u[dof] <= gap.

    normal: {dof: coefficient} [-].  gap: [m], below 0 is a preload.
    law: its own, in place of the scene's: {"restitution": e}, {"penalty": k} [N/m], with "damper": c [N s/m] beside it,
    or {"massless": True}.
    """

    normal: Mapping[int, float]
    gap: float
    law: Mapping[str, object] | None = None


PER_SPEED = {"damping": "gyroscopic_per_speed", "stiffness": "circulatory_per_speed"}


@dataclass(frozen=True)
class Problem:
    """M u'' + D u' + K u = f(t) + W lambda,  x = W^T u <= gap,  lambda <= 0,  lambda (x - gap) = 0.

    n coordinates, Nc contacts; the motion looked for has the period `period` = 2 pi subharmonic / frequency.

    size: n.  frequency: omega [rad/s].  period: [s].
    loads: terms of f(t) [N].  contacts: the stops, Nc of them.
    law: of impacts, {"restitution": e}, {"penalty": [k, ..]} with Nc stiffnesses [N/m], {"massless": True}, {"none": True} or,
    of contacts of different laws, {"mixed": [..]}, a list of one for each; each contact has its own then.
    start: a motion to begin from, if the program has one.
    entries: of "mass" [kg], "damping" [N s/m] and "stiffness" [N/m], arrays (row, column, value); where D and K follow the frequency also
    of "gyroscopic_per_speed", dD / d omega [N s^2/m], and "circulatory_per_speed", dK / d omega [N s/m].
    """

    name: str
    size: int
    frequency: float
    subharmonic: int
    period: float
    loads: tuple[Load, ...]
    contacts: tuple[Contact, ...]
    law: Mapping[str, object]
    start: Motion | None
    entries: Mapping[str, tuple[np.ndarray, np.ndarray, np.ndarray]] = field(repr=False)

    @classmethod
    def from_request(cls, request: Mapping) -> Problem:
        """Of what the program hands to a method that is a command, docs/plugins.md."""
        text = request["problem"]
        matrices = {key: (np.array(text[key]["row"], dtype=int), np.array(text[key]["column"], dtype=int),
                          np.array(text[key]["value"], dtype=float)) for key in ("mass", "damping", "stiffness", *PER_SPEED.values()) if key in text}
        return cls(name=text["name"], size=text["size"], frequency=text["frequency"], subharmonic=text["subharmonic"],
                   period=text["period"], law=text["law"], entries=matrices,
                   start=Motion.from_json(request["start"]) if "start" in request else None,
                   loads=tuple(Load(**term) for term in text["force"]),
                   contacts=tuple(Contact(dict(map(tuple, contact["normal"])), contact["gap"],
                                          contact.get("law") if "mixed" in text["law"] else None)
                                  for contact in text["contacts"]))

    @cached_property
    def mass(self) -> np.ndarray:
        """M, n x n [kg]."""
        return self._dense("mass")

    @cached_property
    def damping(self) -> np.ndarray:
        """D, n x n [N s/m]."""
        return self._dense("damping")

    @cached_property
    def stiffness(self) -> np.ndarray:
        """K, n x n [N/m]."""
        return self._dense("stiffness")

    @cached_property
    def normals(self) -> np.ndarray:
        """W, n x Nc [-]: column j is the normal of contact j."""
        normals = np.zeros((self.size, len(self.contacts)))
        for j, contact in enumerate(self.contacts):
            for dof, coefficient in contact.normal.items():
                normals[dof, j] += coefficient
        return normals

    @cached_property
    def gap(self) -> np.ndarray:
        """g, Nc [m]."""
        return np.array([contact.gap for contact in self.contacts], dtype=float)

    def at(self, frequency: float) -> Problem:
        """The same structure and load at another frequency of the load [rad/s], without a motion to begin from."""
        ratio = frequency / self.frequency
        return replace(self, frequency=frequency, period=self.period / ratio, start=None, entries=self.entries_at(frequency),
                       loads=tuple(load.scaled(ratio) for load in self.loads))

    def entries_at(self, frequency: float) -> dict[str, tuple[np.ndarray, np.ndarray, np.ndarray]]:
        """`entries` at another frequency of the load [rad/s]; at 0 they are those of a rotor at rest."""
        entries = dict(self.entries)
        for matrix, rate in PER_SPEED.items():
            if rate not in entries:
                continue
            sums: dict[tuple[int, int], float] = {}
            for factor, (rows, columns, values) in ((1.0, entries[matrix]), (frequency - self.frequency, entries[rate])):
                for place, value in zip(zip(rows.tolist(), columns.tolist()), values.tolist()):
                    sums[place] = sums.get(place, 0.0) + factor * value
            rows, columns = np.array(list(sums), dtype=int).reshape(-1, 2).T
            entries[matrix] = rows, columns, np.array(list(sums.values()))
        return entries

    def load(self, harmonic: int) -> np.ndarray:
        """F_h, n complex [N]: the load is the sum over h of Re(F_h exp(i h omega t))."""
        amplitudes = np.zeros(self.size, dtype=complex)
        for term in self.loads:
            if term.harmonic == harmonic:
                amplitudes[term.dof] += term.cos - 1j * term.sin
        return amplitudes

    def sparse(self, matrix: str):
        """"mass", "damping" or "stiffness" as an n x n scipy.sparse.csr_matrix. Raises MissingLibrary without scipy."""
        rows, columns, values = self.entries[matrix]
        return library("scipy.sparse", "sparse matrices").csr_matrix((values, (rows, columns)), shape=(self.size, self.size))

    def _dense(self, matrix: str) -> np.ndarray:
        rows, columns, values = self.entries[matrix]
        dense = np.zeros((self.size, self.size))
        np.add.at(dense, (rows, columns), values)
        return dense


# A method that applies to every scene and gives up; its script keeps what it is given in the file of its last word.
READER = """schema = 1
name = "reader"
title = "Keeps the problem it is given"
ladder = ""
command = COMMAND
[represents]
restitution = "scene"
penalty = "scene"
massless = "scene"
mixed = "scene"
no_contact = "scene"
"""
KEEP = """cat >"$0" && echo '{"verdict": "not-converged"}'"""


def read_problem(scene: str) -> Problem:
    """The problem of a scene, a name of the catalogue or a file: the program hands it to a method that keeps it."""
    with tempfile.TemporaryDirectory(prefix="signorini-") as folder:
        description, kept = Path(folder, "reader.toml"), Path(folder, "problem.json")
        description.write_text(READER.replace("COMMAND", json.dumps(["sh", "-c", KEEP, str(kept)])), encoding="utf-8")
        record = program.run(["solve", scene, "--method", "reader", "--plugin", description, "--json"],
                             (program.DONE, program.FAILED))
        problem = Problem.from_request(json.loads(kept.read_text(encoding="utf-8")))
    return replace(problem, name=json.loads(record)["scene"])  # which no method is told
