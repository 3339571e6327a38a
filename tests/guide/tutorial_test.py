"""docs/tutorial.md, word by word: a reader who has the two matrices and types what stands there sees what stands there; and the
scene of the README with its commands.

usage: tutorial_test.py SIGNORINI [--update], which writes what the commands print into the page
"""

import csv
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "tutorial.md"
PICTURE = ROOT / "docs" / "pictures" / "tutorial-response.svg"
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.M | re.S)
TIME = re.compile(r"\d+(\.\d+)?(e[-+]\d+)? (us|ms|s)\b")


def comparable(text):
    """Without what differs from run to run: times, and blanks that line them up."""
    return [re.sub(r"[ -]+", " ", TIME.sub("TIME", line)).rstrip() for line in text.strip("\n").splitlines()]


def words_of(svg):
    """The texts of a picture: axes, numbers and names of what is drawn."""
    return re.findall(r"<tspan[^>]*>([^<]*)</tspan>", svg)


def follow(page, folder, program):
    """What each command of the page prints, in its order, as (place of the block that shows it, text)."""
    (folder / "bin").mkdir()
    (folder / "bin" / "signorini").symlink_to(program)
    work = folder / "work"
    work.mkdir()
    for matrix in ("M.mtx", "K.mtx"):
        shutil.copy(ROOT / "examples" / "cantilever" / matrix, work)
    environment = {**os.environ, "PATH": f"{folder / 'bin'}:{os.environ['PATH']}"}
    printed = ""
    for block in BLOCK.finditer(page):
        kind, text = block.groups()
        if kind == "toml":
            (work / "beam.toml").write_text(text)
        elif kind == "sh":
            for command in text.splitlines():
                print(f"$ {command}", flush=True)
                done = subprocess.run(["sh", "-c", command], cwd=work, env=environment, capture_output=True, text=True, check=False)
                if done.returncode != 0:
                    sys.exit(f"failed with {done.returncode}: {command}\n{done.stdout}{done.stderr}")
                printed = done.stdout
        elif kind == "text":
            yield block, printed


def follow_readme(folder, program):
    """The scene of the README, and the commands below it."""
    section = (ROOT / "README.md").read_text(encoding="utf-8").partition("## A scene of your own")[2]
    scene, commands = re.search(r"^```toml\n(.*?)^```\n\n```\n(.*?)^```$", section, re.M | re.S).groups()
    work = folder / "readme"
    work.mkdir()
    (work / "my-scene.toml").write_text(scene)
    for command in commands.splitlines():
        print(f"$ {command}", flush=True)
        subprocess.run([program, *shlex.split(command, comments=True)[1:]], cwd=work, stdout=subprocess.DEVNULL, check=True)
    return (work / "response.pdf").read_bytes().startswith(b"%PDF")


def main():
    program, update = Path(sys.argv[1]).resolve(), "--update" in sys.argv
    draws = ["gnuplot", "-e", "set terminal svg; set terminal pdfcairo"]
    if shutil.which("gnuplot") is None or subprocess.run(draws, capture_output=True, check=False).returncode != 0:
        print("skipped: no gnuplot with svg and pdfcairo is installed")
        sys.exit(77)
    page = PAGE.read_text(encoding="utf-8")
    commands = [line for kind, text in BLOCK.findall(page) if kind == "sh" for line in text.splitlines()]
    wrong, written, end = [], "", 0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for block, printed in follow(page, folder, program):
            written += page[end:block.start(2)] + printed.rstrip("\n") + "\n"
            end = block.end(2)
            shown, seen = comparable(block[2]), comparable(printed)
            if shown != seen:
                wrong.append("\n".join(["the page shows", *shown, "and the command prints", *seen]))
        work = folder / "work"
        if not (work / "response.pdf").read_bytes().startswith(b"%PDF"):
            wrong.append("response.pdf is none")
        # Three motions at 90 rad/s, of which one is unstable: the text says so, and the figure shows it.
        sweep = [*shlex.split(next(command for command in commands if " sweep " in command))[1:-1], "response.svg", "--format", "csv"]
        answer = subprocess.run([program, *sweep], cwd=work, capture_output=True, text=True, check=True)
        points = list(csv.DictReader(answer.stdout.splitlines()))
        unstable = [float(point["omega [rad/s]"]) for point in points if point["stability"] == "unstable"]
        if not min(unstable) < 90.0 < max(unstable):
            wrong.append(f"unstable from {min(unstable)} to {max(unstable)}")
        drawn = (work / "response.svg").read_text()
        if update:
            PICTURE.write_text(drawn)
        elif words_of(drawn) != words_of(PICTURE.read_text()):
            wrong.append(f"{PICTURE.name} is not what sweep draws")
        if not (work / "compared" / "table.md").is_file():
            wrong.append("the run has left no tables")
        if not follow_readme(folder, program):
            wrong.append("the scene of the README leaves no response.pdf")
    if sum(line.startswith("signorini ") for line in commands) != 5:
        wrong.append("the page promises five commands")
    if update:
        PAGE.write_text(written + page[end:], encoding="utf-8")
    elif wrong:
        sys.exit("\n\n".join([*wrong, f"{sys.argv[0]} {program} --update brings the page up to date"]))
    print("the tutorial holds")


if __name__ == "__main__":
    main()
