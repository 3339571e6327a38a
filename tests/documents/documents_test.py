"""The checks of documents.py on this tree, and on small texts in which each offence is planted."""

import pathlib
import re
import unittest

import documents

ROOT = pathlib.Path(__file__).resolve().parents[2]
PARTS = ("problems", "methods", "harness", "tests", "docs", "examples")


def texts():
    """Path from the root -> text, of what may cite or be named."""
    paths = [path for part in PARTS for path in (ROOT / part).rglob("*") if path.suffix in documents.CITED_IN]
    found = {path.relative_to(ROOT).as_posix(): path.read_text() for path in paths if path.name != "documents_test.py"}
    return {**found, **{path.name: path.read_text() for path in ROOT.glob("*.md")}}


def read(path):
    return (ROOT / path).read_text()


class Tree(unittest.TestCase):
    def expect_none(self, offences):
        self.assertEqual(list(offences), [])

    def test_every_key_of_the_bibliography_stands_once_and_is_cited(self):
        self.expect_none(documents.bibliography_offences(read("docs/references.bib"), texts()))

    def test_the_citation_file_has_version_and_licence_of_the_project(self):
        self.expect_none(documents.citation_offences(read("CITATION.cff"), read("CMakeLists.txt"), read("LICENSE")))

    def test_there_is_one_version(self):
        self.expect_none(documents.version_offences(read("CMakeLists.txt"), read("python/signorini/__init__.py"), read("CHANGELOG.md")))

    def test_the_paper_cites_what_its_bibliography_has(self):
        self.expect_none(documents.paper_offences(read("docs/paper/paper.md"), read("docs/paper/paper.bib"), read("docs/references.bib")))

    def test_equations_of_the_theory_are_numbered_without_gaps(self):
        self.expect_none(documents.theory_offences(read("docs/theory.md")))

    def test_the_theory_counts_the_scenes_with_several_orbits(self):
        kept = {path.stem: path.read_text() for path in (ROOT / "results/references").glob("*.json")}
        self.expect_none(documents.coexistence_offences(read("docs/theory.md"), kept))

    def test_the_theory_says_what_nearby_is(self):
        self.expect_none(documents.nearness_offences(read("docs/theory.md"), texts()))

    def test_pictures_draw_outside_a_browser(self):
        pictures = list((ROOT / "docs/pictures").rglob("*.svg"))
        self.assertGreater(len(pictures), 15)
        self.assertEqual([path.name for path in pictures if re.search(r"var\(--|[{;]--", path.read_text())], [])

    def test_the_first_page_is_short(self):
        self.expect_none(documents.length_offences(read("README.md")))

    def test_the_crosswalk_has_all_equations_of_the_source_paper(self):
        self.expect_none(documents.crosswalk_offences(read("docs/source-paper.md"), read("docs/theory.md"), texts()))

    def test_every_link_of_a_page_leads_somewhere(self):
        pages = {path.relative_to(ROOT).as_posix(): path.read_text() for path in [*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")]}
        self.assertGreater(len(pages), 40)
        self.expect_none(documents.link_offences(pages, lambda path: (ROOT / path).exists()))

    def test_nothing_that_is_read_holds_private_phrases(self):
        paths = [path for part in ("problems", "methods", "harness", "docs", "examples", "python", "results")
                 for path in (ROOT / part).rglob("*") if path.suffix in (*documents.CITED_IN, ".js", ".tex", ".ipynb")]
        read_by_people = {path.relative_to(ROOT).as_posix(): path.read_text() for path in [*paths, *ROOT.glob("*.md"), ROOT / "bench"]
                          if "results/local" not in path.as_posix()}
        self.assertGreater(len(read_by_people), 500)
        self.expect_none(documents.private_phrase_offences(read_by_people))


    def test_what_users_read_is_plain(self):
        pages = [*ROOT.glob("docs/*.md"), ROOT / "README.md", ROOT / "CONTRIBUTING.md"]
        sources = [path for part in ("commands", "terminal", "report", "plots") for path in (ROOT / "harness" / part).rglob("*.[ch]pp")]
        self.assertGreater(len(sources), 100)
        self.expect_none(documents.habit_offences({path.relative_to(ROOT).as_posix(): path.read_text() for path in [*pages, *sources]}))


    def test_words_of_ours_are_linked_where_they_come_first(self):
        pages = ("README", "docs/tutorial", "docs/gallery", "docs/troubleshooting", "docs/units", "docs/results", "docs/methods", "docs/responses",
                 "docs/running", "docs/motions", "docs/python")
        self.expect_none(documents.own_word_offences({f"{page}.md": read(f"{page}.md") for page in pages}))


class Planted(unittest.TestCase):
    def expect(self, offences, *lines):
        self.assertEqual(list(offences), list(lines))

    def test_private_phrases_on_one_line_over_two_and_in_split_literals(self):
        self.expect(documents.private_phrase_offences({"a.md": "It Ranks nobody.", "b.hpp": "/// What became of\n/// every run", "c.cpp":
                                                       'f("a scene that nobody "\n      "solves counts");', "d.md": "Nobody is told."}),
                    "a.md: 'Ranks nobody' is private English", "b.hpp: 'What became of every' is private English",
                    "c.cpp: 'nobody solves' is private English")

    def test_habits_on_pages_and_in_literals_alone(self):
        self.expect(documents.habit_offences({"a.md": "the fastest and,\nof several, the first", "b.cpp": '// nobody\nf("what is"\n  " asked for"); // nobody'}),
                    "a.md: 'of several,': say it plainly", "b.cpp: 'is asked for': say it plainly")

    def test_a_word_of_ours_without_a_link(self):
        self.expect(documents.own_word_offences({"a.md": "`ladder` and [certified](glossary.md), certified.\n```sh\nrefuted\n```\nA *ladder*. Refuted!"}),
                    "a.md: 'Refuted' is first used without a link to docs/glossary.md")

    def test_a_key_that_stands_twice(self):
        self.expect(documents.bibliography_offences("@book{a2001,\n}\n@article{a2001,\n}\n", {"x.md": "[a2001]"}),
                    "docs/references.bib: a2001 stands 2 times")

    def test_a_key_that_nothing_cites_and_a_citation_without_entry(self):
        self.expect(documents.bibliography_offences("@book{a2001,\n}\n", {"x.md": "[b2002, section 3]"}),
                    "docs/references.bib: nothing cites a2001", "x.md: [b2002] is not in docs/references.bib")

    def test_a_first_page_that_is_too_long(self):
        self.expect(documents.length_offences("word " * 901), "README.md: 901 words: must be at most 900; the rest belongs in docs")

    def test_a_link_to_nothing(self):
        pages = {"README.md": "[a](docs/a.md#its-part) [b](docs/b.md) [c](https://example.org/x)", "docs/a.md": "# Its part\n[r](../README.md#gone)"}
        self.expect(documents.link_offences(pages, pages.__contains__),
                    "README.md: there is no docs/b.md", "docs/a.md: README.md has no heading #gone")

    def test_another_version(self):
        citation = ("cff-version: 1.2.0\nmessage: m\ntitle: t\nabstract: a\ntype: software\nauthors:\n  - name: n\n"
                    "version: 0.2.0\ndate-released: 2026-01-01\nlicense: BSD-3-Clause\n")
        self.expect(documents.citation_offences(citation, "project(signorini VERSION 0.1.0", "BSD 3-Clause License"),
                    "CITATION.cff: version is 0.2.0: must be 0.1.0")

    def test_a_package_and_a_changelog_of_another_version(self):
        project, package = "project(signorini VERSION 0.2.0", '__version__ = "0.2.0"\n'
        self.expect(documents.version_offences(project, package, "## [Unreleased]\n## [0.2.0] - 2026-01-01\n## [0.1.0] - 2025-01-01\n"))
        self.expect(documents.version_offences(project, '__version__ = "0.1.0"\n', "## [Unreleased]\n\n## [0.2.0]\n"),
                    "python/signorini/__init__.py: __version__ is 0.1.0: must be 0.2.0",
                    "CHANGELOG.md: the newest version with its date is None: must be 0.2.0")

    def test_a_paper_whose_citations_and_bibliography_differ(self):
        self.expect(documents.paper_offences("[@a2001; @b2002]", "@book{a2001,\n  year = {2001}\n}\n@book{c2003,\n}\n",
                                             "@book{a2001,\n  year = {2002}\n}\n"),
                    "docs/paper/paper.md: [@b2002] is not in docs/paper/paper.bib", "docs/paper/paper.bib: nothing cites c2003",
                    "docs/paper/paper.bib: a2001 is another entry than in docs/references.bib")

    def test_an_equation_that_is_skipped(self):
        self.expect(documents.theory_offences("```math\na = b \\tag{1}\n```\n| (3) | x |\n"),
                    "docs/theory.md: equations are numbered [1, 3]: must be 1, 2, 3, ..")

    def test_a_count_that_is_not_that_of_the_orbits_kept(self):
        kept = {"a": '{"orbits": [1, 2]}', "b": '{"orbits": [1]}'}
        self.expect(documents.coexistence_offences("for 2 of the\n2 scenes", kept),
                    "docs/theory.md: several orbits are kept for 1 of the 2 scenes: it must say so")

    def test_another_distance_for_nearby(self):
        files = {"methods/a.hpp": "inline constexpr double kNearOrbit = 0.1;"}
        self.expect(documents.nearness_offences("at most 0.5\n(`kNearOrbit`)", files),
                    "docs/theory.md: nearby must be a distance of at most 0.1 (`kNearOrbit`)")

    def crosswalk(self, change, misprint="| (2) | a | b | c | `Suite.Name` |"):
        rows = [f"| ({n}) | says | section 1, (1) | `methods/a.hpp`: `solve` | {'misprint' if n == 2 else 'right'} |"
                for n in range(1, 56)]
        page = "## Crosswalk\n" + "\n".join(change(rows)) + "\n## Misprints\n" + misprint + "\n"
        files = {"methods/a.hpp": "void solve();", "tests/a_test.cpp": "TEST(Suite, Name) {}"}
        return documents.crosswalk_offences(page, "```math\na = b \\tag{1}\n```\n", files)

    def test_a_crosswalk_without_offence(self):
        self.expect(self.crosswalk(lambda rows: rows))

    def test_an_equation_without_a_row(self):
        self.expect(self.crosswalk(lambda rows: rows[:54]),
                    f"docs/source-paper.md: the crosswalk has rows {list(range(1, 55))}: must be 1 to 55")

    def test_a_file_that_is_gone(self):
        self.expect(self.crosswalk(lambda rows: [rows[0].replace("a.hpp", "b.hpp"), *rows[1:]]),
                    "docs/source-paper.md: equation (1): there is no methods/b.hpp",
                    "docs/source-paper.md: equation (1): solve is not in methods/b.hpp",
                    "docs/source-paper.md: there is no methods/b.hpp")

    def test_a_function_that_has_another_name(self):
        self.expect(self.crosswalk(lambda rows: [rows[0].replace("solve", "resolve"), *rows[1:]]),
                    "docs/source-paper.md: equation (1): resolve is not in methods/a.hpp")

    def test_a_number_that_the_theory_does_not_have(self):
        self.expect(self.crosswalk(lambda rows: [rows[0].replace("section 1, (1)", "(9)"), *rows[1:]]),
                    "docs/source-paper.md: equation (1): theory.md has no (9)")

    def test_a_misprint_without_its_test(self):
        self.expect(self.crosswalk(lambda rows: rows, "| (2) | a | b | c | `Suite.Other` |"),
                    "docs/source-paper.md: misprint (2): there is no test Suite.Other")
        self.expect(self.crosswalk(lambda rows: rows, "| (2) | a | b | c | |"),
                    "docs/source-paper.md: misprint (2) names no test")

    def test_a_misprint_that_the_crosswalk_calls_right(self):
        self.expect(self.crosswalk(lambda rows: [*rows[:1], rows[1].replace("misprint", "right"), *rows[2:]]),
                    "docs/source-paper.md: the misprints are [2], in the crosswalk []")


if __name__ == "__main__":
    unittest.main()
