"""The program `signorini`: where it is, how it is run, and its complaints as exceptions."""

from __future__ import annotations

import contextlib
import os
import shutil
import signal
import subprocess
import threading
from collections.abc import Iterator, Sequence
from pathlib import Path

PACKAGE_PARENT = Path(__file__).resolve().parents[1]
INSIDE = Path("signorini", "prefix", "bin", "signorini")  # below PACKAGE_PARENT, of a wheel (cmake/release/wheel.py)
SERVING = "SIGNORINI_SERVING"  # set in a process that runs a method for the program
GRACE = 5.0  # [s] for the program to end by itself after an interrupt

DONE, FAILED, BAD_INPUT, NO_MATCH, INCOMPLETE, INTERRUPTED = 0, 1, 2, 3, 6, 130  # exit codes


class SignoriniError(RuntimeError):
    """What the program refuses or cannot do; the text is its one line.

    code: its exit code, or minus the number of the signal that ended it; None where it was not run.
    """

    def __init__(self, message: str, code: int | None = None):
        super().__init__(message)
        self.code = code


class ProgramNotFound(SignoriniError):
    """There is no program to run."""


class BadInput(SignoriniError, ValueError):
    """The program refuses a scene, a method or an option (exit codes 2 and 3)."""


class NotConverged(SignoriniError):
    """A solve without a confirmed answer (exit code 1), or what a method of one's own raises where it gives up.

    solution: a `Solution` with status, message and what there is of an answer; None where a method raises it.
    """

    def __init__(self, message: str, solution=None):
        super().__init__(message, FAILED)
        self.solution = solution


class Interrupted(SignoriniError):
    """The program was asked to stop (exit code 130)."""


def find_program() -> Path:
    """The program: $SIGNORINI_PROGRAM, else that of the wheel that this package came in, else on the PATH, else the release build
    of the tree that holds this package.

    Raises ProgramNotFound.
    """
    named = os.environ.get("SIGNORINI_PROGRAM")
    if named:
        path = Path(named)
        if path.is_file() and os.access(path, os.X_OK):
            return path.absolute()
        raise ProgramNotFound(f"SIGNORINI_PROGRAM = {named} (must be the program signorini)")
    found = shutil.which(PACKAGE_PARENT / INSIDE) or shutil.which("signorini")
    if found:
        return Path(found).absolute()
    built = PACKAGE_PARENT.parent / "build" / "release" / "harness" / "signorini"
    if built.is_file() and os.access(built, os.X_OK):
        return built
    raise ProgramNotFound("the program signorini is not on the PATH: build it (./bench run), then put it on the PATH or its path "
                          "into SIGNORINI_PROGRAM")


def run(arguments: Sequence[str | os.PathLike], allowed: Sequence[int] = (DONE,)) -> str:
    """Standard output of `signorini ARGUMENTS`, which must end with one of the `allowed` exit codes.

    Raises BadInput (exit codes 2 and 3), Interrupted (130), ProgramNotFound, and SignoriniError otherwise. An interrupt of
    this process (KeyboardInterrupt) ends the program too.
    """
    if os.environ.get(SERVING):
        raise SignoriniError("a file that holds a method must not solve while it is imported: "
                             "put such lines below `if __name__ == \"__main__\":`")
    words = [str(find_program()), *map(os.fspath, arguments)]
    process = None
    try:
        with interrupts_later():
            process = start(words)
        output, errors = process.communicate()
    except BaseException:
        if process is not None:
            end(process)
        raise
    if process.returncode in allowed:
        return output
    raise complaint(process.returncode, errors)


def start(words: Sequence[str]) -> subprocess.Popen:
    try:
        return subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                text=True, encoding="utf-8", errors="replace", env=environment())
    except OSError as error:
        raise ProgramNotFound(f"{words[0]} cannot be run: {error.strerror}") from None


@contextlib.contextmanager
def interrupts_later() -> Iterator[None]:
    """Raises a KeyboardInterrupt of the block at its end: by then a program that it starts is known, and can be ended."""
    if threading.current_thread() is not threading.main_thread():  # others are never interrupted
        yield
        return
    seen: list[int] = []
    before = signal.signal(signal.SIGINT, lambda number, frame: seen.append(number))
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before if before is not None else signal.SIG_DFL)
    if seen:
        raise KeyboardInterrupt


def environment() -> dict[str, str]:
    """That of this process, in which a child that runs a method finds this package."""
    paths = [str(PACKAGE_PARENT), *filter(None, [os.environ.get("PYTHONPATH")])]
    return {**os.environ, "PYTHONPATH": os.pathsep.join(paths)}


def end(process: subprocess.Popen) -> None:
    """Interrupts the program, as Ctrl-C does, and kills it if it does not end."""
    process.send_signal(signal.SIGINT)
    try:
        process.communicate(timeout=GRACE)
    except subprocess.TimeoutExpired:
        process.kill()
        process.communicate()


def complaint(code: int, errors: str) -> SignoriniError:
    """The exception for an exit code and what was printed on standard error."""
    lines = errors.strip().splitlines()
    line = lines[-1] if lines else f"signorini ended with exit code {code}"
    if code < 0:
        return SignoriniError(f"signorini was ended by signal {-code} ({signal.strsignal(-code)})", code)
    if code == INTERRUPTED:
        return Interrupted("signorini was interrupted", code)
    return (BadInput if code in (BAD_INPUT, NO_MATCH) else SignoriniError)(line, code)
