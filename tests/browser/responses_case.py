"""What a reader does with the page of a folder of responses."""

import json
import subprocess
from pathlib import Path

from accessibility import findings_of_axe, findings_of_ours, without_repetitions
from page_case import PHONE, WIDE, PageCase, drawn


class Responses(PageCase):
    """The page of a folder of responses."""

    browser, pages, axe, pictures = None, [], None, None

    def test_the_verdict_comes_first_and_recommends_nothing_of_one_response(self):
        self.open()
        self.assertEqual(self.ask("document.querySelector('main section').id"), "response-verdict")
        rows = self.ask("[...document.querySelectorAll('#response-verdict tbody tr')].map((r) => [...r.cells].map((c) => c.textContent))")
        self.assertEqual(rows[0][:2], ["Rigid stop (e = 1), 1 response", "too few scenes to recommend"])
        self.assertEqual(self.ask("document.querySelectorAll('#responses tbody tr').length"), 3 * len(rows))

    def test_branches_are_drawn_by_stability_with_special_points(self):
        self.open()
        self.see("response")
        shapes = self.ask(f"[...{drawn('response')}.querySelectorAll('.line')].map((p) => p.getAttribute('d'))")
        self.assertFalse([shape for shape in shapes if "NaN" in shape or "Infinity" in shape])
        for line, dashed in (("stable", False), ("unstable", True)):
            self.assertTrue(self.ask(f"[...{drawn('response')}.querySelectorAll('.line.broad')].some((p) => p.hasAttribute('stroke-dasharray') === {str(dashed).lower()})"), line)
        # Every special point of the record is a mark that says what it is.
        marks = self.ask(f"[...{drawn('response')}.querySelectorAll('.orbit .mark')].map((m) => m.getAttribute('aria-label'))")
        kept = [json.loads(line) for line in (self.pages[0].parent / "records.jsonl").read_text().splitlines()]
        scene = self.ask(f"{drawn('response')}.dataset.of")
        exact = next(one["response"] for one in kept if one["case"] == f"{scene}/exact response")
        self.assertEqual([mark.split(",")[1].split(":")[0].strip() for mark in marks], [point["kind"] for point in exact["located"]])
        self.assertTrue(self.ask(f"{drawn('response')}.querySelectorAll('.kinds span').length") >= len(set(p["kind"] for p in exact["located"])))

    def test_hovering_tells_values_and_a_click_opens_the_record(self):
        self.open()
        self.see("response")
        mark = f"{drawn('response')}.querySelector('.orbit .mark')"
        self.browser.hover(mark)
        self.assertFalse(self.ask("document.getElementById('hint').hidden"))
        self.assertRegex(self.ask("document.getElementById('hint').textContent"), r"rad/s, amplitude [0-9.]+ m")
        self.browser.click(mark)
        self.browser.wait("document.getElementById('record').open")
        record = json.loads(self.ask("document.querySelector('#record pre').textContent"))
        self.assertEqual(record["scene"], self.ask(f"{drawn('response')}.dataset.of"))
        self.assertNotIn("branches", record["response"])
        self.browser.press("Escape")

    def test_every_method_can_be_switched_off(self):
        self.open()
        self.see("response")
        keys = self.ask("[...document.querySelector('.legend').querySelectorAll('[data-key]')].map((b) => [b.dataset.key, b.textContent])")
        self.assertEqual(len(keys), 3)
        for place, name in keys:
            shown = f"[...{drawn('response')}.querySelectorAll('[data-c=\"{place}\"]')].filter((s) => s.getBoundingClientRect().width > 0).length"
            self.assertGreater(self.ask(shown), 0, name)
            key = f"document.querySelector('.legend [data-key=\"{place}\"]')"
            self.browser.click(key)
            self.assertEqual(self.ask(shown), 0, name)
        # What is left is the exact response.
        self.assertGreater(self.ask(f"[...{drawn('response')}.querySelectorAll('.orbit')].filter((s) => s.getBoundingClientRect().width > 0).length"), 0)

    def test_the_table_stands_beside_and_its_numbers_lead_to_records(self):
        self.open(width=WIDE[0], height=WIDE[1])
        self.see("response")
        figure, table = (self.ask(f"(() => {{ const b = document.querySelector('.beside {what}').getBoundingClientRect(); return [b.left, b.right, b.top, b.bottom]; }})()")
                         for what in ("figure", ".table"))
        self.assertLessEqual(figure[1], table[0])
        self.assertLess(table[2], figure[3])
        for target in self.ask("[...new Set([...document.querySelectorAll(\"a[href^='#']\")].map((a) => a.getAttribute('href').slice(1)))]"):
            if not target.startswith("record-"):
                self.assertTrue(self.ask(f"document.getElementById(decodeURIComponent({json.dumps(target)})) !== null"), target)
        self.browser.click("document.querySelector('.beside td a[href^=\"#record-\"]')")
        self.browser.wait("document.getElementById('record').open")
        name = self.ask("document.querySelector('.beside tbody th a').textContent")
        scene = self.ask(f"{drawn('response')}.dataset.of")
        self.assertEqual(self.ask("document.getElementById('record-title').textContent"), f"{scene}/{name} by arc length")
        self.browser.press("Escape")

    def test_it_is_accessible_in_light_and_dark_wide_and_on_a_phone(self):
        for dark in (False, True):
            for size in (WIDE, PHONE):
                with self.subTest(dark=dark, size=size):
                    self.open(width=size[0], height=size[1], dark=dark, phone=size == PHONE)
                    self.see("response")
                    self.assertLessEqual(self.ask("document.documentElement.scrollWidth"), size[0], "wider than the window")
                    if self.pictures:
                        name = f"responses-{'dark' if dark else 'light'}-{size[0]}"
                        for kind in ("response-verdict", "scene-sdof-stop", "cases"):
                            self.ask(f"document.getElementById('{kind}').scrollIntoView()")
                            self.ask("new Promise((resume) => setTimeout(resume, 200))")
                            self.browser.picture(f"{self.pictures}/{name}-{kind}.png")
                    without_repetitions(self.browser)
                    self.assertEqual(findings_of_ours(self.browser), [])
                    if self.axe and dark == (size == PHONE):
                        self.assertEqual(findings_of_axe(self.browser, self.axe), [])


def responses_page(program, work):
    """The page of a short run of responses."""
    folder = work / "responses"
    suite = Path(__file__).with_name("responses.toml")
    subprocess.run([program, "run", str(suite), "--out", str(folder)], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    subprocess.run([program, "report", str(folder), "--format", "html"], check=True, stdout=subprocess.DEVNULL)
    return folder / "report.html"
