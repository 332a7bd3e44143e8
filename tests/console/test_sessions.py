"""Sessions of the console, and how often a login may fail."""

from __future__ import annotations

import pytest

pytest.importorskip("cryptography", reason="needs the extra 'console'")

from jauspy.console.users import (
    FAILURE_TIME,
    IDLE_TIME,
    LIFETIME,
    MAX_ADDRESSES,
    MAX_FAILURES,
    MAX_FAILURES_IN_ALL,
    MAX_SESSIONS,
    MAX_SESSIONS_OF_USER,
    LoginLimit,
    Sessions,
    User,
)

ANNA = User("anna", "operator", 127)


def test_a_session_ends_when_idle_or_old() -> None:
    sessions = Sessions()
    session = sessions.begin(ANNA, "10.0.0.1", 0.0)
    assert session is not None
    assert sessions.find("guessed", 1.0) is None
    assert sessions.find(session.key, IDLE_TIME - 1) is session
    assert sessions.find(session.key, 2 * IDLE_TIME) is None
    assert session.ended.is_set()

    used = sessions.begin(ANNA, "10.0.0.1", 0.0)
    assert used is not None
    used.sockets = 1
    assert sessions.find(used.key, LIFETIME - 1) is used, "a session with an open page is not idle"
    assert sessions.find(used.key, LIFETIME) is None


def test_sessions_are_bounded() -> None:
    sessions = Sessions()
    own = [sessions.begin(ANNA, "10.0.0.1", float(each)) for each in range(MAX_SESSIONS_OF_USER + 1)]
    assert [each is not None and each.ended.is_set() for each in own] == [True, *[False] * MAX_SESSIONS_OF_USER]
    others = [sessions.begin(User(str(each), "operator", 127), "10.0.0.1", 5.0) for each in range(MAX_SESSIONS)]
    assert len(sessions) == MAX_SESSIONS
    assert others[-1] is None


def test_logins_that_fail_are_limited_by_address() -> None:
    limit = LoginLimit()
    for each in range(MAX_FAILURES):
        assert limit.wait("10.0.0.1", float(each)) == 0.0
        limit.failed("10.0.0.1", float(each))
    assert limit.wait("10.0.0.1", 10.0) == FAILURE_TIME - 10.0
    assert limit.wait("10.0.0.2", 10.0) == 0.0
    assert limit.wait("10.0.0.1", FAILURE_TIME) == 0.0, "the first failure is old"
    limit.succeeded("10.0.0.1")
    assert limit.wait("10.0.0.1", 10.0) == 0.0


def test_networks_of_ipv6_count_as_one_and_all_is_bounded() -> None:
    limit = LoginLimit()
    for each in range(MAX_FAILURES):
        limit.failed(f"2001:db8::{each}", 0.0)
    assert limit.wait("2001:db8::ffff", 1.0) > 0
    assert limit.wait("2001:db8:0:1::1", 1.0) == 0.0
    limit = LoginLimit()
    for each in range(2 * MAX_ADDRESSES):
        limit.failed(f"10.1.{each // 256}.{each % 256}", float(each))
    assert len(limit._failures) == MAX_ADDRESSES
    limit = LoginLimit()
    for each in range(MAX_FAILURES_IN_ALL):
        limit.failed(f"10.1.0.{each}", 0.0)
    assert limit.wait("10.9.9.9", 1.0) > 0
