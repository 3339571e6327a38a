"""`pip install ./python` as docs/python.md has it, in a virtual environment, with numpy alone and without a network."""

import os
import re
import shutil
import subprocess
import sys
import unittest

import support

from signorini import find_program

NEEDED = ("venv", "ensurepip", "setuptools", "wheel")


class Installing(support.TemporaryFolder):
    @unittest.skipUnless(all(map(support.installed, NEEDED)), f"not all of {', '.join(NEEDED)} are installed")
    def test_works_from_the_tree(self):
        tree = self.folder / "tree"
        shutil.copytree(support.ROOT / "python", tree / "python",
                        ignore=shutil.ignore_patterns("__pycache__", "build", "*.egg-info"))
        page = (support.ROOT / "docs" / "python.md").read_text(encoding="utf-8")
        commands = re.search(r"^```sh\n(.*?)^```$", page, re.M | re.S)[1]
        environment = {key: value for key, value in os.environ.items() if key not in ("PYTHONPATH", "PYTHONHOME")}
        environment |= {"HOME": str(self.folder), "PATH": f"{os.path.dirname(sys.executable)}:{os.environ['PATH']}",
                        "PIP_NO_INDEX": "1", "PIP_NO_BUILD_ISOLATION": "0",  # 0: as with --no-build-isolation
                        "PIP_DISABLE_PIP_VERSION_CHECK": "1", "SIGNORINI_PROGRAM": str(find_program())}
        for line in commands.splitlines():
            done = subprocess.run(["sh", "-c", line], cwd=tree, env=environment, capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, f"{line}\n{done.stdout}{done.stderr}")
        python = self.folder / "signorini-python" / "bin" / "python"
        code = ("import sys\nfor name in ('matplotlib', 'pandas', 'scipy'):\n  sys.modules[name] = None\n"  # as if not installed
                "import signorini\nprint(signorini.__file__)\nprint(signorini.Scene.load('sdof-stop').solve(instants=4).status)\n")
        done = subprocess.run([str(python), "-c", code], cwd=self.folder, env=environment, capture_output=True, text=True,
                              check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        place, status = done.stdout.split()
        self.assertTrue(place.startswith(str(self.folder / "signorini-python")), place)
        self.assertEqual(status, "converged")


if __name__ == "__main__":
    unittest.main()
