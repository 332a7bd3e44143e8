"""The 21 bytes of Connect, Accept and Cancel, as real components and node managers send them."""

import pytest
from hypothesis import given, strategies as st

from jauspy.ids import JausID
from jauspy.protocol import junior

ID = JausID.parse("126.1.11")

SEEN = {
    junior.ControlKind.CONNECT: "010000001006020100000000000b017e0000000000",
    junior.ControlKind.ACCEPT: "0100000010060202000b017e000000000000000000",
    junior.ControlKind.CANCEL: "010000001006020300000000000b017e0000000000",
}


@pytest.mark.parametrize("kind", SEEN)
def test_control_messages_have_the_captured_bytes(kind: junior.ControlKind) -> None:
    make = {"CONNECT": junior.connect, "ACCEPT": junior.accept, "CANCEL": junior.cancel}[kind.name]
    assert make(ID).hex() == SEEN[kind]
    assert junior.parse(make(ID)) == junior.ControlMessage(kind, ID)


@given(st.binary(max_size=40))
def test_other_bytes_give_none_or_a_control_message(data: bytes) -> None:
    assert junior.parse(data) is None or data[0] == 1


@pytest.mark.parametrize("at", [0, 4, 6, 7, 17])
def test_changed_byte_is_no_control_message(at: int) -> None:
    data = bytearray(junior.connect(ID))
    data[at] ^= 0x40
    assert junior.parse(data) is None
