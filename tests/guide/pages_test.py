"""README, tutorial, gallery and troubleshooting, word by word: a reader who saves the scenes and types the commands sees what stands there.

Of a page, blocks of TOML are saved under the name of their scene, blocks of `sh` are run line by line ("# exit code 6" where it is not 0), and a block of
`text` shows what the last command prints; a picture that a command draws and the page shows has the same words.

usage: pages_test.py SIGNORINI [--update], which writes what the commands print and draw into the pages
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
PAGES = ("README.md", "docs/tutorial.md", "docs/gallery.md", "docs/troubleshooting.md")
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.M | re.S)
TIME = re.compile(r"\d+(\.\d+)?(e[-+]\d+)? (us|ms|s)\b")


def comparable(text):
    """Without what differs from run to run: times, and blanks that line them up."""
    return [re.sub(r"[ -]+", " ", TIME.sub("TIME", line)).rstrip() for line in text.strip("\n").splitlines()]


def words_of(svg):
    """The texts of a picture: axes, numbers and names of what is drawn."""
    return re.findall(r"<(?:tspan|text)[^>]*>([^<]+)</(?:tspan|text)>", svg)


def run(command, work, environment):
    print(f"$ {command}", flush=True)
    done = subprocess.run(["sh", "-c", command], cwd=work, env=environment, capture_output=True, text=True, check=False)
    expected = int((re.search(r"# exit code (\d+)", command) or ["", "0"])[1])
    if done.returncode != expected:
        sys.exit(f"exit code {done.returncode}, {expected} is expected: {command}\n{done.stdout}{done.stderr}")
    return done.stdout


def follow(text, work, environment):
    """What each command of a page prints, in its order, as (block that shows it, output)."""
    printed = ""
    for block in BLOCK.finditer(text):
        kind, body = block.groups()
        if kind == "toml":
            (work / f"{re.search(r'^name = .(.+).$', body, re.M)[1]}.toml").write_text(body)
        elif kind == "sh":
            for command in body.splitlines():
                printed = run(command, work, environment)
        elif kind == "text":
            yield block, printed


def pictures(page, text, work):
    """Pictures that the page shows and its commands have drawn, as (picture of the page, drawn)."""
    for target in re.findall(r"!\[[^\]]*\]\(([^)]*\.svg)\)", text):
        if (work / Path(target).name).is_file():
            yield (ROOT / page).parent / target, work / Path(target).name


def check(page, folder, environment, update):
    """The offences of a page; brings it up to date if that is asked for."""
    text = (ROOT / page).read_text(encoding="utf-8")
    work = folder / Path(page).stem
    work.mkdir()
    for matrix in ("M.mtx", "K.mtx"):
        shutil.copy(ROOT / "examples" / "cantilever" / matrix, work)
    wrong, written, end = [], "", 0
    for block, printed in follow(text, work, environment):
        shown, seen = comparable(block[2]), comparable(printed)
        written += text[end:block.start(2)] + (block[2] if shown == seen else printed.rstrip("\n") + "\n")
        end = block.end(2)
        if shown != seen:
            wrong.append("\n".join([f"{page} shows", *shown, "and the command prints", *seen]))
    if update:
        (ROOT / page).write_text(written + text[end:], encoding="utf-8")
    for picture, drawn in pictures(page, text, work):
        if update:
            picture.parent.mkdir(exist_ok=True)
            shutil.copyfile(drawn, picture)
        elif not picture.is_file() or words_of(drawn.read_text()) != words_of(picture.read_text()):
            wrong.append(f"{picture.name} is not what the command draws")
    for file in re.findall(r"--plot (\S+\.pdf)", text):
        if not (work / file).read_bytes().startswith(b"%PDF"):
            wrong.append(f"{page}: {file} is none")
    return wrong + (tutorial_offences(text, work, environment, update) if page == "docs/tutorial.md" else [])


def tutorial_offences(text, work, environment, update):
    """Three motions at 90 rad/s, of which one is unstable: the text says so, and the figure shows it."""
    commands = [line for kind, body in BLOCK.findall(text) if kind == "sh" for line in body.splitlines()]
    sweep = shlex.split(next(command for command in commands if " sweep " in command))[:-1]
    points = list(csv.DictReader(run(shlex.join([*sweep, "tutorial-response.svg", "--format", "csv"]), work, environment).splitlines()))
    unstable = [float(point["omega [rad/s]"]) for point in points if point["stability"] == "unstable"]
    drawn, picture = work / "tutorial-response.svg", ROOT / "docs" / "pictures" / "tutorial-response.svg"
    if update:
        shutil.copyfile(drawn, picture)
    offences = {
        f"unstable from {min(unstable)} to {max(unstable)}": not min(unstable) < 90.0 < max(unstable),
        f"{picture.name} is not what sweep draws": words_of(drawn.read_text()) != words_of(picture.read_text()),
        "the run has left no tables": not (work / "compared" / "table.md").is_file(),
        "the tutorial promises five commands": sum(line.startswith("signorini ") for line in commands) != 5,
    }
    return [offence for offence, holds in offences.items() if holds]


def main():
    program, update = Path(sys.argv[1]).resolve(), "--update" in sys.argv
    draws = ["gnuplot", "-e", "set terminal svg; set terminal pdfcairo"]
    if shutil.which("gnuplot") is None or subprocess.run(draws, capture_output=True, check=False).returncode != 0:
        print("skipped: no gnuplot with svg and pdfcairo is installed")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "bin").mkdir()
        (folder / "bin" / "signorini").symlink_to(program)
        environment = {**os.environ, "PATH": f"{folder / 'bin'}:{os.environ['PATH']}"}
        wrong = [offence for page in PAGES for offence in check(page, folder, environment, update)]
    if wrong and not update:
        sys.exit("\n\n".join([*wrong, f"{sys.argv[0]} {program} --update brings the pages up to date"]))
    print("the pages hold")


if __name__ == "__main__":
    main()
