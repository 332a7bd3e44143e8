"""Where a component is that discovery does not find, by the status of this machine's node manager."""

from __future__ import annotations

import json
import socket
import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from jauspy.ids import JausID
from jauspy.inspection.doctor.examination import known_address
from jauspy.transport.node_status import SOCKET_NAME

HERE, THERE = JausID(101, 1, 102), JausID(102, 1, 102)


@pytest.fixture
def serve(root: Path) -> Iterator[Callable[[dict[str, Any]], None]]:
    """Serves a status in the local root."""
    listener = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
    listener.bind(str(root / SOCKET_NAME))
    listener.listen()

    def start(status: dict[str, Any]) -> None:
        def work() -> None:
            client, _ = listener.accept()
            with client:
                client.sendall(json.dumps(status).encode())

        threading.Thread(target=work, daemon=True).start()

    with listener:
        yield start


def status(address: object) -> dict[str, Any]:
    peer = {"id": str(THERE), "address": "10.0.0.7:3795", "heard": 1.0}
    return {"components": [{"id": str(HERE)}], "peers": [peer], "networks": [{"name": "lan", "address": address}]}


@pytest.mark.parametrize(
    ("id", "address", "found"),
    [
        (HERE, "127.0.0.1:3794", ("127.0.0.1", 3794)),
        (HERE, "0.0.0.0:3800", ("10.0.0.2", 3800)),
        (HERE, "[::]:3800", None),
        (HERE, None, None),
        (THERE, "127.0.0.1:3794", ("10.0.0.7", 3795)),
        (JausID(103, 1, 1), "127.0.0.1:3794", None),
    ],
)
def test_where_a_component_is(
    serve: Callable[[dict[str, Any]], None], root: Path, id: JausID, address: object, found: object
) -> None:
    serve(status(address))
    assert known_address(root, id, ("10.0.0.2",)) == found


@pytest.mark.parametrize("networks", [None, 3, [3], [{}], [{"address": "999.1.1.1:3"}]])
def test_a_strange_status_is_no_address(serve: Callable[[dict[str, Any]], None], root: Path, networks: object) -> None:
    serve(status("127.0.0.1:1") | {"networks": networks})
    assert known_address(root, HERE) is None
