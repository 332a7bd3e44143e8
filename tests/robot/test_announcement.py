"""A robot that makes itself known to a console."""

from __future__ import annotations

from datetime import UTC, datetime

import pytest

from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages.core import QueryIdentification, ReportIdentification
from jauspy.protocol import judp
from jauspy.protocol.addressing import GroupPort, LocalPort, UdpPort
from jauspy.protocol.header import Broadcast, Packet
from jauspy.protocol.routing import Router
from jauspy.robot import robot_files
from jauspy.robot.hosts import ANNOUNCEMENT_PERIOD, CONSOLE_SILENCE, Announcement
from jauspy.services.core import Discovery
from jauspy.services.host import Host

ME, CONSOLE, OTHER = JausID(105, 1, 1), JausID(42, 1, 1), JausID(42, 1, 2)
ANSWER = ReportIdentification(2, 10001, "console").encode()


@pytest.fixture
def host():
    return Host(ME, [Discovery()], utc_now=lambda: datetime(2026, 1, 1, tzinfo=UTC))


def asked(host, seconds):
    """When the console was asked, within a time."""
    times, end = [], host.now + seconds
    while (due := host.next_timeout()) is not None and due <= end:
        host.handle_timeout(due)
        times += [due for each in host.poll_output(due) if each.destination == CONSOLE]
    return times


def test_queries_repeat_until_answered(host):
    announcement = Announcement(host, CONSOLE)
    (first,) = host.poll_output(0.0)
    assert (first.destination, QueryIdentification.decode(first.payload).CODE) == (CONSOLE, QueryIdentification.CODE)
    assert asked(host, 3 * ANNOUNCEMENT_PERIOD) == [
        ANNOUNCEMENT_PERIOD,
        2 * ANNOUNCEMENT_PERIOD,
        3 * ANNOUNCEMENT_PERIOD,
    ]
    assert not announcement.intercept(Packet(OTHER, ME, ANSWER))
    assert not announcement.intercept(Packet(CONSOLE, ME, QueryIdentification(2).encode()))
    assert asked(host, ANNOUNCEMENT_PERIOD) == [4 * ANNOUNCEMENT_PERIOD]
    assert announcement.intercept(Packet(CONSOLE, ME, ANSWER))
    assert asked(host, CONSOLE_SILENCE - 0.1) == []


def test_queries_are_repeated_once_the_console_is_silent(host):
    """Also for the next console of the same id, which may be on another machine."""
    announcement = Announcement(host, CONSOLE)
    assert asked(host, 0.0) == []
    announcement.intercept(Packet(CONSOLE, ME, ANSWER))
    host.handle_timeout(8.0)
    assert not announcement.intercept(Packet(CONSOLE, ME, QueryIdentification(2).encode()))
    left = 8.0 + CONSOLE_SILENCE
    host.poll_output(8.0)
    assert asked(host, 3 * ANNOUNCEMENT_PERIOD + 2.0) == [left, left + ANNOUNCEMENT_PERIOD]
    announcement.intercept(Packet(CONSOLE, ME, ANSWER))
    assert asked(host, CONSOLE_SILENCE - 0.1) == []


def test_queries_are_multicast_even_if_an_address_of_the_console_is_known(host):
    """It is the address of an earlier console, which may be switched off."""
    Announcement(host, CONSOLE)
    (query,) = host.poll_output(0.0)
    assert query.broadcast is Broadcast.GLOBAL
    packet = judp.pack(Packet(ME, CONSOLE, query.payload, 7, broadcast=query.broadcast))
    router = Router("/robot", addresses={CONSOLE: [UdpPort("192.0.2.9", 3794)]})
    router.receive(packet, LocalPort(f"/robot/{int(ME)}"), 0.0)
    assert {type(port) for port, _ in router.poll_output()} == {UdpPort, GroupPort}


@pytest.mark.parametrize(("id", "problem"), [("42", "is not a JAUS id"), ("42.1.255", "has wildcards")])
def test_console_must_be_one_component(tmp_path, id, problem):
    path = tmp_path / "mine.toml"
    path.write_text(f'extends = "igvc"\n[[modules]]\ntype = "CM-MOB"\ncomponent = 1\nannounce_to = "{id}"\n')
    with pytest.raises(ConfigError, match=problem):
        robot_files.load(path)
