"""Scene files of kind `matrices`: docs/scene-format.md."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from .files import require_name, write_whole
from .problem import Contact, Load, Problem

Matrix = np.ndarray | Sequence[Sequence[float]] | object  # or a matrix of scipy.sparse
Damping = Mapping[str, float | Sequence[float]]
Entries = tuple[np.ndarray, np.ndarray, np.ndarray]  # row, column, value

FILES = {"mass": "M.mtx", "damping": "D.mtx", "stiffness": "K.mtx", "circulatory": "N.mtx",
         "gyroscopic_per_speed": "G1.mtx", "circulatory_per_speed": "N1.mtx"}


@dataclass(frozen=True)
class SceneFile:
    """What NAME.toml and its Matrix Market files hold."""

    name: str
    title: str
    size: int
    matrices: Mapping[str, Entries]  # "mass", "stiffness", "damping" unless proportional or modal, and of the others of FILES those that there are
    frequency: float
    subharmonic: int
    loads: Sequence[Load]
    contacts: Sequence[Contact]
    law: Mapping[str, object]
    damping: Damping = field(default_factory=dict)  # alpha and beta, or modal

    @classmethod
    def of(cls, M, D, K, *, load, contacts, law, skew: Mapping[str, Matrix | None], **rest) -> SceneFile:
        """Of the arguments of `Scene.from_matrices`, the skew-symmetric ones by their keys in a scene file. Raises ValueError."""
        matrices = {"mass": M, "stiffness": K, **{key: matrix for key, matrix in skew.items() if matrix is not None}}
        if not isinstance(D, Mapping):
            matrices["damping"] = D
        elif not D or set(D) - {"alpha", "beta"} and set(D) != {"modal"}:
            raise ValueError(f"D = {dict(D)} (must be a matrix, or have the keys alpha and beta, or modal)")
        shapes = {Path(FILES[key]).stem: shape_of(matrix) for key, matrix in matrices.items()}
        rows, columns = shapes["M"]
        if rows == 0 or rows != columns or len(set(shapes.values())) > 1:
            told = ", ".join(f"{key} {rows} x {columns}" for key, (rows, columns) in shapes.items())
            raise ValueError(f"matrices = {told} (must be square, of one size)")
        if isinstance(load, Mapping):
            load = [Load(dof, cos) for dof, cos in load.items()]
        if isinstance(contacts, Mapping):
            contacts = [Contact({dof: 1.0}, gap) for dof, gap in contacts.items()]
        return cls(size=rows, matrices={key: entries_of(matrix) for key, matrix in matrices.items()}, loads=load,
                   contacts=contacts, law=law or {}, damping=D if isinstance(D, Mapping) else {}, **rest)

    @classmethod
    def of_problem(cls, problem: Problem) -> SceneFile:
        law = {key: value for key, value in problem.law.items() if key in ("restitution", "penalty")}
        name = re.sub("[^a-z0-9]+", "-", problem.name)  # of a level of a family: grazing@0.1
        matrices = {key: entries for key, entries in problem.entries_at(0.0).items() if len(entries[0]) or not key.endswith("per_speed")}
        matrices["stiffness"], skew = parts_of(matrices["stiffness"])
        if skew is not None:
            matrices["circulatory"] = skew
        return cls(name=name, title=f"{problem.name}, as matrices", size=problem.size, matrices=matrices,
                   frequency=problem.frequency, subharmonic=problem.subharmonic, loads=problem.loads,
                   contacts=problem.contacts, law=law)

    def write(self, folder: str | Path) -> Path:
        """The files, into a folder that is made if need be; returns the path of NAME.toml. Raises BadInput for a name that is none."""
        require_name(self.name)
        folder = Path(folder)
        folder.mkdir(parents=True, exist_ok=True)
        for key, entries in self.matrices.items():
            write_matrix_market(folder / FILES[key], self.size, entries)
        file = folder / f"{self.name}.toml"
        write_whole(file, self.toml())
        return file

    def toml(self) -> str:
        lines = ["schema = 1", f"name = {quoted(self.name)}", f"title = {quoted(self.title)}", "",
                 "[system]", 'kind = "matrices"', *(f'{key} = "{FILES[key]}"' for key in self.matrices)]
        if "modal" in self.damping:
            lines.append(f"modal = {value_of(self.damping['modal'])}")
        elif self.damping:
            told = ", ".join(f"{key} = {value_of(value)}" for key, value in self.damping.items())
            lines.append(f"rayleigh = {{ {told} }}")
        lines += ["", "[forcing]", f"frequency = {value_of(self.frequency)}", f"subharmonic = {value_of(self.subharmonic)}"]
        for term in self.loads:
            power = self.frequency ** term.omega_power  # by which the file's amplitudes grow
            lines += ["", "[[forcing.term]]", f"dof = {value_of(term.dof)}", f"harmonic = {value_of(term.harmonic)}",
                      f"cos = {value_of(term.cos / power)}", f"sin = {value_of(term.sin / power)}"]
            if term.omega_power:
                lines.append(f"omega_power = {value_of(term.omega_power)}")
        for contact in self.contacts:
            normal = ", ".join(f"[{value_of(dof)}, {value_of(factor)}]" for dof, factor in contact.normal.items())
            lines += ["", "[[contact]]", f"normal = [{normal}]", f"gap = {value_of(contact.gap)}",
                      *(f"{key} = {'true' if value is True else value_of(value)}" for key, value in (contact.law or {}).items())]
        if self.law:
            lines += ["", "[law]", *(f"{key} = {value_of(value)}" for key, value in self.law.items())]
        return "\n".join(lines) + "\n"


def quoted(text: str) -> str:
    return json.dumps(text, ensure_ascii=False)


def value_of(value) -> str:
    """A number, or a list of numbers, in TOML."""
    if np.ndim(value) > 0:
        return f"[{', '.join(map(value_of, value))}]"
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, float, np.integer, np.floating)):
        raise ValueError(f"{value!r} (must be a number)")
    return str(int(value)) if isinstance(value, (int, np.integer)) else repr(float(value))


def shape_of(matrix) -> tuple[int, int]:
    shape = matrix.shape if hasattr(matrix, "shape") else np.shape(matrix)
    if len(shape) != 2:
        raise ValueError(f"a matrix has {len(shape)} dimensions (must have 2)")
    return tuple(shape)


def entries_of(matrix) -> Entries:
    """Those that are not zero, of an array or of a matrix of scipy.sparse, each place once. Raises ValueError for complex ones."""
    if hasattr(matrix, "tocoo"):
        sparse = matrix.tocsr().tocoo()  # sums what stands at one place
        return sparse.row, sparse.col, real_of(sparse.data)
    dense = real_of(np.asarray(matrix))
    rows, columns = np.nonzero(dense)
    return rows, columns, dense[rows, columns]


def real_of(values: np.ndarray) -> np.ndarray:
    if np.iscomplexobj(values):
        if np.any(values.imag != 0.0):
            raise ValueError("a matrix is complex (must be real: structural damping K (1 + i eta) is no force in time; "
                             'give K.real and D = {"modal": eta / 2}, or near a frequency w D = K.imag / w)')
        values = values.real
    return values.astype(float)


def parts_of(entries: Entries) -> tuple[Entries, Entries | None]:
    """Symmetric and skew part of a square matrix; as it is, and None, where it is symmetric to 1e-12 of its largest entry."""
    rows, columns, values = entries
    found = dict(zip(zip(rows.tolist(), columns.tolist()), values.tolist()))
    places = sorted(found.keys() | {(column, row) for row, column in found})
    pairs = np.array([(found.get((row, column), 0.0), found.get((column, row), 0.0)) for row, column in places]).reshape(-1, 2)
    skew = 0.5 * (pairs[:, 0] - pairs[:, 1])
    if not np.any(np.abs(skew) > 1e-12 * np.abs(pairs).max(initial=0.0)):
        return entries, None
    row, column = np.array(places).T
    kept = skew != 0.0
    return (row, column, pairs.mean(axis=1)), (row[kept], column[kept], skew[kept])


def write_matrix_market(file: Path, size: int, entries: Entries) -> None:
    """All entries in the format `coordinate real general`, with every digit."""
    rows, columns, values = entries
    lines = [f"{row + 1} {column + 1} {value!r}" for row, column, value in zip(rows.tolist(), columns.tolist(), values.tolist())]
    head = ["%%MatrixMarket matrix coordinate real general", f"{size} {size} {len(lines)}"]
    write_whole(file, "\n".join(head + lines) + "\n", encoding="ascii")
