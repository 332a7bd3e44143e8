"""A node manager that is up before its network is."""

import asyncio
import socket
from pathlib import Path

import pytest

from jauspy.ids import EVERYONE, JausID
from jauspy.node import NodeConfig, NodeManager
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Broadcast, Packet
from jauspy.testing import until
from jauspy.transport import multicast

ABSENT = "192.0.2.1"  # for documentation (RFC 5737), so nobody's
ID = JausID.parse("126.1.11")


async def test_missing_interface_is_logged_and_retried(
    root: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.setattr(multicast, "WATCH_INTERVAL", 0.02)
    attempts: list[multicast.Memberships] = []
    refresh = multicast.Memberships.refresh

    def noted(self: multicast.Memberships) -> None:
        attempts.append(self)
        refresh(self)

    monkeypatch.setattr(multicast.Memberships, "refresh", noted)
    config = NodeConfig(address="127.0.0.1", port=0, local_root=root, multicast_interfaces=(ABSENT,))
    async with NodeManager(config) as node:
        await until(lambda: len(attempts) > 2)
        assert node.counters["multicast.not_joined"] == 1
    assert [record for record in caplog.messages if f"no multicasts on interface {ABSENT}" in record] != []
    count = len(attempts)
    await asyncio.sleep(0.06)
    assert len(attempts) == count


async def test_broadcasts_use_the_present_interfaces(root: Path) -> None:
    """One interface that is gone neither stops the node manager nor the multicasts on the others."""
    config = NodeConfig(address="127.0.0.1", port=0, local_root=root, multicast_interfaces=(ABSENT, "127.0.0.1"))
    async with NodeManager(config) as node:
        with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as component:
            component.setblocking(False)
            component.bind(str(root / str(int(ID))))
            everybody = judp.pack(Packet(ID, EVERYONE, b"\x00\x2b\x04", 1, broadcast=Broadcast.GLOBAL))
            for data in (junior.connect(ID), everybody, everybody):
                component.sendto(data, str(node.path))
            await until(lambda: node.counters["routed.multicast"] == 2)
        if not node.counters["multicast.not_joined"]:
            await until(lambda: node.counters["echoes"] == 2)
