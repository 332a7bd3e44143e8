"""Who hears a message: listeners by its class and sender."""

from __future__ import annotations

from contextlib import ExitStack

import pytest

from jauspy import messages
from jauspy.codec.message import Message
from jauspy.ids import EVERYONE, JausID
from jauspy.messages.core import ReportStatus, ReportTime
from jauspy.messages.mobility import ReportLocalPose
from jauspy.ocu.replies import ReplyDispatcher

A, B = JausID(101, 1, 1), JausID(102, 1, 1)


@pytest.fixture
def dispatcher() -> ReplyDispatcher:
    return ReplyDispatcher(messages.registry, pytest.fail)


def test_listeners_hear_their_classes_from_their_senders(dispatcher: ReplyDispatcher) -> None:
    heard: list[tuple[str, type[Message], JausID]] = []

    def note(name: str):
        return lambda message, source: heard.append((name, type(message), source))

    status, time, pose = (message.encode() for message in (ReportStatus(1, 0), ReportTime(), ReportLocalPose(x=1.0)))
    with ExitStack() as stack:
        stack.enter_context(dispatcher.listening(A, note("a"), ReportStatus, ReportTime))
        stack.enter_context(dispatcher.listening(B, note("b"), ReportStatus))
        stack.enter_context(dispatcher.listening(EVERYONE, note("all"), ReportStatus))
        stack.enter_context(dispatcher.listening(JausID(102, 255, 255), note("robot"), ReportTime))
        assert dispatcher.dispatch(status, A)
        assert dispatcher.dispatch(time, A)
        assert dispatcher.dispatch(time, B)
        assert dispatcher.dispatch(status, B)
        assert not dispatcher.dispatch(pose, A)
    assert sorted(heard, key=str) == sorted(
        [
            ("a", ReportStatus, A),
            ("all", ReportStatus, A),
            ("a", ReportTime, A),
            ("robot", ReportTime, B),
            ("b", ReportStatus, B),
            ("all", ReportStatus, B),
        ],
        key=str,
    )
    assert not dispatcher.dispatch(status, A)
    assert not dispatcher._listeners, "nothing is kept of those that have left"


def test_a_listener_may_leave_while_it_hears(dispatcher: ReplyDispatcher) -> None:
    heard = []
    with ExitStack() as first, ExitStack() as second:

        def leave(name: str) -> None:
            heard.append(name)
            first.close()

        first.enter_context(dispatcher.listening(A, lambda *_: leave("first"), ReportStatus))
        second.enter_context(dispatcher.listening(A, lambda *_: heard.append("second"), ReportStatus))
        assert dispatcher.dispatch(ReportStatus(1, 0).encode(), A)
        assert dispatcher.dispatch(ReportStatus(1, 0).encode(), A)
    assert heard == ["first", "second", "second"]


def test_reports_of_one_sender_are_not_offered_to_listeners_to_others(dispatcher: ReplyDispatcher) -> None:
    """An operator has a subscription to each of hundreds of robots."""
    heard: list[JausID] = []
    with ExitStack() as stack:
        for subsystem in range(1, 501):
            stack.enter_context(
                dispatcher.listening(JausID(subsystem, 1, 1), lambda _, source: heard.append(source), ReportStatus)
            )
        assert [listener.source for listener in dispatcher._listeners[ReportStatus.CODE, A]] == [A]
        assert dispatcher.dispatch(ReportStatus(1, 0).encode(), A)
    assert heard == [A]
