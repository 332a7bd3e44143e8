"""Old headers: examples from the wire, both versions, and what is malformed."""

import pytest
from hypothesis import given, strategies as st

from jauspy.errors import ProtocolError
from jauspy.ids import JausID
from jauspy.protocol import judp, legacy
from jauspy.protocol.header import Ack, DataFlag, Packet, Priority
from jauspy.protocol.legacy import LegacyVersion

V1 = bytes.fromhex("010000001a06023412010165000801640 00a00010000010203040506070809".replace(" ", ""))
OPC = bytes.fromhex("4a41555330312e30 06023412 0101c800 01016400 0200 2300 0102")
HEARTBEAT = bytes.fromhex("4a41555330312e30 06020242 0101ffff 01010182 0000 75f4")


def ra(code: int = 0, properties: int = 6, size: int | None = None, payload: bytes = b"\x02\x20") -> bytes:
    head = bytes([properties, 2]) + code.to_bytes(2, "little") + bytes.fromhex("0101650008016400")
    return head + (len(payload) if size is None else size).to_bytes(2, "little") + b"\x01\x00" + payload


def v1(body: bytes) -> bytes:
    return b"\x01\0\0" + len(body).to_bytes(2, "big") + body


def test_captured_version_1_is_parsed() -> None:
    (packet,) = legacy.parse(V1)
    assert (packet.version, packet.code) == (LegacyVersion.V1, 0x1234)
    assert (packet.raw.destination, packet.raw.source) == (0x00650101, 0x00640108)
    assert packet.payload == bytes(range(10))
    assert packet.as_datagram(LegacyVersion.V1) == V1


def test_captured_opc_is_converted_to_version_1() -> None:
    (packet,) = legacy.parse(OPC)
    assert (packet.version, packet.payload.hex()) == (LegacyVersion.OPC, "0102")
    assert packet.as_datagram(LegacyVersion.OPC) == OPC
    assert legacy.parse(packet.as_datagram(LegacyVersion.V1))[0]._replace(version=LegacyVersion.OPC) == packet
    (heartbeat,) = legacy.parse(HEARTBEAT)
    assert (heartbeat.code, heartbeat.raw.source) == (0x4202, 0x82010101)


def test_packet_without_command_code_is_converted() -> None:
    (packet,) = legacy.parse(v1(ra(properties=0x19)))
    assert judp.unpack(packet.as_current()) == [
        Packet(JausID(100, 1, 8), JausID(101, 1, 1), b"\x02\x20", 1, Priority.HIGH, ack=Ack.REQUIRED)
    ]


@pytest.mark.parametrize(
    ("control", "flag"),
    [(0, DataFlag.SINGLE), (1, DataFlag.FIRST), (2, DataFlag.MIDDLE), (4, DataFlag.MIDDLE), (8, DataFlag.LAST)],
)
def test_fragments_are_mapped(control: int, flag: DataFlag) -> None:
    (packet,) = legacy.parse(v1(ra(size=2 | control << 12)))
    assert judp.unpack(packet.as_current())[0].data_flag is flag


def test_priorities_as_known_node_managers_map_them() -> None:
    mapped = [legacy.priority(v1(ra(properties=value))) for value in range(16)]
    assert mapped == [0] * 6 + [1] * 3 + [2] * 3 + [3] * 4
    assert legacy.priority(OPC) == Priority.STANDARD


def test_several_packets_in_one_datagram() -> None:
    both = v1(ra(payload=b"\x02\x20")) + v1(ra(payload=b"\x05\x20\x01"))[1:]
    assert [packet.payload for packet in legacy.parse(both)] == [b"\x02\x20", b"\x05\x20\x01"]


@pytest.mark.parametrize(
    ("data", "reason"),
    [
        (b"\x01", "empty"),
        (b"\x01\0\0\0", "truncated"),
        (V1[:-1], "truncated"),
        (v1(ra()[:15]), "truncated"),
        (v1(ra(size=9)), "size"),
        (v1(ra(size=2 | 3 << 12)), "data_control"),
        (v1(b"\x06\x03" + ra()[2:]), "ra_version"),
        (b"\x01\0\2" + v1(ra())[3:], "compressed"),
        (b"JAUS01.0\x06", "truncated"),
    ],
)
def test_malformed_legacy_packets_are_rejected(data: bytes, reason: str) -> None:
    with pytest.raises(ProtocolError) as caught:
        legacy.parse(data)
    assert caught.value.reason == reason


@given(st.sampled_from([b"\x01", b"\x01\0\0\0\x10\x06\x02", b"JAUS01.0", b"JAUS01.0\x06\x02"]), st.binary(max_size=60))
def test_arbitrary_bytes_raise_protocol_errors_only(start: bytes, rest: bytes) -> None:
    try:
        packets = legacy.parse(start + rest)
    except ProtocolError:
        return
    for packet in packets:
        judp.unpack(packet.as_current())
