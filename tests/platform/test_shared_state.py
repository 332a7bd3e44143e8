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


def test_the_reader_sees_what_was_written_last_and_when(pair):
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


def test_a_state_of_another_length_is_an_error(pair):
    with pytest.raises(ValueError, match="8 bytes of state, and there is room for 4096"):
        pair[0].write(bytes(8))


def test_closing_twice_is_fine():
    writer = StateWriter(1)
    writer.close()
    writer.close()
    assert writer.descriptor == -1
