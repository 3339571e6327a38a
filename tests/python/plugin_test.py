"""Methods written in Python, run by the program and served line by line."""

import json
import os
import subprocess
import sys
import textwrap
import unittest
from unittest import mock

import support
import numpy as np

import signorini
from signorini import BadInput, Motion, NotConverged, Option, Scene, SignoriniError, method, program

LINEAR = textwrap.dedent('''
    """The linear response, for tests."""
    import numpy as np
    from signorini import Curve, Motion, NotConverged, Option, Point, method
    from neighbour import SAMPLES


    @method(ladder="harmonics=1|4", represents={"restitution": "scene", "no_contact": "scene"}, files=["neighbour.py"],
            options={"harmonics": Option("highest harmonic kept", least=1, most=50),
                     "kind": Option("words", choices=["full", "none"])})
    def my_linear(problem, harmonics=4, kind="full", careful=True):
        """The linear response, where no stop is touched.

        More about it.
        """
        print("talking does no harm")
        t = problem.period / SAMPLES * np.arange(SAMPLES)
        x, velocity = np.zeros((2, len(problem.contacts), SAMPLES))
        for h in range(harmonics + 1):
            w = h * problem.frequency
            dynamic = problem.stiffness - w * w * problem.mass + 1j * w * problem.damping
            wave = np.outer(problem.normals.T @ np.linalg.solve(dynamic, problem.load(h)), np.exp(1j * w * t))
            x, velocity = x + wave.real, velocity + (1j * w * wave).real
        if careful and (x > problem.gap[:, None]).any():
            raise NotConverged("a stop is touched")
        return Motion(x, velocity, np.zeros_like(x), residual=0.0, work={"iterations": harmonics},
                      message="guessed" if problem.start is not None else "cold")


    @my_linear.follow
    def linear_curve(problem, interval, harmonics=4, careful=True):
        points = []
        for frequency in np.linspace(interval.start, interval.stop, 5):
            motion = my_linear(problem.at(frequency), harmonics=harmonics, careful=False)
            points.append(Point(frequency, x=motion.x, stable=True))
        yield Curve(points, kind="linear", ended="enough")
        if careful:
            raise NotConverged("nothing more")


    @method(ladder="", represents={"restitution": 1.0}, title="It breaks")
    def broken(problem):
        raise ArithmeticError("no luck today")


    @method(ladder="", represents={"restitution": 1.0})
    def ragged(problem):
        return Motion(np.zeros((1, 4)), np.zeros((1, 3)), np.zeros((1, 4)))


    @method(ladder="", represents={"restitution": 1.0})
    def infinite(problem):
        return Motion(np.full((1, 4), np.inf), np.zeros((1, 4)), np.zeros((1, 4)))
''')


class PythonMethods(support.TemporaryFolder):
    def setUp(self):
        super().setUp()
        self.write("neighbour.py", "SAMPLES = 256\n")
        self.write("linear_methods.py", LINEAR)
        with mock.patch.object(sys, "path", [str(self.folder), *sys.path]):
            sys.modules.pop("linear_methods", None)
            import linear_methods
        self.methods = linear_methods
        self.scene = Scene.load("sdof-far-stop")

    def test_are_judged_like_any_other(self):
        solution = self.scene.solve(self.methods.my_linear, harmonics=2)
        self.assertEqual((solution.status, solution.method, solution.message), ("converged", "my-linear", "cold"))
        self.assertEqual(solution.options, {"harmonics": 2, "kind": "full", "careful": True})
        self.assertEqual(solution.record["work"]["iterations"], 2)
        self.assertLess(solution.errors["x_l2"], 1e-8)
        # Between the instants given the motion is a cubic.
        np.testing.assert_allclose(solution.x, self.scene.solve("exact-orbit").x, atol=1e-8)

    def test_may_be_called_as_functions(self):
        motion = self.methods.my_linear(self.scene.problem, harmonics=1)
        self.assertEqual(motion.x.shape, (1, 256))
        with self.assertRaisesRegex(NotConverged, "a stop is touched"):
            self.methods.my_linear(Scene.load("sdof-stop").problem)

    def test_start_from_a_motion_where_there_is_one(self):
        start = self.scene.solve("exact-orbit", instants=64)
        self.assertEqual(self.scene.solve(self.methods.my_linear, start=start).message, "guessed")

    def test_that_give_up_fail_or_give_no_motion_say_so(self):
        stop = Scene.load("sdof-stop")
        for function, status, words in ((self.methods.my_linear, "not-converged", "a stop is touched"),
                                        (self.methods.broken, "crashed", "ArithmeticError: no luck today"),
                                        (self.methods.ragged, "crashed", "must each be Nc x N"),
                                        (self.methods.infinite, "crashed", "x has values that are not finite")):
            solution = stop.solve(function, strict=False)
            self.assertEqual(solution.status, status)
            self.assertIn(words, solution.message)
        # A motion through the stop is claimed, and refuted.
        self.assertEqual(stop.solve(self.methods.my_linear, strict=False, careful=False).status, "inaccurate")

    def test_refuse_options_out_of_range_and_laws_that_they_do_not_represent(self):
        with self.assertRaisesRegex(BadInput, r"harmonics = 0 \(must be at least 1\)"):
            self.scene.solve(self.methods.my_linear, harmonics=0)
        with self.assertRaisesRegex(BadInput, "kind = some .must be one of full, none"):
            self.scene.solve(self.methods.my_linear, kind="some")
        with self.assertRaisesRegex(NotConverged, "not-applicable"):
            Scene.load("sdof-penalty-soft").solve(self.methods.my_linear)

    def test_follow_a_frequency(self):
        sweep = self.scene.sweep(0.4, 0.5, 2, self.methods.my_linear, stability=False)
        self.assertEqual((sweep.method, sweep.converged), ("my-linear", True))

    def test_follow_their_own_curve(self):
        response = self.scene.branches(0.5, 0.4, self.methods.my_linear, harmonics=2)
        self.assertEqual((response.method, len(response.branches)), ("my-linear", 1))
        self.assertEqual(response.notes, ["nothing more"])
        branch = response.branches[0]
        np.testing.assert_allclose(branch.frequency, np.linspace(0.5, 0.4, 5))
        self.assertTrue(branch.stable.all())
        for frequency, amplitude in zip(branch.frequency, branch.amplitude[:, 0]):
            here = self.methods.my_linear(self.scene.problem.at(frequency), harmonics=2)
            self.assertAlmostEqual(amplitude, np.ptp(here.x) / 2, delta=1e-12)

    def test_follow_with_options_of_their_own_alone(self):
        with self.assertRaisesRegex(SignoriniError, "colour of wrong .must be options of the method"):
            @self.methods.ragged.follow
            def wrong(problem, interval, colour=1):
                return []

    def test_without_a_curve_are_not_asked_for_one(self):
        self.assertNotIn("curves", self.methods.broken.toml(self.folder / "linear_methods.py", beside=True))
        self.assertIn("curves = true", self.methods.my_linear.toml(self.folder / "linear_methods.py", beside=True))

    def test_are_described_beside_their_file_for_the_command_line(self):
        description = self.methods.my_linear.describe()
        self.assertEqual(description, self.folder.resolve() / "my-linear.toml")
        shown = program.run(["show", "my-linear", "--plugin", str(description)])
        self.assertRegex(shown, r"my-linear: The linear response, where no stop is touched\n")
        self.assertRegex(shown, r"harmonics +4 +\[-\] +highest harmonic kept")
        self.assertRegex(description.read_text(), r'"linear_methods.py", "my_linear"\]\npersistent = true\ncurves = true\nfiles = \["neighbour.py"\]')

    def test_must_stand_at_the_top_level_of_a_file(self):
        @method(ladder="", represents={"restitution": 1.0})
        def nested(problem):
            return None

        with self.assertRaisesRegex(SignoriniError, "must be a function at the top level of a file"):
            self.scene.solve(nested)

    def test_must_be_marked_soundly(self):
        def function(problem, level=1, other=None):
            return None

        with self.assertRaisesRegex(SignoriniError, "other .must have a default"):
            method(ladder="", represents={})(function)
        with self.assertRaisesRegex(SignoriniError, "colour, weight .must be a keyword"):
            method(ladder="", represents={"weight": 1.0}, options={"colour": Option("none")})(lambda problem, level=1: None)

    def test_may_not_solve_while_they_are_imported(self):
        self.write("careless.py", LINEAR + "\nfrom signorini import Scene\nScene.load('sdof-stop').solve()\n")
        served = self.serve("careless.py", "my_linear", "")
        self.assertNotEqual(served.returncode, 0)
        self.assertIn('must not solve while it is imported', served.stderr)

    def serve(self, file, function, lines):
        return subprocess.run([sys.executable, "-B", "-m", "signorini.serve", str(self.folder / file), function], input=lines,
                              capture_output=True, text=True, env=program.environment(), check=False)

    def request(self, **more):
        problem = {"name": "one", "size": 1, "frequency": 2.0, "subharmonic": 1, "period": np.pi, "law": {"restitution": 1.0},
                   "force": [{"dof": 0, "harmonic": 1, "cos": 1.0, "sin": 0.0}], "contacts": [{"normal": [[0, 1.0]], "gap": 2.0}]}
        for key, value in (("mass", 1.0), ("damping", 0.1), ("stiffness", 1.0)):
            problem[key] = {"row": [0], "column": [0], "value": [value]}
        return json.dumps({"schema": 1, "problem": problem, "options": {"harmonics": 3}, **more}) + "\n"

    def test_answer_one_request_or_many_line_by_line(self):
        once = self.serve("linear_methods.py", "my_linear", self.request())
        self.assertNotIn("seconds", json.loads(once.stdout))
        self.assertIn("talking does no harm", once.stderr)
        closed = self.request().replace('"gap": 2.0', '"gap": 0.0')
        lines = "".join([self.request(persistent=True), closed, self.request(persistent=True)])
        first, second, third = map(json.loads, self.serve("linear_methods.py", "my_linear", lines).stdout.splitlines())
        self.assertEqual(first["trajectory"], json.loads(once.stdout)["trajectory"])
        self.assertEqual(second, {"verdict": "not-converged", "message": "a stop is touched"})
        self.assertEqual(third["trajectory"], first["trajectory"])
        self.assertTrue(0 < third["seconds"] < 10)
        self.assertAlmostEqual(max(first["trajectory"]["x"][0]), 1 / abs(-3 + 0.2j), delta=1e-3)

    def test_that_are_not_there_are_told(self):
        self.assertIn("nothing (must be a function marked", self.serve("linear_methods.py", "nothing", "").stderr)
        self.assertIn("FileNotFoundError", self.serve("none.py", "nothing", "").stderr)
        self.assertIn("must be a Python file", self.serve("none.txt", "nothing", "").stderr)


PATIENT = textwrap.dedent('''
    """Takes 20 ms, and writes down who takes them."""
    import os
    import pathlib
    import time
    import numpy as np
    from signorini import Motion, method


    @method(ladder="", represents={"no_contact": "scene", "restitution": "scene"})
    def patient(problem, level=1):
        time.sleep(0.02)
        with open(pathlib.Path(__file__).with_name("processes"), "a") as file:
            print(os.getpid(), file=file)
        return Motion(np.zeros((1, 8)), np.zeros((1, 8)), np.zeros((1, 8)))
''')


class Processes(support.TemporaryFolder):
    def test_answer_all_solves_of_a_round_and_tell_their_own_time(self):
        self.write("patient.py", PATIENT)
        with mock.patch.object(sys, "path", [str(self.folder), *sys.path]):
            sys.modules.pop("patient", None)
            import patient
        scene = Scene.from_matrices([[1.0]], [[0.1]], [[1.0]], frequency=2.0, contacts={0: 1.0}, law={"restitution": 1.0})
        solution = scene.solve(patient.patient)
        seconds = solution.record["seconds"]
        processes = (self.folder / "processes").read_text().split()
        self.assertGreater(len(processes), 1)
        self.assertEqual(len(set(processes)), 1)
        self.assertTrue(0.02 <= seconds["solve"] < 1.0, seconds)
        self.assertGreater(seconds["exchange"], 0.0)


class Begun(support.TemporaryFolder):
    def test_methods_are_described_as_the_package_would_and_pass_the_check(self):
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)
        program.run(["new", "method", "my-method", "--python"])
        folder = self.folder / "my-method"
        written = (folder / "my-method.toml").read_text()
        code = "import my_method; my_method.solve.describe()"
        subprocess.run([sys.executable, "-B", "-c", code], cwd=folder, env=program.environment(), check=True)
        described = (folder / "my-method.toml").read_text()
        self.assertEqual(described.replace(sys.executable, "python3"), written)
        program.run(["check", "my-method", "--plugin", str(folder / "my-method.toml"), "--scenes", "sdof-far-stop"])


class Motions(unittest.TestCase):
    def test_survive_the_way_to_the_program_and_back(self):
        x = np.array([[0.0, 1.0, 2.0], [3.0, 4.0, 5.0]])
        motion = Motion(x, 2 * x, -x, period=3.0, impulses=[(1, 0.5, -2.0)], bandwidth=7)
        again = Motion.from_json(motion.to_json(6.0))
        for key in ("x", "velocity", "force"):
            np.testing.assert_array_equal(getattr(again, key), getattr(motion, key))
        self.assertEqual((again.period, again.impulses, again.bandwidth), (3.0, [(1, 0.5, -2.0)], 7))
        self.assertEqual(motion.to_json(6.0)["trajectory"]["t"], [0.0, 1.0, 2.0])

    def test_are_public(self):
        self.assertTrue(all(hasattr(signorini, name) for name in signorini.__all__))


if __name__ == "__main__":
    unittest.main()
