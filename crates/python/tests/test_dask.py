"""Studies on a cluster of worker processes: the bytes of the single run, whatever happens on the way."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
import types
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import lanchester
import lanchester.dask
from lanchester import Engine, RequestError
from lanchester._blocks import check_paths
from lanchester.dask import BlockError, Blocks

dask = pytest.importorskip("dask")
distributed = pytest.importorskip("distributed")

ROOT = Path(__file__).parents[3]
PROGRAM = os.environ.get("LANCHESTER_PROGRAM")
FOUR = Engine.read(ROOT / "examples" / "in-line-4.toml")
PRODUCTION = Engine.read(ROOT / "examples" / "in-line-4-production.toml")
SEARCH: dict[str, Any] = {"minimise": ["force order 2", "couple order 1"], "throw_angles": "every 7.5 deg"}
SWEEP = FOUR.variants({"rod.length": np.linspace(0.13, 0.17, 384)})
ENERGY = "run.audit.energy"


@pytest.fixture(scope="module")
def cluster() -> Iterator[Any]:
    settings = {"distributed.scheduler.allowed-failures": 2, "distributed.comm.timeouts.connect": "60s"}
    with (
        dask.config.set(settings),
        distributed.LocalCluster(n_workers=3, threads_per_worker=1, processes=True, dashboard_address=None, silence_logs=60) as own,
    ):
        yield own


@pytest.fixture
def client(cluster: Any) -> Iterator[Any]:
    with distributed.Client(cluster, timeout="60s") as own:
        own.wait_for_workers(3, timeout=60)
        yield own


def sweep(folder: Path, client: Any, **further: Any) -> Blocks:
    return lanchester.dask.map("simulate", SWEEP, [ENERGY, "revolutions"], folder, client=client, parts=24, revolutions=1, imposed=True, **further)


def test_a_path_that_no_answer_has_is_refused_before_blocks_are_sent(tmp_path: Path) -> None:
    for path, words in (("run.audit.enrgy", "there is no `enrgy` below `run.audit`"), ("rn", "there is no `rn`")):
        with pytest.raises(RequestError, match=words):
            lanchester.dask.map("simulate", SWEEP, path, tmp_path / "runs", revolutions=1, imposed=True)
    assert not (tmp_path / "runs").exists()
    check_paths("loads", ["total.orders[1].force_forward[0]", "total.peaks.force.max.value", "parts[0].loads.peaks.couple.max.theta"])


def test_a_client_that_is_closed_is_told_with_how_to_go_on(cluster: Any, tmp_path: Path) -> None:
    client = distributed.Client(cluster, timeout="60s")
    client.wait_for_workers(3, timeout=60)
    folder = tmp_path / "runs"

    def close() -> None:
        while len(contents(folder)) < 2:
            time.sleep(0.01)
        client.close()

    closing = threading.Thread(target=close)
    closing.start()
    with pytest.raises(lanchester.LanchesterError, match="the same call with a new client goes on") as caught:
        sweep(folder, client)
    closing.join()
    assert not isinstance(caught.value, BlockError) and "is missing" in caught.value.message or "are missing" in caught.value.message
    kept = contents(folder)
    with distributed.Client(cluster, timeout="60s") as own:
        found = sweep(folder, own)
    assert 2 <= len(kept) < 24 and len(found.computed) == 24 - len(kept)
    assert all(contents(folder)[name] == bytes for name, bytes in kept.items())


def contents(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.glob("*.parquet")}


def program(*line: object) -> None:
    assert PROGRAM is not None
    done = subprocess.run([PROGRAM, *map(str, line)], capture_output=True, text=True, check=False)
    assert done.returncode in (0, 1), done.stderr


@pytest.fixture(scope="module")
def single(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The sweep without a cluster."""
    folder = tmp_path_factory.mktemp("single") / "sweep"
    found = sweep(folder, None)
    assert len(found.files) == 24 and len(found.computed) == 24
    return folder


def test_layouts_have_the_bytes_of_the_command_line(client: Any, tmp_path: Path) -> None:
    found = lanchester.dask.explore(FOUR, tmp_path / "layouts", client=client, parts=3, **SEARCH)
    assert found.answer.to_json() == FOUR.explore(**SEARCH).to_json()
    frame = found.to_dataframe()
    assert len(frame) == found.answer.counts.judged and frame["case"].is_unique
    assert found.merge(tmp_path / "whole.parquet").stat().st_size > 0
    if PROGRAM is None:
        pytest.skip("LANCHESTER_PROGRAM names no program; `cargo xtask python` does")
    options = [*(word for own in SEARCH["minimise"] for word in ("--minimise", own)), "--throw-angles", SEARCH["throw_angles"]]
    for number, own in enumerate(found.files, 1):
        part = tmp_path / f"part-{number}.parquet"
        program("explore", ROOT / "examples" / "in-line-4.toml", *options, "--save", part, "--part", f"{number}/3")
        assert own.read_bytes() == part.read_bytes(), own
    program("explore", ROOT / "examples" / "in-line-4.toml", *options, "--save", tmp_path / "single.parquet")
    assert (tmp_path / "single.parquet").read_bytes() == (tmp_path / "whole.parquet").read_bytes()
    program("merge", *found.files, "--output", tmp_path / "merged.parquet")
    assert (tmp_path / "merged.parquet").read_bytes() == (tmp_path / "whole.parquet").read_bytes()


def test_samples_have_the_bytes_of_the_command_line(client: Any, tmp_path: Path) -> None:
    found = lanchester.dask.scatter(PRODUCTION, tmp_path / "samples", client=client, shared=True, samples=20_000, orders_only=True)
    assert found.answer.to_json() == PRODUCTION.scatter(samples=20_000, orders_only=True).to_json()
    assert found.to_dataframe()["sample"].tolist() == list(range(20_000))
    found.merge(tmp_path / "whole.parquet")
    if PROGRAM is None:
        pytest.skip("LANCHESTER_PROGRAM names no program; `cargo xtask python` does")
    program("scatter", ROOT / "examples" / "in-line-4-production.toml", "--samples", 20_000, "--orders-only", "--save", tmp_path / "single.parquet")
    assert (tmp_path / "single.parquet").read_bytes() == (tmp_path / "whole.parquet").read_bytes()


def test_a_table_says_what_made_it(single: Path) -> None:
    import pyarrow.parquet

    first = sorted(single.glob("*.parquet"))[0]
    said = {key.decode(): value.decode() for key, value in pyarrow.parquet.read_metadata(first).metadata.items()}
    assert said["lanchester.study"] == "cases" and said["lanchester.version"] == lanchester.__version__
    assert '"question":"simulate"' in said["lanchester.request"] and said["lanchester.engine"] == FOUR.text
    assert said["lanchester.blocks"] == "0 to 1 of 24"


def test_engines_of_any_kind_are_rows(client: Any, tmp_path: Path) -> None:
    path = "total.peaks.force.max.value"
    engines = [Engine.template(name) for name in ("in-line-4", "v6-60", "twin-360")] * 12
    found = lanchester.dask.map("loads", engines, path, tmp_path / "engines", client=client, samples=1).to_dataframe()
    assert found[path].tolist() == lanchester.map("loads", engines, path, samples=1)[path].tolist()
    assert found["engine"].tolist() == [engine.name for engine in engines]
    # A column that is of texts in one slice alone is of texts in all.
    mixed = FOUR.variants({"piston.mass": [0.3] * 40 + ["310 g"]})
    masses = lanchester.dask.map("loads", mixed, path, tmp_path / "masses", client=client, samples=1).to_dataframe()
    assert masses["piston.mass"].tolist() == ["0.3"] * 40 + ["310 g"]


def test_killed_workers_lose_nothing(client: Any, single: Path, tmp_path: Path) -> None:
    folder, killed = tmp_path / "sweep", list[int]()

    def kill() -> None:
        while len(list(folder.glob("*.parquet"))) < 4:
            time.sleep(0.005)
        for pid in list(client.run(os.getpid).values())[:2]:
            os.kill(pid, signal.SIGKILL)
            killed.append(len(list(folder.glob("*.parquet"))))

    thread = threading.Thread(target=kill)
    thread.start()
    found = sweep(folder, client)
    thread.join()
    assert len(killed) == 2 and killed[0] < 24, f"killed with {killed} of 24 tables done"
    assert contents(folder) == contents(single)
    assert found.to_dataframe()["case"].tolist() == list(range(384))


def test_a_killed_client_goes_on(cluster: Any, client: Any, single: Path, tmp_path: Path) -> None:
    folder = tmp_path / "sweep"
    script = (
        "import sys; sys.path.insert(0, sys.argv[1])\n"
        "import distributed, test_dask\n"
        "from pathlib import Path\n"
        "with distributed.Client(sys.argv[2]) as client:\n"
        "    test_dask.sweep(Path(sys.argv[3]), client)\n"
    )
    process = subprocess.Popen([sys.executable, "-c", script, str(Path(__file__).parent), cluster.scheduler_address, str(folder)])
    while len(list(folder.glob("*.parquet"))) < 4:
        assert process.poll() is None
        time.sleep(0.005)
    process.kill()
    process.wait()
    (folder / ".new-left").write_bytes(b"begun")
    before = {path.name: path.stat().st_mtime_ns for path in folder.glob("*.parquet")}
    assert 4 <= len(before) < 24
    found = sweep(folder, client)
    assert len(found.computed) == 24 - len(before) and not (folder / ".new-left").exists()
    assert contents(folder) == contents(single)
    assert {name: (folder / name).stat().st_mtime_ns for name in before} == before, "what was done was computed again"
    assert sweep(folder, client).computed == []


def test_a_restarted_cluster_loses_nothing(client: Any, single: Path, tmp_path: Path) -> None:
    folder = tmp_path / "sweep"

    def restart() -> None:
        while len(list(folder.glob("*.parquet"))) < 4:
            time.sleep(0.005)
        client.restart(wait_for_workers=False)

    thread = threading.Thread(target=restart)
    thread.start()
    sweep(folder, client)
    thread.join()
    assert contents(folder) == contents(single)


def test_missing_blocks_are_named() -> None:
    named = lanchester.dask._blocks_of
    assert named([(2, 3)], 24) == "block 3 of 24 is" and named([(4, 5), (2, 4), (8, 9)], 24) == "blocks 3 to 5 and 9 of 24 are"
    assert named([(2 * own, 2 * own + 1) for own in range(10)], 24) == "blocks 1, 3, 5, 7, 9, 11, 13, 15 and 2 more stretches of 24 are"
    with pytest.raises(RequestError, match="`sheet` is a sheet"):
        sheet = lanchester.WorkshopSheet.from_dict({"name": "rotor"})
        lanchester.dask.map("crank_unbalance", [FOUR], "static_unbalance[0]", "nowhere", sheet=sheet)


def wait_for(folder: Path, count: int, process: Any) -> None:
    while len(contents(folder)) < count:
        assert process.poll() is None, "the scheduler ended by itself"
        time.sleep(0.005)


def test_a_dead_scheduler_loses_nothing(cluster: Any, single: Path, tmp_path: Path) -> None:
    """A scheduler of its own process is killed with blocks at work; a client of another cluster goes on from the tables."""
    folder, place = tmp_path / "sweep", tmp_path / "scheduler.json"
    line = [sys.executable, "-m", "distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard", "--scheduler-file", str(place)]
    quiet: dict[str, Any] = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    scheduler = subprocess.Popen(line, **quiet)
    workers: list[Any] = []
    try:
        while not (place.exists() and place.read_text()):
            assert scheduler.poll() is None, "the scheduler has not started"
            time.sleep(0.01)
        worker = [sys.executable, "-m", "distributed.cli.dask_worker", "--scheduler-file", str(place), "--nthreads", "1", "--no-dashboard", "--no-nanny", "--death-timeout", "20"]
        workers = [subprocess.Popen(worker, cwd=tmp_path, **quiet) for _ in range(2)]
        client = distributed.Client(scheduler_file=str(place), timeout="60s")
        client.wait_for_workers(2, timeout=60)
        done: list[int] = []

        def kill() -> None:
            wait_for(folder, 4, scheduler)
            scheduler.kill()
            done.append(len(contents(folder)))

        killing = threading.Thread(target=kill)
        killing.start()
        with pytest.raises(lanchester.LanchesterError) as caught:
            sweep(folder, client)
        killing.join()
        client.close(timeout=1)
    finally:
        for process in (scheduler, *workers):
            process.kill()
            process.wait()
    assert 4 <= done[0] < 24, f"killed with {done} of 24 tables done"
    # What is missing is said by its blocks and its place, and how to go on.
    message, kept = caught.value.message, contents(folder)
    assert "the scheduler has died" in message and message.endswith(f"of 24 are missing in {folder}")
    assert caught.value.hint is not None and "the same call with a new client goes on" in caught.value.hint
    before = {path.name: path.stat().st_mtime_ns for path in folder.glob("*.parquet")}
    with distributed.Client(cluster, timeout="60s") as own:
        own.wait_for_workers(3, timeout=60)
        found = sweep(folder, own)
    assert len(found.computed) == 24 - len(before) == 24 - len(kept), "something was lost, or computed twice"
    assert f"; {lanchester.dask._blocks_of(found.computed, 24)} missing" in message
    assert {name: (folder / name).stat().st_mtime_ns for name in before} == before, "what was done was computed again"
    assert contents(folder) == contents(single)
    assert found.to_dataframe()["case"].tolist() == list(range(384))


def hide() -> None:
    import sys

    sys.modules["hidden"] = sys.modules["lanchester"]
    sys.modules["lanchester"] = None  # type: ignore[assignment]


def show(version: str) -> None:
    import sys

    sys.modules["lanchester"] = sys.modules["hidden"]
    sys.modules["lanchester"].__version__ = version  # type: ignore[attr-defined]


def age() -> None:
    import lanchester

    lanchester.__version__ = "0.0.1"


def test_unfit_workers_are_named_with_their_block(client: Any, single: Path, tmp_path: Path) -> None:
    missing, old, fit = sorted(client.nthreads())
    client.run(hide, workers=[missing])
    client.run(age, workers=[old])
    with pytest.warns(UserWarning, match="another worker has computed it"):
        found = sweep(tmp_path / "sweep", client)
    reasons = {own.worker: own.reason for own in found.refusals}
    assert "the package lanchester is missing" in reasons[missing] and "it has lanchester 0.0.1" in reasons[old]
    assert all(own.end == own.first + 1 and own.of == 24 and "of 24 on tcp" in str(own) for own in found.refusals)
    assert contents(tmp_path / "sweep") == contents(single)
    client.run(hide, workers=[fit])
    client.run(hide, workers=[old])
    with pytest.raises(BlockError, match="stretches of blocks were not computed: block") as caught:
        sweep(tmp_path / "again", client)
    assert sum(own.end - own.first for own in caught.value.refusals) >= 22
    client.run(show, lanchester.__version__)


def test_what_cannot_be_computed_names_block_and_engine(client: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    rods = FOUR.variants({"rod.length": [0.15] * 100 + [-0.15]})
    with pytest.raises(BlockError, match="block 7 of 7 on tcp") as caught:
        lanchester.dask.map("loads", rods, "speed", tmp_path / "rods", client=client, samples=1)
    assert "engine 100" in str(caught.value) and len(list((tmp_path / "rods").glob("*.parquet"))) == 6

    def dies() -> Any:
        def end(*_: Any) -> None:
            import os

            os._exit(1)

        return types.FunctionType(end.__code__, {"__name__": "__main__", "__builtins__": __builtins__}, "end")

    monkeypatch.setattr(lanchester.dask, "_remote", dies)
    with pytest.raises(BlockError, match="block 1 of 1.*its workers died one after another: out of memory, or killed"):
        lanchester.dask.map("loads", FOUR.variants({"rod.length": [0.15]}), "speed", tmp_path / "one", client=client)


def test_folders_of_others_are_left_alone(tmp_path: Path) -> None:
    folder = tmp_path / "rods"
    rods = FOUR.variants({"rod.length": [0.15, 0.16]})
    lanchester.dask.map("loads", rods, "speed", folder, samples=1)
    with pytest.raises(RequestError, match="belongs to another study"):
        lanchester.dask.map("loads", rods, "speed", folder, samples=2)
    [table] = folder.glob("*.parquet")
    data = bytearray(table.read_bytes())
    data[8] ^= 1
    table.write_bytes(data)
    with pytest.raises(RequestError, match="cannot read"):
        lanchester.dask.map("loads", rods, "speed", folder, samples=1)
    for wrong, words in [({"sped": 1}, "no argument"), ({"parts": 0}, "from 1")]:
        with pytest.raises(RequestError, match=words):
            lanchester.dask.map("loads", rods, "speed", tmp_path / "other", **wrong)  # type: ignore[arg-type]
    with pytest.raises(RequestError, match="needs a path"):
        lanchester.dask.map("loads", rods, [], tmp_path / "other")
    with pytest.raises(RequestError, match="two columns"):
        lanchester.dask.map("loads", FOUR.variants({"speed": ["3000 rpm"]}), "speed", tmp_path / "other")


def test_a_cluster_without_workers_says_so(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("lanchester.dask.LONELY", 1.0)
    with distributed.LocalCluster(n_workers=0, processes=True, dashboard_address=None, silence_logs=60) as own, distributed.Client(own) as client:
        later = threading.Timer(4.0, own.scale, (1,))
        later.start()
        with pytest.warns(UserWarning, match="has had no worker for 1 s; 1 stretch of blocks wait"):
            found = lanchester.dask.map("loads", [FOUR], "speed", tmp_path / "one", client=client, samples=1)
        assert len(found.to_dataframe()) == 1


def test_wrong_requests_are_refused_before_anything_is_made(tmp_path: Path) -> None:
    wrong: list[tuple[Any, str]] = [
        (lambda: lanchester.dask.map("loads", FOUR, "speed", tmp_path / "a"), "a list of engines"),  # type: ignore[arg-type]
        (lambda: lanchester.dask.map("loads", [FOUR, "v6"], "speed", tmp_path / "a"), "got `str` at index 1"),  # type: ignore[list-item]
        (lambda: lanchester.dask.map("load", [FOUR], "speed", tmp_path / "a"), 'no question "load"'),
        (lambda: lanchester.dask.map("loads", [FOUR], "speed", tmp_path / "a", client="tcp://10.0.0.1:8786"), "needs a client"),
        (lambda: lanchester.dask.plan(FOUR, cores=0, **SEARCH), "`cores` needs"),
        (lambda: lanchester.dask.plan(FOUR, cores=1, samples=0, **SEARCH), "`samples` needs"),
    ]
    for call, words in wrong:
        with pytest.raises(RequestError, match=words):
            call()
    assert not list(tmp_path.iterdir())
