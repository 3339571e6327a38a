#!/usr/bin/env python3
"""docs/pictures/overview.py, run anew: what the picture at the head of the README holds, and that the committed one is it.

    overview_test.py TREE PROGRAM"""

import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

TREE, PROGRAM = pathlib.Path(sys.argv[1]), sys.argv[2]
SVG = "{http://www.w3.org/2000/svg}"


def made():
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "overview.svg"
        subprocess.run([sys.executable, TREE / "docs/pictures/overview.py", PROGRAM, file], check=True)
        return ElementTree.parse(file).getroot()


def texts(root):
    return [text.text for text in root.iter(SVG + "text")]


class Overview(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.root = made()

    def test_has_four_panels_with_what_they_are_about(self):
        headings = [t for t in self.root.iter(SVG + "text") if t.get("class") == "heading"]
        self.assertEqual(len(headings), 4)
        words = texts(self.root)
        for word in ("g = 0.2 m", "stop, x = g", "dashed: unstable; dots: fold, grazing", "exact-orbit", "fourier-lipschitz",
                     "hat-lcp", "event-driven"):
            self.assertIn(word, words)

    def test_marks_the_impacts_and_dashes_unstable_parts(self):
        # Of two periods drawn, with one impact each.
        large = [c for c in self.root.iter(SVG + "circle") if c.get("class") == "contact" and c.get("r") == "4"]
        self.assertEqual(len(large), 2)
        self.assertEqual(len({c.get("cy") for c in large}), 1)
        dashed = [p for p in self.root.iter(SVG + "path") if p.get("stroke-dasharray") == "4 3" and p.get("class") in ("c0", "c2")]
        self.assertGreaterEqual(len(dashed), 3)

    def test_keeps_its_texts_on_the_sheet(self):
        width, height = (float(v) for v in self.root.get("viewBox").split()[2:])
        for group in self.root.iter(SVG + "g"):
            move = group.get("transform", "translate(0 0)")[10:-1].split()
            for text in group.findall(SVG + "text"):
                if text.get("x") is None:
                    continue
                x, y = float(text.get("x")) + float(move[0]), float(text.get("y")) + float(move[1])
                wide = 7.2 * len(text.text)
                left = x - {"middle": wide / 2, "end": wide}.get(text.get("text-anchor"), 0.0)
                self.assertTrue(0 <= left and left + wide <= width and 10 <= y <= height, text.text)

    def test_is_the_committed_one(self):
        committed = ElementTree.parse(TREE / "docs/pictures/overview.svg").getroot()
        self.assertEqual(texts(committed), texts(self.root), "python3 docs/pictures/overview.py makes it anew")
        for kind in ("path", "circle"):
            count = [sum(1 for _ in root.iter(SVG + kind)) for root in (committed, self.root)]
            self.assertEqual(*count)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
