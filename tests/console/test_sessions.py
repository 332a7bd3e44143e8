"""Sessions of the console."""

from __future__ import annotations

import pytest

pytest.importorskip("cryptography", reason="needs the extra 'console'")

from jauspy.console.users import (
    IDLE_TIME,
    LIFETIME,
    LOCAL,
    MAX_SESSIONS,
    MAX_SESSIONS_OF_USER,
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


def test_sessions_without_a_login_last_until_there_are_too_many() -> None:
    sessions = Sessions(lasting=True)
    first, second = (sessions.begin(LOCAL, "localhost", float(each)) for each in range(2))
    assert first is not None
    assert second is not None
    first.control_sockets = 1
    assert sessions.find(first.key, 10 * LIFETIME) is first
    for _ in range(MAX_SESSIONS - 1):
        assert sessions.begin(LOCAL, "localhost", 20 * LIFETIME) is not None
    assert len(sessions) == MAX_SESSIONS
    assert second.ended.is_set(), "the oldest one without an open page"
    assert not first.ended.is_set()
