"""Whom verbs talk to, and as whom."""

import json
import os
import socket
import threading

import pytest

from jauspy.cli import client
from jauspy.errors import ConfigError
from jauspy.ids import JausID


@pytest.fixture(autouse=True)
def claims(monkeypatch):
    """Of this test alone: names of an own namespace, given back at the end."""
    found = []
    monkeypatch.setattr(client, "_claims", found)
    monkeypatch.setattr(client, "SUBSYSTEM", 40000 + os.getpid() % 20000)
    yield
    for claim in found:
        claim.close()


@pytest.mark.parametrize("text", ["0.0.0", "101.1.0", "101.0.1", "0.1.1"])
def test_ids_with_zeros_are_rejected(text):
    with pytest.raises(ConfigError, match=f"{text} is not the id of a component"):
        client.destination(text)


def test_wildcards_are_accepted():
    assert client.destination("65535.255.255").is_wildcard


def test_given_id_is_used():
    assert client.own_id("7.7.7", None) == "7.7.7"


def test_verbs_get_distinct_ids_and_reuse_the_first_free_one():
    first, second = (JausID.parse(client.own_id(None, "udp://127.0.0.1:1")) for _ in range(2))
    assert (first.component, second.component) == (2, 3)
    client._claims.pop(0).close()
    assert client.own_id(None, "udp://127.0.0.1:1") == str(first)


def test_ids_in_the_local_root_are_not_used(local_root):
    first = JausID(client.SUBSYSTEM, client.NODE, 2)
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as other:
        other.bind(str(local_root / str(int(first))))
        assert JausID.parse(client.own_id(None, f"local:{local_root}")).component == 3


def test_ids_of_other_hosts_are_left_alone(local_root):
    """The node manager would not accept them."""
    ids = [str(JausID(client.SUBSYSTEM, client.NODE, component)) for component in range(2, 8)]
    heard = [
        ("192.0.2.9:3794", 3.0),
        ("[fd00::9]:3794", 29.0),
        ("192.0.2.9:3794", 31.0),
        ("192.0.2.9:3794", None),
        ("127.0.0.1:40000", 3.0),
    ]
    peers = [{"id": id, "address": address, "heard": at} for id, (address, at) in zip(ids, heard, strict=False)]
    with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as server:
        server.bind(str(local_root / "JuniorRTE.status"))
        server.listen()

        def serve():
            for _ in range(2):
                connection, _ = server.accept()
                with connection:
                    connection.sendall(json.dumps({"peers": peers}).encode())

        thread = threading.Thread(target=serve)
        thread.start()
        assert client.ids_elsewhere(f"local:{local_root}") == set(ids[:2])
        assert client.own_id(None, f"local:{local_root}") == ids[2]
        thread.join()
    assert client.ids_elsewhere(f"local:{local_root}") == client.ids_elsewhere("udp://127.0.0.1:1") == set()
