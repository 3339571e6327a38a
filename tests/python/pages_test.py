"""docs/python.md and the notebooks, word by word: code is run in its order, printed text must be that of the page."""

import contextlib
import io
import json
import os
import re
import shutil
import subprocess
import sys
import unittest
from unittest import mock

import support

from signorini import find_program

TIME = re.compile(r"\d+(\.\d+)?(e[-+]\d+)? (us|ms|s)\b")
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.M | re.S)
NOTEBOOKS = sorted((support.ROOT / "python" / "notebooks").glob("*.ipynb"))
PAGE = support.ROOT / "docs" / "python.md"
ALL = support.installed("matplotlib.pyplot") and support.installed("pandas")


def comparable(text):
    """Lines without what differs from run to run: times, and blanks that line them up."""
    return [re.sub(r" +", " ", TIME.sub("TIME", line)).rstrip() for line in text.strip("\n").splitlines()]


def blocks_of(page):
    return BLOCK.findall(page.read_text(encoding="utf-8").partition("## A first solve")[2])


class Pages(support.TemporaryFolder):
    def setUp(self):
        super().setUp()
        (self.folder / "bin").mkdir()
        (self.folder / "bin" / "signorini").symlink_to(find_program())
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)
        path = os.pathsep.join([str(self.folder / "bin"), os.environ["PATH"]])
        python = os.pathsep.join([str(support.ROOT / "python"), os.environ.get("PYTHONPATH", "")])
        for patch in (mock.patch.dict(os.environ, {"PATH": path, "PYTHONPATH": python}),
                      mock.patch.object(sys, "path", ["", *sys.path])):
            patch.start()
            self.addCleanup(patch.stop)

    def run_code(self, text, scope):
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile(text, "page", "exec"), scope)
        return printed.getvalue().replace(str(self.folder.resolve()) + "/", "").rstrip("\n")

    @unittest.skipUnless(ALL, "matplotlib and pandas are not both installed")
    def test_on_python_hold(self):
        scope, printed, kinds = {"__name__": "page"}, "", []
        for kind, text in blocks_of(PAGE):
            kinds.append(kind)
            name = re.match(r"# (\w+\.py)\n", text)
            if kind == "text":
                self.assertEqual(comparable(printed), comparable(text))
            elif kind == "sh":
                for line in text.splitlines():
                    done = subprocess.run(["sh", "-c", line], capture_output=True, text=True, check=False)
                    self.assertEqual(done.returncode, 0, f"{line}\n{done.stdout}{done.stderr}")
                    printed = done.stdout
            elif kind == "python" and name:
                self.write(name[1], text)
            elif kind == "python":
                printed = self.run_code(text, scope)
        self.assertEqual({"python", "text", "sh", "octave"}, set(kinds))
        for figure in ("sdof-stop.pdf", "response.pdf"):
            self.assertTrue((self.folder / figure).read_bytes().startswith(b"%PDF"))
        records = [json.loads(line) for line in (self.folder / "beside" / "records.jsonl").read_text().splitlines()]
        exact = [record for record in records if record["method"] == "one-impact" and record["scene"] == "sdof-stop"]
        self.assertTrue(exact and all(record["certificate"]["status"] == "certified" for record in exact))

    @unittest.skipUnless(shutil.which("octave-cli"), "octave is not installed")
    def test_on_octave_hold(self):
        command = re.search(r"`(signorini solve [^`]*)`", PAGE.read_text())[1]
        subprocess.run(["sh", "-c", command], check=True)
        (script,) = [text for kind, text in blocks_of(PAGE) if kind == "octave"]
        self.assertLessEqual(len(script.splitlines()), 5)
        self.write("look.m", "figure(\"visible\", \"off\");\n" + script)
        done = subprocess.run(["octave-cli", "--no-gui", "--quiet", "look.m"], capture_output=True, text=True, check=False)
        if "unable to load appropriate font" in done.stderr:
            self.skipTest("octave finds no font (fonts-freefont-otf)")
        self.assertEqual((done.returncode, done.stdout), (0, "converged, period 2.855993 s, 1 impact\n"), done.stderr)

    def test_notebooks_are_two(self):
        self.assertEqual([path.name for path in NOTEBOOKS], ["first-look.ipynb", "response-curve.ipynb"])

    @unittest.skipUnless(ALL, "matplotlib and pandas are not both installed")
    def test_notebooks_run(self):
        import matplotlib.pyplot as plt
        self.addCleanup(plt.close, "all")
        for path in NOTEBOOKS:
            scope = {"__name__": "__main__"}
            printed = [self.run_code("".join(cell["source"]), scope)
                       for cell in json.loads(path.read_text(encoding="utf-8"))["cells"] if cell["cell_type"] == "code"]
            self.assertGreater(sum(map(bool, printed)), 2, path.name)
            self.assertGreater(len(plt.get_fignums()), 1)
            plt.close("all")


if __name__ == "__main__":
    unittest.main()
