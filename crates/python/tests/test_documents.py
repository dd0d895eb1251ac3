"""What README, guide and notebooks show works."""

from __future__ import annotations

import os
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]
BLOCKS = [
    pytest.param(block, id=f"{path.name}-{place + 1}")
    for path in (ROOT / "README.md", ROOT / "docs" / "src" / "guide" / "python.md")
    for place, block in enumerate(re.findall(r"^```python\n(.*?)^```", path.read_text(encoding="utf-8"), re.M | re.S))
]


@pytest.mark.parametrize("block", BLOCKS)
def test_lines_of_readme_and_guide_run(block: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    examples = tmp_path / "examples"
    os.symlink(ROOT / "examples", examples)
    monkeypatch.chdir(tmp_path)
    exec(compile(block, "<document>", "exec"), {})  # noqa: S102


def test_there_are_lines_in_both() -> None:
    assert len(BLOCKS) >= 4
