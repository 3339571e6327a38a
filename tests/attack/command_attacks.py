"""check, orbits, sweep, new and verify on what strangers send."""

import json
import shutil

from attacked_program import Campaign
from file_attacks import TREE, small
from generators import damaged, hand_made_scenes, random_scene

NAMES = ["my-method", "../escape", "/tmp/escape", "a/b", "", " ", "-", "--help", "a b", "a\nb", "A", "1", "a" * 300, "a'b", '"',
         "$(id)", "`id`", "\xff", "nul", "hat-lcp", "sdof-stop", "con", ".", "..", "a.b", "ünter", "class", "int", "std", "main",
         "a--b", "a-", "-a", "template"]
CHECKS = ["applicability", "trajectory", "determinism", "certificate", "*-scaling", "numbering", "time-budget"]


def scene_for(random, number):
    """A random scene, one made by hand, or a damaged one."""
    kind = number % 3
    if kind == 0:
        return random_scene(random, number)
    if kind == 1:
        return random.choice(sorted(hand_made_scenes().values())).encode()
    texts = small(TREE.glob("problems/catalogue/sdof-*.toml"))
    return damaged(random.choice(texts), texts, random)


def searches(program, random, count, folder, findings):
    """check, orbits, sweep and solve under small limits."""
    campaign = Campaign("`check`, `orbits`, `sweep`, `solve` on random, hand-made and damaged scenes", findings)
    methods = ["hat-lcp", "fourier-lipschitz", "penalty-hbm", "aft-hbm", "closed-hbm", "event-driven", "exact-orbit"]
    for number in range(count):
        text = scene_for(random, number)
        (folder / "scene.toml").write_bytes(text)
        method = random.choice(methods)
        seconds = str(0.5 * program.slower)
        command = random.choice([
            ["check", method, "--scenes", "./scene.toml", "--timeout", seconds, "--checks", random.choice(CHECKS)],
            ["orbits", "./scene.toml", "--timeout", "1", "--starts", "4"],
            ["sweep", "./scene.toml", "--method", method, "--from", "0.5", "--to", "2", "--points", "4", "--timeout",
             seconds],
            ["solve", "./scene.toml", "--method", method, "--certificate", "1", "--reference", "0.5", "--json"]])
        campaign.attack(program, command, folder, [folder / "scene.toml"], codes=(0, 1, 2, 3), seconds=120.0,
                        given=text)
    yield campaign


def new(program, random, count, folder, findings):
    """Names that are none for methods and scenes that are begun: nothing is written elsewhere."""
    campaign = Campaign("`new` with names that are none", findings)
    for _ in range(count):
        shutil.rmtree(folder / "here", ignore_errors=True)
        (folder / "here").mkdir()
        name = random.choice(NAMES)
        command = random.choice([["new", "method", name, "--out-of-tree"], ["new", "scene", name],
                                 ["new", "method", name]])
        before = sorted(folder.iterdir())
        campaign.attack(program, command, folder / "here")
        written = [path for path in (folder / "here").iterdir() if path.name not in (name, f"{name}.toml")]
        outside = sorted(folder.iterdir()) != before
        found = [f"it wrote {path.name}" for path in written] + ["it wrote outside of its folder"] * outside
        campaign.judge(found, " ".join(command))
    yield campaign


def references(program, random, count, folder, findings):
    """Kept orbits damaged, verified and used by a solve."""
    campaign = Campaign("damaged files of kept orbits, `verify`", findings)
    files = sorted(TREE.glob("results/references/sdof-*.json"))
    texts = [file.read_bytes() for file in files]
    for _ in range(count):
        number = random.randrange(len(files))
        shutil.rmtree(folder / "references", ignore_errors=True)
        (folder / "references").mkdir()
        text = damaged(texts[number], texts, random)
        file = folder / "references" / files[number].name
        file.write_bytes(text)
        command = ["verify", "references", "--scenes", files[number].stem, "--timeout", "2", "--starts", "2"]
        campaign.attack(program, command, folder, [file], codes=(0, 1, 2, 3), seconds=120.0, given=text)
    yield campaign


def starts(program, random, count, folder, findings):
    """Motions to start from, damaged."""
    campaign = Campaign("damaged motions, `solve --start`", findings)
    solve = ["solve", "sdof-stop", "--method", "hat-lcp", "--set", "samples=64"]
    whole = program.run([*solve, "--samples", "16", "--json"], folder).out
    json.loads(whole)
    for _ in range(count):
        text = damaged(whole, [whole], random)
        (folder / "start.json").write_bytes(text)
        campaign.attack(program, [*solve, "--start", "start.json", "--certificate", "0.2"], folder, [folder / "start.json"],
                        codes=(0, 1, 2), seconds=60.0, given=text)
    yield campaign
