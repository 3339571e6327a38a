"""Methods written as Python functions, which the program runs as commands: docs/plugins.md, section Any executable."""

from __future__ import annotations

import inspect
import json
import shutil
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from .files import require_name, write_whole
from .motion import Motion
from .problem import Problem
from .program import SignoriniError

SCENES = ("restitution", "penalty", "massless", "mixed", "no_contact")


@dataclass(frozen=True)
class Option:
    """What an option of a method means; its name and default are those of the function's keyword."""

    meaning: str
    unit: str = "[-]"
    least: float | None = None
    most: float | None = None
    choices: Sequence[str] = ()


@dataclass(frozen=True)
class PythonMethod:
    """A function marked by `method`. Calling it calls the function."""

    function: Callable = field(repr=False)
    name: str
    title: str
    ladder: str
    represents: Mapping[str, object]
    options: Mapping[str, Option]
    files: Sequence[str | Path] = ()
    curves: list[Callable] = field(default_factory=list, repr=False)

    def follow(self, function: Callable) -> Callable:
        """Marks a function `f(problem, interval, option=default, ..)` as the one that follows the method's own curve.

        It gets the problem at interval.start and an `Interval`, and returns curves (`Curve`) or yields them. Its keywords are
        options of the method, of the same names.
        """
        unknown = [name for name in list(inspect.signature(function).parameters)[2:] if name not in keywords(self.function)]
        if unknown:
            raise SignoriniError(f"method {self.name}: {', '.join(unknown)} of {function.__name__} (must be options of the method)")
        self.curves[:] = [function]
        return function

    def __call__(self, problem: Problem, **options) -> Motion:
        return self.function(problem, **options)

    def describe(self, folder: str | Path | None = None) -> Path:
        """Writes the description NAME.toml for `signorini --plugin`, beside the function's file unless told; returns its path.

        Raises SignoriniError for a function that is not at the top level of a file.
        """
        require_name(self.name)
        file = self._file()
        folder = file.parent if folder is None else Path(folder)
        description = folder / f"{self.name}.toml"
        write_whole(description, self.toml(file, beside=folder == file.parent))
        return description

    def toml(self, file: Path, beside: bool) -> str:
        """The description; the function's file by its name alone where it stands beside it."""
        python = "python3" if shutil.which("python3") == sys.executable else sys.executable
        place = [path.name if beside and path.parent == file.parent else str(path)
                 for path in (file, *(Path(file.parent, other) for other in self.files))]
        lines = ["# Written by signorini.method; keys: docs/plugins.md", "schema = 1", f"name = {text(self.name)}",
                 f"title = {text(self.title)}", f"ladder = {text(self.ladder)}",
                 f"command = {text([python, '-m', 'signorini.serve', place[0], self.function.__name__])}"]
        lines.append("persistent = true")
        if self.curves:
            lines.append("curves = true")
        if len(place) > 1:
            lines.append(f"files = {text(place[1:])}")
        lines += ["", "[represents]", *(f"{law} = {text(value)}" for law, value in self.represents.items())]
        for name, parameter in keywords(self.function).items():
            option = self.options.get(name, Option(f"{name} of {self.name}"))
            lines += ["", "[[option]]", f"name = {text(name)}", f"default = {text(parameter.default)}",
                      f"unit = {text(option.unit)}", f"meaning = {text(option.meaning)}"]
            limits = (("least", option.least), ("most", option.most))
            lines += [f"{key} = {text(value)}" for key, value in limits if value is not None]
            if option.choices:
                lines.append(f"choices = {text(list(option.choices))}")
        return "\n".join(lines) + "\n"

    def _file(self) -> Path:
        source = inspect.getsourcefile(self.function)
        if source is None or not Path(source).is_file() or self.function.__qualname__ != self.function.__name__:
            raise SignoriniError(f"method = {self.name} (must be a function at the top level of a file, which the program runs)")
        return Path(source).resolve()


def method(*, ladder: str, represents: Mapping[str, object], name: str | None = None, title: str | None = None,
           options: Mapping[str, Option] | None = None, files: Sequence[str | Path] = ()) -> Callable[[Callable], PythonMethod]:
    """Marks a function `f(problem, option=default, ..)` that returns a `Motion` as a method.

    Its keywords, which need defaults (truth value, whole number, number or word), are the options of the method. It raises
    NotConverged where it gives up. It must stand at the top level of a file: the program runs it in processes of its own.

    ladder: what `signorini run` varies, as "harmonics=10|40".
    represents: the law that answers obey for each law of a scene that the method applies to, as {"restitution": 1.0,
    "penalty": "scene"}; keys restitution (a number, "scene" or "undetermined"), penalty, massless, mixed (each contact its own of these), no_contact ("scene").
    name: else the function's, with - for _.  title: else the first line of its documentation.
    options: what they mean, by their names.  files: others that answers depend on, relative to the function's.
    """
    def mark(function: Callable) -> PythonMethod:
        known = keywords(function)
        unknown = [key for key in options or {} if key not in known]
        if unknown or set(represents) - set(SCENES):
            wrong = ", ".join(unknown + sorted(set(represents) - set(SCENES)))
            raise SignoriniError(f"method {function.__name__}: {wrong} "
                                 f"(must be a keyword of the function, or a law of {', '.join(SCENES)})")
        return PythonMethod(function, name or function.__name__.replace("_", "-"), title or first_line(function), ladder,
                            represents, options or {}, files)
    return mark


def first_line(function: Callable) -> str:
    return (inspect.getdoc(function) or function.__name__).splitlines()[0].rstrip(".")


def keywords(function: Callable) -> dict[str, inspect.Parameter]:
    """Parameters of a method's function after the first. Raises SignoriniError where one has no default of a usable type."""
    parameters = dict(list(inspect.signature(function).parameters.items())[1:])
    for name, parameter in parameters.items():
        if not isinstance(parameter.default, (bool, int, float, str)):
            raise SignoriniError(f"method {function.__name__}: {name} (must have a default: true or false, a number or a word)")
    return parameters


def text(value) -> str:
    """A value in TOML: JSON's words, numbers and lists are."""
    return json.dumps(value, ensure_ascii=False)
