"""Matrices of other programs, on small files made by hand."""

import contextlib
import io
import types
import unittest
from unittest import mock

import support
import numpy as np

from signorini import BadInput, Scene
from signorini.matrices import main, read_calculix, read_nastran

STIFFNESS = [[2.0, -1.0], [-1.0, 2.0]]
needs_scipy = unittest.skipUnless(support.installed("scipy.sparse"), "scipy is not installed")


class CalculiX(support.TemporaryFolder):
    def setUp(self):
        super().setUp()
        self.write("bracket.dof", "7.1\n12.3\n")
        self.write("bracket.sti", "1 1  2.0000000000000E+00\n1 2 -1.0000000000000E+00\n2 2  2.0D+00\n")
        self.write("bracket.mas", "1 1 1.0\n2 2 1.0\n")

    @needs_scipy
    def test_has_both_triangles_and_the_nodes(self):
        for name in ("bracket", "bracket.sti", "bracket.inp"):
            structure = read_calculix(self.folder / name)
            self.assertEqual(structure.coordinate(12, 3), 1)
            np.testing.assert_array_equal(structure.stiffness.toarray(), STIFFNESS)
            np.testing.assert_array_equal(structure.mass.toarray(), np.eye(2))

    @needs_scipy
    def test_full_files_are_not_mirrored(self):
        self.write("bracket.sti", "1 1 2.0\n1 2 -1.0\n2 1 -1.0\n2 2 2.0\n")
        np.testing.assert_array_equal(read_calculix(self.folder / "bracket").stiffness.toarray(), STIFFNESS)

    @needs_scipy
    def test_command_writes_files_that_a_scene_names(self):
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            self.assertEqual(main(["calculix", str(self.folder / "bracket.sti"), "--out", str(self.folder / "model")]), 0)
        self.assertEqual((self.folder / "model" / "coordinates.csv").read_text(), "coordinate,node,degree\n0,7,1\n1,12,3\n")
        rest = '[forcing]\nfrequency_hz = 0.2\n[[forcing.term]]\ndof = 0\ncos = 1.0\n'
        scene = Scene.load(self.write("scene.toml", 'schema = 1\nname = "bracket"\n' + printed.getvalue() + rest))
        np.testing.assert_array_equal(scene.problem.stiffness, STIFFNESS)
        self.assertAlmostEqual(scene.problem.frequency, 0.4 * np.pi, delta=1e-15)

    def test_refuses_what_is_no_such_file_in_one_line(self):
        for name, text, complaint in (("bracket.dof", "7.1\n12\n", "bracket.dof:2: line = '12' (must be node.degree)"),
                                      ("bracket.sti", "1 3 1.0\n", "bracket.sti:1: entry = '1 3 1.0' (must be row and column in 1..2, and a number)"),
                                      ("bracket.mas", "1 1 nan\n", "bracket.mas:1: entry = '1 1 nan' (must be row and column in 1..2, and a number)")):
            before = (self.folder / name).read_text()
            self.write(name, text)
            with self.assertRaises(BadInput) as refused:
                read_calculix(self.folder / "bracket")
            self.assertEqual(str(refused.exception), f"{self.folder}/{complaint}")
            self.write(name, before)
        (self.folder / "bracket.mas").unlink()
        errors = io.StringIO()
        with contextlib.redirect_stderr(errors):
            self.assertEqual(main(["calculix", str(self.folder / "bracket")]), 2)
        self.assertIn("bracket.mas: file = No such file", errors.getvalue())


class Nastran(unittest.TestCase):
    def test_takes_the_named_matrices_of_the_library(self):
        class OP4:  # stands for pyNastran
            def __init__(self, log, debug):
                pass

            def read_op4(self, file):
                return {"KAA": (6, np.array(STIFFNESS)), "MAA": types.SimpleNamespace(data=np.eye(2))}

        with mock.patch("signorini.matrices.library", lambda module, purpose: types.SimpleNamespace(OP4=OP4)):
            structure = read_nastran("plate.op4")
            with self.assertRaisesRegex(BadInput, r"matrix = KGG \(must be one of KAA, MAA\)"):
                read_nastran("plate.op4", stiffness="KGG")
        self.assertEqual((structure.size, structure.coordinates), (2, ()))
        rows, columns, values = structure.entries["stiffness"]
        self.assertEqual(values[(rows == 0) & (columns == 1)], [-1.0])


class Complex(unittest.TestCase):
    @needs_scipy
    def test_stiffness_is_refused_with_the_cure(self):
        with self.assertRaisesRegex(ValueError, "structural damping"):
            Scene.from_matrices([[1.0]], [[0.1]], [[1.0 + 0.02j]], frequency=1.0)
        scene = Scene.from_matrices([[1.0]], [[0.1]], np.array([[2.0 + 0.0j]]), frequency_hz=0.1)
        self.assertEqual(scene.problem.stiffness, [[2.0]])


if __name__ == "__main__":
    unittest.main()
