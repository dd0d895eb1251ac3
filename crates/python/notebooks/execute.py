"""Executes every notebook of this folder; fails where a cell raises. With --write the outputs stay in the notebooks."""

from __future__ import annotations

import sys
import time
from pathlib import Path

import nbformat
from nbclient import NotebookClient

FOLDER = Path(__file__).parent


def main() -> int:
    notebooks = sorted(FOLDER.glob("*.ipynb"))
    began = time.monotonic()
    cells = 0
    for path in notebooks:
        notebook = nbformat.read(path, as_version=4)
        client = NotebookClient(notebook, timeout=120, kernel_name="python3", resources={"metadata": {"path": str(FOLDER)}})
        client.execute()
        cells += sum(cell.cell_type == "code" for cell in notebook.cells)
        if "--write" in sys.argv[1:]:
            nbformat.write(notebook, path)
    print(f"{len(notebooks)} notebooks with {cells} cells in {time.monotonic() - began:.0f} s")
    return 0


if __name__ == "__main__":
    sys.exit(main())
