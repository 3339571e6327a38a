#!/usr/bin/env python3
"""Makes docs/pictures/overview.svg, the picture at the head of the README:

    python3 docs/pictures/overview.py [PROGRAM [FILE]]

One scene in four panels: its schematic (`signorini show --plot`), its motion (`solve`), its response (`sweep`), all
computed anew, and error against time from the records in results/catalogue. Needs Python alone. Colours follow the
reader's choice of light or dark, as those of the schematic do, whose style is used for all."""

import csv
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENE = "sdof-stop"
WIDTH, HEIGHT = 460, 300  # of a panel [px]
LEFT, RIGHT, TOP, BOTTOM = 62, 14, 34, 46  # around its frame
# Okabe and Ito's colours, which colour-blind readers tell apart; lighter ones on dark paper.
CURVES = {"exact-orbit": ("#0072b2", "#56b4e9"), "fourier-lipschitz": ("#009e73", "#2fd3a5"),
          "hat-lcp": ("#cc79a7", "#e79fc8"), "event-driven[flow=cvode]": ("#8a6d00", "#e6c84f")}


def run(program, *words):
    return subprocess.run([program, *words], check=True, capture_output=True, text=True).stdout


def themed(rules, *palettes):
    """A style with the rules of the first palette, and those of the second where paper is dark; no custom properties, which few programs know."""
    day, night = (rules(palette) for palette in palettes)
    return f"<style>{day}@media (prefers-color-scheme:dark){{{night}}}</style>"


def rules(shade):
    ink, contact = (("#1f2328", "#c04f00"), ("#d7dee6", "#ff9d57"))[shade]
    curves = (f"path.c{i}{{stroke:{c[shade]}}}circle.c{i},text.c{i}{{fill:{c[shade]}}}" for i, c in enumerate(CURVES.values()))
    return "".join(curves) + f"text.heading{{fill:{ink};font-weight:600}}circle.contact{{fill:{contact}}}"


class Panel:
    """A frame with axes; places are in units of the data."""

    def __init__(self, title, x, y, x_label, y_label, logarithmic=False):
        self.x, self.y, self.log = x, y, logarithmic
        self.parts = [f'<text class="heading" x="{LEFT}" y="18">{title}</text>']
        bottom, right = HEIGHT - BOTTOM, WIDTH - RIGHT
        self.parts.append(f'<path class="note" d="M{LEFT} {TOP}V{bottom}H{right}"/>')
        for value in self.ticks(*x):
            at = self.at(value, y[0])[0]
            self.parts.append(f'<path class="note" d="M{at:.1f} {bottom}v4"/>')
            self.text(at, bottom + 17, self.number(value), "middle", "note")
        for value in self.ticks(*y):
            at = self.at(x[0], value)[1]
            self.parts.append(f'<path class="note" d="M{LEFT} {at:.1f}h-4"/>')
            self.text(LEFT - 7, at + 4, self.number(value), "end", "note")
        self.text((LEFT + right) / 2, HEIGHT - 8, x_label, "middle", "note")
        middle = (TOP + bottom) / 2
        self.parts.append(f'<text class="note" text-anchor="middle" transform="translate(13 {middle:.0f}) rotate(-90)">{y_label}</text>')

    def ticks(self, low, high):
        if self.log:
            return [10.0**k for k in range(math.ceil(math.log10(low)), math.floor(math.log10(high)) + 1)
                    if (k - math.floor(math.log10(high))) % (1 if high / low < 1e6 else 3) == 0]
        step = 10 ** math.floor(math.log10(high - low))
        step *= next(s for s in (0.1, 0.2, 0.25, 0.5, 1, 2) if (high - low) / (s * step) <= 6)
        return [round(k * step, 10) for k in range(math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9) + 1)]

    def number(self, value):
        if not self.log:
            return f"{value:g}".replace("-", "−")
        return "10" + "".join("⁻" if c == "-" else "⁰¹²³⁴⁵⁶⁷⁸⁹"[int(c)] for c in str(round(math.log10(value))))

    def at(self, x, y):
        share = lambda v, low, high: math.log(v / low) / math.log(high / low) if self.log else (v - low) / (high - low)
        return (LEFT + share(x, *self.x) * (WIDTH - LEFT - RIGHT),
                HEIGHT - BOTTOM - share(y, *self.y) * (HEIGHT - TOP - BOTTOM))

    def text(self, x, y, words, anchor, kind):
        self.parts.append(f'<text class="{kind}" x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{words}</text>')

    def curve(self, points, kind, width, dashes=""):
        """Points outside the frame are cut off with their pieces."""
        d, inside = "", False
        for x, y in points:
            ok = self.x[0] <= x <= self.x[1] and self.y[0] <= y <= self.y[1]
            if ok:
                place = self.at(x, y)
                d += f"{'L' if inside else 'M'}{place[0]:.1f} {place[1]:.1f}"
            inside = ok
        dash = f' stroke-dasharray="{dashes}"' if dashes else ""
        self.parts.append(f'<path class="{kind}" stroke-width="{width}"{dash} d="{d}"/>')

    def dot(self, x, y, kind, radius=3.5):
        place = self.at(x, y)
        self.parts.append(f'<circle class="{kind}" cx="{place[0]:.1f}" cy="{place[1]:.1f}" r="{radius}"/>')

    def svg(self, x, y):
        return f'<g transform="translate({x} {y})">' + "\n".join(self.parts) + "</g>\n"


def schematic(program):
    """The head of the schematic's document with its style, and its body."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "scene.svg"
        run(program, "show", SCENE, "--plot", str(file))
        text = file.read_text()
    sheet = re.search(r"<rect class=\"sheet\".*?/>\n", text)
    size = [float(v) for v in re.search(r'viewBox="0 0 (\S+) (\S+)"', text).groups()]
    return re.search(r"<style>.*?</style>", text, re.S).group(0), text[sheet.end():text.rindex("</svg>")], size


def motion(program):
    record = json.loads(run(program, "solve", SCENE, "--method", "exact-orbit", "--json", "--samples", "400"))
    # What is solved: contact with the stop at the gap of the scene, which the impacts tell.
    period, t, x = record["period"], record["trajectory"]["t"], record["trajectory"]["x"][0]
    impacts = [e["time"] for e in record["certificate"]["events"] if e["kind"] == "impact"]
    gap = max(x)
    points = sorted([*zip(t, x), *((s, gap) for s in impacts)])
    twice = points + [(s + period, v) for s, v in points] + [(2 * period + points[0][0], points[0][1])]
    panel = Panel("Periodic motion, and its impacts", (0.0, 2 * period), (1.15 * min(x), gap + 0.35 * (gap - min(x))),
                  "time t [s]", "displacement x [m]")
    panel.curve([(0.0, gap), (2 * period, gap)], "contact", 1.5, "7 4")
    panel.text(*[v - d for v, d in zip(panel.at(2 * period, gap), (4, 8))], "stop, x = g", "end", "contact")
    panel.curve(twice, "c0", 2)
    for s in impacts:
        for k in (0, 1):
            panel.dot(s + k * period, gap, "contact", 4)
    return panel, len(impacts)


def pieces(points, belongs):
    """Runs of points whose steps belong together, belongs(before, after); each takes the point where it meets the next."""
    found, run_of = [], []
    for before, after in zip(points, points[1:]):
        if belongs(before, after):
            run_of = (run_of or [before]) + [after]
        elif run_of:
            found.append(run_of)
            run_of = []
    return found + ([run_of] if run_of else [])


def vertices(branch):
    """The points of a branch and, where they are, its special ones, at which its stability changes."""
    points = [dict(point, special=False) for point in branch["points"]]
    for special in reversed(branch["special"]):
        points.insert(special["after"], dict(special, special=True))
    return points


def is_stable(before, after):
    """Of the piece between two of them: that of its end where it begins at a special point or a grazing."""
    of_end = (before["special"] or before["stability"] == "undefined") and not after["special"]
    return (after if of_end else before)["stability"] == "stable"


def document(title, styles, body):
    """Four panels as one SVG on a sheet."""
    width, height = 2 * WIDTH, 2 * HEIGHT
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" '
            f'font-size="12.9" role="img">\n<title>{title}</title>\n{styles}'
            f'<rect class="sheet" width="{width}" height="{height}"/>\n{body}</svg>\n')


def response(program):
    branches = json.loads(run(program, "sweep", SCENE, "--methods", "exact-orbit", "--from", "1.3", "--to", "4.2",
                              "--format", "json"))["branches"]
    panel = Panel("Response, stable and unstable", (1.4, 4.2), (0.0, 4.6), "frequency of the load ω [rad/s]", "amplitude [m]")
    for branch in branches:
        order = branch["points"][0]["order"]
        for stable in (True, False):
            for piece in pieces(vertices(branch), lambda before, after: is_stable(before, after) == stable):
                panel.curve([(p["omega"], p["amplitude"][0]) for p in piece], f"c{0 if order == 1 else 2}",
                            2.2 if stable else 1.3, "" if stable else "4 3")
        for special in branch["special"]:
            if special["kind"] in ("fold", "grazing") and 1.4 < special["omega"] < 4.2:
                panel.dot(special["omega"], special["amplitude"][0], "contact", 3)
    panel.text(*panel.at(2.08, 2.6), "period of the load", "start", "c0")
    panel.text(*panel.at(3.2, 1.55), "twice that", "start", "c2")
    panel.text(*panel.at(4.15, 4.25), "dashed: unstable; dots: fold, grazing", "end", "note")
    return panel, len(branches)


def errors():
    panel = Panel("Error against time, by method", (1e-5, 1.0), (1e-14, 1.0), "time of a solve [s]",
                  "relative error of x", logarithmic=True)
    with open(ROOT / "results/catalogue/table.csv", newline="") as file:
        rows = [row for row in csv.DictReader(file) if row["scene"] == SCENE and row["certificate"] == "certified" and row["seconds_median"]]
    drawn = 0  # an error below ten error bars of the orbit is not measured but bounded by them
    for i, name in enumerate(CURVES):
        words = name.rstrip("]").split("[")
        own = [r for r in rows if r["method"] == words[0] and all(w in r["resolution"] for w in words[1:])
               and "plain" not in r["resolution"]]
        points = sorted((float(r["seconds_median"]), max(float(r["x_l2"]), 10.0 * float(r["error_bar"]))) for r in own)
        if not points:
            continue
        panel.curve(points, f"c{i}", 1.6)
        for point in points:
            panel.dot(*point, f"c{i}")
        x, y = panel.at(*points[-1])
        panel.text(x + 8, y + 4, words[0], "start", f"c{i}")
        drawn += 1
    return panel, drawn


def overview(program):
    own_style, body, size = schematic(program)
    svg = f'<text class="heading" x="{LEFT}" y="18">An oscillator before a stop</text>\n'
    svg += f'<g transform="translate({(WIDTH - size[0]) / 2:.0f} {30 + (HEIGHT - 30 - size[1]) / 2:.0f})">{body}</g>\n'
    panels = [motion(program)[0].svg(WIDTH, 0), response(program)[0].svg(0, HEIGHT), errors()[0].svg(WIDTH, HEIGHT)]
    return document(f"{SCENE}: an oscillator before a stop, its motion, its response, and the error of methods against time",
                    own_style + themed(rules, 0, 1), svg + "".join(panels))


def main():
    program = sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "build/release/harness/signorini")
    target = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else pathlib.Path(__file__).parent / "overview.svg"
    target.write_text(overview(program))


if __name__ == "__main__":
    main()
