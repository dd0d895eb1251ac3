"""Executes every notebook of this folder; fails where a cell raises, or where its page in the book is another one's.

With --lessons the pages are written anew, with their pictures; with --write the outputs stay in the notebooks.
"""

from __future__ import annotations

import sys
import time
from pathlib import Path

import nbformat
from lessons import PAGES, Page
from nbclient import NotebookClient

FOLDER = Path(__file__).parent


def main() -> int:
    notebooks = sorted(FOLDER.glob("*.ipynb"))
    began = time.monotonic()
    cells, stale = 0, []
    for path in notebooks:
        notebook = nbformat.read(path, as_version=4)
        client = NotebookClient(notebook, timeout=120, kernel_name="python3", resources={"metadata": {"path": str(FOLDER)}})
        client.execute()
        cells += sum(cell.cell_type == "code" for cell in notebook.cells)
        page = Page(path.stem, notebook)
        if "--lessons" in sys.argv[1:]:
            page.put()
        else:
            stale += [wrong for wrong in [page.check()] if wrong]
        if "--write" in sys.argv[1:]:
            nbformat.write(notebook, path)
    stale += [f"{page.relative_to(PAGES.parents[3])} has no notebook" for page in PAGES.glob("*.md") if page.stem not in {path.stem for path in notebooks}]
    if stale:
        print("; ".join(stale) + ": run `cargo xtask python --write`, and look at the pictures", file=sys.stderr)
        return 1
    print(f"{len(notebooks)} notebooks with {cells} cells in {time.monotonic() - began:.0f} s")
    return 0


if __name__ == "__main__":
    sys.exit(main())
