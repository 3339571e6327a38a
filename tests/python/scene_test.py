"""Scenes and what is computed of them, against closed forms, receptances and the catalogue."""

import tempfile
import unittest
from pathlib import Path

import support
import numpy as np

import signorini
from signorini import BadInput, Contact, Load, NotConverged, Scene

CHAIN = np.array([[2.0, -1.0, 0.0], [-1.0, 2.0, -1.0], [0.0, -1.0, 1.0]])


def oscillator(**changes):
    parts = support.Oscillator(**changes)
    return parts, Scene.from_matrices([[parts.mass]], [[parts.damping]], [[1.0]], frequency=parts.frequency, load={0: 1.0},
                                      contacts={0: parts.gap}, law={"restitution": parts.restitution})


def linear_scene(frequency=1.3, gap=100.0, subharmonic=1):
    """Three coupled masses, a load of three terms, a contact in a direction of its own."""
    generator = np.random.default_rng(5)
    root = generator.normal(size=(3, 3))
    M, D, K = np.diag([1.0, 2.0, 0.5]), 0.1 * CHAIN, root @ root.T + np.eye(3)
    loads = [Load(0, cos=1.0, sin=-0.5), Load(2, cos=0.3, harmonic=3), Load(1, cos=0.7, harmonic=0)]
    scene = Scene.from_matrices(M, D, K, frequency=frequency, load=loads, contacts=[Contact({0: 0.6, 2: -0.8}, gap)],
                                law={"restitution": 1.0}, subharmonic=subharmonic)
    normal = np.array([0.6, 0.0, -0.8])
    return scene, {h: normal @ support.receptance(M, D, K, h * frequency) @ force for h, force in
                   {0: [0, 0.7, 0], 1: [1.0 + 0.5j, 0, 0], 3: [0, 0, 0.3]}.items()}


class Names(unittest.TestCase):
    def test_are_no_paths(self):
        with tempfile.TemporaryDirectory() as folder:
            own = Path(folder, "own.toml")
            own.write_text("the user's\n")
            for name in (str(own.with_suffix("")), "../own", "Own", "", "a" * 65):
                with self.assertRaises(BadInput):
                    Scene.from_matrices([[1.0]], [[0.1]], [[1.0]], frequency=1.0, load={0: 1.0}, name=name)
            self.assertEqual(own.read_text(), "the user's\n")

    def test_of_links_are_replaced_and_what_they_lead_to_stays(self):
        _, scene = oscillator()
        with tempfile.TemporaryDirectory() as folder:
            own = Path(folder, "own")
            own.write_text("the user's\n")
            for name in ("K.mtx", "K.mtx.new", "from-matrices.toml"):
                Path(folder, name).symlink_to(own)
            file = scene.save(folder)
            self.assertEqual(own.read_text(), "the user's\n")
            self.assertFalse(file.is_symlink())
            self.assertEqual(Scene(str(file)).problem.size, 1)


class Solutions(unittest.TestCase):
    def test_of_an_oscillator_that_hits_its_stop_are_the_closed_form(self):
        for restitution in (1.0, 0.6):
            parts, scene = oscillator(restitution=restitution)
            solution = scene.solve("exact-orbit")
            (impact,) = solution.impacts
            time, speed = min(parts.impacts(), key=lambda one: abs(one[0] - impact.time))
            self.assertAlmostEqual(impact.time, time, delta=1e-9 * parts.period)
            self.assertAlmostEqual(impact.impulse, -(1 + restitution) * parts.mass * speed, delta=1e-9)
            np.testing.assert_allclose(solution.x[0], parts.motion(time, solution.t), atol=1e-9)
            fine = parts.motion(time, parts.period * np.arange(200000) / 200000)
            self.assertAlmostEqual(solution.extremes[1][0], parts.gap, delta=1e-14)
            self.assertAlmostEqual(solution.extremes[0][0], fine.min(), delta=1e-9)
            # The flow shrinks areas by exp(-c T / m), the impact by e^2.
            product = restitution**2 * np.exp(-parts.damping * parts.period / parts.mass)
            self.assertAlmostEqual(np.prod(solution.multipliers), product, delta=1e-9)
            self.assertTrue(solution.stable and solution.certified and solution.converged)

    def test_without_contact_are_the_receptance(self):
        scene, harmonics = linear_scene()
        for method in ("exact-orbit", "fourier-lipschitz"):
            solution = scene.solve(method, instants=64)
            expected = sum((x * np.exp(1j * h * 1.3 * solution.t)).real for h, x in harmonics.items())
            np.testing.assert_allclose(solution.x[0], expected, atol=1e-9 * np.abs(expected).max())
            rate = sum((1j * h * 1.3 * x * np.exp(1j * h * 1.3 * solution.t)).real for h, x in harmonics.items())
            np.testing.assert_allclose(solution.velocity[0], rate, atol=1e-9 * np.abs(rate).max())
            self.assertEqual((solution.impacts, solution.force.any()), ((), False))

    def test_have_the_period_that_is_looked_for(self):
        scene, _ = linear_scene(subharmonic=2)
        self.assertAlmostEqual(scene.solve("fourier-lipschitz").period, 2 * 2 * np.pi / 1.3, delta=1e-12)

    def test_have_extremes_between_the_instants(self):
        scene, harmonics = linear_scene()
        t = np.linspace(0, 2 * np.pi / 1.3, 100001)
        expected = sum((x * np.exp(1j * h * 1.3 * t)).real for h, x in harmonics.items())
        least, largest = scene.solve(instants=256).extremes
        self.assertAlmostEqual(least[0], expected.min(), delta=1e-7 * np.ptp(expected))
        self.assertAlmostEqual(largest[0], expected.max(), delta=1e-7 * np.ptp(expected))

    def test_may_start_from_others_and_take_options(self):
        scene = Scene.load("sdof-stop")
        coarse = scene.solve("hat-lcp", samples=512, plain=False)
        self.assertEqual((coarse.options["samples"], coarse.options["plain"], coarse.x.shape), (512, False, (1, 1024)))
        self.assertIn("from the guess", scene.solve("exact-orbit", start=coarse).message)

    def test_that_do_not_converge_say_why_and_may_be_asked_for(self):
        scene = Scene.load("sdof-stop")
        with self.assertRaisesRegex(NotConverged, "sdof-stop/fourier-lipschitz.*not-converged: ") as caught:
            scene.solve("fourier-lipschitz", plain=True)
        self.assertEqual(caught.exception.code, 1)
        solution = scene.solve("fourier-lipschitz", plain=True, strict=False)
        self.assertEqual((solution.status, solution.converged), ("not-converged", False))
        with self.assertRaisesRegex(NotConverged, "not-converged"):
            solution.x
        self.assertEqual(len(solution.multipliers), 0)


class Matrices(support.TemporaryFolder):
    def test_of_a_chain_are_those_of_the_catalogue(self):
        catalogue = Scene.load("chain3-stop")
        own = Scene.from_matrices(np.eye(3), 0.1 * CHAIN, CHAIN, frequency=0.7, load={2: 1.0}, contacts={2: 0.5},
                                  law={"restitution": 1.0})
        for key, expected in (("mass", np.eye(3)), ("damping", 0.1 * CHAIN), ("stiffness", CHAIN)):
            np.testing.assert_allclose(getattr(catalogue.problem, key), expected, atol=1e-15)
        np.testing.assert_array_equal(catalogue.problem.normals, [[0.0], [0.0], [1.0]])
        np.testing.assert_array_equal(catalogue.problem.load(1), [0.0, 0.0, 1.0])
        first, second = catalogue.solve(), own.solve()
        np.testing.assert_allclose(second.x, first.x, atol=1e-11 * np.abs(first.x).max())

    @unittest.skipUnless(support.installed("scipy.sparse"), "scipy is not installed")
    def test_may_be_sparse_with_repeated_entries(self):
        from scipy import sparse
        K = sparse.coo_matrix(([2.0, -1.0, -1.0, 0.5, 0.5], ([0, 0, 1, 1, 1], [0, 1, 0, 1, 1])))
        scene = Scene.from_matrices(sparse.eye(2), sparse.csr_matrix((2, 2)), K, frequency=0.4)
        np.testing.assert_array_equal(scene.problem.stiffness, [[2.0, -1.0], [-1.0, 1.0]])
        np.testing.assert_array_equal(scene.problem.damping, np.zeros((2, 2)))
        np.testing.assert_array_equal(scene.problem.sparse("stiffness").toarray(), scene.problem.stiffness)

    def test_of_damping_may_be_proportional_or_modal(self):
        M, K = np.diag([1.0, 2.0]), np.diag([3.0, 8.0])
        damped = Scene.from_matrices(M, {"alpha": 0.5, "beta": 0.25}, K, frequency=1.0).problem.damping
        np.testing.assert_allclose(damped, 0.5 * M + 0.25 * K, rtol=1e-14)
        modal = Scene.from_matrices(M, {"modal": [0.1, 0.2]}, K, frequency=1.0).problem.damping
        np.testing.assert_allclose(modal, np.diag([2 * 0.1 * np.sqrt(3.0), 2 * 0.2 * 2.0 * 2.0]), rtol=1e-12, atol=1e-15)

    def test_may_have_a_circulatory_part(self):
        N = 0.12 * np.array([[0.0, 1.0], [-1.0, 0.0]])
        scene = Scene.from_matrices(np.eye(2), np.diag([0.3, 0.3]), np.eye(2), frequency=1.7, circulatory=N,
                                    load=[Load(0, 1.0), Load(1, sin=1.0)], contacts={0: 9.0}, law={"restitution": 1.0})
        np.testing.assert_array_equal(scene.problem.stiffness, np.eye(2) + N)
        solution = scene.solve("fourier-lipschitz", instants=16)
        whirl = 1.0 / (1.0 - 1.7**2 + 1j * (0.3 * 1.7 - 0.12))
        np.testing.assert_allclose(solution.x[0], (whirl * np.exp(1.7j * solution.t)).real, atol=1e-12)
        with self.assertRaisesRegex(BadInput, "must be skew-symmetric"):
            Scene.from_matrices(np.eye(2), np.eye(2), np.eye(2), frequency=1.0, circulatory=np.eye(2))

    def test_may_follow_the_frequency(self):
        J = np.array([[0.0, 1.0], [-1.0, 0.0]])
        scene = Scene.from_matrices(np.eye(2), np.diag([0.3, 0.3]), np.eye(2), frequency=2.0, gyroscopic_per_speed=0.5 * J,
                                    circulatory_per_speed=0.25 * J, load=[Load(0, 1.0), Load(1, sin=1.0)], contacts={0: 9.0}, law={"restitution": 1.0})
        again = Scene.load(scene.save(self.folder / "saved"))
        for problem in (scene.problem, again.problem):
            np.testing.assert_array_equal(problem.damping, 0.3 * np.eye(2) + J)
            np.testing.assert_array_equal(problem.stiffness, np.eye(2) + 0.5 * J)
            np.testing.assert_array_equal(problem.at(4.0).damping, 0.3 * np.eye(2) + 2.0 * J)
            np.testing.assert_array_equal(problem.at(4.0).stiffness, np.eye(2) + J)
        with self.assertRaisesRegex(BadInput, "gyroscopic_per_speed.*must be skew-symmetric"):
            Scene.from_matrices(np.eye(2), np.eye(2), np.eye(2), frequency=1.0, gyroscopic_per_speed=np.eye(2))
        with self.assertRaisesRegex(ValueError, "N1 3 x 3"):
            Scene.from_matrices(np.eye(2), np.eye(2), np.eye(2), frequency=1.0, circulatory_per_speed=np.zeros((3, 3)))

    def test_take_stops_with_dampers(self):
        scene = Scene.from_matrices([[1.0]], [[0.1]], [[1.0]], frequency=2.0, load={0: 1.0}, contacts={0: 0.2},
                                    law={"penalty": 100.0, "damping": 4.0})
        catalogue = Scene.load("sdof-damped-stop").problem
        for key in ("mass", "damping", "stiffness", "normals"):
            np.testing.assert_array_equal(getattr(scene.problem, key), getattr(catalogue, key))

    def test_saved_and_loaded_are_the_same_scene(self):
        for scene in (linear_scene(subharmonic=3)[0], Scene.load("rotor-12-facets"), Scene.load("grazing@0.1"),
                      Scene.load("matrices-seal-rotor"), Scene.load("sdof-damped-stop")):
            again = Scene.load(scene.save(self.folder / "saved"))
            for key in ("mass", "damping", "stiffness", "normals", "gap"):
                np.testing.assert_array_equal(getattr(again.problem, key), getattr(scene.problem, key))
            self.assertEqual((again.problem.law, again.problem.period), (scene.problem.law, scene.problem.period))
            self.assertEqual(len(again.problem.loads), len(scene.problem.loads))
            for kept, load in zip(again.problem.loads, scene.problem.loads):
                self.assertEqual((kept.dof, kept.harmonic, kept.omega_power), (load.dof, load.harmonic, load.omega_power))
                np.testing.assert_allclose((kept.cos, kept.sin), (load.cos, load.sin), rtol=1e-15)

    def test_that_cannot_be_used_are_refused(self):
        eye = np.eye(2)
        for M, D, K, line in ((eye, eye, np.eye(3), "M 2 x 2, K 3 x 3, D 2 x 2"), (np.zeros((0, 0)),) * 3 + ("0 x 0",),
                              (eye, {"beta": 1.0, "gamma": 1.0}, eye, "must be a matrix"), (eye, {}, eye, "must be a matrix"),
                              ([1.0], eye, eye, "1 dimensions")):
            with self.assertRaisesRegex(ValueError, line):
                Scene.from_matrices(M, D, K, frequency=1.0)
        for change, line in (({"frequency": -1.0}, r"frequency = -1.* \(must be"),
                             ({"load": {2: 1.0}}, r"forcing.term\[0\].dof = 2"),
                             ({"contacts": {0: 1.0}}, "law"), ({"load": {0: np.nan}}, "nan")):
            with self.assertRaisesRegex(BadInput, line):
                Scene.from_matrices(eye, eye, eye, **{"frequency": 1.0, **change})
        with self.assertRaisesRegex(BadInput, "symmetric"):
            Scene.from_matrices(eye, eye, [[1.0, 0.5], [0.0, 1.0]], frequency=1.0)
        with self.assertRaisesRegex(ValueError, "'stiff'.*must be a number"):
            Scene.from_matrices(eye, eye, eye, frequency=1.0, contacts={0: 0.1}, law={"penalty": "stiff"})

    def test_without_load_or_contact_are_an_empty_case(self):
        scene = Scene.from_matrices([[1.0]], [[0.1]], [[1.0]], frequency=2.0)
        solution = scene.solve(instants=4)
        self.assertEqual((solution.x.shape, solution.amplitude.shape, solution.impacts), ((0, 4), (0,), ()))
        self.assertEqual(scene.sweep(1.0, 2.0, 3).branches[0].amplitude.shape, (3, 0))


class Names(unittest.TestCase):
    def test_that_are_none_are_refused(self):
        for name, line in (("no-such-scene", "no-such-scene"), ("./none.toml", "none.toml"), ("hat-lcp", "it is a method")):
            with self.assertRaisesRegex(BadInput, line) as caught:
                Scene.load(name)
            self.assertEqual(caught.exception.code, 2)

    def test_of_methods_and_options_that_are_none_are_refused(self):
        scene = Scene.load("sdof-stop")
        with self.assertRaisesRegex(BadInput, "method = exactorbit"):
            scene.solve("exactorbit")
        with self.assertRaisesRegex(BadInput, "sample = 64 .unknown option"):
            scene.solve("exact-orbit", sample=64)
        with self.assertRaisesRegex(BadInput, "samples"):
            scene.solve(instants=0)

    def test_show_what_the_program_says(self):
        self.assertRegex(Scene.load("sdof-stop").show(), r"^sdof-stop: One mass[\s\S]*law +rigid stops, e = 1$")


class Orbits(unittest.TestCase):
    def test_are_those_of_the_closed_form(self):
        parts, scene = oscillator()
        (orbit,) = scene.orbits(starts=1, subharmonics=1)
        (impact,) = orbit.impacts
        time, speed = min(parts.impacts(), key=lambda one: abs(one[0] - impact.time))
        self.assertAlmostEqual(impact.impulse, -2 * speed, delta=1e-9)
        self.assertTrue(orbit.stable)
        self.assertEqual((orbit.order, orbit.from_rest), (1, True))
        self.assertAlmostEqual(orbit.amplitude, scene.solve().amplitude[0], delta=1e-3)
        self.assertRegex(repr(orbit), r"order 1, 1 impacts, amplitude 0\.4375\d* m, stable")
        self.assertEqual(orbit.stability, "stable")

    def test_may_be_none(self):
        self.assertEqual(Scene.load("sdof-stop").orbits(starts=0, timeout=1e-9), [])


class Sweeps(unittest.TestCase):
    def test_without_contact_are_the_receptance(self):
        M, D = np.eye(3), 0.05 * CHAIN
        scene = Scene.from_matrices(M, D, CHAIN, frequency=1.0, load={0: 1.0}, contacts={2: 1000.0}, law={"restitution": 1.0})
        sweep = scene.sweep(0.2, 2.0, 7, "fourier-lipschitz", stability=False, harmonics=3)
        (branch,) = sweep.branches
        np.testing.assert_allclose(branch.frequency, np.linspace(0.2, 2.0, 7), rtol=1e-14)
        expected = [abs(support.receptance(M, D, CHAIN, w)[2, 0]) for w in branch.frequency]
        np.testing.assert_allclose(branch.amplitude[:, 0], expected, rtol=1e-3)  # largest of the instants
        self.assertTrue(sweep.converged)
        self.assertFalse(branch.stable.any() or branch.unstable.any())

    def test_lose_stability_at_the_period_doubling_and_go_back(self):
        # Of this oscillator at 2.264702 rad/s; it grazes at 2.448265 (docs of the closed form: tests/reference).
        sweep = Scene.load("sdof-stop").sweep(2.2, 2.3, 11, back=True)
        there, back = sweep.branches
        np.testing.assert_array_equal(there.unstable, there.frequency > 2.2647)
        np.testing.assert_array_equal(there.stable, there.frequency < 2.2647)
        np.testing.assert_allclose(back.frequency, there.frequency[::-1][:len(back.frequency)], rtol=1e-14)

    def test_keep_points_without_an_answer(self):
        sweep = Scene.load("sdof-stop").sweep(2.2, 2.4, 3, "fourier-lipschitz", plain=True, stability=False)
        (branch,) = sweep.branches
        self.assertFalse(sweep.converged)
        np.testing.assert_array_equal(np.isnan(branch.amplitude).any(axis=1), ~branch.converged)

    def test_in_hertz_are_those_in_radians(self):
        scene = Scene.load("sdof-stop")
        np.testing.assert_array_equal(scene.sweep(0.5, 0.6, 3, stability=False, hz=True).branches[0].frequency,
                                      scene.sweep(np.pi, 1.2 * np.pi, 3, stability=False).branches[0].frequency)

    def test_of_no_frequencies_are_refused(self):
        with self.assertRaisesRegex(BadInput, "must differ"):
            Scene.load("sdof-stop").sweep(2.0, 2.0)


class Branches(unittest.TestCase):
    """Of the oscillator; fold and period doubling from its closed form, tests/methods/orbit/continuation/diagram_test.cpp."""

    @classmethod
    def setUpClass(cls):
        cls.response = Scene.load("sdof-stop").branches(1.7, 4.2)

    def located(self, kind):
        return {round(special.frequency, 9) for branch in self.response.branches for special in branch.special
                if special.kind == kind}

    def test_have_folds_and_doublings_where_the_closed_form_has_them(self):
        self.assertIn(3.855375321, self.located("fold"))
        self.assertTrue({2.264701940, 2.912583579} <= self.located("period-doubling"))
        (special,) = [special for branch in self.response.branches for special in branch.special
                      if abs(special.frequency - 3.855375321) < 1e-9]
        self.assertAlmostEqual(min(abs(special.multipliers - 1)), 0.0, delta=1e-9)

    def test_graze_where_the_receptance_reaches_the_gap(self):
        low, high = 2.0, 3.0  # |1 / (1 - w^2 + 0.1 i w)| falls through 0.2 between them
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if abs(1 / (1 - middle**2 + 0.1j * middle)) > 0.2 else (low, middle)
        self.assertIn(round(low, 9), self.located("grazing"))

    def test_have_the_amplitudes_of_the_closed_forms(self):
        free, hitting = self.response.branches[:2]
        np.testing.assert_allclose(free.amplitude[:, 0], abs(1 / (1 - free.frequency**2 + 0.1j * free.frequency)), rtol=1e-9)
        self.assertTrue(free.stable.all() and hitting.unstable.any() and hitting.stable.any())
        np.testing.assert_allclose(hitting.x_max, 0.2, rtol=1e-9)
        for i in range(3, len(hitting.frequency), 12):
            parts = support.Oscillator(frequency=hitting.frequency[i])
            t = parts.period * np.arange(20001) / 20000
            ranges = [0.2 - x.min() for time, speed in parts.impacts() if speed > 0
                      for x in [parts.motion(time, t)] if x.max() < 0.2 + 1e-9]
            self.assertLess(min(abs(2 * hitting.amplitude[i, 0] - r) for r in ranges), 1e-6)

    def test_are_those_of_springs_too(self):
        response = Scene.load("sdof-penalty-soft").branches(0.9, 1.1)
        self.assertTrue(any((branch.x_max > 1.0).any() for branch in response.branches))  # the gap

    def test_are_refused_beyond_some_hundred_coordinates(self):
        with self.assertRaisesRegex(BadInput, "must be followed with --natural here: 2160 coordinates"):
            Scene.load("block-nine-contacts").branches(0.1, 0.12)


class Backbones(unittest.TestCase):
    def test_begin_at_the_linear_mode_and_end_at_the_whole_load(self):
        free, pressing = Scene.load("sdof-penalty-soft").backbone().branches
        self.assertEqual(free.second[0], 0.01)
        np.testing.assert_allclose(free.frequency, 1.0, rtol=1e-11)
        np.testing.assert_allclose(free.damping_ratio, 0.05, rtol=1e-11)
        self.assertAlmostEqual(pressing.second[-1], 1.0, 12)
        self.assertTrue((np.diff(pressing.frequency) > 0.0).all())  # a stop stiffens

    def test_that_are_none_say_why(self):
        response = Scene.load("sdof-two-harmonics").backbone(0.9, 1.1)
        self.assertEqual(response.branches, ())
        self.assertIn("the load has more than one harmonic", response.notes[0])


class Versions(unittest.TestCase):
    def test_are_those_of_the_project(self):
        import re
        cmake = re.search(r"project\(signorini VERSION ([\d.]+)", (support.ROOT / "CMakeLists.txt").read_text())[1]
        self.assertEqual(signorini.__version__, cmake)  # from which pyproject.toml takes it


if __name__ == "__main__":
    unittest.main()
