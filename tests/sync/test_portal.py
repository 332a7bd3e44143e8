from __future__ import annotations

import asyncio
import signal
import threading
from collections.abc import AsyncIterator, Iterator

import pytest

from jauspy.errors import TransportError
from jauspy.sync import portal as module
from jauspy.sync.portal import Portal


@pytest.fixture(autouse=True)
def ctrl_c() -> Iterator[None]:
    """Ctrl-C interrupts, also where the tests run in the background of a script, which ignores it."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


async def here() -> str:
    return threading.current_thread().name


async def forever(log: list[str]) -> None:
    log.append("begun")
    try:
        await asyncio.Event().wait()
    finally:
        await asyncio.sleep(0)
        log.append("tidied up")


def test_coroutines_run_in_another_thread():
    with Portal("other") as portal:
        assert portal.run(here()) == "other"
    assert not portal.is_open


def test_errors_are_raised_in_the_caller():
    async def fail() -> None:
        raise ValueError("a bug")

    with Portal() as portal, pytest.raises(ValueError, match="a bug"):
        portal.run(fail())


def test_closed_portal_is_an_error_and_can_be_reopened():
    portal = Portal()
    with pytest.raises(TransportError, match="not open"):
        portal.run(here())
    for _ in range(2):
        with portal:
            assert portal.run(here()) == "jauspy"


def test_ctrl_c_waits_for_the_clean_up():
    log: list[str] = []
    with Portal() as portal:
        interrupt = threading.Timer(0.0, lambda: signal.pthread_kill(threading.main_thread().ident, signal.SIGINT))

        async def interrupted() -> None:
            interrupt.start()
            await forever(log)

        with pytest.raises(KeyboardInterrupt):
            portal.run(interrupted())
        assert log[-1:] == ["tidied up"]
        assert portal.run(here()) == "jauspy"


def test_ctrl_c_before_the_start_is_raised(monkeypatch):
    """The coroutine is cancelled in the same turn of the loop in which it was to start."""
    with Portal() as portal:
        loop_is_busy, go_on = threading.Event(), threading.Event()

        def block() -> None:
            loop_is_busy.set()
            assert go_on.wait(20)

        portal._loop.call_soon_threadsafe(block)
        assert loop_is_busy.wait(20)
        interrupted = []

        def result(*_: object) -> None:
            if not interrupted:
                interrupted.append(True)
                threading.Timer(0.0, go_on.set).start()
                raise KeyboardInterrupt

        monkeypatch.setattr(module.Future, "result", result)
        with pytest.raises(KeyboardInterrupt):
            portal.run(here())
        monkeypatch.undo()
        assert portal.run(here()) == "jauspy"


def test_ctrl_c_before_the_next_item_leaves_no_coroutine(monkeypatch):
    """A coroutine that is never awaited is a warning, which is an error here."""

    class Numbers:
        def __aiter__(self) -> AsyncIterator[int]:
            return self

        async def __anext__(self) -> int:
            return 1

    def interrupted(_: object) -> None:
        raise KeyboardInterrupt

    with Portal() as portal:
        numbers = portal.iterate(Numbers())
        assert next(numbers) == 1
        monkeypatch.setattr(portal, "run", interrupted)
        with pytest.raises(KeyboardInterrupt):
            next(numbers)


def test_close_ends_calls_of_other_threads():
    log: list[str] = []
    portal = Portal()
    portal.open()
    problems: list[Exception] = []

    def wait() -> None:
        try:
            portal.run(forever(log))
        except TransportError as error:
            problems.append(error)

    thread = threading.Thread(target=wait)
    thread.start()
    while not log:
        portal.run(here())
    portal.close()
    thread.join(20)
    assert (log, str(problems[0])) == (["begun", "tidied up"], "the portal was closed during this call")


def test_call_from_its_own_loop_is_an_error():
    with Portal() as portal:

        async def again() -> str:
            return portal.run(here())

        with pytest.raises(TransportError, match="its own event loop"):
            portal.run(again())
