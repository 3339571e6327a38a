"""The defects that the first attacks found, each brought about as it was then: the numbers are those of the list in
results/attack.md, and none of them happens any more."""

import json
import os
import pathlib
import shutil
import sys

from attacked_program import CONTROL, Campaign
from file_attacks import MATRICES_SCENE, TREE
from generators import hand_made_scenes, one_mass
from method_attacks import DESCRIPTION, HERE, LARGEST_TABLE, LONGEST_MESSAGE
from solve_attacks import nulls, read_records, write_suite

MOST_SAMPLES = "65536"  # that a solve prints


class Attacked:
    """What a reproduction needs: the program, a folder of its own, and the calls that it judges."""

    def __init__(self, program, folder, campaign):
        self.program, self.folder, self.campaign = program, folder, campaign
        self.plugin = pathlib.Path(program.path).parents[1] / "tests/attack/ill_behaved_plugin.so"
        folder.mkdir()

    def scene(self, text, name="scene.toml"):
        (self.folder / name).write_bytes(text if isinstance(text, bytes) else text.encode())

    def call(self, *arguments, codes=(0, 2), seconds=10.0, memory_mb=2048.0, before=()):
        """The outcome of a call, and what it broke."""
        outcome = self.campaign.count(self.program.run(arguments, self.folder, seconds, before))
        given = " ".join(arguments).encode("utf-8", "surrogateescape")
        found = self.program.violations(outcome, codes, memory_mb, given)
        return outcome, [f"{' '.join(arguments)[:80]}: {text}" for text in found]

    def solved(self, method, *more, seconds=60.0):
        """The record of one solve of scene.toml, and what the call broke."""
        outcome, found = self.call("solve", "./scene.toml", "--method", method, *more, "--certificate", "5", "--reference",
                                   "2", "--json", codes=(0, 1), seconds=seconds)
        record = json.loads(outcome.out) if outcome.out else {}
        return record, found + [f"{path} is null" for path in nulls(record)]

    def ill_behaved(self, deed, command=False):
        """The record of a method that does that, in a run of its own, and what the run broke."""
        write_suite(self.folder, self.program, timeout=1.5)
        plugin = str(self.plugin)
        if command:
            shutil.copy(HERE / "ill_behaved_command.py", self.folder)
            self.scene(DESCRIPTION.format(python=sys.executable), "method.toml")
            plugin = "./method.toml"
        elif not self.plugin.exists():
            return {}, ["ill_behaved_plugin.so is not built"]
        _, found = self.call("run", "./suite.toml", "--scenes", "sdof-stop", "--methods", f"ill-behaved[deed={deed}]",
                             "--plugin", plugin, "--out", "run", codes=(0, 1), seconds=30.0)
        records = read_records(self.folder / "run")
        if len(records) != 1:
            return {}, [*found, f"{len(records)} records"]
        if (self.folder / "run/table.md").stat().st_size > LARGEST_TABLE:
            found.append("table.md is large")
        return records[0], found

    def not_claimed(self, deed, command=False):
        record, found = self.ill_behaved(deed, command)
        return found + ([f"{deed} is converged"] if record.get("status") == "converged" else [])


def claims(record):
    return record.get("status") == "converged" and record["certificate"]["status"] == "certified"


def converges(record):
    """Restitution is 1 whatever the scene says: there is an answer, and no claim on the scene."""
    return record.get("status") == "converged"


def origin_far_away(attacked):
    """A motion that stands still before a stop 1000 m away."""
    standing = one_mass(gaps=(1000.2,), law="restitution = 0.8", force="dof = 0\nharmonic = 0\ncos = 1000.0\n"
                        "[[forcing.term]]\ndof = 0\ncos = 1.0\n")
    attacked.scene(standing)
    attacked.scene(DESCRIPTION.format(python=sys.executable), "method.toml")
    shutil.copy(HERE / "ill_behaved_command.py", attacked.folder)
    record, found = attacked.solved("ill-behaved", "--set", "deed=stand-before-the-stop", "--plugin", "./method.toml")
    found += ["a motion that stands still is converged"] if record.get("status") == "converged" else []
    for method in ("hat-lcp", "exact-orbit"):
        far, broken = attacked.solved(method)
        attacked.scene(one_mass(law="restitution = 0.8"))
        near, more = attacked.solved(method)
        attacked.scene(standing)
        found += broken + more + ([f"{method} claims one of two"] if claims(far) != claims(near) else [])
    return found


def text_for_gnuplot(attacked):
    """Records whose texts are programs, or lead to another folder."""
    lines = [json.loads(line) for line in (TREE / "results/catalogue/records.jsonl").read_text().splitlines()[:40]]
    attempts = [("scene", "a'.system('touch PWN').'"), ("scene", "../../ESC"), ("scene", "`touch PWN`"),
                ("word", "x'.system('touch${IFS}PWN').'"), ("word", '"; touch PWN; "'), ("word", "@PWN")]
    found = []
    for number, (member, text) in enumerate(attempts):
        run = attacked.folder / f"run-{number}"
        run.mkdir()
        shutil.copy(TREE / "results/catalogue/manifest.json", run)
        changed = [dict(line, scene=text) if member == "scene" else dict(line, options=dict(line["options"], word=text))
                   for line in lines]
        (run / "records.jsonl").write_text("".join(json.dumps(line) + "\n" for line in changed))
        for form in ("html", "tex"):
            found += attacked.call("report", run.name, "--format", form, codes=(0, 2, 3), seconds=60.0)[1]
    found += [f"{path} was written" for path in attacked.folder.parent.rglob("*") if "PWN" in path.name or "ESC" in path.name]
    return found


def message_of_megabytes(attacked):
    record, found = attacked.ill_behaved("long-message")
    return found + (["its message is long"] if len(record.get("message", "").encode()) > LONGEST_MESSAGE else [])


def deep_keys(attacked):
    found = []
    for text in ("a." * 20000 + "a = 1", "[" + "a." * 20000 + "a]"):
        attacked.scene("schema = 1\n" + text)
        for command in (["show", "./scene.toml"], ["run", "./scene.toml", "--dry-run"], ["list", "--plugin", "./scene.toml"]):
            found += attacked.call(*command, codes=(2,))[1]
    return found


def check_that_dies(attacked):
    return attacked.not_claimed("period-1e9", command=True) + attacked.not_claimed("zero-the-problem")


def magnitudes(attacked):
    """The same oscillator in other units: refused, or the same answer."""
    attacked.scene(one_mass())
    unit, found = attacked.solved("exact-orbit")
    for power in (-200, -150, -58, 58, 150, 200):
        attacked.scene(one_mass(force=f"dof = 0\ncos = 1e{power}\n", gaps=(f"2e{power - 1}",)))
        outcome, broken = attacked.call("solve", "./scene.toml", "--method", "exact-orbit", "--json", codes=(0, 1, 2),
                                        seconds=60.0)
        found += broken
        if outcome.code == 2:
            continue
        record = json.loads(outcome.out)
        same = record["status"] == "converged" and record.get("contact_ratio") == unit.get("contact_ratio") and \
            len(record.get("orbit", {}).get("events", [])) == len(unit.get("orbit", {}).get("events", []))
        found += [] if same else [f"another motion in units of 1e{power}: {record['status']}"]
    for frequency in ("1e75", "1e-75"):
        attacked.scene(one_mass(frequency=frequency))
        found += attacked.call("solve", "./scene.toml", "--method", "event-driven", codes=(1, 2), seconds=60.0)[1]
    return found


def energy_of_lasting_contact(attacked):
    """Contact for ever, and for nearly all of the period: an error of rounding is no defect of energy."""
    found = []
    nearly = one_mass(gaps=(0.0,), law="restitution = 0.0", force="dof = 0\nharmonic = 0\ncos = 1.0\n[[forcing.term]]\n"
                      "dof = 0\ncos = 1.05\n", frequency=1.0)
    for text in (one_mass(gaps=(-50.0,), law="restitution = 0.5"), nearly):
        attacked.scene(text)
        for method in ("hat-lcp", "exact-orbit", "event-driven"):
            record, broken = attacked.solved(method)
            found += broken
            defect = record.get("energy_defect")
            if claims(record) and defect is not None and defect > 1e-3:
                found.append(f"{method}: energy defect {defect:.1e} of a certified motion")
    return found


def files_without_end(attacked):
    found = []
    os.mkfifo(attacked.folder / "pipe")
    with open(attacked.folder / "sparse", "wb") as file:
        file.truncate(10 << 30)
    attacked.scene(MATRICES_SCENE, "matrices.toml")
    for target in ("/dev/zero", "/dev/full", "/dev/urandom", "pipe", "sparse"):
        for place, scene in (("endless.toml", "./endless.toml"), ("mass.mtx", "./matrices.toml")):
            (attacked.folder / place).unlink(missing_ok=True)
            (attacked.folder / place).symlink_to(target)
            found += attacked.call("show", scene, codes=(2,), memory_mb=256.0)[1]
    return found


def waiting_for_references(attacked):
    """Solves whose reference used to be looked for during a minute."""
    found = []
    stick = (TREE / "problems/catalogue/sdof-stick.toml").read_text().replace("cos = 1.0", "cos = 2.0")
    soft = (TREE / "problems/catalogue/sdof-penalty-soft.toml").read_text().replace("damping = 0.1", "damping = 1e-7")
    free = one_mass(stiffness=0.0, damping=0.0)
    for text, method in ((stick, "hat-lcp"), (soft, "penalty-hbm"), (free, "fourier-lipschitz")):
        attacked.scene(text)
        found += attacked.call("solve", "./scene.toml", "--method", method, codes=(0, 1, 2), seconds=20.0)[1]
    return found


def duplicated_stops(attacked):
    """The same stop once, twice and twenty times is one stop."""
    found = []
    for method in ("fourier-lipschitz", "penalty-hbm", "aft-hbm", "closed-hbm"):
        solves = claims if method == "closed-hbm" else converges
        errors = []
        for copies in (1, 2, 20):
            attacked.scene(one_mass(gaps=(0.2,) * copies, law="restitution = 0.8"))
            record, broken = attacked.solved(method, "--set", "harmonics=20")
            found += broken + ([] if solves(record) else [f"{method}, {copies} copies: {record.get('status')}"])
            errors.append(record.get("x_l2", 1.0))
        found += [f"{method}: errors {errors}"] if max(errors) > 1.01 * min(errors) else []
    return found


def lines_of_slurm(attacked):
    found = []
    for name in ("nl\nrm -rf x", 'a"b', "%j", "{}"):
        submit = ["submit", "slurm", name, "--shards", "2", "--dry-run", "smoke"]
        outcome, broken = attacked.call(*submit)
        found += broken
        for script in (path for path in attacked.folder.rglob("*.sh") if path.is_file()):
            lines = script.read_text().splitlines()
            found += [f"{script.name} runs rm for {name!r}" for line in lines if line.lstrip().startswith("rm -rf x")]
        found += ["a line of #SBATCH breaks"] if outcome.code == 0 and "\n" in name else []
    found += attacked.call("submit", "slurm", "run", "--shards", "2", "--dry-run", "smoke", "--sbatch", "a\nrm -rf x",
                           codes=(2,))[1]
    return found


def largest_scenes(attacked):
    """What the format allows is shown, or refused by a limit, within 10 s and 2 GB."""
    beam = ('schema = 1\nname = "s"\n[system]\nkind = "beam"\nelements = 20000\ncount = 100\nlength = 1.0\narea = 1.0\n'
            "inertia = 1.0\nyoung = 1.0\ndensity = 1.0\n[forcing]\nfrequency = 1.0\n")
    block = ('schema = 1\nname = "s"\n[system]\nkind = "block"\nelements = [67, 67, 67]\nlengths = [1.0, 1.0, 1.0]\nyoung = 1.0\n'
             'poisson = 0.3\ndensity = 1.0\ndamping = { alpha = 0.1, beta = 0.1 }\n[forcing]\nfrequency = 1.0\n')
    ring = "[[contact]]\ndofs = [0, 1]\nfacets = 1000\ngap = 0.3\n"
    rotor = ('schema = 1\nname = "s"\n[system]\nkind = "rotor"\nmass = 1.0\ndamping = 0.2\nstiffness = 1.0\n[forcing]\n'
             "frequency = 1.5\n" + ring * 100000 + "[law]\npenalty = 50.0\n")
    levels = (TREE / "problems/families/grazing.toml").read_text().splitlines()
    family = "\n".join("levels = [" + ", ".join(f"{1 + i}.0" for i in range(300000)) + "]" if line.startswith("levels")
                       else line for line in levels)
    found = []
    for text in (beam, block, rotor, family):
        attacked.scene(text)
        # On a machine that does nothing else the block of 945 000 coordinates takes 6 s.
        found += attacked.call("show", "./scene.toml", seconds=30.0)[1]
    attacked.scene(one_mass())
    solve = ["solve", "./scene.toml", "--method", "hat-lcp", "--set", "samples=64", "--samples"]
    found += attacked.call(*solve, MOST_SAMPLES, codes=(0,))[1]
    return found + attacked.call(*solve, "4194304", codes=(2,))[1]


def stops_that_exclude_each_other(attacked):
    scenes = hand_made_scenes()
    attacked.scene(scenes["crossed-stops"])
    outcome, found = attacked.call("show", "./scene.toml", codes=(2,))
    attacked.scene(scenes["two-gaps-zero"])
    for method in ("hat-lcp", "fourier-lipschitz", "exact-orbit"):
        found += attacked.call("solve", "./scene.toml", "--method", method, codes=(0, 1, 2), seconds=40.0)[1]
    return found


def no_room(attacked):
    """Files limited to a few kilobytes: said so, and resumed afterwards."""
    write_suite(attacked.folder, attacked.program)
    run = ["run", "./suite.toml", "--scenes", "sdof-stop", "--methods", "hat-lcp[samples=64|96]", "--out", "run"]
    found = []
    for blocks in (1, 6, 12):  # of 512 bytes: no room for the manifest, for the records, for the tables
        limited = ("sh", "-c", f'ulimit -f {blocks}; exec "$@"', "sh")
        outcome, broken = attacked.call(*run, codes=(2,), seconds=60.0, before=limited)
        found += broken + (["the complaint says Success"] if b"Success" in outcome.err else [])
        found += attacked.call(*run, "--resume", codes=(0, 1), seconds=60.0)[1]
        shutil.rmtree(attacked.folder / "run")
    return found


def brackets(attacked):
    found = attacked.call("run", "smoke", "--methods", "hat-lcp[", "--dry-run", codes=(2,))[1]
    text = (TREE / "problems/catalogue/bar200-massless.toml").read_text()
    attacked.scene(text.replace("length = 1.0", "length = 1e300"))
    return found + attacked.call("show", "./scene.toml", codes=(2,))[1]


def raw_bytes(attacked):
    attacked.scene(MATRICES_SCENE)
    (attacked.folder / "mass.mtx").write_bytes(b"%%MatrixMarket matrix \xff\xfe\x1b[31m general\n")
    found = attacked.call("show", "./scene.toml", codes=(2,))[1]
    for name in ("a\x1b[31m.toml", "\udcff.toml", "x" * 5000, "/proc/self/mem"):
        outcome, broken = attacked.call("show", name, codes=(2,))
        found += broken + (["raw bytes"] if CONTROL.search(outcome.err) else [])
    return found


def nonsense_accepted(attacked):
    found = []
    for deed in ("work-unknown", "work-negative", "bandwidth-negative", "bandwidth-huge"):
        record, broken = attacked.ill_behaved(deed, command=True)
        found += broken + ([] if record.get("status") == "invalid-output" else [f"{deed}: {record.get('status')}"])
        shutil.rmtree(attacked.folder / "run")
    attacked.scene(one_mass(law="penalty = 5e-324"))
    return found + attacked.call("show", "./scene.toml", codes=(2,))[1]


def extreme_frequencies(attacked):
    found = []
    for frequency in ("1e300", "1e-300"):
        attacked.scene(one_mass(frequency=frequency))
        found += attacked.call("solve", "./scene.toml", "--method", "aft-hbm", codes=(2,))[1]
    return found


def one_bad_line(attacked):
    """A line in the middle that is no record is left out with a warning; all others are there."""
    run = attacked.folder / "run"
    run.mkdir()
    shutil.copy(TREE / "results/catalogue/manifest.json", run)
    lines = (TREE / "results/catalogue/records.jsonl").read_bytes().splitlines(keepends=True)[:40]
    (run / "records.jsonl").write_bytes(b"".join([*lines[:20], b"{ this is no record\n", *lines[20:]]))
    found = []
    for command in (["status", "run"], ["report", "run", "--format", "csv"]):
        outcome, broken = attacked.call(*command, codes=(0, 1))
        found += broken + ([] if b"left out" in outcome.err else [f"{command[0]} says nothing of the line"])
    return found


def pipe_floods(attacked):
    record, found = attacked.ill_behaved("flood-pipes")
    return found + (["flood-pipes is converged"] if record.get("status") == "converged" else []) + \
        ([f"{record['elapsed']:.1f} s"] if record.get("elapsed", 0.0) > 6.0 * attacked.program.slower else [])


def modes_of_the_processor(attacked):
    """Rounding, flush-to-zero and handlers that a solve leaves changed touch no verdict."""
    found = []
    for deed in ("upward", "flush-to-zero", "handlers"):
        found += attacked.not_claimed(deed)
        shutil.rmtree(attacked.folder / "run")
    return found


REPRODUCTIONS = [
    ("the origin decides what is certified", origin_far_away),
    ("text of records is run by gnuplot", text_for_gnuplot),
    ("a message makes tables of 350 MB", message_of_megabytes),
    ("deep keys overflow the stack", deep_keys),
    ("a check that dies leaves a claim", check_that_dies),
    ("norms underflow and overflow", magnitudes),
    ("an energy defect of round-off", energy_of_lasting_contact),
    ("files without end are read", files_without_end),
    ("a solve waits for its reference", waiting_for_references),
    ("duplicated stops spoil harmonic balance", duplicated_stops),
    ("folder names run in Slurm scripts", lines_of_slurm),
    ("allowed scenes take minutes and gigabytes", largest_scenes),
    ("stops that exclude each other", stops_that_exclude_each_other),
    ("a full disk is called Success", no_room),
    ("unclosed brackets, lengths of 1e300", brackets),
    ("raw bytes on the terminal", raw_bytes),
    ("nonsense of commands is accepted", nonsense_accepted),
    ("frequencies of 1e300", extreme_frequencies),
    ("one bad line blocks a run", one_bad_line),
    ("a flood without line breaks is quadratic", pipe_floods),
    ("rounding that a solve leaves changed", modes_of_the_processor),
]


def reproductions(program, random, count, folder, findings):
    """All of them, or so many at random."""
    campaign = Campaign("the 21 defects of the first attacks, brought about again", findings)
    numbers = sorted(random.sample(range(len(REPRODUCTIONS)), min(count, len(REPRODUCTIONS))))
    rows = [["number", "defect", "now"]]
    for number in numbers:
        what, reproduce = REPRODUCTIONS[number]
        found = reproduce(Attacked(program, folder / str(number + 1), campaign))
        campaign.judge(found, f"{number + 1}: {what}")
        rows.append([number + 1, what, "happens" if found else "does not happen"])
    campaign.notes.append(("Defects of the first attacks", rows))
    yield campaign
