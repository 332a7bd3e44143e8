"""A robot's node manager: one's own, or somebody else's that may end."""

import asyncio
from pathlib import Path

import psutil
import pytest

from jauspy.cli import up
from jauspy.node import NodeConfig, NodeManager
from jauspy.protocol import junior
from jauspy.testing import until
from jauspy.transport import local as local_socket


@pytest.fixture(autouse=True)
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(up, "RESTART_DELAY", 0.05)


def is_there(root: Path) -> bool:
    return local_socket.is_alive(root / junior.SOCKET_NAME)


def children() -> list[psutil.Process]:
    """Node managers; Python may have started helpers of its own for earlier tests."""
    return [each for each in psutil.Process().children() if "node-manager" in each.cmdline()]


@pytest.mark.slow
async def test_foreign_node_manager_is_replaced_when_it_ends(
    root: Path, free_port: int, capsys: pytest.CaptureFixture[str]
) -> None:
    other = NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root))
    await other.open()
    async with up.node_manager(root, free_port) as node:
        assert node.where == f"was running, local sockets in {root}"
        assert children() == []
        await other.close()
        await until(lambda: is_there(root))
        await until(lambda: "starting one" in capsys.readouterr().err)
        assert len(children()) == 1
        children()[0].kill()
        await until(lambda: not is_there(root))
        await until(lambda: is_there(root))
    assert children() == []
    assert list(root.iterdir()) == []


@pytest.mark.slow
async def test_child_is_stopped_if_the_supervisor_never_ran(root: Path, free_port: int) -> None:
    async with up.node_manager(root, free_port) as node:
        assert node.where == f"UDP port {free_port}, local sockets in {root}"
        assert len(children()) == 1
    assert children() == []


@pytest.mark.slow
async def test_repeated_start_error_is_logged_once(
    root: Path, free_port: int, capsys: pytest.CaptureFixture[str]
) -> None:
    """The port is taken, so none can be started; when it is free, one is."""
    with_port = NodeManager(NodeConfig(address="127.0.0.1", port=free_port, local_root=root / "elsewhere"))
    other = NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root))
    await with_port.open()
    await other.open()
    reported = ""
    async with up.node_manager(root, free_port):
        await other.close()
        async with asyncio.timeout(20):
            while "--port" not in reported:
                reported += capsys.readouterr().err
                await asyncio.sleep(0.02)
        await with_port.close()
        await until(lambda: is_there(root))
        reported += capsys.readouterr().err
    assert reported.count("Error") == 1
