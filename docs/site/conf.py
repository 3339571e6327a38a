"""The pages of this project as a site, by Sphinx with MyST: `./bench site` (docs/running.md, decision 0060).

The sources are README.md and docs/ as they stand, and what they link to. What GitHub shows and Sphinx does not is
translated while a page is read: fences of `math`, links to folders and to large tables. The navigation is the lists of docs/README.md."""

import posixpath
import re
import shutil
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MATHJAX = Path("/usr/share/javascript/mathjax")
LINK = re.compile(r"(?<!!)\[((?:[^\[\]`]|`[^`]*`)+)\]\(([^)\s#]+)(#[^)\s]*)?\)")
FENCE = re.compile(r"^( *)```.*?^\1```$", re.M | re.S)

project = "signorini"
author = "The signorini developers"
version = release = re.search(r"project\(signorini VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]
language = "en"

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.mathjax"]
root_doc = "README"
include_patterns = ["README.md", "CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md", "docs/*.md", "docs/decisions/*.md", "examples/rivals/README.md"]
source_suffix = {".md": "markdown"}
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4
myst_update_mathjax = False
suppress_warnings = ["misc.highlighting_failure"]  # a block of TOML may end in "..."
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_SVG" if MATHJAX.is_dir() else "https://cdn.jsdelivr.net/npm/mathjax@2.7.9/MathJax.js?config=TeX-AMS_SVG"
html_theme = "furo"
html_title = f"signorini {release}"
html_copy_source = False
html_static_path = []
sys.path.insert(0, str(ROOT / "python"))
autodoc_mock_imports = ["scipy", "matplotlib", "pandas"]
autodoc_member_order = "bysource"
autodoc_typehints = "signature"


def navigation():
    """The lists of docs/README.md as (caption, pages)."""
    text = (ROOT / "docs/README.md").read_text(encoding="utf-8")
    for caption, items in re.findall(r"^\*\*(.+?)\*\*\n\n((?:[- ].*\n)+)", text, re.M):
        pages = [posixpath.normpath(posixpath.join("docs", target)) for _, target, _ in LINK.findall(items)]
        yield caption, [f"{page}/README.md" if (ROOT / page / "README.md").is_file() else page for page in pages]


def contents(caption, pages):
    lines = [f":caption: {caption}"] if caption else []
    return "\n".join(["", "```{toctree}", ":hidden:", *lines, "", *(f"/{page}" for page in pages), "```", ""])


def is_page(path):
    folder = posixpath.dirname(path)
    return path.endswith(".md") and any(posixpath.dirname(p) == folder and p in (path, posixpath.join(folder, "*.md")) for p in include_patterns)


def translated_link(match, folder):
    """A link as MyST takes it: a folder by its page, or else by its name; a Markdown file that is no page as a file to load."""
    words, target, heading = match[1], match[2], match[3] or ""
    if ":" in target:
        return match[0]
    path = posixpath.normpath(posixpath.join(folder, target))
    if (ROOT / path).is_dir():
        if is_page(f"{path}/README.md"):
            return f"[{words}]({target.rstrip('/')}/README.md{heading})"
        return words if words.strip("`") == path else f"{words} (`{path}`)"
    if path.endswith(".md") and not is_page(path):
        return f"{{download}}`{words.replace('`', '')} <{target}>`"
    return match[0]


def translated(docname, text):
    folder = posixpath.dirname(docname)
    parts, end = [], 0
    for fence in FENCE.finditer(text):
        parts.append(LINK.sub(lambda match: translated_link(match, folder), text[end:fence.start()]))
        block = fence[0]
        if block.lstrip().startswith("```math\n"):
            body = block.strip()[8:-3].rstrip().splitlines()
            lines = ["```{math}", ":nowrap: true", "", "\\begin{equation*}", *(line.strip() for line in body), "\\end{equation*}", "```"]
            block = "\n".join(fence[1] + line for line in lines)
        parts.append(block)
        end = fence.end()
    return "".join(parts) + LINK.sub(lambda match: translated_link(match, folder), text[end:])


def read(app, docname, source):
    text = translated(docname, source[0])
    if docname == root_doc:
        listed = list(navigation())
        named = {page for _, pages in listed for page in pages}
        listed = [(caption, [page for page in pages if is_page(page)]) for caption, pages in listed]
        text += contents("", ["docs/README.md"]) + "".join(contents(caption, pages) for caption, pages in listed)
        others = [p for p in ("CHANGELOG.md", "SECURITY.md", "examples/rivals/README.md") if p not in named]
        text += contents("Project", others)
    elif docname == "docs/decisions/README":
        pages = sorted((ROOT / "docs/decisions").glob("[0-9]*.md"))
        text += "\n".join(["", "```{toctree}", ":maxdepth: 1", "", *(page.name for page in pages), "```", ""])
    elif docname == "docs/python-reference":
        text += "\n```{eval-rst}\n.. automodule:: signorini\n   :members:\n   :imported-members:\n```\n"
    elif docname == "docs/reference" and app.config.cpp_reference:
        text += "\n```{raw} html\n<p><a href=\"cpp/index.html\">All public headers</a></p>\n```\n"
    source[0] = text


def finish(app, exception):
    """The first page under the name that servers look for, Doxygen's pages, and MathJax."""
    if exception or app.builder.name != "html":
        return
    out = Path(app.outdir)
    shutil.copyfile(out / "README.html", out / "index.html")
    if app.config.cpp_reference:
        shutil.copytree(app.config.cpp_reference, out / "docs/cpp", dirs_exist_ok=True)
    if MATHJAX.is_dir():
        for part in ("MathJax.js", "config/TeX-AMS_SVG.js", "extensions", "jax/element", "jax/input/TeX", "jax/output/SVG"):
            copy = shutil.copyfile if (MATHJAX / part).is_file() else lambda a, b: shutil.copytree(a, b, dirs_exist_ok=True)
            (out / "_static/mathjax" / part).parent.mkdir(parents=True, exist_ok=True)
            copy(MATHJAX / part, out / "_static/mathjax" / part)


def plain_docstring(app, what, name, obj, options, lines):
    """Docstrings are text, not markup: every line stands as it is written, symbols too."""
    if any(line.strip() for line in lines):
        lines[:] = [f"| {line}" if line.strip() else "" for line in (re.sub(r"([*`|_\\])", r"\\\1", line) for line in lines)] + [""]


def setup(app):
    app.add_config_value("cpp_reference", "", "html")  # a folder of Doxygen's pages
    app.connect("source-read", read)
    app.connect("build-finished", finish)
    app.connect("autodoc-process-docstring", plain_docstring)
