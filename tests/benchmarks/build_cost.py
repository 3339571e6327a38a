"""What a build takes, in processor time over that of one fixed source, so that machines compare.

The reference is REFERENCE below, compiled alone by the same compiler: half a minute to a minute, the least of three.
limits.py asks for the lines of the tree (`build_lines`); every function takes the target, so that a small one may be
measured alone:

python3 -c 'import build_cost; print(build_cost.one_target("TREE", "signorini_problems"))'
"""

import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

JOBS = 2
DEAR = 0.9  # of the reference: units above are listed
MEASURED = pathlib.Path(__file__).with_name("measured.py")
REFERENCE = """#include <Eigen/Dense>
double f(const Eigen::MatrixXd& a) {
  Eigen::JacobiSVD<Eigen::MatrixXd> s(a, Eigen::ComputeThinU);
  Eigen::EigenSolver<Eigen::MatrixXd> e(a);
  Eigen::GeneralizedEigenSolver<Eigen::MatrixXd> g(a, a);
  return s.singularValues()[0] + e.eigenvalues()[0].real() + g.betas()[0];
}
"""


def launcher(file):
    """The words that measure the command behind them into the file."""
    return [sys.executable, "-S", "-E", str(MEASURED), str(file)]


def environment():
    """Without what would spare a compiler its work, and without orders for ninja."""
    return {key: value for key, value in os.environ.items() if "LAUNCHER" not in key} | {"CCACHE_DISABLE": "1"}


def run(command, check=True):
    """What a command took, with the load when it began and what it printed."""
    load = os.getloadavg()[0]
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder, "cost")
        done = subprocess.run([*launcher(file), *map(str, command)], env=environment(), capture_output=True, text=True, check=False)
        if check and done.returncode != 0:
            sys.exit(f"limits: {shlex.join(map(str, command))} ended with {done.returncode}\n{(done.stdout + done.stderr)[-4000:]}")
        return json.loads(file.read_text()) | {"load": load, "output": done.stdout}


def reference_seconds(repetitions=3):
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder, "r.cpp")
        source.write_text(REFERENCE)
        command = ["g++", "-std=c++20", "-O2", "-I/usr/include/eigen3", "-c", source, "-o", source.with_suffix(".o")]
        return min(run(command)["processor"] for _ in range(repetitions))


class Tree:
    """A fresh clone of a tree, configured as `./bench` does; its units are measured one by one."""

    def __init__(self, source, folder):
        self.root, self.units_file = pathlib.Path(folder, "tree"), pathlib.Path(folder, "units")
        launch = pathlib.Path(folder, "launch")  # one word, as tests hand it on
        launch.write_text(f'#!/bin/sh\nexec {shlex.join(launcher(self.units_file))} "$@"\n')
        launch.chmod(0o755)
        self.build = self.root / "build/release"
        subprocess.run(["git", "clone", "-q", source, self.root], check=True)
        self.commit = subprocess.run(["git", "-C", self.root, "rev-parse", "--short=12", "HEAD"], capture_output=True, text=True,
                                     check=True).stdout.strip()
        run(["cmake", "-S", self.root, "--preset", "release", f"-DCMAKE_CXX_COMPILER_LAUNCHER={launch}"])

    def target(self, name):
        """What it takes to build a target, and the units that were compiled for it, the dearest first."""
        self.units_file.unlink(missing_ok=True)
        cost = run(["cmake", "--build", self.build, "--parallel", JOBS, "--target", name])
        lines = self.units_file.read_text().splitlines() if self.units_file.exists() else []
        units = [{"unit": unit_name(line["command"]), **line} for line in map(json.loads, lines)]
        cost["mib"] = max((unit["mib"] for unit in units), default=None)  # of compilers alone, not of what links
        return cost, sorted(units, key=lambda unit: -unit["processor"])

    def edit(self, file, name):
        """The same after one source was touched."""
        (self.root / file).touch()
        return self.target(name)

    def tests(self):
        """What running the tests takes that `./bench test` runs, and ctest's word on them."""
        cost = run(["ctest", "--test-dir", self.build, "--parallel", JOBS, "-LE", "^(slow|long)$"], check=False)
        found = re.search(r"(\d+) tests? failed out of (\d+)", cost["output"])
        return cost, int(found[2]) if found else 0, int(found[1]) if found else 0


def unit_name(command):
    """The object without what CMake adds: methods/signorini_numerics/unity_2."""
    output = command[command.index("-o") + 1] if "-o" in command else command[-1]
    name = output.replace("CMakeFiles/", "").replace(".dir/", "/").replace("Unity/", "")
    return re.sub(r"(_cxx)?\.(cxx|cpp|hxx)\.(o|gch)$", "", name)


def dear_units(units, reference):
    return [{"unit": unit["unit"], "seconds": unit["processor"], "ratio": unit["processor"] / reference, "mib": unit["mib"]}
            for unit in units if unit["processor"] > DEAR * reference]


def one_target(source, name):
    """Ratio to the reference, wall seconds, largest compiler [MiB] and dear units of one target of a fresh clone."""
    with tempfile.TemporaryDirectory() as folder:
        reference = reference_seconds()
        cost, units = Tree(source, folder).target(name)
        return {"reference": reference, "ratio": cost["processor"] / reference, "wall": cost["wall"], "mib": cost["mib"],
                "units": dear_units(units, reference)}


def build_lines(source):
    """The lines of the build, and the dear units of the program and its tests."""
    with tempfile.TemporaryDirectory() as folder:
        reference = reference_seconds()
        tree = Tree(source, folder)
        lines = []

        def line(what, cost, goal, reached):
            lines.append({"what": what, "seconds": cost["processor"], "reference": reference, "wall": cost["wall"],
                          "load": cost["load"], "mib": cost["mib"], "goal": goal, "reached": reached, "commit": tree.commit})

        program, units = tree.target("signorini")
        line("the program from a fresh clone", program, "ratio 16, 215 s",
             program["processor"] <= 16 * reference and program["wall"] <= 215)
        tests, more = tree.target("all")
        line("its tests after it", tests, "ratio 34 with the program, 240 s",
             program["processor"] + tests["processor"] <= 34 * reference and tests["wall"] <= 240)
        ran, count, failed = tree.tests()
        line(f"{count} tests run, {failed} failed", ran, "180 s", count > 0 and failed == 0 and ran["wall"] <= 180)
        for what, target, most in (("the program", "signorini", 10), ("its tests", "test_method_hat_lcp", 20)):
            cost, _ = tree.edit("methods/hat_lcp/hat_lcp.cpp", target)
            line(f"{what} after an edit of hat_lcp.cpp", cost, f"{most} s", cost["wall"] <= most)
        return lines, dear_units(units + more, reference)
