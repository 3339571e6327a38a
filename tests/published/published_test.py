"""Published contact cases, against the program and against formulas of the tests' own; docs/published.md is made of values.toml.

Each value is read off a run of the program, and must agree with `ours` to a unit of its last digit and with `independent` on as many digits. A published number that differs by more than
its stated tolerance, or than half a unit of its last digit, has a note that says why; where the note names the publisher's method, that method gives the published number.

usage: published_test.py SIGNORINI [--update], which writes `ours` and the tables of the page
"""

import csv
import json
import math
import re
import shlex
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

import modes
import oracles
import rods
from flow import Flow, Stop

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
VALUES, PAGE = HERE / "values.toml", ROOT / "docs" / "published.md"
DONE = (0, 1, 6)  # done; an undecided motion; an interval of which other parts have no branch
SOLVED_BY_MARCH = {  # what carries a sample of the program to the next event
    "touching": lambda: oracles.one_mass(100.0, 0.0, 1e4, [], [Stop([1.0], 0.0, 1e6)]),
    "stiff": lambda: oracles.one_mass(156.0, 0.0, 2e6, [(0, 10.0 * math.pi, 0.0, 3e3)], [Stop([1.0], 1e-3, 1e10)]),
}


def state_of(word):
    """The numbers of a state, or of the one that a function of modes.py gives."""
    return " ".join(map(repr, getattr(modes, word[1:])())) if word.startswith("@") else word


class Program:
    """Answers of the program, each asked for once."""

    def __init__(self, path, folder):
        self.path, self.folder, self.answers = path, folder, {}

    def answer(self, value):
        """What it prints as JSON, and the samples that it writes, of the command of a value."""
        key = value["scene"], value["command"], value.get("state")
        if key not in self.answers:
            scene = value["scene"]
            waveform = self.folder / f"{len(self.answers)}.csv"
            (self.folder / "state").write_text(state_of(value.get("state", "")) + "\n")
            places = {"SCENE": str(ROOT / scene) if "/" in scene else scene, "STATE": str(self.folder / "state"), "WAVEFORM": str(waveform)}
            words = [places.get(word, word) for word in shlex.split(value["command"])]
            done = subprocess.run([self.path, *words], capture_output=True, text=True, check=False)
            if done.returncode not in DONE:
                raise AssertionError(f"exit code {done.returncode}: {done.stderr.strip()}")
            samples = list(csv.reader(waveform.open())) if waveform.is_file() else []
            self.answers[key] = json.loads(done.stdout), samples
        return self.answers[key]


def columns(samples):
    """Name without its unit -> numbers."""
    return {name.split(" ")[0]: [float(row[i]) for row in samples[1:]] for i, name in enumerate(samples[0])}


def sample(samples, time, name):
    told = columns(samples)
    nearest = min(range(len(told["t"])), key=lambda i: abs(told["t"][i] - time))
    if abs(told["t"][nearest] - time) > 1e-9 * max(time, 1e-3):
        raise AssertionError(f"no sample at {time} s")
    return told[name][nearest]


def event(samples, time, system):
    """Instant of the event that follows a sample, which an own march finds."""
    flow = Flow(SOLVED_BY_MARCH[system](), [sample(samples, time, "x0")], [sample(samples, time, "velocity0")], time)
    flow.advance(time + 0.01)
    return flow.events[0].t


def root_mean_square(samples, begin, end, names):
    """By the rule of rectangles over samples that are equally far apart."""
    told = columns(samples)
    inside = [i for i, t in enumerate(told["t"]) if begin <= t <= end]
    return math.sqrt(math.fsum(told[name][i]**2 for name in names for i in inside) / len(inside))


def span(point):
    """Largest distance from rest: the largest x, or the least one."""
    most, extent = point["x_max"][0], 2.0 * point["amplitude"][0]
    return max(abs(most), abs(most - extent))


def branch_point(answer, which, quantity, place=None):
    """Of the points with contact at the place that is asked for, the one of the largest amplitude, the second, or the smallest."""
    points = [point for branch in answer["branches"] for point in branch["points"] if point["impacts"] > 0]
    if place is not None:
        points = [point for point in points if abs(point["omega"] - place) < 1e-9 * place]
    if which.endswith("of order 1"):
        points = [point for point in points if point["order"] == 1]
    points.sort(key=lambda point: -point["amplitude"][0])
    point = points[{"largest": 0, "second": 1, "smallest": -1}[which.split(" ")[0]]]
    return {"span": lambda: span(point), "amplitude": lambda: point["amplitude"][0], "energy": lambda: point["energy"]}[quantity]()


def mode(answer, energy):
    """Frequency [Hz] of the point of that energy."""
    points = [point for branch in answer["branches"] for point in branch["points"]]
    return min(points, key=lambda point: abs(point["energy"] - energy))["omega"] / (2.0 * math.pi)


def read(program, value):
    answer, samples = program.answer(value)
    kind, *words = value["read"]
    if kind == "sample":
        return words[2] * sample(samples, words[0], words[1])
    if kind == "event":
        return event(samples, *words)
    if kind == "rms":
        return root_mean_square(samples, *words)
    if kind == "measure":
        return modes.root_mean_square_of_harmonics(columns(samples)[words[0]], 21)
    if kind == "statistic":
        told = answer["contacts"][words[0]][words[1]]
        return told["value"] if isinstance(told, dict) else told
    if kind == "mode":
        return mode(answer, words[0])
    if kind == "branch":
        return branch_point(answer, *words)
    if kind == "bounce":
        return next(-orbit["events"][0]["value"] for orbit in answer if orbit["impacts"] == 1)
    if answer["certificate"]["status"] != "certified":
        raise AssertionError(f"certificate {answer['certificate']['status']}")
    return answer["motion"]["x"][0]["amplitude"] if kind == "orbit" else abs(answer["motion"]["impacts"][0][words[0]])


def call(function):
    name, *arguments = function
    own = next(getattr(module, name) for module in (oracles, modes, rods) if hasattr(module, name))
    return own(*(tuple(a) if isinstance(a, list) else a for a in arguments))


def unit(text):
    """Of the last digit of a printed number."""
    digits, _, exponent = text.lower().partition("e")
    return 10.0**(int(exponent or 0) - len(digits.partition(".")[2]))


def error(published, ours):
    return abs(float(published) - float(ours)) / abs(float(ours))


def allowed(published, tolerance, ours):
    return max(tolerance, 0.5 * unit(published) / abs(float(ours)))


def offences(program, value):
    """What is wrong about a value; `ours` is brought up to date in it."""
    told = read(program, value)
    digits = f"{told:#.{value['digits']}g}".rstrip(".")
    last = unit(digits)
    if not value["ours"] or abs(told - float(value["ours"])) > last:
        yield f"the program says {digits}, and `ours` is {value['ours']}"
        value["ours"] = digits
    if "independent" in value and abs(call(value["independent"]) - told) > last:
        yield f"the program says {told!r}, and {value['independent']} says {call(value['independent'])!r}"
    for published, tolerance, _ in value["published"]:
        if error(published, told) > allowed(published, tolerance, told) and "note" not in value:
            yield f"{published} is {error(published, told):.1e} off, and nothing says why"
    if "reproduced" in value:
        name, arguments, tolerance = value["reproduced"]
        own, published = call([name, *arguments]), value["published"][0][0]
        if abs(own - float(published)) > max(tolerance * abs(own), unit(published)):
            yield f"{name} gives {own!r}, not the published {published}"


def inherited(values):
    """Values with what they share with the one before them in their case."""
    before = {}
    for value in values:
        if value["case"] == before.get("case"):
            value = {**{key: before[key] for key in ("scene", "source", "file", "command", "state") if key in before}, **value}
        before = value
        yield value


def forgotten(values):
    """Scenes of problems/published that no value is of."""
    used = {value["scene"].partition("@")[0] for value in values}
    for path in sorted((ROOT / "problems" / "published").rglob("*.toml")):
        if path.relative_to(ROOT).as_posix() not in used:
            yield f"{path.relative_to(ROOT)}: no value of values.toml is of this scene"


def scene_link(scene):
    path, _, level = scene.partition("@")
    if "/" in path:
        return f"[{Path(path).stem}{'@' + level if level else ''}](../{path})"
    folder = "families" if level else "catalogue"
    return f"[{scene}](../problems/{folder}/{path}.toml)"


def rows_of(values, notes):
    """The table: a row for each published number, or for the value where there is none."""
    numbers = list(notes)
    yield "| case | scene | quantity | ours | published | off by | stated | why |"
    yield "|---|---|---|---|---|---|---|---|"
    shown = None
    for value in values:
        head = (f"{value['case']} [{value['source']}], {value['file']}", scene_link(value["scene"])) if value["case"] != shown else ("", "")
        shown = value["case"]
        for i, (published, tolerance, which) in enumerate(value["published"] or [["", 0, ""]]):
            off = error(published, value["ours"]) if published else 0.0
            why = published and "note" in value and off > 0.5 * unit(published) / abs(float(value["ours"]))
            yield "| " + " | ".join([*(head if i == 0 else ("", "")), value["what"] if i == 0 else "", value["ours"] if i == 0 else "",
                                     f"{published} {f'({which})' if which else ''}".strip() or "none printed", (f"{off:.2g}" if off > 1e-12 else "< 1e-12") if published else "-",
                                     f"{tolerance:g}" if tolerance else "-", f"({numbers.index(value['note']) + 1})" if why else ""]) + " |"


def tables(values, notes):
    counted = len({value["case"] for value in values})
    printed = len({value["case"] for value in values if value["published"]})
    yield f"{counted} cases, {len(values)} quantities; of {printed} cases a number is published."
    yield ""
    yield from rows_of(values, notes)
    yield ""
    for i, (name, text) in enumerate(notes.items()):
        again = {value["case"]: value["reproduced"] for value in values if value.get("note") == name and "reproduced" in value}
        yield f"{i + 1}. {text}." + (f" (Repeated by `{next(iter(again.values()))[0]}` in the test.)" if again else "")


def page_with(page, lines):
    begin, end = "<!-- published values -->\n", "<!-- /published values -->"
    head, _, rest = page.partition(begin)
    return head + begin + "\n" + "\n".join(lines) + "\n\n" + end + rest.partition(end)[2]


def main():
    update = "--update" in sys.argv
    text, page = VALUES.read_text(encoding="utf-8"), PAGE.read_text(encoding="utf-8")
    data = tomllib.loads(text)
    values = list(inherited(data["value"]))
    wrong = list(forgotten(values))
    with tempfile.TemporaryDirectory() as folder:
        program = Program(Path(sys.argv[1]).resolve(), Path(folder))
        for value in values:
            try:
                wrong += [f"{value['case']}, {value['what']}: {offence}" for offence in offences(program, value)]
            except (AssertionError, ArithmeticError, LookupError) as failure:
                wrong.append(f"{value['case']}, {value['what']}: {failure!r}")
    if update:
        ours = iter(value["ours"] for value in values)
        VALUES.write_text(re.sub(r'^ours = ".*"$', lambda _: f'ours = "{next(ours)}"', text, flags=re.M), encoding="utf-8")
        PAGE.write_text(page_with(page, tables(values, data["notes"])), encoding="utf-8")
    elif page != page_with(page, tables(values, data["notes"])):
        wrong.append(f"docs/published.md is not of these values; {sys.argv[0]} {sys.argv[1]} --update brings it up to date")
    print(*wrong, sep="\n")
    print(f"{len(values)} values of {len({value['case'] for value in values})} cases")
    return int(bool(wrong) and not update)


if __name__ == "__main__":
    sys.exit(main())
