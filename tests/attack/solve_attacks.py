"""Scenes of strangers, solved by every method under small limits and judged."""

import collections
import json
import shutil

from attacked_program import Campaign, NOT_A_NUMBER
from file_attacks import TREE, small
from generators import damaged, hand_made_scenes, random_scene

METHODS = ["hat-lcp[samples=256]", "fourier-lipschitz[harmonics=20]", "penalty-hbm[harmonics=20]",
           "aft-hbm[harmonics=20]", "augmented-lagrangian[harmonics=20]", "closed-hbm[harmonics=20]", "event-driven[flow=modal]",
           "exact-orbit[samples=64]"]
# A case may end badly only where it says so; these would be ends that nobody asked for.
FAULTS = ("crashed", "exception", "invalid-output", "out-of-memory")
SUITE = """schema = 1
name = "attack"
title = "Small limits"
scenes = ["*"]
[limits]
timeout = {timeout}
memory = 1024
repetitions = 1
certificate_timeout = {timeout}
reference_timeout = 0.5
"""


def write_suite(folder, program, timeout=2.0):
    (folder / "suite.toml").write_text(SUITE.format(timeout=timeout * program.slower))


def read_records(folder):
    """The records of a run, each line as strict JSON."""
    def refuse(word):
        raise ValueError(word)

    file = folder / "records.jsonl"
    return [json.loads(line, parse_constant=refuse) for line in file.read_bytes().splitlines()] if file.exists() else []


def nulls(value, path=""):
    """Where a record holds null: a number that was none when it was written."""
    if value is None:
        yield path
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, item in items:
        yield from nulls(item, f"{path}/{key}")


def outcome_of(record):
    """The word of a record in tables of outcomes."""
    if record["status"] != "converged":
        return record["status"]
    return "certified" if record["certificate"]["status"] == "certified" else "unproven"


class Judged:
    """Runs of all methods on scenes, and how they ended."""

    def __init__(self, program, folder, campaign):
        self.program, self.folder, self.campaign = program, folder, campaign
        self.outcomes = collections.defaultdict(collections.Counter)
        write_suite(folder, program)

    def run(self, text):
        """One scene, all methods. Returns the records."""
        (self.folder / "scene.toml").write_bytes(text)
        run = self.folder / "run"
        shutil.rmtree(run, ignore_errors=True)
        arguments = ["run", "./suite.toml", "--scenes", "./scene.toml", "--methods", ":".join(METHODS), "--out", "run"]
        outcome = self.campaign.count(self.program.run(arguments, self.folder, 120.0))
        found = self.program.violations(outcome, (0, 1, 2), 1200.0, text)
        records = []
        if outcome.code in (0, 1):
            records = read_records(run)
            found += [fault for record in records for fault in self.faults_of(record)]
            if len(records) != len(METHODS):
                found.append(f"{len(records)} records of {len(METHODS)} cases")
            if NOT_A_NUMBER.search((run / "table.md").read_bytes()):
                found.append("a table holds no number")
        self.campaign.judge(found, "run ./suite.toml --scenes ./scene.toml", [self.folder / "scene.toml"])
        return outcome, records

    def faults_of(self, record):
        self.outcomes[record["method"]][outcome_of(record)] += 1
        if record["status"] in FAULTS:
            yield f"{record['method']}: {record['status']}: {record['message'][:200]}"
        yield from (f"{record['method']}: {path} is null" for path in nulls(record))
        if NOT_A_NUMBER.search(record.get("message", "").encode()):
            yield f"{record['method']}: {record['message'][:200]}"
        if record["status"] == "converged" and "period" not in record:
            yield f"{record['method']}: converged without a period"

    def note_outcomes(self):
        """The table of outcomes, one row per method."""
        words = sorted({word for counter in self.outcomes.values() for word in counter})
        rows = [["method", *words]] + [[method, *(str(counter[word]) for word in words)]
                                       for method, counter in sorted(self.outcomes.items())]
        self.campaign.notes.append((f"Outcomes: {self.campaign.what}", rows))


def random_scenes(program, random, count, folder, findings):
    """Scenes at random, and damaged ones of the catalogue that the reader takes; each by every method."""
    campaign = Campaign("random and damaged scenes, solved by every method", findings)
    judged = Judged(program, folder, campaign)
    texts = small(path for path in TREE.glob("problems/catalogue/sdof-*.toml"))
    for number in range(count):
        text = random_scene(random, number)
        if number % 3 == 0:  # of the damaged ones most are refused at once: look for one that is not
            for _ in range(20):
                text = damaged(random.choice(texts), texts, random)
                (folder / "scene.toml").write_bytes(text)
                if program.run(["show", "./scene.toml"], folder).code == 0:
                    break
        judged.run(text)
    judged.note_outcomes()
    yield campaign


def hand_made(program, random, count, folder, findings):
    """The edges of mechanics, by hand."""
    campaign = Campaign("hand-made scenes, solved by every method", findings)
    judged = Judged(program, folder, campaign)
    rows = [["scene", *(method.split("[")[0] for method in METHODS)]]
    scenes = hand_made_scenes()
    for name in list(scenes)[:count]:
        outcome, records = judged.run(scenes[name].encode())
        by_method = {record["method"]: outcome_of(record) for record in records}
        said = outcome.err.decode(errors="replace").strip().split("./scene.toml:")[-1][:150]
        row = [by_method.get(method, "") for method in rows[0][1:]] if by_method else [f"refused: {said}"]
        rows.append([name, *row])
    campaign.notes.append(("Hand-made scenes", rows))
    yield campaign
