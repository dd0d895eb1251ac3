"""Tables of cases."""

from __future__ import annotations

from pathlib import Path

import pytest

import lanchester
from lanchester import Engine, RequestError

FOUR = Engine.template("in-line-4")


def test_rows_are_changed_copies(tmp_path: Path) -> None:
    path = tmp_path / "cases.csv"
    path.write_text("rod.length [mm],piston.mass,crank.stroke,name\n140,,8 cm,a\n150,0.32,,b\n\n", encoding="utf-8")
    cases = FOUR.cases(path)
    assert len(cases) == 2
    assert cases[0].text == FOUR.with_({"rod.length": "140 mm", "crank.stroke": "8 cm", "name": "a"}).text
    assert cases[1].text == FOUR.with_({"rod.length": "150 mm", "piston.mass": 0.32, "name": "b"}).text
    force = "total.peaks.force.max.value"
    found = lanchester.map("loads", cases, force)[force]
    assert found.tolist() == [own.loads().total.peaks.force.max.value for own in cases]


def test_dataframes_are_tables_too() -> None:
    import pandas as pd

    frame = pd.DataFrame({"rod.length": [0.14, 0.15], "layout.spacing": ["90 mm", None]})
    cases = FOUR.cases(frame)
    assert cases[0].text == FOUR.with_({"rod.length": 0.14, "layout.spacing": "90 mm"}).text
    assert cases[1].text == FOUR.with_({"rod.length": 0.15}).text


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "is empty"),
        ("rod.length,rod.length\n1,2\n", "one head"),
        ("rod.length,rod.length [mm]\n1,2\n", "two columns are of"),
        ("rod.length\n1,2\n", "has 2 cells"),
        ("rod.length [mm]\nlong\n", "needs a number"),
        ("[mm]\n1\n", "is no key"),
    ],
)
def test_wrong_tables_say_where(text: str, words: str, tmp_path: Path) -> None:
    path = tmp_path / "cases.csv"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(RequestError, match=words):
        FOUR.cases(path)
    with pytest.raises(RequestError, match="cannot read"):
        FOUR.cases(tmp_path / "none.csv")
