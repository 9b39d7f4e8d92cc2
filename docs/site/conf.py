"""The documentation as pages: Sphinx reads the Markdown files where they are. "./argo site" runs it."""
import os
import pathlib
import re

from pygments.lexer import RegexLexer
from pygments.lexers.jvm import KotlinLexer
from pygments.token import Comment, Keyword, Name, Number, Operator, String, Text

ROOT = pathlib.Path(__file__).resolve().parents[2]
INDEX = "docs/README"

project = "ARGO"
release = re.search(r"<version>(.+?)</version>", (ROOT / "pom.xml").read_text())[1]
html_title = f"ARGO {release}"
extensions = ["myst_parser"]
root_doc = "README"
include_patterns = [
    "README.md", "CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md", "docs/*.md", "javino-arduino/README.md", "javino-arduino/extras/*.md",
    "javino-arduino/simulator/README.md", "javino-arduino/vectors/README.md", "javino-python/README.md",
    "samples/*/README.md", "experiment/README.md",
]
exclude_patterns = ["**/target", "**/build", ".*"]
myst_heading_anchors = 4  # as GitHub has them
suppress_warnings = ["toc.not_included"]  # links lead to the samples' pages
html_theme = "furo"
html_show_copyright = False
html_show_sphinx = False
html_copy_source = False
templates_path = ["templates"]
html_sidebars = {"**": [
    "sidebar/brand.html", "sidebar/search.html", "sidebar/scroll-start.html", "sidebar/navigation.html", "api.html",
    "sidebar/scroll-end.html",
]}


class AgentSpeak(RegexLexer):
    """AgentSpeak, as far as colours need it."""

    tokens = {"root": [
        (r"//.*|/\*(.|\n)*?\*/", Comment),
        (r'"(\\.|[^"\\])*"', String),
        (r"<-|&|\||:-|=\.\.|[-+]?!{1,2}|[-+]{1,2}|\?|[<>=\\]+", Operator),
        (r"\b(not|true|false|MAS|agents|environment|aslSourcePath|agentArchClass)\b", Keyword),
        (r"\d+(\.\d+)?", Number),
        (r"[A-Z_]\w*", Name.Variable),
        (r"\.?[a-z]\w*(\.[a-z]\w*)+|\.[a-z]\w*", Name.Builtin),
        (r"[a-z]\w*", Name),
        (r".|\n", Text),
    ]}


def page_of(target, folder):
    """The file among the pages that a link leads to: for a folder, its README. None if there is no page."""
    path = (folder / target).resolve()
    path = path / "README.md" if path.is_dir() else path
    return path if path.suffix == ".md" and path.is_file() else None


def navigation():
    """A list of pages for each section of the index, in its order."""
    for section in re.split(r"^## ", (ROOT / f"{INDEX}.md").read_text(), flags=re.M)[1:]:
        pages = [page_of(target, ROOT / "docs") for target in re.findall(r"\]\(([^)#:]+)\)", section)]
        yield section.splitlines()[0], [str(page.relative_to(ROOT).with_suffix("")) for page in pages if page]


def prepare(app, name, source):
    """Links to folders lead to their page, or are plain text; the first page lists the others."""
    folder = (ROOT / name).parent

    def link(match):
        path = folder / match[2]
        if not path.is_dir():
            return match[0]
        page = page_of(match[2], folder)
        return f"[{match[1]}]({os.path.relpath(page, folder)})" if page and page_is_included(page) else match[1]

    source[0] = re.sub(r"\[([^\]]+)\]\(([^)#:]+)\)", link, source[0])
    if name == root_doc:
        for caption, pages in navigation():
            source[0] += "\n\n```{toctree}\n:hidden:\n:caption: " + caption + "\n\n" + "\n".join(f"/{page}" for page in pages) + "\n```\n"


def page_is_included(page):
    return any(page.relative_to(ROOT).match(pattern) for pattern in include_patterns)


def setup(app):
    for language in ("agentspeak", "mas2j", "jcm"):
        app.add_lexer(language, AgentSpeak)
    app.add_lexer("kts", KotlinLexer)
    app.connect("source-read", prepare)
