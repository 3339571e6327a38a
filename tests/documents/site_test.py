#!/usr/bin/env python3
"""The site of README.md and docs/: it builds without a warning, and every link and picture of its pages leads somewhere.

    site_test.py TREE"""

import html.parser
import shutil
import subprocess
import sys
import tempfile
import urllib.parse
from pathlib import Path

TREE = Path(sys.argv[1])
PACKAGES = "python3-sphinx python3-myst-parser furo python3-numpy"


class Page(html.parser.HTMLParser):
    """What a page links to, and what of it may be linked to."""

    def __init__(self, text):
        super().__init__()
        self.links, self.anchors = set(), set()
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        for name, value in attrs:
            if name in ("href", "src") and value:
                self.links.add(value)
            elif name in ("id", "name") and value:
                self.anchors.add(value)


def broken_links(site):
    """Links of the pages below a folder that lead to no file or no anchor of it; those to servers are not followed."""
    pages = {path.resolve(): Page(path.read_text(encoding="utf-8")) for path in site.rglob("*.html")}
    for path, page in sorted(pages.items()):
        for link in sorted(page.links):
            place = urllib.parse.urlsplit(link)
            if place.scheme or place.netloc:
                continue
            target = (path.parent / urllib.parse.unquote(place.path)).resolve() if place.path else path
            if not target.is_file():
                yield f"{path.relative_to(site)}: there is no {link}"
            elif place.fragment and target in pages and urllib.parse.unquote(place.fragment) not in pages[target].anchors:
                yield f"{path.relative_to(site)}: {link} has no such heading"


def build(site, cache, *options):
    command = ["sphinx-build", "-q", "-c", TREE / "docs/site", "-d", cache, *options, TREE, site]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def main():
    interpreter = Path(shutil.which("sphinx-build") or "/").resolve()
    needs = ["/usr/bin/python3", "-c", "import sphinx, myst_parser, furo, numpy"]
    if not interpreter.is_file() or subprocess.run(needs, capture_output=True, check=False).returncode != 0:
        print(f"skipped: the generator of the site is not installed ({PACKAGES})")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        planted = Path(folder) / "planted"
        planted.mkdir()
        (planted / "a.html").write_text('<p id="x"><a href="b.html#y"></a><a href="c.html"></a><a href="b.html#z"></a><img src="d.svg"></p>')
        (planted / "b.html").write_text('<p id="y"><a href="a.html#x"></a><a href="https://example.org/q"></a></p>')
        found = list(broken_links(planted.resolve()))
        if found != ["a.html: b.html#z has no such heading", "a.html: there is no c.html", "a.html: there is no d.svg"]:
            sys.exit(f"broken links that were planted, and what is found: {found}")
        site = (Path(folder) / "site").resolve()
        done = build(site, Path(folder) / "cache", "-W", "--keep-going")
        if done.returncode != 0:
            sys.exit(f"the site does not build without warnings:\n{done.stdout}{done.stderr}")
        wrong = list(broken_links(site))
        index = (site / "index.html").read_text(encoding="utf-8")
        wrong += [f"index.html: no {what}" for what in ("docs/tutorial.html", "docs/python-reference.html", "docs/decisions/README.html", "search.html")
                  if what not in index]
        if "signorini.Scene.sweep" not in (site / "docs/python-reference.html").read_text(encoding="utf-8"):
            wrong.append("docs/python-reference.html: no Scene.sweep")
        if wrong:
            sys.exit("\n".join(wrong))
    print("the site holds")


if __name__ == "__main__":
    main()
