"""Pages of the book from executed notebooks: their words, their lines, and what these showed, with the pictures as files.

A page is written by `execute.py --lessons`; without it `execute.py` fails where words or lines of a notebook are not those of its page, or a picture is missing. What the lines showed
is that of the day on which it was written: another version of a library prints in another form.
"""

from __future__ import annotations

import base64
import re
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[3]
PAGES = ROOT / "docs" / "src" / "guide" / "lessons"
PICTURES = ROOT / "docs" / "src" / "images" / "lessons"

SHOWN = "<!-- shown -->"
LINES = 60
"""Lines of a printed text that a page has at most."""
MOST_SVG = 250_000
"""Characters of a drawing that the book holds; a mesh has more."""


class Page:
    """A page and its pictures."""

    def __init__(self, name: str, notebook: Any) -> None:
        self.name = name
        self.pictures: dict[str, bytes] = {}
        self.text = ""
        for cell in notebook.cells:
            if cell.cell_type == "markdown":
                self._words(cell)
            elif cell.cell_type == "code":
                self.text += f"```python\n{cell.source.strip()}\n```\n\n"
                for output in cell.get("outputs", []):
                    self._shown(output)
        self.text = self.text.rstrip() + "\n"

    def _words(self, cell: Any) -> None:
        words = cell.metadata.get("book", cell.source).strip()
        if "$" in words:
            raise SystemExit(f'{self.name}: the book sets no TeX: give the cell "{words[:40]}..." a text without it as `book` in its metadata')
        # Links of a notebook count from its folder.
        self.text += re.sub(r"\]\((?!https?:)([^)#]+)", lambda link: f"]({_from_pages(link[1])}", words) + "\n\n"
        if not self.text.count("\n\n") > 1:
            source = f"crates/python/notebooks/{self.name}.ipynb"
            self.text += f"*A lesson: the notebook `{source}` as it ran. [Python](../python.md) shows how its parts play together.*\n\n"

    def _shown(self, output: Any) -> None:
        if output.output_type == "stream":
            self._printed(output.text)
            return
        data = output.get("data", {})
        html = data.get("text/html", "")
        drawing = _first_drawing(html) or data.get("image/svg+xml", "")
        images = [data["image/png"]] if "image/png" in data else re.findall(r"data:image/png;base64,([^\"]+)", html)
        if images:
            self._picture(base64.b64decode(images[0]), "png", data)
        elif drawing and len(drawing) <= MOST_SVG:
            self._picture(drawing.encode(), "svg", data)
        elif "text/plain" in data:
            self._printed(data["text/plain"])

    def _printed(self, text: str) -> None:
        lines = text.rstrip().splitlines()
        if len(lines) > LINES:
            lines = [*lines[:LINES], f"... {len(lines) - LINES} more lines"]
        self.text += f"{SHOWN}\n```text\n" + "\n".join(line.rstrip() for line in lines) + "\n```\n\n"

    def _picture(self, content: bytes, ending: str, data: Any) -> None:
        file = f"{self.name}-{len(self.pictures) + 1}.{ending}"
        self.pictures[file] = content
        words = str(data.get("text/plain", "")).strip().splitlines()
        words = [own for own in words if not own.startswith(("<Figure", "<IPython", "<lanchester", "<matplotlib"))]
        title = re.search(r"Picture\('[^']*', '([^']*)'\)", " ".join(words))
        meant = title[1] if title else _meant(" ".join(words))
        self.text += f"{SHOWN}\n![{meant}](../../images/lessons/{file})\n\n"

    def put(self) -> None:
        """Writes the page and its pictures."""
        PAGES.mkdir(exist_ok=True)
        PICTURES.mkdir(exist_ok=True)
        for old in PICTURES.glob(f"{self.name}-[0-9]*"):
            old.unlink()
        (PAGES / f"{self.name}.md").write_text(self.text, encoding="utf-8")
        for file, content in self.pictures.items():
            (PICTURES / file).write_bytes(content)

    def check(self) -> str | None:
        """What of the page is not that of the notebook."""
        place = PAGES / f"{self.name}.md"
        held = place.read_text(encoding="utf-8") if place.exists() else ""
        if _asked(held) != _asked(self.text):
            return f"{place.relative_to(ROOT)} has other words or lines than its notebook"
        missing = [file for file in self.pictures if not (PICTURES / file).exists()]
        return f"{PICTURES.relative_to(ROOT)} has no {missing[0]}" if missing else None


def _first_drawing(html: str) -> str:
    """The first drawing of a page as SVG, with the drawings within it; empty where there is none."""
    depth, begin = 0, html.find("<svg")
    for tag in re.finditer(r"<svg\b[^>]*?(/?)>|</svg>", html):
        depth += -1 if tag[0] == "</svg>" else 0 if tag[1] else 1
        if depth == 0:
            return html[begin : tag.end()]
    return ""


def _asked(page: str) -> str:
    """A page without what its lines showed, but for the number of pictures."""
    pictures = len(re.findall(rf"{SHOWN}\n!\[", page))
    text = re.sub(rf"{SHOWN}\n```text\n.*?\n```\n\n?", "", page, flags=re.S)
    text = re.sub(rf"{SHOWN}\n!\[.*?\n\n?", "", text).rstrip()
    return f"{text}\n{pictures}"


def _meant(words: str) -> str:
    """What a picture shows, for whom cannot see it."""
    engine = re.match(r"<Engine '([^']*)'", words)
    if engine:
        return f"Drawing of the engine {engine[1]}"
    kind = re.match(r"(\w+)\(", words)
    return f"Picture of {kind[1]}" if kind else "Plot of the lines above"


def _from_pages(target: str) -> str:
    place = (Path(__file__).parent / target).resolve()
    pages = ROOT / "docs" / "src"
    if place.is_relative_to(pages):
        return "../../" + place.relative_to(pages).as_posix()
    return target
