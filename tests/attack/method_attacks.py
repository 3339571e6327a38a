"""Methods from outside that misbehave, as commands and as shared objects, beside one that does not."""

import pathlib
import re
import shutil
import sys
import time

from attacked_program import CONTROL, Campaign
from ill_behaved_command import DEEDS
from run_attacks import answers
from solve_attacks import nulls, outcome_of, read_records, write_suite

HERE = pathlib.Path(__file__).resolve().parent
GOOD = "hat-lcp[samples=64]"
SCENES = ("sdof-stop", "chain2-stop")
SECONDS = 1.5  # of a solve
DESCRIPTION = """schema = 1
name = "ill-behaved"
title = "A command that misbehaves as it is told"
ladder = "deed=stand-still"
command = ["{python}", "-B", "ill_behaved_command.py"]
[represents]
restitution = "scene"
[[option]]
name = "deed"
default = "stand-still"
unit = "[-]"
meaning = "how it misbehaves"
"""
# 1000 bytes of the method's and what the harness says before them; of a table of two scenes [bytes].
LONGEST_MESSAGE, LARGEST_TABLE = 1500, 4 << 20


def processes_with(marker):
    """Those whose command line holds the marker."""
    for process in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            if marker.encode() in (process / "cmdline").read_bytes():
                yield process.name
        except OSError:
            continue


def attack_run(campaign, program, folder, plugin, deeds, scene):
    """One run of all the deeds beside a good method; one judgement per deed, and one of the run."""
    write_suite(folder, program, timeout=SECONDS)
    arguments = ["run", "./suite.toml", "--scenes", scene, "--repetitions", "1", "--out"]
    program.run([*arguments, "alone", "--methods", GOOD], folder, 60.0)
    methods = f"{GOOD}:ill-behaved[deed={'|'.join(deeds)}]"
    # Timeout, grace and ten seconds for what should be quick, of each.
    arguments += ["run", "--methods", methods, "--plugin", plugin, "--jobs", "2"]
    outcome = campaign.count(program.run(arguments, folder, 15.0 * len(deeds) + 60.0))
    found = program.violations(outcome, (0, 1), 1200.0)
    records = read_records(folder / "run")
    alone = answers(read_records(folder / "alone"))
    here = answers(records)
    found += [f"{case} is otherwise beside them" for key, case in alone.items() if here.get(key) != case]
    if (folder / "run/table.md").stat().st_size > LARGEST_TABLE:
        found.append("table.md is large")
    time.sleep(0.5)
    found += [f"process {process} is left" for process in processes_with(str(folder))]
    campaign.judge(found, f"the run of {len(deeds)} deeds on {scene}", [folder / "run/records.jsonl"])
    by_deed = {record["options"]["deed"]: record for record in records if record["method"] == "ill-behaved"}
    for deed in deeds:
        found = list(deed_violations(by_deed.get(deed), program.slower))
        campaign.judge(found, f"{deed} on {scene}")
    for part in ("alone", "run"):
        shutil.rmtree(folder / part, ignore_errors=True)
    return by_deed


def deed_violations(record, slower):
    if record is None:
        yield "no record"
        return
    message = record.get("message", "")  # a method need not say anything
    if record["status"] == "converged":
        yield f"converged ({record['certificate']['status']}): {message[:200]}"
    if len(message.encode()) > LONGEST_MESSAGE or CONTROL.search(message.encode()):
        yield "its message is long or raw"
    if record.get("elapsed", 0.0) > (SECONDS + 1.5) * slower + 1.5 and record["status"] == "timeout":
        yield f"{record['elapsed']:.1f} s of {SECONDS} s"
    yield from (f"{path} is null" for path in nulls(record))


def note(campaign, title, outcomes):
    rows = [["deed", *outcomes]]
    for deed in sorted({deed for by_deed in outcomes.values() for deed in by_deed}):
        rows.append([deed, *(outcome_of(by_deed[deed]) if deed in by_deed else "" for by_deed in outcomes.values())])
    campaign.notes.append((title, rows))


def ill_behaved_commands(program, random, count, folder, findings):
    """Commands that crash, hang, flood, fork and lie."""
    campaign = Campaign("ill-behaved command methods beside a good one", findings)
    shutil.copy(HERE / "ill_behaved_command.py", folder)
    (folder / "method.toml").write_text(DESCRIPTION.format(python=sys.executable))
    deeds = random.sample(sorted(DEEDS), min(count, len(DEEDS)))
    outcomes = {scene: attack_run(campaign, program, folder, "./method.toml", deeds, scene) for scene in SCENES}
    note(campaign, "Ill-behaved commands", outcomes)
    yield campaign


def ill_behaved_plugins(program, random, count, folder, findings):
    """Shared objects that do as much inside the process of a case."""
    campaign = Campaign("ill-behaved shared objects beside a good method", findings)
    plugin = pathlib.Path(program.path).parents[1] / "tests/attack/ill_behaved_plugin.so"
    if not plugin.exists():
        campaign.notes.append((f"{plugin.name} is not built", []))
        yield campaign
        return
    text = (HERE / "ill_behaved_plugin.cpp").read_text()
    names = re.findall(r'"([a-z0-9-]+)"', text[text.index("values{"):text.index("};", text.index("values{"))])
    # Sanitizers stop the program where it would have gone on, and take no limit of memory.
    unfit = {"hog", "recurse"} if program.slower > 1.0 else set()
    fit = [name for name in names if name not in unfit]
    deeds = random.sample(fit, min(count, len(fit)))
    outcomes = {scene: attack_run(campaign, program, folder, str(plugin), deeds, scene) for scene in SCENES}
    note(campaign, "Ill-behaved shared objects", outcomes)
    yield campaign
