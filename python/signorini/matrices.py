"""Mass and stiffness as finite-element programs write them: CalculiX, and Nastran through pyNastran.

    python3 -m signorini.matrices calculix bracket.sti --out model

writes M.mtx, K.mtx and coordinates.csv, and prints the table [system] of a scene that names them. What Abaqus and others write as
Matrix Market, Abaqus or Harwell-Boeing files, a scene names as it is (docs/scene-format.md).
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from .files import write_whole
from .libraries import MissingLibrary, library
from .program import BAD_INPUT, DONE, BadInput
from .scene_file import FILES, Entries, entries_of, write_matrix_market


@dataclass(frozen=True)
class Structure:
    """M and K of a structure, and what its coordinates are.

    size: n.  entries: of "mass" [kg] and "stiffness" [N/m], arrays (row, column, value) of both triangles.
    coordinates: (node, degree of freedom) of each coordinate, n of them; empty where the files do not say.
    """

    size: int
    entries: dict[str, Entries] = field(repr=False)
    coordinates: Sequence[tuple[int, int]] = field(default=(), repr=False)

    @property
    def mass(self):
        """M, n x n, a scipy.sparse.csr_matrix [kg]. Raises MissingLibrary without scipy."""
        return self._sparse("mass")

    @property
    def stiffness(self):
        """K, n x n, a scipy.sparse.csr_matrix [N/m]. Raises MissingLibrary without scipy."""
        return self._sparse("stiffness")

    def coordinate(self, node: int, degree: int) -> int:
        """The coordinate of a degree of freedom, 1 to 3 displacements along x, y, z. Raises BadInput where it is none."""
        try:
            return list(self.coordinates).index((node, degree))
        except ValueError:
            raise BadInput(f"node {node}, degree {degree} (must be a coordinate: one without support)", BAD_INPUT) from None

    def write(self, folder: str | Path) -> Path:
        """M.mtx, K.mtx and, where they are known, coordinates.csv into a folder, which is made if need be and returned."""
        folder = Path(folder)
        folder.mkdir(parents=True, exist_ok=True)
        for key, entries in self.entries.items():
            write_matrix_market(folder / FILES[key], self.size, entries)
        if self.coordinates:
            lines = [f"{number},{node},{degree}" for number, (node, degree) in enumerate(self.coordinates)]
            write_whole(folder / "coordinates.csv", "\n".join(["coordinate,node,degree", *lines]) + "\n", encoding="ascii")
        return folder

    def _sparse(self, key: str):
        rows, columns, values = self.entries[key]
        return library("scipy.sparse", "sparse matrices").csr_matrix((values, (rows, columns)), shape=(self.size, self.size))


def read_calculix(job: str | Path) -> Structure:
    """JOB.sti, JOB.mas and JOB.dof, which `*FREQUENCY, SOLVER=MATRIXSTORAGE` of CalculiX writes.

    job: the name with or without one of these endings. A file of one triangle is mirrored. Raises BadInput.
    """
    stem = Path(job)
    if stem.suffix in (".sti", ".mas", ".dof", ".inp"):
        stem = stem.with_suffix("")
    places = [place_of(number, line, Path(f"{stem}.dof")) for number, line in numbered(Path(f"{stem}.dof"))]
    entries = {key: read_triples(Path(f"{stem}{ending}"), len(places)) for key, ending in (("mass", ".mas"), ("stiffness", ".sti"))}
    return Structure(size=len(places), entries=entries, coordinates=places)


def read_nastran(file: str | Path, mass: str = "MAA", stiffness: str = "KAA") -> Structure:
    """Two matrices of an OP4 file of Nastran, read by pyNastran. Not tested: no such file and no pyNastran were at hand.

    mass, stiffness: their names in the file. Raises BadInput, and MissingLibrary without pyNastran.
    """
    reader = library("pyNastran.op4.op4", "files of Nastran").OP4
    found = {name.upper(): value for name, value in reader(log=None, debug=False).read_op4(str(file)).items()}
    entries, sizes = {}, set()
    for key, name in (("mass", mass), ("stiffness", stiffness)):
        if name.upper() not in found:
            raise BadInput(f"{file}: matrix = {name} (must be one of {', '.join(sorted(found))})", BAD_INPUT)
        matrix = found[name.upper()]
        matrix = matrix[1] if isinstance(matrix, tuple) else getattr(matrix, "data", matrix)
        sizes.add(tuple(matrix.shape))
        entries[key] = entries_of(matrix)
    if len(sizes) != 1 or len(set(next(iter(sizes)))) != 1:
        raise BadInput(f"{file}: {mass}, {stiffness} = {sorted(sizes)} (must be square, of one size)", BAD_INPUT)
    return Structure(size=next(iter(sizes))[0], entries=entries)


def numbered(file: Path) -> list[tuple[int, str]]:
    """The lines of a file that hold something, with their numbers."""
    try:
        text = file.read_text(encoding="ascii", errors="replace")
    except OSError as error:
        raise BadInput(f"{file}: file = {error.strerror} (must be one that CalculiX wrote)", BAD_INPUT) from None
    return [(number, line) for number, line in enumerate(text.splitlines(), 1) if line.strip()]


def place_of(number: int, line: str, file: Path) -> tuple[int, int]:
    """(node, degree) of a line "node.degree"."""
    node, point, degree = line.strip().partition(".")
    if not (point and node.isdecimal() and degree.isdecimal()):
        raise BadInput(f"{file}:{number}: line = {line.strip()[:40]!r} (must be node.degree)", BAD_INPUT)
    return int(node), int(degree)


def read_triples(file: Path, size: int) -> Entries:
    """Lines "row column value", counted from 1, of both triangles or one."""
    rows, columns, values = [], [], []
    for number, line in numbered(file):
        words = line.replace("D", "e").replace("d", "e").split()
        try:
            row, column, value = int(words[0]) - 1, int(words[1]) - 1, float(words[2])
            sound = len(words) == 3 and 0 <= row < size and 0 <= column < size and np.isfinite(value)
        except (ValueError, IndexError):
            sound = False
        if not sound:
            raise BadInput(f"{file}:{number}: entry = {line.strip()[:40]!r} (must be row and column in 1..{size}, and a number)", BAD_INPUT)
        rows.append(row), columns.append(column), values.append(value)
    found: dict[tuple[int, int], float] = {}
    for row, column, value in zip(rows, columns, values):
        found[row, column] = found.get((row, column), 0.0) + value
    if not any(row != column and (column, row) in found for row, column in found):
        found |= {(column, row): value for (row, column), value in found.items()}
    places = np.array(sorted(found), dtype=int).reshape(-1, 2)
    return places[:, 0], places[:, 1], np.array([found[row, column] for row, column in places.tolist()], dtype=float)


def main(words: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="python3 -m signorini.matrices", description="Mass and stiffness of a finite-element program as files for a scene.")
    parser.add_argument("program", choices=["calculix", "nastran"], help="that wrote the files; nastran is not tested")
    parser.add_argument("file", help="JOB.sti, beside JOB.mas and JOB.dof; of Nastran an OP4 file")
    parser.add_argument("--out", default="model", help="folder of M.mtx, K.mtx and coordinates.csv (model)")
    parser.add_argument("--mass", default="MAA", help="name of the matrix in the OP4 file (MAA)")
    parser.add_argument("--stiffness", default="KAA", help="name of the matrix in the OP4 file (KAA)")
    given = parser.parse_args(words)
    try:
        structure = read_calculix(given.file) if given.program == "calculix" else read_nastran(given.file, given.mass, given.stiffness)
        folder = structure.write(given.out)
    except (BadInput, MissingLibrary) as refusal:
        print(refusal, file=sys.stderr)
        return BAD_INPUT
    print(f'[system]\nkind = "matrices"\nmass = "{folder}/M.mtx"\nstiffness = "{folder}/K.mtx"\nmodal = 0.01')
    return DONE


if __name__ == "__main__":
    sys.exit(main())
