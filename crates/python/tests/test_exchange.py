"""Files for other programs, read back by readers of others: pyNastran, pyuff, pyarrow, and workbooks by what wrote and reads them."""

from __future__ import annotations

import ast
import json
import os
import subprocess
import zipfile
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

from lanchester import Engine

ROOT = Path(__file__).parents[3]
MOUNTED = ROOT / "examples" / "in-line-4-mounts.toml"
PROGRAM = os.environ.get("LANCHESTER_PROGRAM")
pytestmark = pytest.mark.skipif(PROGRAM is None, reason="LANCHESTER_PROGRAM names no program; `cargo xtask python` does")
SPEEDS = [100.0, 250.0, 400.0]


def program(*line: object) -> str:
    done = subprocess.run([str(PROGRAM), *map(str, line)], capture_output=True, text=True, encoding="utf-8", check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def expected() -> tuple[dict[tuple[str, float], np.ndarray[Any, Any]], dict[tuple[int, float], np.ndarray[Any, Any]]]:
    """Forces by name and order at mounts, by number and order at main bearings: (speed, axis), each by another way than the export."""
    engine = Engine.read(MOUNTED)
    study = engine.mounts(speeds=SPEEDS, orders=4)
    mounts: dict[tuple[str, float], np.ndarray[Any, Any]] = {}
    for place, own in enumerate(study.response.speeds):
        for order in own.orders:
            for name, force in zip(study.response.mounts, np.asarray(order.forces), strict=True):
                here = mounts.setdefault((name, order.order), np.zeros((len(SPEEDS), 3), complex))
                here[place] = force[:, 0] + 1j * force[:, 1]
    mains: dict[tuple[int, float], np.ndarray[Any, Any]] = {}
    for place, speed in enumerate(SPEEDS):
        loads = engine.bearings(speed, samples=720)
        revolutions = round(loads.period / (2 * np.pi))
        for main in loads.mains:
            series = np.asarray(main.load.load)
            for axis in (0, 1):
                spectrum = np.fft.rfft(series[:, axis]) * 2 / len(series)
                for number in range(1, 4 * revolutions + 1):
                    here = mains.setdefault((main.main, number / revolutions), np.zeros((len(SPEEDS), 3), complex))
                    here[place, axis] = spectrum[number]
    return mounts, mains


def arguments(tmp_path: Path, ending: str) -> tuple[Path, list[object]]:
    output = tmp_path / f"four.{ending}"
    speeds = ", ".join(f"{speed} rad/s" for speed in SPEEDS)
    return output, [MOUNTED, "--speeds", speeds, "--orders", 4, "--first-node", 11, "--output", output]


def test_pynastran_reads_the_forces_by_order(tmp_path: Path) -> None:
    # The name that NumPy has left behind.
    if not hasattr(np, "in1d"):
        np.in1d = np.isin  # type: ignore[attr-defined]
    bdf = pytest.importorskip("pyNastran.bdf.bdf")
    output, line = arguments(tmp_path, "bdf")
    program("export", "nastran", *line)
    model = bdf.read_bdf(str(output), punch=True, xref=False, debug=None)
    mounts, mains = expected()
    names = [str(name) for name in Engine.read(MOUNTED).mounts(speeds=SPEEDS).response.mounts]
    loads = {load.sid: load for own in model.dloads.values() for load in own} | {load.sid: load for own in model.dload_entries.values() for load in own}
    areas = {area.sid: area for area in model.dareas.values()} if not isinstance(next(iter(model.dareas.values())), list) else {}
    seen, worst, peak = set(), 0.0, 0.0
    for text, sid in order_sets(output):
        [combination] = model.dloads[sid]
        [frequency] = model.frequencies[sid]
        np.testing.assert_allclose(sorted(frequency.freqs), [text * speed / (2 * np.pi) for speed in SPEEDS], rtol=1e-8)
        assert set(combination.scale_factors) == {1.0} and combination.scale == 1.0
        for own in combination.load_ids:
            load = loads[own]
            assert load.Type == "LOAD"
            area = areas[load.excite_id]
            node, axis = area.node_ids[0], int(area.components[0]) - 1
            real, imaginary = model.tables_d[load.tc], model.tables_d[load.td]
            np.testing.assert_allclose(real.x, frequency.freqs, rtol=1e-8)
            found = np.asarray(real.y) + 1j * np.asarray(imaginary.y)
            due = mains[node - 1010, text] if node >= 1011 else mounts[names[node - 11], text]
            worst, peak = max(worst, np.abs(found - due[:, axis]).max()), max(peak, np.abs(due).max())
            seen.add((node, text, axis))
    assert peak > 100 and worst < 1e-8 * peak, f"off by {worst} of {peak}"
    due_mounts = {(names.index(name) + 11, order, axis) for (name, order), force in mounts.items() for axis in range(3) if np.any(force[:, axis] != 0)}
    assert due_mounts <= seen
    assert {node for node, _, _ in seen} == set(range(11, 11 + len(names))) | set(range(1011, 1011 + len({main for main, _ in mains})))
    places = {node: model.nodes[node].get_position_no_xref(model) for node in model.nodes}
    assert len(places) == len({node for node, _, _ in seen}) and any(np.abs(place).max() > 0.01 for place in places.values())


def test_comments_are_whole_and_numbers_can_be_moved(tmp_path: Path) -> None:
    bdf = pytest.importorskip("pyNastran.bdf.bdf")
    output, line = arguments(tmp_path, "bdf")
    program("export", "nastran", *line, "--first-set", 501, "--first-table", 9001)
    comments = [own.removeprefix("$ ") for own in output.read_text().splitlines() if own.startswith("$ ")]
    assert max(map(len, comments)) <= 70
    whole = " ".join(comments)
    assert "Main bearings: force of the journal on each bearing, of the block, from inertia" in whole and "Units: N, m, Hz." in whole
    model = bdf.read_bdf(str(output), punch=True, xref=False, debug=None)
    loads = [load for own in (*model.dloads.values(), *model.dload_entries.values()) for load in own]
    sets = {own.sid for own in loads} | set(model.frequencies)
    areas = {area.sid for area in model.dareas.values()}
    assert min(sets) == 501 and not sets & areas and min(model.tables_d) == 9001
    assert max(sets | areas) < 9001 and len(model.tables_d) == 2 * len(areas)
    # Without a number of their own, tables are behind the sets.
    plain = tmp_path / "plain.bdf"
    program("export", "nastran", *line[:-1], plain)
    model = bdf.read_bdf(str(plain), punch=True, xref=False, debug=None)
    assert max(area.sid for area in model.dareas.values()) + 1 == min(model.tables_d)


def order_sets(output: Path) -> list[tuple[float, int]]:
    """Orders with their sets as the head of the file names them."""
    heads = [line.split() for line in output.read_text().splitlines() if line.startswith("$ subcase of order")]
    return [(float(words[4].rstrip(":")), int(words[7].rstrip(","))) for words in heads]


def test_pyuff_reads_the_forces_by_order(tmp_path: Path) -> None:
    pyuff = pytest.importorskip("pyuff")
    output, line = arguments(tmp_path, "unv")
    program("export", "universal", *line)
    sets = pyuff.UFF(str(output)).read_sets()
    assert [own["type"] for own in sets[:2]] == [164, 2411] and all(own["type"] == 58 for own in sets[2:])
    assert sets[0]["units_code"] == 1 and sets[0]["length"] == sets[0]["force"] == 1.0
    mounts, mains = expected()
    names = [str(name) for name in Engine.read(MOUNTED).mounts(speeds=SPEEDS).response.mounts]
    worst, peak = 0.0, 0.0
    for own in sets[2:]:
        node, axis, order = int(own["rsp_node"]), int(own["rsp_dir"]) - 1, float(own["z_axis_value"])
        assert own["func_type"] == 27 and own["ordinate_spec_data_type"] == 13 and own["abscissa_spec_data_type"] == 19
        np.testing.assert_allclose(own["x"], np.array(SPEEDS) * 30 / np.pi, rtol=1e-5)
        due = mains.get((node - 1010, order)) if node >= 1011 else mounts.get((names[node - 11], order))
        column = np.zeros(len(SPEEDS)) if due is None else due[:, axis]
        worst, peak = max(worst, np.abs(own["data"] - column).max()), max(peak, np.abs(column).max())
    assert peak > 100 and worst < 1e-9 * peak, f"off by {worst} of {peak}"


def test_histories_are_the_same_as_csv_and_parquet(tmp_path: Path) -> None:
    import pandas as pd

    for ending in ("csv", "parquet"):
        program("export", "history", MOUNTED, "--speed", "3000 rpm", "--samples", 90, "--output", tmp_path / f"four.{ending}")
    table, other = pd.read_parquet(tmp_path / "four.parquet"), pd.read_csv(tmp_path / "four.csv")
    pd.testing.assert_frame_equal(table, other.astype(float), rtol=1e-15)
    engine = Engine.read(MOUNTED)
    bearings, loads = engine.bearings("3000 rpm", samples=90), engine.loads("3000 rpm", samples=90)
    assert len(table) == len(bearings.theta)
    np.testing.assert_allclose(table["time_s"], bearings.theta / bearings.speed)
    np.testing.assert_allclose(table["main_bearing_2_y_N"], np.asarray(bearings.mains[1].load.load)[:, 1])
    torque = engine.torque("3000 rpm").torque
    np.testing.assert_allclose(table["torque_Nm"], np.interp(bearings.theta, torque.theta, np.asarray(torque.gas) + np.asarray(torque.inertia)), atol=1e-9 * np.abs(table["torque_Nm"]).max())
    settled = engine.mounts(speeds=["3000 rpm"], orders=8).response.speeds[0]
    for place in range(len(settled.peaks)):
        sizes = np.sqrt(sum(table[f"mount_{place + 1}_{axis}_N"] ** 2 for axis in "xyz"))
        peak = settled.peaks[place].value
        # Samples four degrees apart miss the peak by no more than this.
        assert 0.97 * peak < sizes.max() <= peak * (1 + 1e-9)
    pressures = [name for name in table.columns if name.endswith("_pressure_Pa")]
    assert bool(pressures) == torque.with_gas
    count = len(loads.total.trace.theta)
    np.testing.assert_allclose(table["shaking_force_x_N"][:count], loads.total.trace.force_x)
    np.testing.assert_allclose(table["shaking_force_x_N"][-count:], loads.total.trace.force_x)


def test_cases_are_read_and_written_as_csv_and_workbooks(tmp_path: Path) -> None:
    four = ROOT / "examples" / "in-line-4.toml"
    (tmp_path / "cases.csv").write_text("rod.length [mm],piston.mass,name\n140,0.30 kg,short\n155,,long\n", encoding="utf-8")
    rows = json.loads(program("loads", four, "--cases", tmp_path / "cases.csv", "--format", "json"))
    engine = Engine.read(four)
    for row, changes in zip(rows, [{"rod.length": "140 mm", "piston.mass": "0.30 kg"}, {"rod.length": "155 mm"}], strict=True):
        peaks = engine.with_(changes).loads().total.peaks
        assert row["largest force [N]"] == peaks.force.max.value
        assert row["largest roll moment [N m]"] == peaks.roll_moment.max.value
    assert [row["row"] for row in rows] == [2, 3] and rows[1]["piston.mass"] is None
    # What is written as a workbook is read as one.
    program("loads", four, "--cases", tmp_path / "cases.csv", "--output", tmp_path / "loads.xlsx")
    heads, *cells = sheet(tmp_path / "loads.xlsx")
    assert sorted(heads) == sorted(rows[0]) and heads[:5] == ["row", "rod.length [mm]", "piston.mass", "name", "speed [rpm]"]
    for found, row in zip(cells, rows, strict=True):
        assert found[0] == row["row"] and found[heads.index("largest force [N]")] == pytest.approx(row["largest force [N]"], rel=1e-14)
    write_sheet(tmp_path / "cases.xlsx", [["rod.length [mm]", "piston.mass", "name"], [140, "0.30 kg", "short"], [155, None, "long"]])
    again = json.loads(program("loads", four, "--cases", tmp_path / "cases.xlsx", "--format", "json"))
    assert [row["largest force [N]"] for row in again] == [row["largest force [N]"] for row in rows]
    # A spreadsheet with decimal commas parts its cells by semicolons; a name may be a number.
    (tmp_path / "cases.csv").write_text("rod.length [mm];piston.mass;name\n140,0;0,30 kg;3,5 l\n155;;4711\n", encoding="utf-8")
    again = json.loads(program("loads", four, "--cases", tmp_path / "cases.csv", "--format", "json"))
    assert [row["largest force [N]"] for row in again] == [row["largest force [N]"] for row in rows]
    assert [row["name"] for row in again] == ["3,5 l", "4711"]
    write_sheet(tmp_path / "cases.xlsx", [["name", "rod.length [mm]"], [4711, 155]])
    [row] = json.loads(program("loads", four, "--cases", tmp_path / "cases.xlsx", "--format", "json"))
    assert (row["name"], row["largest force [N]"]) == ("4711", rows[1]["largest force [N]"])
    done = subprocess.run([str(PROGRAM), "loads", str(four), "--cases", str(tmp_path / "loads.xlsx")], capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert "row 1, column F: `largest force [N]` is no key of an engine file" in done.stderr


SHEET = "{http://schemas.openxmlformats.org/spreadsheetml/2006/main}"


def sheet(path: Path) -> list[list[Any]]:
    """The cells of the first sheet, read without anything of ours."""
    with zipfile.ZipFile(path) as book:
        shared = [("".join(own.itertext())) for own in ElementTree.fromstring(book.read("xl/sharedStrings.xml"))]
        rows = ElementTree.fromstring(book.read("xl/worksheets/sheet1.xml")).iter(f"{SHEET}row")
        return [cells_of(row, shared) for row in rows]


def cells_of(row: ElementTree.Element, shared: list[str]) -> list[Any]:
    cells: list[Any] = []
    for own in row:
        # Empty cells are left out: the letter says where this one stands.
        cells += [None] * (ord(own.get("r", "A")[0]) - ord("A") - len(cells))
        text = own[0].text or ""
        cells.append(shared[int(text)] if own.get("t") == "s" else float(text))
    return cells


def write_sheet(path: Path, rows: list[list[Any]]) -> None:
    """A workbook of the smallest kind that spreadsheets write."""
    main, office = SHEET[1:-1], "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
    package = "http://schemas.openxmlformats.org/package/2006"
    body = ""
    for number, row in enumerate(rows, 1):
        cells = ""
        for letter, cell in zip("ABCDEFG", row, strict=False):
            if isinstance(cell, str) and cell.startswith("="):
                cells += f'<c r="{letter}{number}"><f>{cell[1:]}</f><v></v></c>'
            elif isinstance(cell, str):
                cells += f'<c r="{letter}{number}" t="inlineStr"><is><t>{cell}</t></is></c>'
            elif cell is not None:
                cells += f'<c r="{letter}{number}"><v>{cell}</v></c>'
        body += f'<row r="{number}">{cells}</row>'
    kind = "application/vnd.openxmlformats-officedocument.spreadsheetml"
    parts = {
        "[Content_Types].xml": f'<Types xmlns="{package}/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
        f'<Override PartName="/xl/workbook.xml" ContentType="{kind}.sheet.main+xml"/>'
        f'<Override PartName="/xl/worksheets/sheet1.xml" ContentType="{kind}.worksheet+xml"/></Types>',
        "_rels/.rels": f'<Relationships xmlns="{package}/relationships"><Relationship Id="a" Type="{office}/officeDocument" Target="xl/workbook.xml"/></Relationships>',
        "xl/workbook.xml": f'<workbook xmlns="{main}" xmlns:r="{office}"><sheets><sheet name="cases" sheetId="1" r:id="a"/></sheets></workbook>',
        "xl/_rels/workbook.xml.rels": f'<Relationships xmlns="{package}/relationships"><Relationship Id="a" Type="{office}/worksheet" Target="worksheets/sheet1.xml"/></Relationships>',
        "xl/worksheets/sheet1.xml": f'<worksheet xmlns="{main}"><sheetData>{body}</sheetData></worksheet>',
    }
    with zipfile.ZipFile(path, "w") as book:
        for name, text in parts.items():
            book.writestr(name, f'<?xml version="1.0" encoding="UTF-8"?>{text}')


def test_every_bad_cell_is_told_with_row_and_column(tmp_path: Path) -> None:
    (tmp_path / "cases.csv").write_text("rod.length [mm],piston.mass,crank.strok\nlong,,\n140,0.3 mm,\n\n150,,80 mm\n20,,\n", encoding="utf-8")
    line = [str(PROGRAM), "loads", str(ROOT / "examples" / "in-line-4.toml"), "--cases", str(tmp_path / "cases.csv")]
    done = subprocess.run(line, capture_output=True, text=True, check=False)
    assert done.returncode == 2 and done.stdout == ""
    for words in [
        "row 2, column A (rod.length [mm]): needs a number [mm], got `long`",
        "row 3, column B (piston.mass):",
        "row 5, column C (crank.strok):",
        "unknown key `strok` in [crank] (did you mean `stroke`?)",
        "row 6, column A (rod.length [mm]):",
        "hint: no case was computed",
    ]:
        assert words in done.stderr, f"{words} is not in {done.stderr}"


def refused(*line: object) -> str:
    done = subprocess.run([str(PROGRAM), *map(str, line)], capture_output=True, text=True, encoding="utf-8", check=False)
    assert done.returncode == 2 and done.stdout == "", done.stdout
    return done.stderr


def test_cases_that_say_less_than_they_seem_to_are_refused(tmp_path: Path) -> None:
    line = ["loads", ROOT / "examples" / "in-line-4.toml", "--cases"]
    # A formula without its result, as programs write it that compute none.
    write_sheet(tmp_path / "cases.xlsx", [["name", "rod.length [mm]"], ["plain", 140], ["sum", "=100+40"]])
    words = refused(*line, tmp_path / "cases.xlsx")
    assert "row 3, column B (rod.length [mm]): needs a value, got the formula =100+40 in cell B3 of the sheet" in words and "save it there" in words, words
    (tmp_path / "cases.csv").write_text('name,rod.length [mm]\nA,140\n"abc,150\n', encoding="utf-8")
    assert "row 3 is not CSV: a quotation mark opens a cell here" in refused(*line, tmp_path / "cases.csv")
    (tmp_path / "cases.csv").write_text("name [mm]\nA\n", encoding="utf-8")
    assert "row 1, column A: `name` is no quantity and has no unit" in refused(*line, tmp_path / "cases.csv")


def test_results_of_cases_are_kept_apart_from_cases_and_files(tmp_path: Path) -> None:
    line = ["loads", ROOT / "examples" / "in-line-4.toml", "--cases", tmp_path / "cases.csv"]
    (tmp_path / "cases.csv").write_text("speed [rpm],rod.length,name\n3000,150 mm,0012\n", encoding="utf-8")
    [row] = json.loads(program(*line, "--format", "json"))
    assert (row["speed [rpm]"], row["name"], row["rod.length"]) == (3000, "0012", "150 mm")
    assert row["speed of the loads [rpm]"] == pytest.approx(3000, rel=1e-12)
    output = tmp_path / "loads.csv"
    done = subprocess.run([str(PROGRAM), *map(str, line), "--output", str(output)], capture_output=True, text=True, check=False)
    assert done.returncode == 0 and "loads of 1 case written into" in done.stderr
    before = output.read_bytes()
    assert "exists and is not overwritten" in refused(*line, "--output", output)
    assert output.read_bytes() == before


EXUDYN = ROOT / "validation" / "external" / "exudyn"
GALLERY: dict[str, Any] = json.loads((EXUDYN / "gallery.json").read_text())["engines"]


def hold_against_exudyn(kept: dict[str, Any], engine: Path) -> None:
    script = program("export", "exudyn", engine)
    [line] = [line for line in script.splitlines() if line.startswith("TRAIN = ")]
    train = json.loads(ast.literal_eval(line.removeprefix("TRAIN = json.loads(").removesuffix(")")))
    assert kept["speed"] == train["speed"]
    ours, theirs = np.array(train["reference"]["loads"]), np.array(kept["loads"])
    # What a part makes alone: that of all may cancel.
    square = [(train["speed"] * rotor["ratio"]) ** 2 for rotor in train["rotors"]]
    single = [own["piston_mass"] * np.hypot(*own["crankpin"]) * square[own["rotor"]] for own in train["cylinders"]]
    assert train["force_scale"] >= max(single) > 0 and train["couple_scale"] > 0
    assert np.abs(ours[:, :2] - theirs[:, :2]).max() < 1e-6 * train["force_scale"]
    assert np.abs(ours[:, 2:] - theirs[:, 2:]).max() < 1e-6 * train["couple_scale"]


@pytest.mark.parametrize("name", ["in-line-3", "in-line-4", "v6-60"])
def test_ext_exudyn_loads(name: str) -> None:
    """What Exudyn made of the script when it was run (`validation/external/exudyn`), against ours of today."""
    hold_against_exudyn(json.loads((EXUDYN / f"{name}.json").read_text()), ROOT / "examples" / f"{name}.toml")


@pytest.mark.parametrize("name", sorted(GALLERY))
def test_ext_exudyn_loads_of_the_gallery(name: str, tmp_path: Path) -> None:
    """The same for the gallery: parts whose loads cancel, and crankshafts beside one another."""
    program("new", name, "--output", tmp_path / "engine.toml")
    hold_against_exudyn(GALLERY[name], tmp_path / "engine.toml")
