"""Engines: where they come from, what is refused, changed copies."""

from __future__ import annotations

import os
import pickle
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import lanchester
from lanchester import Engine, EngineFileError, RequestError

WEIGHTS = Path(__file__).parents[3] / "examples" / "in-line-3-counterweights.toml"
SINGLE: dict[str, Any] = {
    "name": "single",
    "speed": "6000 rpm",
    "layout": {"type": "in-line", "cylinders": 1},
    "crank": {"stroke": 0.06},
    "piston": {"mass": 0.3},
    "rod": {"length": 0.1, "mass": 0.25},
}


def test_every_engine_of_the_gallery_is_read_and_shakes() -> None:
    assert len(Engine.templates()) > 40
    for name in Engine.templates():
        engine = Engine.template(name)
        assert engine.loads(samples=36).engine == engine.name


def test_plain_values_make_the_engine_that_their_text_makes() -> None:
    engine = Engine.from_dict(SINGLE)
    assert Engine.from_toml(engine.text).loads().to_json() == engine.loads().to_json()
    with_units = {**SINGLE, "crank": {"stroke": "60 mm"}, "piston": {"mass": "300 g"}, "rod": {"length": "10 cm", "mass": "0.25 kg"}}
    assert Engine.from_dict(with_units).loads().to_json() == engine.loads().to_json()


def test_numbers_of_numpy_and_lists_are_values() -> None:
    engine = Engine.from_dict({**SINGLE, "speed": np.array([100.0, 600.0]), "crank": {"stroke": np.float32(0.0625)}})
    assert engine.speed_range == (100.0, 600.0)
    assert engine.with_(layout={"cylinders": np.int64(1)}).cylinders == 1


def test_all_mistakes_are_told_at_once_with_their_places() -> None:
    wrong = {**SINGLE, "crank": {"stroke": "60 kg"}, "rod": {"length": 0.1, "mass": "0.25 kg", "colour": 3}}
    del wrong["piston"]
    with pytest.raises(EngineFileError) as caught:
        Engine.from_dict(wrong)
    found = caught.value.diagnostics
    assert len(found) >= 3
    assert all(own.code.startswith("E") and own.line > 0 and own.column > 0 for own in found)
    assert "60 kg" in str(caught.value) and "hint" in str(caught.value) and "colour" in str(caught.value)
    assert isinstance(caught.value, ValueError)


@pytest.mark.parametrize("value", [float("nan"), float("inf"), object(), {1: 2}, b"60 mm", {"a": {"b": object()}}])
def test_values_that_no_file_holds_are_refused_with_their_key(value: object) -> None:
    with pytest.raises(RequestError) as caught:
        Engine.from_dict({**SINGLE, "crank": {"stroke": value}})
    assert "crank" in str(caught.value)


def test_values_nested_in_themselves_are_refused() -> None:
    endless: dict[str, Any] = {}
    endless["crank"] = endless
    with pytest.raises(RequestError):
        Engine.from_dict(endless)


def test_changed_copies_keep_comments_and_leave_the_engine_alone() -> None:
    engine = Engine.template("in-line-4")
    before = engine.text
    changed = engine.with_({"piston.mass": 0.31}, rod={"length": "150 mm"})
    assert engine.text == before and changed.text != before
    comments = [line.strip() for line in before.splitlines() if line.strip().startswith("#")]
    assert all(comment in changed.text for comment in comments)
    back = changed.with_({"piston.mass": engine_value(engine, "piston", "mass"), "rod.length": engine_value(engine, "rod", "length")})
    assert back.loads().to_json() == engine.loads().to_json()


def engine_value(engine: Engine, table: str, key: str) -> str:
    inside = False
    for line in engine.text.splitlines():
        if line.startswith("["):
            inside = line.strip() == f"[{table}]"
        elif inside and line.split("=")[0].strip() == key:
            return line.split("=", 1)[1].split("#")[0].strip().strip('"')
    raise AssertionError(f"{table}.{key} is not in the file")


def test_lists_of_tables_are_replaced_and_taken_out() -> None:
    engine = Engine.template("in-line-4").with_(
        mount=[{"name": "left", "x": 0.0, "y": -0.2, "z": 0.0}, {"name": "right", "x": 0.0, "y": 0.2, "z": 0.0}]
    )
    assert engine.text.count("[[mount]]") == 2
    assert engine.with_(mount=[{"name": "one", "x": 0.0, "y": 0.1, "z": 0.0}]).text.count("[[mount]]") == 1
    assert "mount" not in engine.with_(mount=[]).text
    assert "mount" not in engine.with_(mount=None).text


def test_a_wrong_change_says_where() -> None:
    engine = Engine.template("in-line-4")
    with pytest.raises(EngineFileError, match="stroke"):
        engine.with_(crank={"stroke": "80 kg"})
    with pytest.raises(EngineFileError, match="strok"):
        engine.with_(crank={"strok": 0.08})
    with pytest.raises(RequestError, match="paths are written like"):
        engine.with_({"crank..stroke": 0.08})


def test_typical_values_complete_an_engine_and_keep_what_it_says() -> None:
    single = Engine.template("single")
    gas = single.complete("gas", kind="motorcycle-petrol")
    assert "[gas]" in gas.text and "# Typical values" in gas.text and "[flywheel]" not in gas.text
    assert "[gas]" not in single.text, "the engine itself is left alone"
    assert gas.with_({"gas": None}).text.strip().startswith(single.text.strip()[:200])
    whole = single.complete()
    assert whole.torque().torque.with_gas and whole.mounts().modes.modes
    assert whole.complete().text == whole.text, "nothing is missing any more"


def test_typical_values_that_cannot_be_had_are_refused() -> None:
    single = Engine.template("single")
    with pytest.raises(RequestError, match="no typical values for .gsa"):
        single.complete("gsa")
    with pytest.raises(RequestError, match="no kind of engine"):
        single.complete(kind="steam")
    with pytest.raises(RequestError, match="shaft_weight_design cannot be had for this engine: the engine has no balance shafts"):
        single.complete("shaft_weight_design")


def test_unknown_names_have_a_suggestion() -> None:
    with pytest.raises(RequestError, match='did you mean "in-line-4"'):
        Engine.template("in-line-44")


def test_files(tmp_path: Path) -> None:
    engine = Engine.template("twin-270")
    path = engine.save(tmp_path / "twin.toml")
    assert Engine.read(path).text == engine.text == Engine.read(str(path)).text
    with pytest.raises(RequestError, match="is not overwritten"):
        engine.save(path)
    engine.save(path, overwrite=True)
    with pytest.raises(RequestError, match="cannot read"):
        Engine.read(tmp_path / "none.toml")
    (tmp_path / "bytes.toml").write_bytes(b"\xff\xfe")
    with pytest.raises(RequestError, match="not UTF-8"):
        Engine.read(tmp_path / "bytes.toml")
    with pytest.raises(RequestError, match="no regular file"):
        Engine.read(tmp_path)


def test_files_that_an_engine_names_come_from_its_folder(tmp_path: Path) -> None:
    text = Engine.template("single").text + '\n[gas]\n\n[[gas.trace]]\nfile = "none.csv"\n'
    with pytest.raises(RequestError, match="without a folder"):
        Engine.from_toml(text).torque()
    with pytest.raises(RequestError, match="cannot read"):
        Engine.from_toml(text, folder=tmp_path).torque()


def test_engines_are_values() -> None:
    one, other = Engine.template("v6-60"), Engine.template("v6-60")
    assert one == other and hash(one) == hash(other) and len({one, other}) == 1
    assert one != Engine.template("v6-90") and one != "v6-60"
    assert pickle.loads(pickle.dumps(one)) == one
    read = Engine.read(Path(__file__).parents[3] / "examples" / "in-line-4-mounts.toml")
    assert pickle.loads(pickle.dumps(read)) == read
    assert "6 cylinders" in repr(one) and one._repr_html_().startswith("<svg")


def test_the_version_is_that_of_the_program() -> None:
    assert lanchester.__version__.count(".") == 2


@pytest.mark.parametrize("ending", ["step", "stl", "glb", "svg", "dxf"])
def test_solids_are_the_bytes_of_the_command_line(tmp_path: Path, ending: str) -> None:
    program = os.environ.get("LANCHESTER_PROGRAM")
    if program is None:
        pytest.skip("LANCHESTER_PROGRAM names no program; `cargo xtask python` does")
    fitted = Engine.read(WEIGHTS).counterweight().adopt()
    file = fitted.save(tmp_path / "engine.toml")
    name: list[str] = ["web 1"] if ending in ("svg", "dxf") else []
    own = fitted.save_solids(tmp_path / f"own.{ending}", weight=name)
    theirs = tmp_path / f"theirs.{ending}"
    line = [program, "counterweight", "export", str(file), "--output", str(theirs), *(word for own in name for word in ("--weight", own))]
    subprocess.run(line, check=True, capture_output=True)
    assert own.read_bytes() == theirs.read_bytes() and own.stat().st_size > 100


def test_solids_that_cannot_be_written_say_why(tmp_path: Path) -> None:
    fitted = Engine.read(WEIGHTS).counterweight().adopt()
    with pytest.raises(lanchester.RequestError, match="must end in step, stl, glb, dxf or svg"):
        fitted.save_solids(tmp_path / "crankshaft.obj")
    with pytest.raises(lanchester.RequestError, match="outline of one part"):
        fitted.save_solids(tmp_path / "crankshaft.svg")
    with pytest.raises(lanchester.RequestError, match="STL and glTF alone"):
        fitted.save_solids(tmp_path / "crankshaft.step", facet=1e-5)
    with pytest.raises(lanchester.RequestError):
        fitted.save_solids(tmp_path / "crankshaft.stl", facet=-1e-5)
    with pytest.raises(lanchester.RequestError):
        fitted.save_solids(tmp_path / "crankshaft.step", weight="no such weight")
    with pytest.raises(lanchester.RequestError):
        fitted.save_solids(tmp_path / "crankshaft.step", crankshaft=1)
    kept = fitted.save_solids(tmp_path / "crankshaft.step")
    before = kept.read_bytes()
    with pytest.raises(lanchester.RequestError, match="not overwritten"):
        fitted.save_solids(kept, weight="web 1")
    assert kept.read_bytes() == before and len(list(tmp_path.iterdir())) == 1
