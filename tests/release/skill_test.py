"""docs/skill/SKILL.md, followed: skill_test.py TREE PROGRAM. Its scenes are read, its commands run, and the keys it names are there."""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

TREE, PROGRAM = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
PAGE = (TREE / "docs/skill/SKILL.md").read_text()


def value(record, path):
    for key in path.split("."):
        record = record[int(key) if isinstance(record, list) else key]
    return record


def main(folder):
    for scene in re.findall(r"^```toml\n(.*?)^```$", PAGE, re.M | re.S):
        (folder / re.match(r"# (\S+)\n", scene)[1]).write_text(scene)
    commands = re.findall(r"^signorini .*", "".join(re.findall(r"^```sh\n(.*?)^```$", PAGE, re.M | re.S)), re.M)
    assert len(commands) >= 5, commands
    for command in commands:
        done = subprocess.run(["sh", "-c", command], cwd=folder, env={"PATH": f"{PROGRAM.parent}:/usr/bin:/bin"}, capture_output=True, text=True,
                              check=False)
        assert done.returncode == 0, f"{command}\n{done.stdout}{done.stderr}"
    records = {path.stem: json.loads(path.read_text()) for path in folder.glob("*.json")}
    for row in re.findall(r"^\| (`.*?) \|", PAGE[PAGE.index("Keys of `solve --json`"):PAGE.index("- **Stability**")], re.M):
        for path in re.findall(r"`([^`]*)`", row):
            assert value(records["solution"], path) is not None, path
    assert records["solution"]["status"] == "converged" and records["solution"]["certificate"]["status"] == "certified"
    assert {"stability", "from_rest"} <= set(records["orbits"][0])
    assert records["motion"]["verdict"] in PAGE
    assert {"omega", "amplitude", "stable"} <= set(records["response"]["branches"][0]["points"][0])
    known = "".join(subprocess.run([PROGRAM, command, "--help"], capture_output=True, text=True, check=True).stdout
                    for command in ("show", "solve", "orbits", "motion", "sweep", "run", "reduce"))
    unknown = set(re.findall(r"(?<![\w-])--[a-z]+", PAGE)) - set(re.findall(r"--[a-z-]+", known))
    assert not unknown, unknown


with tempfile.TemporaryDirectory(prefix="signorini-test-") as scratch:
    main(pathlib.Path(scratch))
