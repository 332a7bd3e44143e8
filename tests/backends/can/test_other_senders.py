"""Counting of frames that nobody but a drive or the master may have sent."""

from __future__ import annotations

import pytest

from jauspy.backends.can.other_senders import Balance

LATE = 10


@pytest.fixture
def balance() -> Balance:
    return Balance(LATE)


def test_frames_beyond_those_due_are_too_many(balance: Balance) -> None:
    for _ in range(5):
        balance.add_due()
    balance.received = 5
    assert balance.excess() == 0
    balance.received = 8
    assert balance.excess() == 3


def test_answers_that_waited_while_a_drive_was_held_up_are_not_too_many_after_a_restart(balance: Balance) -> None:
    for _ in range(12):
        balance.add_due()
    balance.received = 1  # the first of the late ones
    balance.restart()
    balance.received += 11
    assert balance.excess() <= 1


def test_frames_that_were_lost_before_a_restart_leave_room_for_late_ones_only(balance: Balance) -> None:
    for _ in range(1000):
        balance.add_due()
    balance.restart()
    balance.received += 2 * LATE + 1
    assert balance.excess() > LATE


def test_frames_too_many_are_forgotten_by_a_restart(balance: Balance) -> None:
    balance.received = 30
    balance.restart()
    assert balance.excess() == 0
