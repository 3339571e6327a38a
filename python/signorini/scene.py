"""Scenes: from matrices, from a file or from the catalogue; solved, searched and swept by the program."""

from __future__ import annotations

import json
import math
import shutil
import tempfile
import weakref
from collections.abc import Mapping, Sequence
from functools import cached_property
from pathlib import Path

from . import program
from .plugin import PythonMethod
from .problem import Contact, Load, Problem, read_problem
from .response import Response
from .results import Orbit, Solution
from .scene_file import Damping, Matrix, SceneFile

Method = str | PythonMethod
Option = bool | int | float | str


class Scene:
    """A mechanical system, its load, its stops and the law of its impacts.

    M u'' + D u' + K u = f(t) + W lambda,  x = W^T u <= gap,  lambda <= 0,  lambda (x - gap) = 0.

    Made by `Scene.load` or `Scene.from_matrices`. Everything is computed by the program signorini (`find_program`); what it
    refuses is a BadInput with its one line. SI units.
    """

    def __init__(self, source: str, file: SceneFile | None = None):
        self._source = source
        self._file = file

    @classmethod
    def load(cls, scene: str | Path) -> Scene:
        """A scene of the catalogue by its name, or a scene file (docs/scene-format.md). Raises BadInput."""
        text = str(scene)
        source = str(Path(text).absolute()) if "/" in text or text.endswith(".toml") else text
        if "\nsystem " not in program.run(["show", source]):  # a method has that name
            raise program.BadInput(f"scene = {scene} (must be a scene; it is a method)", program.BAD_INPUT)
        return cls(source)

    @classmethod
    def from_matrices(cls, M: Matrix, D: Matrix | Damping, K: Matrix, *, frequency: float | None = None, frequency_hz: float | None = None,
                      load: Mapping[int, float] | Sequence[Load] = (),
                      contacts: Mapping[int, float] | Sequence[Contact] = (),
                      law: Mapping[str, object] | None = None, subharmonic: int = 1, name: str = "from-matrices",
                      title: str = "From matrices", circulatory: Matrix | None = None,
                      gyroscopic_per_speed: Matrix | None = None, circulatory_per_speed: Matrix | None = None) -> Scene:
        """A scene of n coordinates.

        M, K: n x n, symmetric and positive semi-definite, arrays or of scipy.sparse [kg] [N/m].
        circulatory: N, n x n, skew-symmetric, added to K: what a seal, or damping that turns with a shaft, does [N/m].
        gyroscopic_per_speed, circulatory_per_speed: n x n, skew-symmetric; omega times them is added to D and K: of a rotor that turns as
        fast as its load, at each frequency of a sweep [N s^2/m] [N s/m].
        D: n x n, its skew part gyroscopic [N s/m]; or {"alpha": a, "beta": b} for a M + b K [1/s] [s]; or {"modal": z}, damping ratios of the modes by
        rising frequency, one number or a list [-].
        frequency: omega [rad/s], or frequency_hz: omega / (2 pi) [Hz].  load: {dof: amplitude of cos(omega t)} [N], or a list of `Load`.
        contacts: {dof: gap} for u[dof] <= gap [m], or a list of `Contact`, which may have laws of their own.
        law: {"restitution": e}, 0 <= e <= 1, or {"penalty": k} with one stiffness or one per contact [N/m], and "damping", c,
        likewise if a damper stands beside each spring [N s/m]; None where no contact carries mass. subharmonic: k, motions of the period 2 pi k / omega are looked for.

        Raises BadInput where the program refuses the scene, and ValueError for matrices that are complex or of no or unequal shape.
        """
        if (frequency is None) == (frequency_hz is None):
            raise ValueError("frequency, frequency_hz (must be one of them)")
        if frequency is None:
            frequency = 2.0 * math.pi * frequency_hz
        file = SceneFile.of(M, D, K, frequency=frequency, load=load, contacts=contacts, law=law, subharmonic=subharmonic,
                            name=name, title=title,
                            skew={"circulatory": circulatory, "gyroscopic_per_speed": gyroscopic_per_speed,
                                  "circulatory_per_speed": circulatory_per_speed})
        folder = tempfile.mkdtemp(prefix="signorini-")
        scene = cls(str(Path(folder, f"{file.name}.toml")), file)
        weakref.finalize(scene, shutil.rmtree, folder, ignore_errors=True)  # it lives as long as the scene
        file.write(folder)
        program.run(["show", scene._source])
        return scene

    def save(self, folder: str | Path) -> Path:
        """Writes NAME.toml and its matrices, M.mtx and so on, into the folder, which is made if need be; returns the path of NAME.toml."""
        file = self._file
        if file is None:
            file = SceneFile.of_problem(self.problem)
        return file.write(folder)

    def show(self) -> str:
        """What the program says of the scene: sizes, eigenfrequencies, load, contacts, law."""
        return program.run(["show", self._source]).rstrip("\n")

    @cached_property
    def problem(self) -> Problem:
        """Matrices, load, contacts and law as arrays, for a scene of any kind."""
        return read_problem(self._source)

    def solve(self, method: Method = "exact-orbit", *, instants: int = 1024, start: Solution | None = None,
              reference: float | None = None, strict: bool = True, **options: Option) -> Solution:
        """One periodic motion by one method, judged by the program.

        method: a name of `signorini list methods`, or a function marked with `signorini.method`.
        instants: N, of the motion that is returned, 1 to 65536.  start: a solution to start from.
        reference: march from rest for so many seconds to tell whether that ends on the same orbit.
        options: of the method, as `signorini show METHOD` lists them.
        Raises NotConverged (its `solution` has the record) unless the status is "converged"; with strict=False such a
        solution is returned.
        """
        with tempfile.TemporaryDirectory(prefix="signorini-") as folder:
            words = ["solve", self._source, *method_words(method, options, folder), "--json", "--samples", str(instants)]
            if start is not None:
                guess = Path(folder, "start.json")
                guess.write_text(json.dumps(start.record), encoding="utf-8")
                words += ["--start", str(guess)]
            if reference is not None:
                words += ["--reference", str(reference)]
            record = json.loads(program.run(words, (program.DONE, program.FAILED)))
        solution = Solution(scene=self, record=record)
        if strict and not solution.converged:
            raise program.NotConverged(f"{record['case']}: {solution.status}: {solution.message}", solution)
        return solution

    def orbits(self, *, starts: int = 48, subharmonics: int | None = None, seed: int = 1, timeout: float = 600.0) -> list[Orbit]:
        """All certified orbits that a search finds under the scene's own law, stable or not; an empty list if there are none.

        starts: random states to start from, at each order.  subharmonics: periods of 1 to this many forcing periods.
        timeout: processor time of the search [s].  The same arguments give the same list.
        """
        words = ["orbits", self._source, "--starts", str(starts), "--seed", str(seed), "--timeout", str(timeout), "--json"]
        if subharmonics is not None:
            words += ["--subharmonics", str(subharmonics)]
        return [Orbit(scene=self, record=record) for record in json.loads(program.run(words, (program.DONE, program.FAILED)))]

    def sweep(self, start: float, stop: float, points: int = 50, method: Method = "exact-orbit", *, logarithmic: bool = False,
              back: bool = False, stability: bool = True, timeout: float = 10.0, hz: bool = False, **options: Option) -> Response:
        """The frequency response by any method, each solve from the answer before.

        start, stop: first and last frequency [rad/s]; with hz=True [Hz], as what is computed never is.  logarithmic: equal ratios instead of equal steps.
        back: and back again from the last answer, as a second branch.
        stability: look for the orbit behind each answer and its multipliers.  timeout: of one solve [s].
        """
        with tempfile.TemporaryDirectory(prefix="signorini-") as folder:
            words = ["sweep", self._source, *method_words(method, options, folder), "--from", repr(float(start)),
                     "--to", repr(float(stop)), "--points", str(points), "--timeout", str(timeout), "--format", "json"]
            words += [flag for flag, wanted in (("--log", logarithmic), ("--back", back), ("--certify", stability), ("--hz", hz))
                      if wanted]
            answer = json.loads(program.run(words, (program.DONE, program.FAILED)))
        return Response.from_steps(self, method_name(method), answer)

    def branches(self, start: float, stop: float, method: Method = "exact-orbit", *, orders: int = 2, most: int = 40, search: int = 0,
                 timeout: float = 60.0, hz: bool = False, **options: Option) -> Response:
        """Branches between two frequencies [rad/s], with hz=True [Hz], by arc length, of exact orbits or of a method that follows its own curve.

        orders: longest period, in periods of the load.  most: branches in all.  timeout: processor time of all of them [s].
        search: begin also at all orbits that a search finds at so many frequencies, for isolated branches.
        What is followed, and what is not: docs/responses.md. Raises BadInput for scenes of more than 300 coordinates.
        """
        with tempfile.TemporaryDirectory(prefix="signorini-") as folder:
            words = ["sweep", self._source, *method_words(method, options, folder, "--methods"), "--from", repr(float(start)),
                     "--to", repr(float(stop)), "--max-order", str(orders), "--max-branches", str(most), "--search", str(search),
                     "--total-time", str(timeout), "--format", "json", *(["--hz"] if hz else [])]
            answer = json.loads(program.run(words, (program.DONE, program.FAILED, program.INCOMPLETE)))
        return Response.from_branches(self, method_name(method), answer)

    def backbone(self, start: float | None = None, stop: float | None = None, *, load: float = 1.0, timeout: float = 60.0,
                 hz: bool = False) -> Response:
        """Modes of a damped structure over the amplitude: its phase resonances, from a hundredth of the load up to `load` times it.

        start, stop: frequencies looked between [rad/s], with hz=True [Hz]; those of free motions where none are given.
        Branches have a curve for each mode and sequence of events, with `second`, the factor of the load, and `damping_ratio`.
        timeout: processor time of all of them [s]; what a limit cuts says so in `ended`.  Where there is none, `notes` says why.
        """
        words = ["sweep", self._source, "--backbone", "--second-to", repr(float(load)), "--total-time", str(timeout), "--format", "json"]
        words += [word for flag, value in (("--from", start), ("--to", stop)) if value is not None for word in (flag, repr(float(value)))]
        answer = json.loads(program.run([*words, *(["--hz"] if hz else [])], (program.DONE, program.FAILED, program.INCOMPLETE)))
        return Response.from_branches(self, "exact-orbit", {"branches": answer["curves"], "notes": [], "unfinished": answer["unfinished"]})

    def __repr__(self) -> str:
        return f"Scene({self._source!r})"


def method_name(method: Method) -> str:
    return method.name if isinstance(method, PythonMethod) else method


def method_words(method: Method, options: Mapping[str, Option], folder: str, flag: str = "--method") -> list[str]:
    """--method (or another flag), --plugin and --set of a method with its options; the description of a Python method goes into the folder."""
    words = [flag, method_name(method)]
    if isinstance(method, PythonMethod):
        words += ["--plugin", str(method.describe(folder))]
    for key, value in options.items():
        words += ["--set", f"{key}={str(value).lower() if isinstance(value, bool) else value}"]
    return words
