"""Runs that are killed, that find no room, and whose folders are no folders: nothing that was written is lost."""

import os
import pathlib
import shutil
import signal
import subprocess
import time

from attacked_program import Campaign
from file_attacks import TREE
from generators import damaged
from solve_attacks import read_records, write_suite

SCENES = "sdof-stop:sdof-far-stop"
METHODS = "hat-lcp[samples=64|96|128]:fourier-lipschitz[harmonics=5]:exact-orbit[samples=64]"
# tmpfs of so many kB, then room: sh -c FULL sh FOLDER KILOBYTES OUT PROGRAM ARGUMENTS
FULL = """mount -t tmpfs -o size=$2k none "$1" || exit 98
folder=$1 out=$3; shift 3
"$@"; echo $? >"$out/code"
mount -o remount,size=64m "$folder"
"$@" --resume >/dev/null 2>&1; echo $? >"$out/code-of-resume"
cp -r "$folder/run" "$out"
"""


def arguments_of(folder, jobs=1):
    return ["run", str(folder / "suite.toml"), "--scenes", SCENES, "--methods", METHODS, "--out", str(folder / "run"),
            "--repetitions", "2", "--jobs", str(jobs)]


def answers(records):
    """What two runs of the same cases must agree on."""
    return {record["key"]: (record["case"], record["status"], record.get("answer")) for record in records}


class Resumed:
    """A run that ended early, against one that nobody disturbed."""

    def __init__(self, program, folder):
        self.program, self.folder = program, folder
        write_suite(folder, program, timeout=10.0)
        began = time.monotonic()
        outcome = program.run(arguments_of(folder), folder, 300.0)
        self.seconds = time.monotonic() - began
        if outcome.code not in (0, 1):
            raise RuntimeError(f"the undisturbed run failed: {outcome.err!r}")
        self.whole = answers(read_records(folder / "run"))
        self.clear()

    def clear(self):
        shutil.rmtree(self.folder / "run", ignore_errors=True)

    def differences(self, run=None):
        """What is lost, new, otherwise or twice."""
        records = read_records(run or self.folder / "run")
        found = answers(records)
        for key in self.whole.keys() | found.keys():
            if self.whole.get(key) != found.get(key):
                yield f"{found.get(key)} where the undisturbed run has {self.whole.get(key)}"
        if len(records) != len(found):
            yield f"{len(records)} lines of {len(found)} cases"
        for name in ("table.md", "table.csv", "measures.csv"):
            if not ((run or self.folder / "run") / name).exists():
                yield f"no {name}"


def kills(program, random, count, folder, findings):
    """Signals at random instants, then --resume: the records of a run that nobody disturbed."""
    campaign = Campaign("runs killed at random instants and resumed, `--jobs` 1 and 2", findings)
    resumed = Resumed(program, folder)
    signals = [signal.SIGKILL, signal.SIGINT, signal.SIGTERM, signal.SIGHUP]
    for number in range(count):
        resumed.clear()
        jobs = 1 + number % 2
        found, told = [], []
        for _ in range(random.randint(1, 4)):
            instant, which = random.uniform(0.0, 0.9 * resumed.seconds), random.choice(signals)
            process = program.start([*arguments_of(folder, jobs), "--resume"], folder)
            time.sleep(instant)
            os.kill(process.pid, which)  # a process that has ended is not waited for yet
            outcome = campaign.count(program.finish(process, 60.0))
            told.append(f"{which.name} after {instant:.3f} s")
            # An interrupt is told and obeyed; the others end it as they end any process; or it was over before.
            asked = (0, 1, 130, -which)
            found += program.violations(outcome, asked)
        outcome = campaign.count(program.run([*arguments_of(folder, jobs), "--resume"], folder, 300.0))
        found += program.violations(outcome, (0, 1)) + list(resumed.differences())
        found += [f"{name} is left" for name in ("unfinished.jsonl",) if (folder / "run" / name).exists()]
        campaign.judge(found, f"--jobs {jobs}, {', '.join(told)}", [folder / "run/records.jsonl"])
    yield campaign


def no_room(program, random, count, folder, findings):
    """Disks and files that are full in the middle: the message names it, and --resume goes on."""
    campaign = Campaign("full disks (tmpfs) and limits of file sizes, then `--resume`", findings)
    resumed = Resumed(program, folder)
    disk, out = folder / "disk", folder / "out"
    may_mount = subprocess.run(["unshare", "--mount", "true"], capture_output=True).returncode == 0
    for number in range(count):
        resumed.clear()
        for path in (disk, out):
            shutil.rmtree(path, ignore_errors=True)
            path.mkdir()
        kilobytes = random.choice([4, 8, 12, 16, 20, 24, 32, 40, 48, 64])
        if may_mount and number % 2:
            found = list(attack_disk(program, folder, disk, out, kilobytes, resumed))
            campaign.judge(found, f"tmpfs of {kilobytes} kB")
        else:
            limit = random.choice([0, 1, 512, 1024, 4096, 8192, 16384, 32768])
            outcome = campaign.count(program.run(arguments_of(folder), folder, 300.0, ["prlimit", f"--fsize={limit}"]))
            # Its own output goes to a file as well.
            found = [text for text in program.violations(outcome, (0, 1, 2)) if "lines of complaint" not in text]
            outcome = program.run([*arguments_of(folder), "--resume"], folder, 300.0)
            found += program.violations(outcome, (0, 1)) + list(resumed.differences())
            campaign.judge(found, f"file-size limit of {limit} bytes")
    if not may_mount:
        campaign.notes.append(("No tmpfs could be mounted: file-size limits alone", []))
    yield campaign


def attack_disk(program, folder, disk, out, kilobytes, resumed):
    """One run on a disk that is full, resumed once there is room."""
    arguments = [word.replace(str(folder / "run"), str(disk / "run")) for word in arguments_of(folder)]
    command = ["unshare", "--mount", "sh", "-c", FULL, "sh", disk, str(kilobytes), out, program.path, *arguments]
    shell = subprocess.run(command, cwd=folder, capture_output=True, env=program.environment, timeout=600)
    if shell.returncode != 0 or not (out / "code").exists():
        yield f"the disk could not be made: {shell.stderr!r}"
        return
    code, code_of_resume = (int((out / name).read_text()) for name in ("code", "code-of-resume"))
    if code not in (0, 1, 2):
        yield f"exit code {code}: {shell.stderr[-300:]!r}"
    if code == 2 and not any(word in shell.stderr for word in (b"No space left", b"room", b"written")):
        yield f"the complaint does not name the disk: {shell.stderr[-300:]!r}"
    if code_of_resume not in (0, 1):
        yield f"exit code {code_of_resume} of --resume"
    yield from resumed.differences(out / "run")


def folders(program, random, count, folder, findings):
    """Folders of results that are none, are not writable, or are written by another run."""
    campaign = Campaign("folders of results that are none, or in use", findings)
    (folder / "file").write_text("a file")
    (folder / "loop").symlink_to("loop")
    (folder / "gone").symlink_to("no-such-folder/below")
    names = ["file", "file/below", "loop", "gone", "/dev/null", "/dev/full/x", "/proc/x", "/proc/self/fd", "x" * 300, "a\nb",
             "a'b\"c", "-", "a b/c", "\xff", "", "~", "$HOME", "%j", "{}"]
    write_suite(folder, program)
    for name in random.sample(names, min(count, len(names))):
        arguments = ["run", "./suite.toml", "--scenes", "sdof-far-stop", "--methods", "hat-lcp[samples=64]",
                     "--repetitions", "1", f"--out={name}"]
        campaign.attack(program, arguments, folder, codes=(0, 2), seconds=60.0)
    resumed = Resumed(program, folder)
    first = program.start([*arguments_of(folder), "--resume"], folder)
    while not (folder / "run/records.jsonl").exists():  # it locks the folder before
        time.sleep(0.005)
    # Held still: a run of a second would be over while the other one still waits for its lock.
    os.killpg(first.pid, signal.SIGSTOP)
    second = program.run([*arguments_of(folder), "--resume"], folder, 60.0)
    os.killpg(first.pid, signal.SIGCONT)
    found = program.violations(second, (2,)) + program.violations(program.finish(first, 300.0), (0, 1))
    found += resumed.differences()
    campaign.judge(found, "two runs with one --out")
    yield campaign


def resumed_damage(program, random, count, folder, findings):
    """Folders of runs whose files are damaged, resumed: every case is there in the end, none from nowhere."""
    campaign = Campaign("damaged records, rounds, plans and manifests, `run --resume`", findings)
    resumed = Resumed(program, folder)
    program.run(arguments_of(folder), folder, 300.0)
    shutil.copytree(folder / "run", folder / "good")
    for _ in range(count):
        resumed.clear()
        shutil.copytree(folder / "good", folder / "run")
        name = random.choice(["records.jsonl", "records.jsonl", "unfinished.jsonl", "manifest.json", "plan.txt"])
        text = (folder / "good" / name.replace("unfinished", "records")).read_bytes()
        (folder / "run" / name).write_bytes(damaged(text, [text], random))
        if name == "unfinished.jsonl":
            (folder / "run/records.jsonl").unlink()
        outcome = campaign.count(program.run([*arguments_of(folder), "--resume"], folder, 300.0))
        found = program.violations(outcome, (0, 1, 2))
        if outcome.code != 2:  # a manifest that is none cannot be resumed
            here = answers(read_lines_that_are_records(folder / "run/records.jsonl"))
            found += [f"{case} is missing" for key, case in resumed.whole.items() if key not in here]
        campaign.judge(found, f"{name} damaged", [folder / "run" / name])
    yield campaign


def read_lines_that_are_records(file):
    """Damaged lines stay in the file, left out with a warning."""
    for line in pathlib.Path(file).read_bytes().splitlines():
        part = file.parent / "line"
        part.mkdir(exist_ok=True)
        (part / "records.jsonl").write_bytes(line)
        try:
            yield from (record for record in read_records(part) if {"key", "case", "status"} <= set(record))
        except (ValueError, TypeError, UnicodeDecodeError):
            continue


SUITES = ("smoke", "article")  # the latter takes an hour
BUSY_PROCESSES = 6


def verdicts(run):
    """What does not depend on how much else the machine does."""
    return {record["case"]: (record["status"], record["certificate"]["status"]) for record in read_records(run)}


def busy(program, random, count, folder, findings):
    """Suites on a machine as it is, and beside busy processes of the same nice value."""
    campaign = Campaign(f"suites beside {BUSY_PROCESSES} busy processes, at `nice 19`", findings)
    for suite in SUITES[:count]:
        run = ["run", suite, "--repetitions", "1", "--out"]
        campaign.count(program.run([*run, f"{suite}-quiet"], folder, 7200.0))
        others = [subprocess.Popen(["nice", "-n", "19", "sh", "-c", "while :; do :; done"]) for _ in range(BUSY_PROCESSES)]
        try:
            outcome = campaign.count(program.run([*run, f"{suite}-busy"], folder, 7200.0, ("nice", "-n", "19")))
        finally:
            for other in others:
                other.kill()
                other.wait()
        found = program.violations(outcome, (0, 1))
        quiet, now = verdicts(folder / f"{suite}-quiet"), verdicts(folder / f"{suite}-busy")
        found += [f"{case}: {now.get(case)} where it was {quiet.get(case)}" for case in quiet.keys() | now.keys()
                  if quiet.get(case) != now.get(case)]
        campaign.judge(found, f"run {suite}, {len(quiet)} cases")
    yield campaign
