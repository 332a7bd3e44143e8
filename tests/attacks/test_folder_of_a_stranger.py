"""A file author's folder has modules named as those of jauspy: processes that are started in it import none of them."""

from __future__ import annotations

import signal
from pathlib import Path

import pytest

from jauspy.cli.processes import ChildFailed, ChildProcess
from jauspy.worker_process import WorkerProcess

CODE = "import pathlib\npathlib.Path(__file__).resolve().with_name('ran').touch()\n"


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The current directory."""
    (tmp_path / "jauspy").mkdir()
    for name in ("jauspy/__init__.py", "jauspy/worker_process.py", "typer.py", "numpy.py", "struct.py"):
        (tmp_path / name).write_text(CODE)
    monkeypatch.chdir(tmp_path)
    return tmp_path


async def test_workers_import_nothing_from_the_current_directory(folder: Path) -> None:
    worker = await WorkerProcess.start("json", 0, ())
    await worker.stop()
    assert await worker.wait() != -signal.SIGKILL
    assert not list(folder.rglob("ran"))


@pytest.mark.slow
async def test_commands_import_nothing_from_the_current_directory(folder: Path) -> None:
    with pytest.raises(ChildFailed):
        async with ChildProcess("command", ["node-manager", "--port", "none"]):
            pass
    assert not list(folder.rglob("ran"))
