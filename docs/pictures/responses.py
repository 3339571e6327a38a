#!/usr/bin/env python3
"""Makes docs/pictures/responses.svg, whole frequency responses in the README, from the records of a run:

    python3 docs/pictures/responses.py [FOLDER [FILE]]

Four scenes of results/responses: the exact branches, and those that two methods follow by arc length, where they represent
the scene's law. Needs Python alone."""

import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from overview import HEIGHT, ROOT, WIDTH, Panel, document, pieces, themed

SCENES = {"sdof-stop": "Rigid stop, e = 1", "sdof-stop-e05": "Rigid stop, e = 0.5", "rod-penalty@4": "Rod before a spring",
          "beam20-three-stops": "Beam, three massless contacts"}
METHODS = {"fourier-lipschitz[harmonics=20]": ("m0", "#009e73", "#2fd3a5"), "hat-lcp[samples=128]": ("m1", "#d55e00", "#ff9c57")}


def rules(shade):
    ink, sheet, exact = (("#1b1f24", "#ffffff", "#b8bec6"), ("#d6dbe1", "#15181c", "#5d6670"))[shade]
    methods = ((name, colours[shade]) for name, *colours in METHODS.values())
    return (f"text{{font-family:sans-serif}}path{{fill:none}}path.note{{stroke:{ink}}}text.note,text.heading{{fill:{ink}}}text.heading{{font-weight:600}}"
            f"rect.sheet{{fill:{sheet}}}path.exact{{stroke:{exact}}}"
            + "".join(f"path.{name}{{stroke:{colour}}}text.{name}{{fill:{colour}}}" for name, colour in methods))


def panel_of(scene, title, records):
    exact = next(r["response"] for r in records if r["scene"] == scene and r["response"]["way"] == "exact")
    amplitudes = [a for branch in exact["branches"] for a in branch["amplitude"]]
    metre, metre_name = (1e3, "mm") if max(amplitudes) < 1e-2 else (1.0, "m")
    rate, rate_name = (1e-3, "krad/s") if exact["to"] > 1e4 else (1.0, "rad/s")
    low, high = sorted((rate * exact["from"], rate * exact["to"]))
    panel = Panel(title, (low, high), (0.0, 1.6 * metre * max(amplitudes)), f"frequency of the load ω [{rate_name}]", f"amplitude [{metre_name}]")
    scaled = lambda points: [(rate * point[0], metre * point[1]) for point in points]
    for branch in exact["branches"]:
        for stable in (True, False):
            points = list(zip(branch["omega"], branch["amplitude"], branch["stable"]))
            for run in pieces(points, lambda before, after: (before[2] == 1) == stable):
                panel.curve(scaled(run), "exact", 7 if stable else 4, "" if stable else "7 5")
    for row, (label, (name, _, _)) in enumerate(METHODS.items()):
        record = next((r for r in records if r["case"] == f"{scene}/{label} by arc length"), None)
        if record is None:
            continue
        words = label
        if record.get("law_matches_scene") is False:
            words += ": another law"
        else:
            for branch in record["response"]["branches"]:
                panel.curve(scaled(zip(branch["omega"], branch["amplitude"])), name, 1.3)
            found = record["response"].get("comparison", {}).get("within_0.02", {}).get("covered")
            words += f": {100 * found:.0f} % found" if found is not None else ""
        x, y = panel.at(high, panel.y[1])
        panel.text(x - 4, y + 16 + 18 * row, words, "end", name)
    return panel


def picture(records):
    svg = ""
    for i, (scene, title) in enumerate(SCENES.items()):
        svg += panel_of(scene, f"{title} ({scene})", records).svg(WIDTH * (i % 2), HEIGHT * (i // 2))
    return document("Amplitude over the frequency of the load on four scenes: the exact branches, dashed where unstable, and those of "
                    "two methods", themed(rules, 0, 1), svg)


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "results/responses"
    target = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else pathlib.Path(__file__).parent / "responses.svg"
    records = [json.loads(line) for line in (folder / "records.jsonl").read_text().splitlines()]
    target.write_text(picture(records))


if __name__ == "__main__":
    main()
