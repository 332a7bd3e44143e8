"""Whom verbs talk to, and as whom."""

import os
import socket

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
