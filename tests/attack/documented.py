"""Documented commands on scenes of each kind, with their options in pairs; those that once crashed; folders of traps."""

import itertools
import json
import math
import os
import shutil
import signal

from attacked_program import Campaign
from file_attacks import TREE
from generators import one_mass

RUN = ["run", "quick", "--scenes", "sdof-stop", "--methods", "hat-lcp[samples=64]", "--repetitions", "1"]


def chain(masses, springs, dampers, law="[law]\nrestitution = 0.7\n", frequency=1.0):
    """A chain loaded at its end before a stop of its first mass."""
    return f"""schema = 1
name = "chain"
[system]
kind = "chain"
masses = {masses}
springs = {springs}
dampers = {dampers}
[forcing]
frequency = {frequency}
[[forcing.term]]
dof = {len(masses) - 1}
cos = 1.0
[[contact]]
dof = 0
gap = 0.3
{law}"""


UNDAMPED_WITH_DAMPED_STOP = one_mass(law="penalty = 50.0\ndamping = 1.0", damping=0.0)
CONSTANT_LOAD = one_mass(law="restitution = 0.8", force="dof = 0\nharmonic = 0\ncos = 1.0\n")


def shipped(name):
    return (TREE / f"problems/catalogue/{name}.toml").read_text()


def bar_of(elements):
    """The bar of 200 elements with a massless tip, with others."""
    text = shipped("bar200-massless").replace("elements = 200", f"elements = {elements}")
    return text.replace("dof = 99\n", f"dof = {elements // 2}\n").replace("dof = 199\n", f"dof = {elements - 1}\n")


def scenes_of_each_kind(folder):
    """Scene files by what is particular about them."""
    two_sided = ("gap = 0.2", "clearance = 0.6")
    files = {
        "without contact": one_mass(gaps=(), law="").replace("[law]", ""),
        "rigid": one_mass(law="restitution = 0.8"),
        "two-sided spring": one_mass(law="penalty = 20.0").replace(*two_sided),
        "free": one_mass(law="restitution = 0.7", stiffness=0.0).replace(*two_sided),
        "constant load": CONSTANT_LOAD,
        "without load": one_mass(force="", damping=0.0),
        "damped stop": UNDAMPED_WITH_DAMPED_STOP,
        "two masses": chain([1.0, 1.0], [1.0, 1.0], [0.1, 0.1]),
        "idle mass": chain([1.0, 1.0], [1.0, 0.0], [0.1, 0.0]),
        "undamped resonance": chain([0.0, 1.0], [1.0, 1.0], [0.0, 0.0], law="", frequency=math.sqrt(0.5)),
        "bouncing ball": shipped("clearance-bouncing-ball"),
        "loose part in a box": shipped("clearance-impact-damper"),
        "laws of two kinds": shipped("chain2-housing-and-buffer"),
        "moving stop": shipped("rotor-moving-casing"),
        "tube": shipped("sdnl301d"),
        "ten contacts": shipped("beam20-ten-stops"),
        "massless contact": shipped("bar10-massless"),
        "damping ratios of modes": shipped("bar10-massless").replace("modal = 0.05", "modal = [0.0, 0.02, 1e3]"),
        "1000 coordinates": bar_of(1000),
        "1000 coordinates, without contact": bar_of(1000).partition("[[contact]]")[0].replace('contact_mass = "massless"\n', ""),
    }
    folder.mkdir(exist_ok=True)
    for number, (kind, text) in enumerate(files.items()):
        (folder / f"kind-{number}.toml").write_text(text)
        yield kind, f"./kind-{number}.toml"


SWEEP = ("sweep", "SCENE", "--methods", "exact-orbit", "--from", "0.9", "--to", "1.1", "--total-time", "2")
COMMANDS = {
    ("show", "SCENE"): (["--json"], ["--plot", "p.svg"]),
    ("solve", "SCENE", "--method", "exact-orbit", "--timeout", "5"): (
        ["--json"], ["--plot", "p.svg"], ["--certificate", "0"], ["--dofs", "0"], ["--samples", "8"], ["--harmonics", "3"], ["--verbose"],
        ["--reference", "1"], ["--column", "single"]),
    ("solve", "SCENE", "--method", "hat-lcp", "--set", "samples=32"): (["--json"], ["--plot", "p.svg"], ["--certificate", "1"]),
    ("solve", "SCENE", "--method", "aft-hbm", "--set", "harmonics=5"): (["--json"], ["--plot", "p.svg"], ["--certificate", "1"]),
    ("solve", "SCENE", "--method", "event-driven", "--timeout", "2"): (["--json"], ["--plot", "p.svg"], ["--certificate", "1"]),
    ("orbits", "SCENE", "--starts", "4", "--timeout", "2"): (["--json"], ["--plot", "p.svg"], ["--subharmonics", "2"]),
    ("motion", "SCENE", "--starts", "1", "--timeout", "2"): (
        ["--json"], ["--plot", "p.svg"], ["--waveform", "w.csv"], ["--first", "2"], ["--exponents", "1"], ["--transient", "2"]),
    ("reduce", "SCENE", "--out", "reduced.toml"): (["--vectors", "1"],),
    ("check", "hat-lcp", "--scenes", "SCENE", "--timeout", "1", "--checks", "*-scaling"): (["--json"],),
    ("run", "smoke", "--scenes", "SCENE", "--methods", "hat-lcp[samples=32]:exact-orbit", "--timeout", "2", "--repetitions", "1", "--out", "run"): (
        ["--resume"], ["--waveforms"], ["--verbose"], ["--jobs", "2"]),
    SWEEP: (["--format", "json"], ["--format", "csv"], ["--format", "jsonl"], ["--plot", "p.svg"], ["--max-order", "2"], ["--at", "1.0"],
            ["--bifurcation"], ["--search", "1"], ["--natural"], ["--hz"], ["--out", "kept"], ["--attractors", "1", "--timeout", "1"],
            ["--max-branches", "1"], ["--max-points", "3"]),
    ("sweep", "SCENE", "--method", "aft-hbm", "--set", "harmonics=5", "--from", "0.9", "--to", "1.1", "--points", "3"): (
        ["--format", "json"], ["--format", "csv"], ["--back"], ["--plot", "p.svg"], ["--log"], ["--certify"], ["--hz"]),
    ("sweep", "SCENE", "--methods", "hat-lcp:aft-hbm", "--from", "0.9", "--to", "1.1", "--total-time", "2"): (["--format", "json"], ["--plot", "p.svg"]),
    ("sweep", "SCENE", "--methods", "exact-orbit", "--parameter", "system.mass", "--from", "1", "--to", "0", "--total-time", "2"): (
        ["--format", "json"], ["--plot", "p.svg"]),
    (*SWEEP, "--second", "contact[0].gap", "--second-from", "0.2", "--second-to", "0.3"): (
        ["--follow", "fold"], ["--follow", "grazing"], ["--follow", "contact-change"], ["--follow", "phase-resonance"]),
    ("sweep", "SCENE", "--backbone", "--from", "0.9", "--to", "1.1", "--total-time", "2"): (["--format", "json"], ["--second-to", "2"]),
    # Of a folder of results, whatever the scene.
    ("status", "whole"): (["--json"],),
    ("report", "whole"): (["--format", "md,csv"], ["--format", "html,tex"], ["--format", "screen"], ["--out", "reported"]),
    ("pack", "whole", "--out", "whole.tar.gz"): (),
    ("verify", "whole", "--cases", "*hat-lcp*"): (),
    ("compare", "whole", "whole"): (),
    ("history", "whole"): (["--plot", "p.svg"],),
    ("merge", "whole", "--out", "merged"): (),
}


def calls_of(kinds):
    """Each command on each kind of scene, with one of its options or two: of what scene, and the words."""
    for words, options in COMMANDS.items():
        for kind, file in kinds if "SCENE" in words else [("folder of results", "")]:
            for chosen in [()] + list(itertools.combinations(options, 1)) + list(itertools.combinations(options, 2)):
                if len({option[0] for option in chosen}) == len(chosen):
                    yield kind, [file if word == "SCENE" else word for word in (*words, *itertools.chain(*chosen))]


def pairs(program, random, count, folder, findings):
    """So many of these calls."""
    campaign = Campaign("documented commands on scenes of each kind, options in pairs", findings)
    folder.mkdir(exist_ok=True)
    calls = list(calls_of(list(scenes_of_each_kind(folder))))
    campaign.count(program.run([*RUN, "--out", "whole"], folder, seconds=60.0))
    for kind, file in scenes_of_each_kind(folder):  # one that is refused attacks nothing
        campaign.judge(program.violations(campaign.count(program.run(["show", file], folder)), codes=(0,)), f"{kind}: show")
    for kind, arguments in random.sample(calls, min(count, len(calls))):
        outcome = campaign.count(program.run(arguments, folder, seconds=60.0))
        found = program.violations(outcome, codes=(0, 1, 2, 4, 6), given=" ".join(arguments).encode())
        if outcome.code == 1 and not outcome.err.strip() and not outcome.out.strip():
            found.append("fails without a word")
        campaign.judge(found, f"{kind}: {' '.join(arguments)}")
    yield campaign


# Command, exit code, a piece of what it says on either stream.
CRASHED = [
    ("sweep sdof-stop --methods exact-orbit --from 2.2 --to 2.6 --follow fold --second system.stiffness --second-from 1 --second-to 1.2", 0,
     "ends: end of the interval"),
    ("sweep sdof-stop --methods exact-orbit --from 2.2 --to 2.6 --follow grazing --second contact[0].gap --second-from 0.2 --second-to 0.3", 0,
     "end of the interval"),
    ("sweep sdof-stop --methods exact-orbit --from 0 --to 1 --follow fold --second contact[0].gap --second-from 0.2 --second-to 0.3", 2,
     "from = 0 (must be a positive number"),
    ("sweep sdof-stop --methods exact-orbit --from -1 --to 1 --follow fold --second contact[0].gap --second-from 0.2 --second-to 0.3", 2,
     "from = -1 (must be a positive number"),
    ("sweep chain2-stop --methods exact-orbit --parameter system.masses[0] --from 1 --to 0 --total-time 5", 0, "exact-orbit: "),
    ("reduce sdof-contact-free --out reduced.toml", 2, "it has no contact"),
    ("solve sdof-contact-free --method exact-orbit --plot p.svg", 2, "plot = nothing to draw (the scene has no contact)"),
    ("orbits sdof-contact-free --starts 2 --plot p.svg", 2, "plot = nothing to draw (the scene has no contact)"),
    ("solve sdof-stop --method hat-lcp --certificate nan", 2, "nan"),
    ("run quick --scenes sdof-stop --methods hat-lcp --seed 18446744073709551616 --out never", 2, "18446744073709551616"),
]


def crashed(program, _random, count, folder, findings):
    """Commands that once ended by a signal, without a word, or with what they should have refused."""
    campaign = Campaign("documented commands that crashed", findings)
    folder.mkdir(exist_ok=True)
    for command, code, said in CRASHED[:count]:
        outcome = campaign.count(program.run(command.split(), folder, seconds=60.0))
        found = program.violations(outcome, codes=(code,), given=command.encode())
        if said.encode() not in outcome.out + outcome.err:
            found.append(f"does not say {said!r}: {(outcome.out + outcome.err)[-200:]!r}")
        campaign.judge(found, command)
    campaign.judge(list(reduced_damper(program, campaign, folder)), "reduce of an undamped structure with a damped stop")
    campaign.judge(list(silent_sweeps(program, campaign, folder)), "sweep that finds no branch")
    campaign.judge(list(bandwidth_of_a_start(program, campaign, folder)), "a start with a bandwidth of 1e9")
    campaign.judge(list(memory_that_runs_out(program, campaign, folder)), "a command that prints a line without end")
    campaign.judge(list(children_ignored(program, campaign, folder)), "SIGCHLD ignored by the parent")
    campaign.judge(list(time_without_end(program, campaign, folder)), "run --timeout 1e10")
    yield campaign


def reduced_damper(program, campaign, folder):
    """What `reduce` writes is a scene."""
    (folder / "damped.toml").write_text(UNDAMPED_WITH_DAMPED_STOP)
    for arguments in (["reduce", "./damped.toml", "--out", "./reduced.toml"], ["show", "./reduced.toml"]):
        outcome = campaign.count(program.run(arguments, folder))
        yield from program.violations(outcome, codes=(0,))


def silent_sweeps(program, campaign, folder):
    (folder / "constant.toml").write_text(CONSTANT_LOAD)
    for form in ("csv", "jsonl", "text", "json"):
        outcome = campaign.count(program.run(["sweep", "./constant.toml", "--methods", "exact-orbit", "--parameter", "forcing.term[0].cos",
                                              "--from", "1", "--to", "0.5", "--total-time", "5", "--format", form], folder))
        yield from program.violations(outcome, codes=(1, 2))
        if not outcome.err.strip() and form != "json":
            yield f"no reason with --format {form}"
        if form == "csv" and outcome.code == 1 and b"," not in outcome.out:
            yield "csv without its header"


def bandwidth_of_a_start(program, campaign, folder):
    outcome = campaign.count(program.run(["solve", "sdof-stop", "--method", "hat-lcp", "--set", "samples=64", "--json", "--samples", "16"], folder))
    record = json.loads(outcome.out)
    for bandwidth in (10**9, -5):
        record["trajectory"]["bandwidth"] = bandwidth
        (folder / "start.json").write_text(json.dumps(record))
        for method in ("aft-hbm", "fourier-lipschitz", "closed-hbm"):
            outcome = campaign.count(program.run(["solve", "sdof-stop", "--method", method, "--start", "start.json"], folder))
            yield from program.violations(outcome, codes=(2,))


ENDLESS = """import sys
sys.stdin.readline()
while True:
    sys.stdout.write("x" * (1 << 20))
"""


def memory_that_runs_out(program, campaign, folder):
    """A text that grows until `new` fails is told as what it is."""
    (folder / "endless.py").write_text(ENDLESS)
    (folder / "endless.toml").write_text('schema = 1\nname = "endless"\ntitle = "prints without end"\nladder = ""\n'
                                         'command = ["python3", "endless.py"]\n[represents]\nrestitution = "scene"\n')
    outcome = campaign.count(program.run(["solve", "sdof-stop", "--method", "endless", "--plugin", "./endless.toml"], folder, seconds=60.0))
    yield from program.violations(outcome, codes=(1,), memory_mb=4096.0)
    if b"signal" in outcome.out + outcome.err:
        yield f"ends by a signal: {outcome.out[-200:]!r}"


def children_ignored(program, campaign, folder):
    before = signal.signal(signal.SIGCHLD, signal.SIG_IGN)
    blocked = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGCHLD})
    try:
        process = program.start(["solve", "sdof-stop", "--method", "hat-lcp"], folder)
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, blocked)
        signal.signal(signal.SIGCHLD, before)
    outcome = campaign.count(program.finish(process, 20.0))
    yield from program.violations(outcome, codes=(0,))


def time_without_end(program, campaign, folder):
    run = ["run", "quick", "--scenes", "sdof-far-stop", "--methods", "hat-lcp[samples=64]", "--repetitions", "1", "--out", "endless"]
    for arguments in ([*run, "--timeout", "1e10"], [*run, "--timeout", "1e10", "--resume"], ["report", "endless"]):
        outcome = campaign.count(program.run(arguments, folder, seconds=60.0))
        yield from program.violations(outcome, codes=(0,))


# Every name that a command writes into a folder of results, or a folder below it.
WRITTEN = ["table.md", "table-whole.md", "table.csv", "measures.csv", "report.html", "manifest.json", "plan.txt", "records.jsonl", "unfinished.jsonl",
           "records.previous.jsonl", "tables", "figures", "pages"]
TRAPS = ["link to a file", "link to a folder", "pipe", "hard link", "link to a device"]


def set_trap(kind, place, victim, folder):
    """Puts something of that kind where a command will write; false where another file is at stake."""
    if place.is_dir() and not place.is_symlink():
        shutil.rmtree(place)
    place.unlink(missing_ok=True)
    if kind == "link to a file":
        place.symlink_to(victim)
    elif kind == "link to a folder":
        place.symlink_to(folder)
    elif kind == "pipe":
        os.mkfifo(place)
    elif kind == "hard link":
        os.link(victim, place)
    else:
        place.symlink_to("/dev/full")


def traps(program, random, count, folder, findings):
    """Folders of results from somebody else: nothing outside of them is written, and nothing waits."""
    campaign = Campaign("folders of results with links, pipes and hard links in them", findings)
    folder.mkdir(exist_ok=True)
    whole = folder / "whole"
    campaign.count(program.run([*RUN, "--out", "whole"], folder, seconds=60.0))
    names = [name + draft for name in WRITTEN for draft in ("", ".new") if not (draft and name in ("tables", "figures", "pages"))]
    cases = list(itertools.product(names, TRAPS, ("report", "resume", "merge")))
    for name, kind, command in random.sample(cases, min(count, len(cases))):
        results, elsewhere = folder / "results", folder / "elsewhere"
        for old in (results, elsewhere):
            shutil.rmtree(old, ignore_errors=True)
        shutil.copytree(whole, results)
        elsewhere.mkdir()
        victim = folder / "victim"
        victim.write_text("precious\n")
        set_trap(kind, results / name, victim, elsewhere)
        arguments = {"report": ["report", "results", "--format", "md,whole,csv,tex,html"], "resume": [*RUN, "--out", "results", "--resume"],
                     "merge": ["merge", "whole", "--out", "results"]}[command]
        outcome = campaign.count(program.run(arguments, folder, seconds=60.0))
        found = program.violations(outcome, codes=(0, 2))
        if victim.read_text() != "precious\n":
            found.append("the victim is overwritten")
        if any(elsewhere.iterdir()):
            found.append(f"writes {sorted(path.name for path in elsewhere.iterdir())} elsewhere")
        campaign.judge(found, f"{command} where {name} is a {kind}")
    yield campaign
