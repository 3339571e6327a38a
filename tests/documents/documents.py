"""What the pages and the bibliography must hold; each check yields one line per offence, "file: what"."""

import json
import posixpath
import re

CITED_IN = (".hpp", ".cpp", ".md", ".toml", ".py", ".in")
ENTRY = re.compile(r"^@\w+\{([^,\s]+),", re.M)
CITATION = re.compile(r"\[([a-z]+\d{4}[a-z]?)(?:, [^\]]*)?\]")
MEMBERS = re.compile(r"\b(?:TEST|TEST_F|TEST_P)\((\w+),\s*(\w+)\)")


# Phrases that once stood in tables, pages and messages, and that a reader had to guess at.
PRIVATE = re.compile(r"ranks? nobody|against nobody|nobody solves|nobody's (?:loss|gain)|earns no time|(?:own|their) kin\b|went otherwise|"
                     r"what became of every|only then a time|do not get there|\bis told in\b|from a second side|refutes none|left to itself|"
                     r"[\"'`]there[\"'`]", re.I)


# Habits that make a reader go over a sentence twice, refused where users read: pages, help, screens and reports.
HABITS = re.compile(r"\bof several,|\b(?:is|are) asked (?:for|of)\b|\b(?:that|what|which) (?:is|are) none\b|\bleaves? open\b|\bnobody\b|\bsays nothing\b|"
                    r"\bhollow ones\b|\btime grows with\b|\bcontacts? feels?\b|\bwhich represents? the law\b|\bwhich alone\b|\bcount once:|"
                    r"\blead to orders\b|\bis no such\b|\b(?:is|are) at hand\b|\bwent otherwise\b", re.I)
LITERAL = re.compile(r'R"(\w*)\((.*?)\)\1"|"((?:\\.|[^"\\\n])*)"', re.S)


def habit_offences(texts):
    """Such habits in pages, and in the literals of C++ sources."""
    for path, text in texts.items():
        if not path.endswith(".md"):
            text = re.sub(r'"\s*\n\s*"', "", re.sub(r"^\s*//.*$", "", text, flags=re.M))
            text = " | ".join(match[2] or match[3] or "" for match in LITERAL.finditer(text))
        for match in HABITS.finditer(re.sub(r"\s*\n\s*", " ", text)):
            yield f"{path}: {match[0]!r}: say it plainly"


# Words that this project gives a meaning of its own: docs/glossary.md has them.
OWN_WORDS = re.compile(r"\b(certif(?:y|ies|ied)|refute[sd]?|unproven|ladders?|represent(?:s|ed)?)\b", re.I)
NO_PROSE = re.compile(r"^( *)```.*?^\1```$|^\|.*?$|<!--.*?-->|`[^`\n]*`|^#.*?$", re.M | re.S)


def own_word_offences(pages):
    """Such words, where a page first uses them in prose, that are neither linked nor set in emphasis with their meaning."""
    for path, text in pages.items():
        prose, seen = NO_PROSE.sub(" ", text), set()
        marked = [match.span() for match in re.finditer(r"\[[^\]]*\]\([^)]*\)|\*[^*\n]+\*", prose)]
        for match in OWN_WORDS.finditer(prose):
            root = match[1].lower()[:5]
            if root not in seen and not any(begin <= match.start() < end for begin, end in marked):
                yield f"{path}: {match[0]!r} is first used without a link to docs/glossary.md"
            seen.add(root)


def private_phrase_offences(texts):
    """Private phrases in texts, those broken over lines, comments or adjacent literals of a source included."""
    for path, text in texts.items():
        whole = re.sub(r'"\s*\n\s*"', "", text)
        whole = re.sub(r"\s*\n\s*(?:///? |# |\* |> )?", " ", whole)
        for match in PRIVATE.finditer(whole):
            yield f"{path}: {match[0]!r} is private English"


def bibliography_offences(bibliography, texts):
    """Keys of docs/references.bib that stand twice, that nothing cites, and citations without an entry."""
    keys = ENTRY.findall(bibliography)
    for key in sorted({key for key in keys if keys.count(key) > 1}):
        yield f"docs/references.bib: {key} stands {keys.count(key)} times"
    cited = {}
    for path, text in texts.items():
        for key in CITATION.findall(text):
            cited.setdefault(key, path)
    for key in sorted(set(keys) - set(cited)):
        yield f"docs/references.bib: nothing cites {key}"
    for key in sorted(set(cited) - set(keys)):
        yield f"{cited[key]}: [{key}] is not in docs/references.bib"


def field(text, key):
    """The value of a top-level key of a YAML file, on one line, without quotes."""
    match = re.search(rf"^{key}:[ \t]*(.*)$", text, re.M)
    return match[1].strip().strip("\"'") if match else None


def version_of(cmake):
    """The version of the project, which has its place in CMakeLists.txt."""
    return re.search(r"project\(signorini VERSION ([\d.]+)", cmake)[1]


def version_offences(cmake, package, changelog):
    """The Python package's version, and the newest of the changelog, against that of the project."""
    version = version_of(cmake)
    told = re.search(r'^__version__ = "(.*)"$', package, re.M)
    if told is None or told[1] != version:
        yield f"python/signorini/__init__.py: __version__ is {told and told[1]}: must be {version}"
    released = re.search(r"^## \[([\d.]+)\] - \d{4}-\d\d-\d\d$", changelog, re.M)
    if released is None or released[1] != version:
        yield f"CHANGELOG.md: the newest version with its date is {released and released[1]}: must be {version}"


def paper_offences(paper, bibliography, references):
    """docs/paper: keys that are cited and not there, that nothing cites, and entries that docs/references.bib has otherwise."""
    cited = set(re.findall(r"@([a-z]+\d{4}[a-z]?)\b", paper))
    keys = ENTRY.findall(bibliography)
    for key in sorted(cited - set(keys)):
        yield f"docs/paper/paper.md: [@{key}] is not in docs/paper/paper.bib"
    for key in sorted(set(keys) - cited):
        yield f"docs/paper/paper.bib: nothing cites {key}"
    same = {ENTRY.match(entry)[1]: entry for entry in re.findall(r"^@.*?^\}$", references, re.M | re.S)}
    for entry in re.findall(r"^@.*?^\}$", bibliography, re.M | re.S):
        key = ENTRY.match(entry)[1]
        if same.get(key, entry) != entry:
            yield f"docs/paper/paper.bib: {key} is another entry than in docs/references.bib"


def citation_offences(citation, cmake, licence):
    """CITATION.cff against the version of CMakeLists.txt and the licence."""
    expected = {
        "cff-version": "1.2.0",
        "version": version_of(cmake),
        "license": "BSD-3-Clause" if licence.startswith("BSD 3-Clause License") else None,
    }
    for key, value in expected.items():
        if field(citation, key) != value:
            yield f"CITATION.cff: {key} is {field(citation, key)}: must be {value}"
    for key in ("message", "title", "authors", "date-released", "abstract", "type"):
        if field(citation, key) is None:
            yield f"CITATION.cff: {key} is missing"


def numbers_of(theory):
    """The numbers of the displayed equations and in the tables of docs/theory.md, in their order."""
    found = (re.search(r"\\tag\{(\d+)\}|^\| \((\d+)\) \|", line) for line in theory.splitlines())
    return [int(match[1] or match[2]) for match in found if match]


def theory_offences(theory):
    numbers = numbers_of(theory)
    if numbers != list(range(1, len(numbers) + 1)):
        yield f"docs/theory.md: equations are numbered {numbers}: must be 1, 2, 3, .."


def coexistence_offences(theory, orbit_files):
    """The count of scenes with several orbits, and of all, that the page gives."""
    several = sum(len(json.loads(text)["orbits"]) > 1 for text in orbit_files.values())
    if f"{several} of the {len(orbit_files)} scenes" not in " ".join(theory.split()):
        yield f"docs/theory.md: several orbits are kept for {several} of the {len(orbit_files)} scenes: it must say so"


def nearness_offences(theory, files):
    """What the page calls nearby is what the code does."""
    values = re.findall(r"constexpr double kNearOrbit = ([\d.]+);", "".join(files.values()))
    for value in values or ["(no kNearOrbit in the tree)"]:
        if f"at most {value} (`kNearOrbit`)" not in " ".join(theory.split()):
            yield f"docs/theory.md: nearby must be a distance of at most {value} (`kNearOrbit`)"


README_WORDS = 900


def length_offences(readme):
    """The first page is for strangers: at most README_WORDS words, as wc counts them."""
    if (words := len(readme.split())) > README_WORDS:
        yield f"README.md: {words} words: must be at most {README_WORDS}; the rest belongs in docs"


def rows_of(page):
    """Cells of the rows of a page's tables whose first cell is a number in parentheses, by that number."""
    for line in page.splitlines():
        cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        if cells and re.fullmatch(r"\((\d+)\)", cells[0]):
            yield int(cells[0][1:-1]), cells


def section(page, title):
    """The text under a heading of the second level."""
    match = re.search(rf"^## {re.escape(title)}\n(.*?)(?=^## |\Z)", page, re.M | re.S)
    return match[1] if match else ""


def named_files(text):
    """Paths from the root in backticks."""
    return re.findall(r"`((?:problems|methods|harness|tests|docs)/[^`\s]*)`", text)


def crosswalk_offences(page, theory, files):
    """docs/source-paper.md: each of the 55 equations once, with files, names in those files and numbers that exist."""
    table = list(rows_of(section(page, "Crosswalk")))
    numbers = [number for number, _ in table]
    if numbers != list(range(1, 56)):
        yield f"docs/source-paper.md: the crosswalk has rows {numbers}: must be 1 to 55"
    known = set(numbers_of(theory))
    for number, cells in table:
        row = f"docs/source-paper.md: equation ({number})"
        for target in re.findall(r"\((\d+)\)", cells[2]):
            if int(target) not in known:
                yield f"{row}: theory.md has no ({target})"
        paths = named_files(cells[3])
        for path in paths:
            if path not in files:
                yield f"{row}: there is no {path}"
        text = "".join(files.get(path, "") for path in paths)
        for name in re.findall(r"`(\w+)`", cells[3]):
            if not re.search(rf"\b{name}\b", text):
                yield f"{row}: {name} is not in {' or '.join(paths)}"
    yield from misprint_offences(page, files)
    for path in named_files(page):
        if path not in files and not any(other.startswith(path) for other in files):
            yield f"docs/source-paper.md: there is no {path}"


def misprint_offences(page, files):
    """Every row of the table of misprints names tests that exist, or says that there is none."""
    tests = {f"{suite}.{name}" for path, text in files.items() if path.startswith("tests/")
             for suite, name in MEMBERS.findall(text)}
    listed = [number for number, _ in rows_of(section(page, "Misprints"))]
    wrong = [number for number, cells in rows_of(section(page, "Crosswalk")) if cells[4] != "right"]
    if listed != wrong:
        yield f"docs/source-paper.md: the misprints are {listed}, in the crosswalk {wrong}"
    for number, cells in rows_of(section(page, "Misprints")):
        names = re.findall(r"`(\w+\.\w+)`", cells[-1])
        if not names and not cells[-1].startswith("none"):
            yield f"docs/source-paper.md: misprint ({number}) names no test"
        for name in names:
            if name not in tests:
                yield f"docs/source-paper.md: misprint ({number}): there is no test {name}"


def link_offences(pages, exists):
    """Links of Markdown pages (path from the root -> text) that lead to no file and no heading.

    exists(path) says whether a file or folder of that path is there."""
    for path, text in sorted(pages.items()):
        for link in re.findall(r"\]\(([^)\s]+)\)", text):
            if re.match(r"\w+:", link):
                continue  # elsewhere
            name, _, heading = link.partition("#")
            target = posixpath.normpath(posixpath.join(posixpath.dirname(path), name)) if name else path
            if not exists(target):
                yield f"{path}: there is no {link}"
            elif heading and target in pages and heading not in headings(pages[target]):
                yield f"{path}: {target} has no heading #{heading}"


def headings(text):
    """The anchors that GitHub gives to the headings of a page."""
    return {re.sub(r"[^\w\- ]", "", title.lower()).strip().replace(" ", "-") for title in re.findall(r"^#+ (.*)$", text, re.M)}
