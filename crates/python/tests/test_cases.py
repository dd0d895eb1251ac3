"""Tables of cases."""

from __future__ import annotations

from pathlib import Path

import pytest

import lanchester
from lanchester import Engine, RequestError
from lanchester.cases import columns

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
        ("rod.length,rod.length\n1,2\n", "two columns are of"),
        ("rod.length [mm]\n", "has no case"),
        ("rod.length [mm],\n140,\n", "a head is due"),
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


@pytest.mark.parametrize(
    "text",
    [
        "rod.length [mm];piston.mass;name\n140,5;0,30 kg;a, b\n150;;4711\n",
        "\ufeffrod.length [mm]\tpiston.mass\tname\n140.5\t0.30 kg\ta, b\n150\t\t4711\n",
        'rod.length [mm],piston.mass,name\r\n140.5,0.30 kg,"a, b"\r\n\r\n150,,4711\r\n',
        "name,rod.length [mm],piston.mass\n\"a, b\",140.5,0.30 kg\n4711,150\n",
    ],
    ids=["semicolons", "tabs", "commas", "a short row"],
)
def test_tables_of_any_spreadsheet_are_read_alike(text: str, tmp_path: Path) -> None:
    path = tmp_path / "cases.csv"
    path.write_bytes(text.encode())
    cases = FOUR.cases(path)
    assert cases[0].text == FOUR.with_({"rod.length": "140.5 mm", "piston.mass": "0.30 kg", "name": "a, b"}).text
    assert cases[1].text == FOUR.with_({"rod.length": "150 mm", "name": "4711"}).text


def test_all_cells_are_named_at_once_by_their_lines(tmp_path: Path) -> None:
    path = tmp_path / "cases.csv"
    path.write_text("rod.length [mm],crank.stroke [mm]\n140,80\n\nlong,1;2\n150,80,3\n", encoding="utf-8")
    with pytest.raises(RequestError) as caught:
        FOUR.cases(path)
    lines = caught.value.message.splitlines()
    assert "row 5: it has 3 cells, the first row has 2" in lines[1]
    assert "row 4, column A (rod.length [mm]): needs a number [mm], got 'long'" in lines[2]
    assert "row 4, column B" in lines[3] and len(lines) == 4
    with pytest.raises(RequestError, match="read_excel"):
        FOUR.cases(tmp_path / "cases.xlsx")


def test_gaps_of_a_dataframe_leave_keys_as_they_are() -> None:
    import pandas as pd

    frame = pd.DataFrame({"layout.cylinders": [4.0, None], "rod.length [mm]": pd.array([None, 150], dtype="Int64"), "name": [1, 2]})
    cases = FOUR.cases(frame)
    assert cases[0].text == FOUR.with_({"layout.cylinders": 4, "name": "1"}).text
    assert cases[1].text == FOUR.with_({"rod.length": "150 mm", "name": "2"}).text


@pytest.mark.parametrize(
    "text",
    [
        "rod.length [mm],name; free\n140,long\n",
        "rod.length [mm],name;free;or not,crank.stroke [mm]\n140,long,80\n",
        '"rod.length\n;;; [mm]",name\n140,long\n',
    ],
    ids=["as many", "fewer", "in quotes"],
)
def test_a_semicolon_in_a_head_parts_no_cells(text: str, tmp_path: Path) -> None:
    path = tmp_path / "cases.csv"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(RequestError) as caught:
        FOUR.cases(path)
    # One head is no key; nothing else is wrong with the table.
    assert "is no key of an engine file" in caught.value.message and "`rod.length [mm],name" not in caught.value.message
    assert len(caught.value.message.replace("\n;;;", "").splitlines()) == 2


def test_decimal_commas_are_those_of_numbers_and_not_of_lists(tmp_path: Path) -> None:
    path = tmp_path / "cases.csv"
    path.write_text("rod.length;piston.mass;crank.stroke [mm];cylinder[0].angles;layout.cylinders;name\n0,14;0,30 kg;80,5;1,2;4;1,2 l\n", encoding="utf-8")
    found = columns(path)
    assert found == {
        "rod.length": [0.14],
        "piston.mass": ["0.30 kg"],
        "crank.stroke": ["80.5 mm"],
        "cylinder[0].angles": ["1,2"],
        "layout.cylinders": [4],
        "name": ["1,2 l"],
    }
    path.write_text("firing.angles;gas.cycle.heat.angles;speed\n1,2;-180,5 deg;800,5 rpm\n", encoding="utf-8")
    assert columns(path) == {"firing.angles": ["1,2"], "gas.cycle.heat.angles": ["-180.5 deg"], "speed": ["800.5 rpm"]}


def test_thousands_separators_are_named(tmp_path: Path) -> None:
    path = tmp_path / "cases.csv"
    path.write_text("rod.length [mm];piston.mass\n1.234,5;0,3\n140;1 234 g\n", encoding="utf-8")
    with pytest.raises(RequestError) as caught:
        FOUR.cases(path)
    lines = caught.value.message.splitlines()
    assert "row 2, column A (rod.length [mm]): needs a value, got `1.234,5`: thousands separators are not read, write 1234,5" in lines[1]
    assert "row 3, column B (piston.mass): needs a value, got `1 234 g`: thousands separators are not read, write 1234 g" in lines[2]
