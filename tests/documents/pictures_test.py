#!/usr/bin/env python3
"""The pictures of the README, made anew: what they hold, and that the committed ones are they.

    pictures_test.py TREE PROGRAM"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

TREE, PROGRAM = pathlib.Path(sys.argv[1]), sys.argv[2]
SVG = "{http://www.w3.org/2000/svg}"


def written(script, source):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "picture.svg"
        subprocess.run([sys.executable, TREE / "docs/pictures" / script, source, file], check=True)
        return file.read_text()


def made(script, source):
    return ElementTree.fromstring(written(script, source))


def texts(root):
    return [text.text for text in root.iter(SVG + "text")]


def texts_beside_the_sheet(root):
    """Texts that reach over an edge, by the usual width of their letters."""
    width, height = (float(v) for v in root.get("viewBox").split()[2:])
    beside = []
    for group in root.iter(SVG + "g"):
        move = group.get("transform", "translate(0 0)")[10:-1].split()
        for text in group.findall(SVG + "text"):
            if text.get("x") is None:
                continue
            x, y = float(text.get("x")) + float(move[0]), float(text.get("y")) + float(move[1])
            wide = 7.2 * len(text.text)
            left = x - {"middle": wide / 2, "end": wide}.get(text.get("text-anchor"), 0.0)
            if not (0 <= left and left + wide <= width and 10 <= y <= height):
                beside.append(text.text)
    return beside


class Overview(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.root = made("overview.py", PROGRAM)

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
        self.assertEqual(texts_beside_the_sheet(self.root), [])

    def test_is_the_committed_one(self):
        committed = ElementTree.parse(TREE / "docs/pictures/overview.svg").getroot()
        self.assertEqual(texts(committed), texts(self.root), "python3 docs/pictures/overview.py makes it anew")
        for kind in ("path", "circle"):
            count = [sum(1 for _ in root.iter(SVG + kind)) for root in (committed, self.root)]
            self.assertEqual(*count)


class Responses(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = TREE / "results/responses"
        cls.root = made("responses.py", cls.folder)

    def test_shows_four_scenes_and_what_methods_find_of_them(self):
        words = texts(self.root)
        self.assertEqual(len([t for t in self.root.iter(SVG + "text") if t.get("class") == "heading"]), 4)
        self.assertIn("fourier-lipschitz[harmonics=20]: another law", words)
        kept = [json.loads(line) for line in (self.folder / "records.jsonl").read_text().splitlines()]
        hat = next(r for r in kept if r["case"] == "sdof-stop/hat-lcp[samples=128] by arc length")
        self.assertIn(f"hat-lcp[samples=128]: {100 * hat['response']['comparison']['within_0.02']['covered']:.0f} % found", words)

    def test_dashes_unstable_branches_and_draws_methods_over_the_exact_ones(self):
        exact = [p for p in self.root.iter(SVG + "path") if p.get("class") == "exact"]
        self.assertTrue(any(p.get("stroke-dasharray") for p in exact))
        self.assertTrue(any(not p.get("stroke-dasharray") for p in exact))
        for group in self.root.iter(SVG + "g"):
            kinds = [p.get("class") for p in group.iter(SVG + "path") if p.get("class") != "note"]
            self.assertEqual(kinds, sorted(kinds, key=lambda kind: kind != "exact"))
            self.assertIn("m1", kinds)

    def test_keeps_its_texts_on_the_sheet(self):
        self.assertEqual(texts_beside_the_sheet(self.root), [])

    def test_is_the_committed_one(self):
        committed = (TREE / "docs/pictures/responses.svg").read_text()
        self.assertEqual(committed, written("responses.py", self.folder), "python3 docs/pictures/responses.py makes it anew")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
