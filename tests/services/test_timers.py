from __future__ import annotations

from jauspy.services.service import Timers


def run(timers: Timers, now: float) -> None:
    for due in timers.due(now):
        call = timers.take(due)
        if call is not None:
            call()


def test_timers_fire_once_in_order() -> None:
    timers, fired = Timers(), []
    for at in (3.0, 1.0, 2.0):
        timers.set(at, at, lambda at=at: fired.append(at))
    assert timers.next() == 1.0
    run(timers, 2.0)
    run(timers, 2.0)
    assert fired == [1.0, 2.0]
    assert timers.next() == 3.0


def test_set_moves_and_cancel_removes_a_timer() -> None:
    timers, fired = Timers(), []
    timers.set("a", 1.0, lambda: fired.append("early"))
    timers.set("a", 5.0, lambda: fired.append("late"))
    timers.set("b", 1.0, lambda: fired.append("b"))
    timers.cancel("b")
    timers.cancel("b")
    assert timers.next() == 5.0
    run(timers, 4.9)
    assert fired == []
    run(timers, 5.0)
    assert fired == ["late"]
    assert timers.next() is None


def test_due_timer_can_cancel_or_move_another_due_one() -> None:
    timers, fired = Timers(), []

    def first() -> None:
        timers.cancel("cancelled")
        timers.set("moved", 9.0, lambda: fired.append("moved"))

    timers.set("first", 1.0, first)
    timers.set("cancelled", 2.0, lambda: fired.append("cancelled"))
    timers.set("moved", 2.0, lambda: fired.append("not moved"))
    run(timers, 3.0)
    assert fired == []
    run(timers, 9.0)
    assert fired == ["moved"]


def test_repeatedly_moved_timer_takes_no_memory() -> None:
    timers = Timers()
    for step in range(10_000):
        timers.set("watchdog", float(step), lambda: None)
    assert len(timers) == 1
    assert len(timers._heap) < 200
