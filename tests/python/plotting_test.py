"""What figures show, where matplotlib is installed; and what is said where it is not."""

import sys
import unittest
from unittest import mock

import support
import numpy as np

import signorini
from signorini import MissingLibrary, Scene
from signorini.response import Branch, Response

WITHOUT = {"matplotlib": None, "matplotlib.pyplot": None, "pandas": None, "scipy": None, "scipy.sparse": None}


def sweep_of(stability):
    points = [{"frequency": float(i), "way": "up", "status": "converged", "amplitude": [10.0 * i], "x_max": [0.0]}
              for i in range(len(stability))]
    for point, stable in zip(points, stability):
        if stable is not None:
            point["stable"] = stable
    return Response.from_steps(None, "exact-orbit", points)


@unittest.skipUnless(support.installed("matplotlib.pyplot"), "matplotlib is not installed")
class Figures(support.TemporaryFolder):
    @classmethod
    def setUpClass(cls):
        cls.solution = Scene.load("sdof-stop-e08").solve()

    def tearDown(self):
        import matplotlib.pyplot as plt
        plt.close("all")

    def test_of_a_solution_show_the_stop_and_its_impacts(self):
        figure = self.solution.plot()
        wave, portrait = figure.axes
        lines = wave.get_lines()
        self.assertEqual(list(lines[1].get_ydata()), [0.2, 0.2])
        np.testing.assert_array_equal(lines[2].get_xdata(), [event.time for event in self.solution.impacts])
        np.testing.assert_array_equal(lines[2].get_ydata(), [0.2])
        np.testing.assert_array_equal(lines[0].get_ydata()[:-1], self.solution.x[0])
        self.assertEqual(lines[0].get_xdata()[-1], self.solution.period)
        self.assertGreater(wave.get_ylim()[1], 0.2)
        np.testing.assert_array_equal(portrait.get_lines()[0].get_ydata()[:-1], self.solution.velocity[0])
        self.assertEqual(list(portrait.get_lines()[1].get_xdata()), [0.2, 0.2])
        figure.savefig(self.folder / "figure.pdf")
        self.assertGreater((self.folder / "figure.pdf").stat().st_size, 1000)

    def test_show_a_stop_that_is_far_away(self):
        wave = Scene.load("sdof-far-stop").solve().plot().axes[0]
        gap = Scene.load("sdof-far-stop").problem.gap[0]
        self.assertGreater(wave.get_ylim()[1], gap)
        self.assertEqual(len(wave.get_lines()[2].get_xdata()), 0)

    def test_of_a_contact_that_is_none_are_refused(self):
        for contact in (1, -1):
            with self.assertRaisesRegex(ValueError, f"contact = {contact} .must be below 1"):
                self.solution.plot(contact)
        with self.assertRaisesRegex(ValueError, "must be below 0"):
            Scene.load("sdof-contact-free").solve().plot()
        with self.assertRaisesRegex(ValueError, "must be below 1"):
            sweep_of([True]).plot(1)

    def test_of_a_sweep_dash_what_is_unstable(self):
        axes = sweep_of([True, True, False, False, True, None]).plot(color="C2")
        solid, dashed = axes.get_lines()
        self.assertEqual((solid.get_linestyle(), dashed.get_linestyle()), ("-", "--"))
        np.testing.assert_array_equal(solid.get_ydata(), [0, 10, 20, np.nan, 40, 50])
        np.testing.assert_array_equal(dashed.get_ydata(), [np.nan, np.nan, 20, 30, 40, np.nan])
        self.assertEqual({line.get_color() for line in axes.get_lines()}, {"C2"})
        self.assertEqual([text.get_text() for text in axes.get_legend().get_texts()], ["exact-orbit"])

    def test_of_a_sweep_name_the_law_of_a_method_where_the_scene_has_another(self):
        steps = [{"frequency": w, "way": "up", "status": "converged", "x_max": [1.0], "amplitude": [1.0], "other_law": "e = 1"} for w in (1.0, 2.0)]
        axes = Response.from_steps(None, "hat-lcp", steps).plot()
        self.assertEqual([text.get_text() for text in axes.get_legend().get_texts()], ["hat-lcp, e = 1"])

    def test_of_branches_mark_folds_beside_the_points_around_them(self):
        points = [{"omega": w, "amplitude": [a], "x_max": [a], "stable": a < 2.5} for w, a in ((1.0, 1.0), (2.0, 2.0), (1.8, 3.0))]
        fold = {"kind": "fold", "omega": 2.1, "after": 2, "multipliers": [[1.0, 0.0]]}
        graze = {"kind": "grazing", "omega": 1.25, "after": 1, "multipliers": []}
        branch = {"points": points, "special": [graze, fold], "began": "here", "ended": "there"}
        response = Response.from_branches(None, "exact-orbit", {"branches": [branch], "notes": ["one"], "unfinished": "time"})
        marks = {line.get_label(): (list(line.get_xdata()), list(line.get_ydata())) for line in response.plot().get_lines()[2:]}
        self.assertEqual(marks, {"fold": ([2.1], [2.0]), "grazing": ([1.25], [1.25])})
        self.assertEqual((response.branches[0].ended, response.notes), ("there", ["one", "time"]))

    def test_of_several_sweeps_may_share_axes(self):
        axes = sweep_of([True, True]).plot()
        self.assertIs(sweep_of([False, False]).plot(axes=axes), axes)
        self.assertEqual([line.get_linestyle() for line in axes.get_lines()], ["-", "--"])

    @unittest.skipUnless(support.installed("pandas"), "pandas is not installed")
    def test_sweeps_are_frames_too(self):
        frame = sweep_of([True, None]).to_frame()
        self.assertEqual((list(frame["amplitude.0"]), frame["stable"][0]), ([0.0, 10.0], True))


class Empty(unittest.TestCase):
    def test_branches_have_no_points(self):
        branch = Branch.of([])
        self.assertEqual((branch.frequency.shape, branch.amplitude.shape), ((0,), (0, 0)))


class Missing(unittest.TestCase):
    def test_libraries_are_named_with_their_package(self):
        with mock.patch.dict(sys.modules, WITHOUT):
            with self.assertRaisesRegex(MissingLibrary, "plot: needs matplotlib .Debian: apt install python3-matplotlib"):
                sweep_of([True]).plot()
            with self.assertRaisesRegex(MissingLibrary, "Response.to_frame: needs pandas"):
                sweep_of([True]).to_frame()
            with self.assertRaisesRegex(MissingLibrary, "signorini.frame: needs pandas"):
                signorini.frame([])
            with self.assertRaisesRegex(MissingLibrary, "sparse matrices: needs scipy"):
                Scene.load("sdof-stop").problem.sparse("mass")
            with self.assertRaisesRegex(MissingLibrary, "matplotlib"):
                Scene.load("sdof-stop").solve(instants=4).plot()


if __name__ == "__main__":
    unittest.main()
