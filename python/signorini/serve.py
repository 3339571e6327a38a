"""python3 -m signorini.serve FILE FUNCTION: runs the method of that name in a file for the program, until its input ends.

Each line read is a request, each line printed its answer: a program that starts the process for each solve and one that keeps
it are served alike. docs/plugins.md has both.
"""

from __future__ import annotations

import importlib.util
import inspect
import json
import os
import sys
import time
from collections.abc import Mapping
from pathlib import Path

from .curve import Interval
from .plugin import PythonMethod
from .problem import Problem
from .program import SERVING, NotConverged, SignoriniError


def answer(method: PythonMethod, request: Mapping) -> dict:
    """The answer to one request; with the function's own time where the request comes to a process that stays [s]."""
    problem = Problem.from_request(request)
    begin = time.perf_counter()
    if "follow" in request:
        return curve(method, problem, request)
    try:
        motion = method(problem, **request["options"])
        seconds = time.perf_counter() - begin
        result = {"verdict": "converged", **motion.to_json(problem.period)}
    except NotConverged as reason:
        seconds = time.perf_counter() - begin
        result = {"verdict": "not-converged", "message": str(reason)}
    return {**result, "seconds": seconds} if request.get("persistent") else result


def curve(method: PythonMethod, problem: Problem, request: Mapping) -> dict:
    """The answer to a request for a curve. What was followed before the function raises NotConverged counts."""
    begin = time.perf_counter()
    branches: list[dict] = []
    unfinished = ""
    function = method.curves[0]
    options = {name: request["options"][name] for name in list(inspect.signature(function).parameters)[2:]}
    try:
        for found in function(problem, Interval.from_request(request["follow"]), **options):
            branches.append(found.to_json())
    except NotConverged as reason:
        unfinished = str(reason)
    return {"branches": branches, "unfinished": unfinished, "seconds": time.perf_counter() - begin}


def serve(method: PythonMethod) -> None:
    """What the function prints goes to standard error."""
    answers, sys.stdout = sys.stdout, sys.stderr
    for line in sys.stdin:
        print(json.dumps(answer(method, json.loads(line))), file=answers, flush=True)


def find_method(file: Path, function: str) -> PythonMethod:
    """Raises SignoriniError where the file has no such method."""
    sys.path.insert(0, str(file.resolve().parent))
    spec = importlib.util.spec_from_file_location(file.stem, file)
    if spec is None or spec.loader is None:
        raise SignoriniError(f"{file} (must be a Python file)")
    module = importlib.util.module_from_spec(spec)
    sys.modules[file.stem] = module
    spec.loader.exec_module(module)
    found = getattr(module, function, None)
    if not isinstance(found, PythonMethod):
        raise SignoriniError(f"{file}: {function} (must be a function marked with signorini.method)")
    return found


def main() -> None:
    if len(sys.argv) != 3:
        sys.exit("usage: python3 -m signorini.serve FILE FUNCTION")
    os.environ[SERVING] = "1"
    sys.dont_write_bytecode = True
    serve(find_method(Path(sys.argv[1]), sys.argv[2]))


if __name__ == "__main__":
    main()
