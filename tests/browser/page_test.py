"""What a reader does with the page of a run, and of responses, in a real browser, and what must then be so.

usage: page_test.py SIGNORINI RUN..., the second run with motions; AXE names the file axe.min.js of axe-core, if it is there;
PICTURES a folder for screenshots, if any are wanted
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from accessibility import findings_of_axe, findings_of_ours, without_repetitions
from browser import Browser
from page_case import PHONE, WIDE, PageCase, drawn
from responses_case import Responses, responses_page

STRANGE = "</td></script><script>document.title = 3</script><img src=x onerror='document.title = 4'>\\ \" {}"
MARK = "document.querySelector('#side-by-side figure .mark')"


class Page(PageCase):
    """The page of a run."""

    # Text and tables

    def test_the_verdict_is_that_of_the_screen_and_comes_first(self):
        screen = subprocess.run([SIGNORINI, "report", str(self.pages[0].parent), "--format", "screen"],
                                capture_output=True, text=True, check=True).stdout
        self.open()
        captions = self.ask("[...document.querySelectorAll('#verdict caption')].map((c) => c.textContent)")
        self.assertTrue(captions)
        for caption in captions:
            self.assertIn(f" {caption} ", " ".join(screen.split()))  # which wraps at 80 columns
        # Recommended on the screen, recommended here, and with the same time at 1 %.
        wanted = [line.split() for line in screen.splitlines() if line.startswith("* ") and line[2:3].isalpha() and " us" in line or line.startswith("* ") and " ms" in line]
        best = self.ask("[...document.querySelectorAll('#verdict tr.best')].map((r) => [r.querySelector('a').textContent, r.cells[2].textContent])")
        self.assertEqual(len(best), len(wanted))
        for (name, cell), words in zip(best, wanted):
            self.assertEqual(name, words[1])
            self.assertEqual(cell.replace("µ", "u").split(), words[5:8])
        first = self.ask("document.querySelector('main section').id")
        last = self.ask("[...document.querySelectorAll('main > section')].at(-1).id")
        self.assertEqual((first, last), ("verdict", "about"))
        self.assertLess(self.ask("document.querySelector('#verdict tr.best').getBoundingClientRect().top"), 500)

    def test_tables_sort_by_value_and_lose_no_row(self):
        self.open()
        rows = "[...document.querySelectorAll('#cases tbody tr')]"
        place = self.ask("[...document.querySelectorAll('#cases thead th')].findIndex((t) => t.textContent === 'time')")
        values = f"{rows}.map((r) => Number(r.cells[{place}].dataset.v ?? Infinity)).filter(isFinite)"
        before = self.ask(values)
        self.assertNotEqual(before, sorted(before))
        button = f"document.querySelectorAll('#cases thead th')[{place}].querySelector('button')"
        self.browser.click(button)
        self.assertEqual(self.ask(values), sorted(before))
        self.assertEqual(self.ask(f"{button}.parentElement.getAttribute('aria-sort')"), "ascending")
        self.browser.click(button)
        self.assertEqual(self.ask(values), sorted(before, reverse=True))

    def test_filters_show_the_rows_asked_for(self):
        self.open()
        shown = "[...document.querySelectorAll('#cases tbody tr')].filter((r) => !r.hidden)"
        every = self.ask(f"{shown}.length")
        self.browser.click("document.querySelector('#cases .tools input')")
        self.browser.type("hat-lcp converged")
        texts = self.ask(f"{shown}.map((r) => r.textContent)")
        self.assertTrue(0 < len(texts) < every)
        self.assertTrue(all("hat-lcp" in text and "converged" in text for text in texts))
        self.assertEqual(self.ask("document.querySelector('#cases .tools output').value"), f"{len(texts)} of {every} rows")
        # The name of a method leads to its rows.
        self.browser.click("document.querySelector('#summary a[data-filter]')")
        name = self.ask("document.querySelector('#summary a[data-filter]').textContent")
        method = name.split("[")[0]
        texts = self.ask(f"{shown}.map((r) => r.textContent)")
        self.assertTrue(0 < len(texts) < every)
        self.assertTrue(all(method in text for text in texts))

    def test_no_column_is_empty_and_every_link_leads_somewhere(self):
        self.open()
        empty = self.ask("""[...document.querySelectorAll('main table')].flatMap((table) => [...table.tHead.rows[0].cells]
            .filter((title, c) => c > 0 && [...table.tBodies[0].rows].every((row) => /^(|-|–[^0-9]*)$/.test(row.cells[c].textContent)))
            .map((title) => `${table.caption.textContent}: ${title.textContent}`))""")
        self.assertEqual(empty, [])
        records = self.ask("ready.then((data) => data.records.length)")
        for target in self.ask("[...new Set([...document.querySelectorAll(\"a[href^='#']\")].map((a) => a.getAttribute('href').slice(1)))]"):
            if target.startswith("record-"):
                self.assertTrue(0 < int(target[7:]) <= records, target)
            else:
                self.assertTrue(self.ask(f"document.getElementById(decodeURIComponent({json.dumps(target)})) !== null"), target)

    # Figures

    def test_a_mark_tells_what_it_is_and_leads_to_its_record(self):
        self.open()
        self.see("small")
        self.browser.hover(MARK)
        self.assertFalse(self.ask("document.getElementById('hint').hidden"))
        name = self.ask("document.querySelector('#hint strong').textContent")
        # On another mark at the same place the nearest is meant; either is one of the scene.
        self.browser.click(MARK)
        self.browser.wait("document.getElementById('record').open")
        title = self.ask("document.getElementById('record-title').textContent")
        scene = self.ask(f"{MARK}.closest('figure').dataset.of")
        self.assertTrue(title.startswith(f"{scene}/"), title)
        self.assertTrue(name)
        record = json.loads(self.ask("document.querySelector('#record pre').textContent"))
        self.assertEqual(record["case"], title)
        where = [json.loads(line) for line in (self.pages[0].parent / "records.jsonl").read_text().splitlines()]
        kept = next(one for one in where if one["case"] == title)
        kept.pop("waveforms", None)
        self.assertEqual(record, kept)
        self.browser.press("Escape")
        self.browser.wait("!document.getElementById('record').open")
        self.assertNotIn("record-", self.ask("location.hash"))

    def test_a_method_switched_off_leaves_every_figure(self):
        self.open()
        self.see("small")
        name = "exact-orbit"
        key = f"[...document.querySelectorAll('.legend button')].find((b) => b.textContent === '{name}')"
        place = self.ask(f"{key}.dataset.key")
        visible = f"[...document.querySelectorAll('figure [data-c=\"{place}\"]')].filter((s) => s.getBoundingClientRect().width > 0).length"
        self.assertGreater(self.ask(visible), 2)
        self.browser.click(key)
        self.assertEqual(self.ask(f"{key}.getAttribute('aria-pressed')"), "false")
        self.assertEqual(self.ask(visible), 0)
        # In figures that are drawn later, too.
        self.see("work")
        self.assertEqual(self.ask(visible), 0)
        self.browser.click(key)
        self.assertGreater(self.ask(visible), 2)

    def test_figures_zoom_and_show_the_whole_again(self):
        self.open()
        figure = drawn("work")
        self.see("work")
        ticks = f"[...{figure}.querySelectorAll('.axis text')].map((t) => t.textContent).join()"
        places = f"[...{figure}.querySelectorAll('.mark')].map((m) => m.getAttribute('transform')).join()"
        before, at = self.ask(ticks), self.ask(places)
        self.browser.click(f"{figure}.querySelector('.zoom button')")
        self.assertNotEqual(self.ask(places), at)
        self.browser.press("+", 3)  # of the button that has the focus: nothing
        self.ask(f"{figure}.querySelector('svg').focus()")
        self.browser.press("+", 3)
        self.assertNotEqual(self.ask(ticks), before)
        self.browser.press("0")
        self.assertEqual((self.ask(ticks), self.ask(places)), (before, at))

    def test_motions_and_portraits_are_drawn(self):
        self.open(1)
        self.ask(f"{drawn('schematic')}.scrollIntoView()")
        self.browser.wait(f"{drawn('schematic')}.querySelector('svg path')")
        for kind, panels in (("waveforms", 4), ("portrait", 1), ("profile", 3)):
            figure = drawn(kind)
            self.see(kind)
            self.assertEqual(self.ask(f"{figure}.querySelectorAll('svg').length"), panels)
            shapes = self.ask(f"[...{figure}.querySelectorAll('.line')].map((p) => p.getAttribute('d'))")
            self.assertGreater(len(shapes), panels)
            self.assertFalse([shape for shape in shapes if "NaN" in shape or "Infinity" in shape])

    def test_the_stop_is_drawn_where_the_mass_turns(self):
        self.open(1)
        for kind, ends in (("waveforms", ("y1", "y2")), ("portrait", ("x1", "x2"))):
            self.see(kind)
            stop = f"{drawn(kind)}.querySelectorAll('.rule.stop')"
            self.assertEqual(self.ask(f"{stop}.length"), 1)
            at = [self.ask(f"Number({stop}[0].getAttribute('{end}'))") for end in ends]
            self.assertEqual(at[0], at[1])
            # The orbit touches it and does not pass: in pixels, downwards in the waveforms.
            corner = self.ask(f"(() => {{ const box = {drawn(kind)}.querySelector('.line.broad').getBBox();"
                              f" return {'box.y' if kind == 'waveforms' else 'box.x + box.width'}; }})()")
            self.assertAlmostEqual(corner, at[0], delta=1.5)

    # Keyboard, screen readers, colours, sizes

    def test_a_keyboard_gets_everywhere(self):
        self.open()
        self.browser.press("Tab")
        self.assertEqual(self.ask("document.activeElement.className"), "skip")
        self.browser.press("Enter")
        self.assertEqual(self.ask("document.activeElement.id"), "main")
        met = []
        for _ in range(400):
            self.browser.press("Tab")
            met.append(self.ask("document.activeElement.matches('figure svg')"))
            if met[-1]:
                break
        self.assertTrue(met[-1], "no figure gets the focus")
        outline = self.ask("getComputedStyle(document.activeElement).outlineStyle")
        self.assertEqual(outline, "solid", "the focus is not seen")
        self.browser.press("ArrowRight", 2)
        self.assertTrue(self.ask("document.activeElement.matches('.mark')"))
        self.assertFalse(self.ask("document.getElementById('hint').hidden"))
        title = self.ask("document.activeElement.getAttribute('aria-label')").split(": ")[0]
        self.browser.press("Enter")
        self.browser.wait("document.getElementById('record').open")
        self.assertTrue(self.ask("document.getElementById('record-title').textContent").endswith(f"/{title}"))
        self.browser.press("Escape")
        self.browser.wait("!document.getElementById('record').open")
        self.assertTrue(self.ask("document.activeElement.matches('.mark')"), "the focus does not come back")

    def test_it_is_accessible_in_light_and_dark_wide_and_on_a_phone(self):
        for dark in (False, True):
            for size in (WIDE, PHONE):
                with self.subTest(dark=dark, size=size):
                    self.open(1, width=size[0], height=size[1], dark=dark, phone=size == PHONE)
                    for kind in ("small", "work", "waveforms"):
                        self.see(kind)
                    self.assertLessEqual(self.ask("document.documentElement.scrollWidth"), size[0], "wider than the window")
                    self.assertEqual(self.ask("matchMedia('(prefers-color-scheme: dark)').matches"), dark)
                    if PICTURES:
                        name = f"{'dark' if dark else 'light'}-{size[0]}"
                        self.ask("scrollTo(0, 0)")
                        self.browser.picture(f"{PICTURES}/{name}-top.png")
                        for kind in ("side-by-side", "scene-sdof-stop", "means-1", "about"):
                            self.ask(f"document.getElementById('{kind}').scrollIntoView()")
                            self.ask("new Promise((resume) => setTimeout(resume, 200))")
                            self.browser.picture(f"{PICTURES}/{name}-{kind}.png")
                    without_repetitions(self.browser)
                    self.assertEqual(findings_of_ours(self.browser), [])
                    if AXE and dark == (size == PHONE):  # either of each; it takes its time
                        self.assertEqual(findings_of_axe(self.browser, AXE), [])

    def test_a_phone_keeps_the_first_column_in_sight(self):
        self.open(1, width=PHONE[0], height=PHONE[1], phone=True)
        place = """(() => { const t = document.querySelector('#summary .table'); t.scrollIntoView(); t.scrollLeft = 300;
            return [t.scrollLeft, t.querySelector('tbody th').getBoundingClientRect().left - t.getBoundingClientRect().left]; })()"""
        scrolled, left = self.ask(place)
        self.assertGreater(scrolled, 50)
        self.assertAlmostEqual(left, 0, delta=1)

    def test_text_of_strangers_stays_text(self):
        self.open(2)
        places = self.ask("ready.then((data) => data.records.map((r) => JSON.parse(r).message))")
        self.assertEqual(places, [STRANGE] * len(places))
        self.ask("location.hash = '#record-1'")
        self.browser.wait("document.getElementById('record').open")
        self.assertIn(STRANGE, self.ask("document.getElementById('record-facts').textContent"))
        self.assertEqual(json.loads(self.ask("document.querySelector('#record pre').textContent"))["message"], STRANGE)
        self.assertEqual(self.ask("document.querySelectorAll('img, iframe').length"), 0)
        self.assertTrue(self.ask("document.title").endswith("- signorini"))

    def test_the_policy_of_the_page_keeps_scripts_of_strangers_out(self):
        # What would run if the page let it: the policy names our scripts alone.
        self.open()
        self.ask("document.body.insertAdjacentHTML('beforeend', '<img src=x onerror=\"document.title = 1\">')")
        self.ask("(() => { const s = document.createElement('script'); s.textContent = 'document.title = 2'; document.body.append(s); })()")
        self.ask("new Promise((resume) => setTimeout(resume, 100))")
        self.assertTrue(self.ask("document.title").endswith("- signorini"))
        self.assertTrue(self.browser.complaints)
        self.browser.complaints.clear()
        self.browser.requests.clear()

    def test_the_page_of_the_article_is_below_two_megabytes(self):
        self.assertLess(self.pages[1].stat().st_size, 2e6)


def strange_page(work):
    """The page of a few records whose messages would run if they were taken for HTML or script."""
    strange = work / "strange"
    strange.mkdir()
    with open(Path(RUNS[0]) / "records.jsonl", encoding="utf-8") as lines, open(strange / "records.jsonl", "w", encoding="utf-8") as kept:
        for line in list(lines)[:6]:
            kept.write(json.dumps({**json.loads(line), "message": STRANGE}) + "\n")
    subprocess.run([SIGNORINI, "report", str(strange), "--format", "html"], check=True, stdout=subprocess.DEVNULL)
    return strange / "report.html"


def main():
    if shutil.which("chromium") is None:
        print("skipped: chromium is not installed")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as work:
        for run in RUNS:
            copy = Path(work) / Path(run).name
            shutil.copytree(run, copy, ignore=shutil.ignore_patterns("figures", "tables", "report.html"))
            subprocess.run([SIGNORINI, "report", str(copy), "--format", "html"], check=True, stdout=subprocess.DEVNULL)
            Page.pages.append(copy / "report.html")
        Page.pages.append(strange_page(Path(work)))
        Responses.pages.append(responses_page(SIGNORINI, Path(work)))
        Responses.axe, Responses.pictures = AXE, PICTURES
        try:
            Page.browser = Responses.browser = Browser()
        except (ConnectionError, BrokenPipeError, TimeoutError) as problem:
            print(f"skipped: chromium does not start here: {problem}")
            sys.exit(77)
        print("axe-core:", AXE or "not there; the checks of accessibility.py alone")
        try:
            unittest.main(argv=["page_test.py", *WORDS], verbosity=2)
        finally:
            Page.browser.close()


WORDS = [word for word in sys.argv[1:] if word.startswith(("Page", "Responses"))]
SIGNORINI, *RUNS = [word for word in sys.argv[1:] if word not in WORDS]
AXE = os.environ.get("AXE") if Path(os.environ.get("AXE") or "/none").is_file() else None
PICTURES = os.environ.get("PICTURES")

if __name__ == "__main__":
    main()
