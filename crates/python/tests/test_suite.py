"""The reference suite of published numbers, recomputed by the example of `validation/`, which has nothing of Lanchester."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

PROGRAM = os.environ.get("LANCHESTER_PROGRAM")
pytestmark = pytest.mark.skipif(PROGRAM is None, reason="LANCHESTER_PROGRAM names no program; `cargo xtask python` does")
EXAMPLE = Path(__file__).parents[3] / "validation" / "example.py"


def recomputed(suite: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, str(EXAMPLE), str(suite)], capture_output=True, text=True, check=False)


@pytest.fixture(scope="module")
def suite(tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("suite") / "suite.json"
    assert PROGRAM is not None
    subprocess.run([PROGRAM, "validate", "twin-cylinder-thesis", "--suite", str(file)], check=True, capture_output=True)
    return file


def test_another_program_recomputes_the_suite(suite: Path) -> None:
    found = recomputed(suite)
    assert found.returncode == 0, found.stdout
    computed = int(found.stdout.split(" of ")[0])
    assert computed > 1200 and f"{computed} agree" in found.stdout


def test_an_expected_value_one_unit_off_is_found(suite: Path, tmp_path: Path) -> None:
    data: dict[str, Any] = json.loads(suite.read_text(encoding="utf-8"))
    row = next(row for row in data["rows"] if row["key"] == "Fres max" and row["comparison"] is None)
    row["expected"]["value"] += 2 * row["expected"]["uncertainty"]
    file = tmp_path / "wrong.json"
    file.write_text(json.dumps(data), encoding="utf-8")
    found = recomputed(file)
    assert found.returncode == 1 and row["id"] in found.stdout
