"""Faults of a real network between two hosts: what is not permitted, an MTU that differs, interfaces that are down."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

from tests.helpers.namespaces import peer, run_verb
from tests.helpers.udp_peer import GROUP

PEER_HOST = "10.77.0.2"


def examine(namespace: str, root: Path, *arguments: str) -> dict[str, dict[str, str]]:
    """The findings that are not well, by the name of the check."""
    where = ("--local-root", str(root), "--multicast-group", GROUP)
    done = run_verb(namespace, "doctor", *arguments, "--json", *where)
    found = [json.loads(line) for line in done.stdout.splitlines()]
    assert found, done.stderr
    assert done.status == any(finding["severity"] == "fail" for finding in found)
    return {finding["check"]: finding for finding in found if finding["severity"] != "ok"}


def ip(namespace: str, *words: str) -> None:
    subprocess.run(["ip", "-n", namespace, *words], check=True, capture_output=True, timeout=20)


def test_healthy_network(cable: tuple[str, str], root: Path) -> None:
    with peer(cable[1], PEER_HOST):
        found = examine(cable[0], root, "101.1.1")
    assert found.keys() == {"port", "sockets", "group"}
    assert {finding["severity"] for finding in found.values()} == {"warn"}  # no node manager here


def test_an_mtu_that_differs(cable: tuple[str, str], root: Path) -> None:
    ip(cable[1], "link", "set", f"jv{os.getpid()}b", "mtu", "600")
    with peer(cable[1], PEER_HOST):
        found = examine(cable[0], root, "101.1.1")
    assert found["fragments"]["what"] == "large datagrams do not reach 101.1.1"
    ip(cable[0], "link", "set", f"jv{os.getpid()}a", "mtu", "600")
    with peer(cable[1], PEER_HOST):
        found = examine(cable[0], root, "101.1.1")
    assert "fragments" not in found
    assert found["MTU"]["what"].endswith("has an MTU of 600 bytes only")


def test_peer_to_which_nothing_may_be_sent(cable: tuple[str, str], root: Path) -> None:
    ip(cable[0], "route", "add", "prohibit", "10.77.0.2")
    with peer(cable[1], PEER_HOST):
        found = examine(cable[0], root, "101.1.1")
    assert found["firewall"]["what"] == "nothing can be sent to 10.77.0.2:3794: Permission denied"


def test_interface_that_is_down(cable: tuple[str, str], root: Path) -> None:
    ip(cable[0], "link", "set", f"jv{os.getpid()}a", "down")
    found = examine(cable[0], root)
    assert found["interface"]["what"].endswith("is down")
    assert "discovery" in found


def test_interface_without_multicasts(cable: tuple[str, str], root: Path) -> None:
    ip(cable[0], "link", "set", f"jv{os.getpid()}a", "multicast", "off")
    found = examine(cable[0], root)
    assert "does not send multicasts" in found["interface"]["what"]


def test_host_that_is_not_there(cable: tuple[str, str], root: Path) -> None:
    with peer(cable[1], PEER_HOST):
        found = examine(cable[0], root, "101.1.1", "--connect", "udp://10.77.0.2:3795")
        assert found["peer"]["what"] == "no program has UDP port 3795 on 10.77.0.2"
        ip(cable[1], "route", "add", "prohibit", "10.77.0.1")
        found = examine(cable[0], root, "101.1.1", "--connect", "udp://10.77.0.2")
    assert "get no answer" in found["peer"]["what"]
