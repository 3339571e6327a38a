"""Files that somebody else wrote, through the commands that read them: nothing is solved."""

import os
import pathlib
import shutil
import socket

from attacked_program import Campaign
from generators import NUMBERS, damaged, random_scene

TREE = pathlib.Path(__file__).resolve().parents[2]
CORPUS = TREE / "tests/attack/corpus"
MATRICES_SCENE = b"""schema = 1
name = "matrices"
[system]
kind = "matrices"
mass = "mass.mtx"
stiffness = "stiffness.mtx"
damping = "damping.mtx"
[forcing]
frequency = 2.0
[[contact]]
dof = 0
gap = 0.1
[law]
restitution = 0.5
"""
DESCRIPTION = b"""schema = 1
name = "my-method"
title = "A method"
command = ["/bin/cat", "method.toml"]
ladder = "level=1|2"
[represents]
restitution = "scene"
penalty = true
[[option]]
name = "level"
default = 1
least = 1
most = 3
unit = "[-]"
meaning = "1..3"
[[option]]
name = "word"
default = "a"
choices = ["a", "b"]
meaning = "one of two"
"""


def small(files, most=6000):
    return [text for text in (file.read_bytes() for file in sorted(files)) if len(text) <= most]


def scenes(program, random, count, folder, findings):
    """Scenes damaged and made at random, through show."""
    campaign = Campaign("damaged and random scenes, `show`", findings)
    texts = small([path for glob in ("problems/catalogue/*.toml", "problems/families/*.toml", "tests/attack/corpus/scene/*")
                   for path in TREE.glob(glob)])
    for number in range(count):
        text = random_scene(random, number) if number % 3 == 0 else random.choice(texts)
        if number % 6:
            text = damaged(text, texts, random)
        (folder / "scene.toml").write_bytes(text)
        campaign.attack(program, ["show", "./scene.toml"], folder, [folder / "scene.toml"], given=text)
    yield campaign


def matrices(program, random, count, folder, findings):
    """Matrix Market files damaged, through show of a scene that names them."""
    campaign = Campaign("damaged Matrix Market files, `show`", findings)
    catalogue = TREE / "problems/catalogue"
    shutil.copy(catalogue / "matrices-cantilever.toml", folder / "scene.toml")
    shutil.copytree(catalogue / "matrices-cantilever", folder / "matrices-cantilever")
    files = sorted((folder / "matrices-cantilever").iterdir())
    whole = {file: file.read_bytes() for file in files}
    texts = small([*files, *CORPUS.glob("matrix/*")], 20000)
    for number in range(count):
        file = random.choice(files)
        text = damaged(random.choice(texts) if number % 4 == 0 else whole[file], texts, random)
        file.write_bytes(text)
        campaign.attack(program, ["show", "./scene.toml"], folder, [file], given=text)
        file.write_bytes(whole[file])
    yield campaign


def suites(program, random, count, folder, findings):
    """Suites damaged, through run --dry-run."""
    campaign = Campaign("damaged suites, `run --dry-run`", findings)
    texts = small(TREE.glob("problems/suites/*.toml"))
    for _ in range(count):
        text = damaged(random.choice(texts), texts, random)
        (folder / "suite.toml").write_bytes(text)
        campaign.attack(program, ["run", "./suite.toml", "--dry-run"], folder, [folder / "suite.toml"], codes=(0, 2, 3),
                        given=text)
    yield campaign


def descriptions(program, random, count, folder, findings):
    """Descriptions of commands damaged, through list and show."""
    campaign = Campaign("damaged descriptions of commands, `list`, `show`", findings)
    texts = [DESCRIPTION, *small(TREE.glob("examples/*/*.toml"))]
    for _ in range(count):
        text = damaged(random.choice(texts), texts, random)
        (folder / "method.toml").write_bytes(text)
        arguments = random.choice([["list", "methods"], ["show", "my-method"]])
        arguments += ["--plugin", "./method.toml"]
        campaign.attack(program, arguments, folder, [folder / "method.toml"], given=text)
    yield campaign


def run_folder(folder, random, most=12):
    """A small run: manifest and plan of a committed one, with some of its records."""
    source = random.choice(["catalogue", "hard", "structures", "compensation"])
    run = folder / "run"
    shutil.rmtree(run, ignore_errors=True)
    run.mkdir()
    for name in ("manifest.json", "plan.txt"):
        if (TREE / "results" / source / name).exists():
            shutil.copy(TREE / "results" / source / name, run)
    lines = (TREE / "results" / source / "records.jsonl").read_bytes().splitlines(keepends=True)
    (run / "records.jsonl").write_bytes(b"".join(random.sample(lines, random.randint(1, most))))
    return run


def records(program, random, count, folder, findings):
    """Folders of runs with a damaged file, through every command that reads one."""
    what = "damaged records, manifests and plans, `status`, `report`, `merge`, `compare`, `verify`"
    campaign = Campaign(what, findings)
    commands = [["status", "run"], ["report", "run", "--format", "md"], ["report", "run", "--format", "csv"],
                ["merge", "run", "--out", "merged"], ["compare", "run", "whole"], ["verify", "run", "--cases", "none*"],
                ["report", "run", "--format", "html"]]
    shutil.copytree(run_folder(folder, random), folder / "whole")
    for number in range(count):
        run = run_folder(folder, random)
        name = random.choice(["records.jsonl"] * 4 + ["manifest.json", "plan.txt"])
        if not (run / name).exists():
            name = "records.jsonl"
        text = (run / name).read_bytes()
        text = damaged(text, [text], random)
        (run / name).write_bytes(text)
        shutil.rmtree(folder / "merged", ignore_errors=True)
        # gnuplot draws the figures of html: one in a while.
        command = commands[-1] if number % 40 == 39 else random.choice(commands[:-1])
        campaign.attack(program, command, folder, [run / name], codes=(0, 1, 2, 3, 4), seconds=60.0, given=text)
    yield campaign


def responses(program, random, count, folder, findings):
    """Damaged frequency responses of a run, through report: their figures are drawn by gnuplot."""
    campaign = Campaign("damaged frequency responses, `report`", findings)
    whole = (CORPUS / "responses/two.jsonl").read_bytes()
    run = folder / "run"
    run.mkdir()
    for number in range(count):
        text = damaged(whole, [whole], random)
        (run / "records.jsonl").write_bytes(text)
        drawn = ["--format", "html"] if number % 20 == 19 else []
        campaign.attack(program, ["report", "run", *drawn], folder, [run / "records.jsonl"], codes=(0, 1, 2, 3),
                        seconds=60.0, given=text)
        shutil.rmtree(run / "figures", ignore_errors=True)
    yield campaign


class SpecialFiles:
    """Paths that are no ordinary file, made in a folder."""

    def __init__(self, folder):
        self.folder = folder
        folder.mkdir()
        os.mkfifo(folder / "pipe")
        for name in ("zero", "full", "urandom", "null"):
            (folder / name).symlink_to(f"/dev/{name}")
        (folder / "memory").symlink_to("/proc/self/mem")
        (folder / "kernel").symlink_to("/proc/kmsg")
        (folder / "loop").symlink_to("loop")
        (folder / "nowhere").symlink_to("no-such-file")
        (folder / "folder").mkdir()
        (folder / "empty").touch()
        with open(folder / "sparse", "wb") as file:
            file.truncate(10 << 30)
        (folder / "line").write_bytes(b"a" * (3 << 20))
        (folder / "zeros").write_bytes(b"\0" * 100000)
        (folder / "brackets").write_bytes(b"[" * 1000000)
        (folder / "quotes").write_bytes(b'a = "' + b"\\" * 1000000)
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.bind(os.path.relpath(folder / "socket"))
        self.names = sorted(path.name for path in folder.iterdir())


def special_files(program, random, count, folder, findings):
    """Files that never end, never begin or are none, in the place of every file that is read."""
    campaign = Campaign("pipes, devices, sockets, sparse and endless files as every input", findings)
    special = SpecialFiles(folder / "special")
    (folder / "scene.toml").write_bytes(MATRICES_SCENE)
    (folder / "whole").mkdir()
    shutil.copy(TREE / "results/catalogue/records.jsonl", folder / "whole")
    shutil.copy(TREE / "results/catalogue/manifest.json", folder / "whole")
    kept = ["sweep", "sdof-stop", "--methods", "exact-orbit", "--from", "3", "--to", "3.1", "--out"]
    program.run([*kept, "kept"], folder, 60.0)
    places = {"x.toml": [["show", "./x.toml"], ["solve", "./x.toml", "--method", "hat-lcp"],
                         ["run", "./x.toml", "--dry-run"], ["list", "--plugin", "./x.toml"], ["orbits", "./x.toml"]],
              "x.so": [["list", "--plugin", "./x.so"]],
              "mass.mtx": [["show", "./scene.toml"]],
              "start.json": [["solve", "sdof-stop", "--method", "hat-lcp", "--start", "start.json"]],
              "run/records.jsonl": [["status", "run"], ["report", "run", "--format", "md"], ["compare", "whole", "run"]],
              "run/branches.jsonl": [[*kept, "run", "--resume"], [*kept, "run"]],
              "run/manifest.json": [["report", "run", "--format", "csv"], ["merge", "run", "--out", "merged"],
                                    [*kept, "run", "--resume"]],
              "run/plan.txt": [["status", "run"]],
              "references/sdof-stop.json": [["verify", "references", "--scenes", "sdof-stop"]]}
    cases = [(name, place, command) for name in special.names for place, commands in places.items()
             for command in commands]
    for name, place, command in random.sample(cases, min(count, len(cases))):
        for part in ("run", "references", "merged"):
            shutil.rmtree(folder / part, ignore_errors=True)
        (folder / place).parent.mkdir(exist_ok=True)
        if place == "run/plan.txt" or place == "run/manifest.json":
            shutil.copy(TREE / "tests/attack/corpus/records/several.jsonl", folder / "run/records.jsonl")
        if place == "run/branches.jsonl":
            shutil.copy(folder / "kept/manifest.json", folder / "run")
        (folder / place).unlink(missing_ok=True)
        (folder / place).symlink_to(special.folder / name)
        campaign.attack(program, command, folder, codes=(0, 1, 2, 3, 4), seconds=20.0)
        campaign.violations[-1:] = [f"{text} [{place} is {name}]" if not text.endswith("]") else text
                                    for text in campaign.violations[-1:]]
        (folder / place).unlink()
    special.socket.close()
    yield campaign


def command_lines(program, random, count, folder, findings):
    """Words that are no options, and options with words that are no values."""
    campaign = Campaign("command lines of nonsense, all commands", findings)
    words = [*NUMBERS, "", " ", "-", "--", "*", "**", "[", "a[", "hat-lcp[", "hat-lcp[samples=", "hat-lcp[samples=64", "[=]",
             "{}", "%j", "a\x1b[31m", "\xff\xfe", "a\nb", "'", '"', "`id`", "$(id)", "x" * 5000, "../..", "/", "/dev/null",
             "/dev/full", "sdof-stop", "sdof-*", "grazing@", "grazing@1e-4", "@", "samples=64", "samples=", "=64",
             "samples=1e9", "I/N", "0/0", "1/1", "2/1"]
    options = {"list": ["--json"], "show": [], "solve": ["--method", "--set", "--samples", "--certificate", "--json"],
               "run": ["--methods", "--scenes", "--timeout", "--memory", "--repetitions", "--seed", "--jobs", "--shard",
                       "--beside", "--durations"],
               "status": [], "merge": ["--out"], "compare": [], "submit": ["--shards"], "doctor": ["--json"],
               "report": ["--format", "--into"], "orbits": ["--starts", "--subharmonics", "--seed"],
               "sweep": ["--method", "--from", "--to", "--points", "--format"], "verify": ["--scenes", "--cases"],
               "check": ["--scenes", "--checks"], "new": [], "completion": [], "man": [], "nonsense": []}
    for _ in range(count):
        command = random.choice(list(options))
        arguments = [command]
        for _ in range(random.randint(0, 4)):
            arguments += [random.choice(options[command])] if options[command] and random.random() < 0.5 else []
            arguments += [random.choice(words)]
        if command == "run":
            arguments.append("--dry-run")
        if command == "orbits":
            arguments += ["--timeout", "1"]
        if command in ("check", "sweep", "verify"):
            arguments += ["--timeout", "0.5"]
        # What is asked for may be much: it ends by its limits, and these calls do not wait for that.
        if command in ("check", "verify") and not any(word in arguments for word in ("--scenes",)):
            arguments += ["--scenes", "sdof-far-stop"]
        campaign.attack(program, arguments, folder, codes=(0, 1, 2, 3), seconds=60.0)
        for path in folder.iterdir():
            shutil.rmtree(path, ignore_errors=True) if path.is_dir() and not path.is_symlink() else path.unlink()
    yield campaign
