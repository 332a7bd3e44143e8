from __future__ import annotations

import struct
import threading

import pytest

from jauspy.platform.shared_state import StateReader, StateWriter


@pytest.fixture
def pair():
    writer = StateWriter(512, clock=lambda: 12.5)
    reader = StateReader(writer.descriptor)
    yield writer, reader
    reader.close()
    writer.close()


def numbers(value: float) -> bytes:
    return struct.pack("=512d", *[value] * 512)


def test_reader_gets_the_last_state_and_its_time(pair):
    writer, reader = pair
    for value in (1.0, 2.0):
        writer.write(numbers(value))
        assert reader.read() == (12.5, numbers(value))


def test_a_state_is_never_read_in_parts(pair):
    writer, reader = pair
    writer.write(numbers(0.0))
    ending = threading.Event()

    def write() -> None:
        value = 0.0
        while not ending.is_set():
            value += 1.0
            writer.write(numbers(value))

    thread = threading.Thread(target=write)
    thread.start()
    try:
        seen = [struct.unpack("=512d", reader.read()[1]) for _ in range(2000)]
    finally:
        ending.set()
        thread.join()
    assert all(len(set(state)) == 1 for state in seen)
    assert [state[0] for state in seen] == sorted(state[0] for state in seen)


def test_reader_waits_for_an_interrupted_write(pair, monkeypatch):
    writer, reader = pair
    writer.write(numbers(1.0))
    unfinished = (3).to_bytes(8, "little")
    writer._memory[:8] = unfinished
    waited = []

    def sleep(seconds: float) -> None:
        waited.append(seconds)
        if len(waited) == 20:
            writer.write(numbers(2.0))

    monkeypatch.setattr("time.sleep", sleep)
    assert reader.read() == (12.5, numbers(2.0))
    assert len(waited) == 20
    writer._memory[:8] = unfinished
    monkeypatch.setattr("time.sleep", lambda _: None)
    with pytest.raises(RuntimeError, match="stopped in the middle of writing"):
        reader.read()


def test_a_state_of_another_length_is_an_error(pair):
    with pytest.raises(ValueError, match="8 bytes of state, and there is room for 4096"):
        pair[0].write(bytes(8))


def test_close_may_be_called_twice():
    writer = StateWriter(1)
    writer.close()
    writer.close()
    assert writer.descriptor == -1
