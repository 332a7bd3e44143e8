"""In tshark the Lua dissector shows the fields that our decoder reads, and what is wrong where our decoder does."""

from __future__ import annotations

import json
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from random import Random
from typing import Final

import pytest
from tests.helpers.definitions import definition
from tests.helpers.tshark import (
    capture_of,
    difference,
    expected,
    frames,
    needs_tshark,
    serial_capture,
    tcp_capture,
    tshark,
)

import jauspy
from jauspy.capture.dissect import Content, dissect, read_message
from jauspy.capture.reader import CaptureReader
from jauspy.codec.message import Message
from jauspy.codec.registry import NO_HINTS, Hints, Registry
from jauspy.fuzz.messages import targets
from jauspy.fuzz.mutation import from_schemas, mutate
from jauspy.ids import JausID
from jauspy.inspection.dissector import make_dissector
from jauspy.messages import registry
from jauspy.messages.core.v1_1.access_control import RequestControl
from jauspy.messages.core.v1_1.events import Event
from jauspy.messages.mobility.v1_1.local_pose_sensor import ReportLocalPose
from jauspy.protocol import header, jserial, judp
from jauspy.protocol.header import Ack, DataFlag, Packet
from jauspy.schema import load_builtin

pytestmark = needs_tshark

GOLDEN: Final = Path(__file__).parents[1] / "golden"
CAPTURES: Final = Path(__file__).parents[2].parent / "shared" / "captures"
USER_LINK_TYPE: Final = 'uat:user_dlts:"User 0 (DLT=147)","jserial","0","","0",""'
ROBOT, OPERATOR = JausID(101, 1, 1), JausID(42, 1, 1)


def datagram(payload: bytes, sequence: int = 0, **flags: header.Ack | header.DataFlag) -> bytes:
    return judp.pack(Packet(ROBOT, OPERATOR, payload, sequence, **flags))  # type: ignore[arg-type]


@pytest.fixture(scope="module")
def lua(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The dissector of all built-in messages."""
    return written(tmp_path_factory.mktemp("lua"), registry)


def written(folder: Path, known: Registry, wanted: Hints = NO_HINTS) -> Path:
    path = folder / "jaus.lua"
    path.write_text(make_dissector(known, wanted).text, encoding="utf-8")
    return path


def mismatches(lua: Path, capture: Path, contents: list[Content]) -> Iterator[str]:
    """How what tshark shows of each message differs from what our decoder read."""
    shown = frames(lua, capture)
    assert len(shown) == len(contents)
    for number, (frame, content) in enumerate(zip(shown, contents, strict=True), 1):
        if content.message is None:
            if content.payload and not frame.experts:
                yield f"{number}: nothing is said about {content.problem}"
            continue
        found = difference(frame.messages[0], expected(content.message), cut=bool(content.deviations))
        if not found and bool(content.deviations) != bool(frame.experts):
            found = f"{frame.experts} where our decoder says {content.deviations}"
        if found:
            yield f"{number} {content.message.NAME}: {found}"


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(path.stem for path in GOLDEN.glob("*.jsonl") if path.stem != "scaling"))
def test_golden_vectors_are_shown_as_we_decode_them(name: str, tmp_path: Path) -> None:
    rows = [json.loads(line) for line in (GOLDEN / f"{name}.jsonl").read_text().splitlines()]
    wanted = Hints(version=rows[0]["version"])
    payloads = [bytes.fromhex(row["hex"]) for row in rows]
    contents = [read_message(payload, registry, wanted) for payload in payloads]
    assert sum(
        c.message is not None and row["message"] == c.message.NAME for c, row in zip(contents, rows, strict=True)
    )
    capture = capture_of(map(datagram, payloads), tmp_path / "vectors.pcapng")
    assert list(mismatches(written(tmp_path, registry, wanted), capture, contents)) == []


@pytest.mark.parametrize("name", ["sae_management", "cop_waypoint_run_2013"])
def test_captures_are_shown_as_we_decode_them(name: str, lua: Path) -> None:
    file = CAPTURES / f"{name}.pcap"
    if not file.is_file():
        pytest.skip(f"{file} is not there")
    with file.open("rb") as stream:
        parts = [dissect(each.payload, registry).parts for each in CaptureReader(stream, name=name)]
    shown = frames(lua, file, "-Y", "jaus")
    assert [len(frame.messages) for frame in shown] == [sum(part.content.payload != b"" for part in p) for p in parts]
    for frame, found in zip(shown, parts, strict=True):
        contents = [part.content for part in found if part.content.payload]
        for message, content in zip(frame.messages, contents, strict=True):
            if content.message is not None:
                assert difference(message, expected(content.message), cut=bool(content.deviations)) == ""
        assert bool(frame.experts) == any(not content.exact for content in contents)


@cache
def seeds() -> tuple[list[bytes], list[bytes]]:
    """Random messages of every kind that ids are decoded to, with messages in messages; and damaged ones."""
    known = [t for t in targets(registry, load_builtin()) if registry.class_of(t.id) is t.cls]
    made = list(from_schemas(known))
    rng = Random(7)
    chosen = rng.sample(made, 800)
    return [seed.data for seed in chosen if len(seed.data) < 3000], [
        data for seed in chosen if len(data := mutate(rng, seed, made)) < 60_000
    ]


@pytest.mark.slow
def test_random_messages_are_shown_as_we_decode_them(lua: Path, tmp_path: Path) -> None:
    valid, _ = seeds()
    contents = [read_message(payload, registry) for payload in valid]
    assert any(isinstance(getattr(content.message, "report_message", None), Message) for content in contents)
    capture = capture_of(map(datagram, valid), tmp_path / "valid.pcapng")
    found = list(mismatches(lua, capture, contents))
    assert found == [], "\n".join(found)


@pytest.mark.slow
def test_damaged_messages_are_shown_as_far_as_we_decode_them(lua: Path, tmp_path: Path) -> None:
    _, damaged = seeds()
    contents = [read_message(payload, registry) for payload in damaged]
    assert sum(bool(content.deviations) for content in contents) > 100
    capture = capture_of(map(datagram, damaged), tmp_path / "damaged.pcapng")
    found = list(mismatches(lua, capture, contents))
    assert found == [], "\n".join(found)


@pytest.mark.slow
def test_no_packet_makes_the_dissector_fail(lua: Path, tmp_path: Path) -> None:
    """Random bytes, mutated datagrams, counts of four thousand million, a thousand packets in a datagram."""
    rng = Random(3)
    valid, _ = seeds()
    hostile = [rng.randbytes(rng.randrange(1, 200)) for _ in range(500)]
    hostile += [b"\x02" + rng.randbytes(rng.randrange(60)) for _ in range(500)]
    for payload in valid[:400]:
        data = bytearray(datagram(payload))
        for _ in range(3):
            data[rng.randrange(len(data))] = rng.randrange(256)
        hostile.append(bytes(data[: rng.randrange(1, len(data) + 1)]))
    hostile.append(b"\x02" + datagram(RequestControl(authority_code=1).encode())[1:] * 1000)
    hostile += [datagram(payload[:2] + b"\xff" * 4000) for payload in valid[:60]]
    capture = capture_of(hostile, tmp_path / "hostile.pcapng")
    shown = frames(lua, capture)
    assert len(shown) == len(hostile)
    assert not [number for number, frame in enumerate(shown) if "jaus.failed" in frame.experts]
    assert any("jaus.malformed.header" in frame.experts for frame in shown)


@pytest.mark.slow
def test_no_stream_and_no_serial_line_makes_the_dissector_fail(lua: Path, tmp_path: Path) -> None:
    rng = Random(5)
    good = datagram(RequestControl(authority_code=1).encode())
    segments = [
        *([good, good[1:]] * 3),
        *(rng.randbytes(rng.randrange(1, 80)) for _ in range(300)),
        b"\0",
        b"\2",
        b"\0\xff",
    ]
    shown = frames(lua, tcp_capture(segments, tmp_path / "tcp.pcap"))
    marks = (b"\x10\x01", b"\x10\x02", b"\x10\x03", b"\x10", b"\x02\x0f\0")
    records = [
        b"".join(rng.choice((*marks, rng.randbytes(3))) for _ in range(rng.randrange(1, 12))) for _ in range(500)
    ]
    shown += frames(lua, serial_capture(records, tmp_path / "serial.pcap"), "-o", USER_LINK_TYPE)
    assert len(shown) == len(segments) + 1 + len(records)
    assert not [frame for frame in shown if "jaus.failed" in frame.experts]
    assert sum("jaus.malformed.truncated" in frame.experts for frame in shown) > 10


@pytest.mark.slow
def test_a_frame_shows_a_limited_number_of_items(lua: Path, tmp_path: Path) -> None:
    few = tmp_path / "few.lua"
    few.write_text(lua.read_text("utf-8").replace("MAX_ITEMS = 100000", "MAX_ITEMS = 50"), encoding="utf-8")
    packet = datagram(RequestControl(authority_code=1).encode())
    capture = capture_of([b"\x02" + packet[1:] * 20, packet], tmp_path / "many.pcapng")
    many, one = frames(few, capture)
    assert (many.experts, one.experts) == (["jaus.limit"], [])
    assert 1 <= len(many.messages) < 20


@pytest.mark.slow
def test_filters_name_fields(lua: Path, tmp_path: Path) -> None:
    messages = [RequestControl(authority_code=code).encode() for code in (1, 127, 255)]
    capture = capture_of(map(datagram, messages), tmp_path / "control.pcapng")
    options = ("-T", "fields", "-e", "frame.number", "-Y")
    assert tshark(lua, capture, *options, "jaus.core.request_control.authority_code > 100").split() == ["2", "3"]
    assert tshark(lua, capture, *options, 'jaus.source == "101.1.1" && jaus.message == "RequestControl"').split() == [
        *("1", "2", "3")
    ]


def test_values_have_units(lua: Path, tmp_path: Path) -> None:
    capture = capture_of([datagram(ReportLocalPose(x=1.5, yaw=0.5).encode())], tmp_path / "pose.pcapng")
    (frame,) = frames(lua, capture)
    texts = {field.name.rpartition(".")[2]: field.text for field in frame.messages[0].fields}
    assert texts["x"].endswith(" m")
    assert texts["yaw"].endswith(" rad")


@pytest.mark.slow
def test_the_message_in_an_event_is_shown(lua: Path, tmp_path: Path) -> None:
    inner = ReportLocalPose(x=1.5)
    event = Event(event_id=3, sequence_number=9, report_message=inner)
    for _ in range(12):
        event = Event(event_id=3, sequence_number=9, report_message=event.encode())
    capture = capture_of([datagram(event.encode())], tmp_path / "event.pcapng")
    (frame,) = frames(lua, capture)
    depth, message = 0, frame.messages[0]
    while nested := message.fields[-1].nested:
        depth, message = depth + 1, nested
    assert depth == 8
    assert message.name == "Event"


@pytest.mark.slow
def test_the_list_of_packets_names_messages(lua: Path, tmp_path: Path) -> None:
    event = Event(event_id=3, sequence_number=9, report_message=ReportLocalPose(x=1.5)).encode()
    capture = capture_of(
        [datagram(event), datagram(b"", ack=Ack.ACK), datagram(b"\xff\xff")], tmp_path / "event.pcapng"
    )
    assert tshark(lua, capture, "-T", "fields", "-e", "_ws.col.Info").splitlines() == [
        "101.1.1 → 42.1.1 Event (ReportLocalPose)",
        "101.1.1 → 42.1.1 ACK",
        "101.1.1 → 42.1.1 message FFFFh",
    ]


@pytest.mark.slow
def test_a_count_of_64_bits_is_no_error_of_the_dissector(tmp_path: Path) -> None:
    file = tmp_path / "thing.xml"
    count = 'min_count="0" max_count="80"'
    text = definition().replace(f'"unsigned byte" {count}', f'"unsigned long integer" {count}')
    assert text != definition()
    file.write_text(text, encoding="utf-8")
    known = jauspy.load(str(file))
    payload = b"\x11\xd0" + (1 << 4).to_bytes(2, "little") + bytes(2) + b"\xff" * 8
    (frame,) = frames(written(tmp_path, known), capture_of([datagram(payload)], tmp_path / "thing.pcapng"))
    assert frame.experts == ["jaus.malformed.count", "jaus.malformed.truncated"]


def fragments(payload: bytes, size: int, first: int) -> list[bytes]:
    pieces = [payload[at : at + size] for at in range(0, len(payload), size)]
    flags = [DataFlag.FIRST, *[DataFlag.MIDDLE] * (len(pieces) - 2), DataFlag.LAST]
    return [
        datagram(piece, (first + number) % 65536, data_flag=flag)
        for number, (piece, flag) in enumerate(zip(pieces, flags, strict=True))
    ]


@pytest.mark.slow
@pytest.mark.parametrize("order", [[0, 1, 2, 3], [0, 2, 1, 3], [3, 2, 1, 0], [0, 1, 1, 2, 3, 3]], ids=str)
def test_large_messages_are_put_together(order: list[int], lua: Path, tmp_path: Path) -> None:
    """In order, in any other order, and with repeated fragments; the sequence number wraps."""
    payload = Event(event_id=3, sequence_number=9, report_message=ReportLocalPose(x=1.5, y=2.5, yaw=0.5)).encode()
    message = registry.decode(payload)
    parts = fragments(payload, -(-len(payload) // 4), 65534)
    capture = capture_of([parts[number] for number in order], tmp_path / "large.pcapng")
    found = [shown for frame in frames(lua, capture) for shown in frame.messages]
    assert [difference(shown, expected(message)) for shown in found] == [""]
    both = tshark(lua, capture, "-2", "-T", "fields", "-e", "jaus.reassembled.in").split()
    assert set(both) == {str(order.index(0) + 1) if order[0] == 3 else str(len(set(order)) if len(order) == 4 else 5)}


def test_all_packets_of_a_datagram_are_shown(lua: Path, tmp_path: Path) -> None:
    data = b"\x02" + b"".join(datagram(RequestControl(authority_code=n).encode(), n)[1:] for n in range(5))
    acknowledgement = datagram(b"", 7, ack=Ack.ACK)
    (frame, other) = frames(lua, capture_of([data, acknowledgement], tmp_path / "packed.pcapng"))
    assert [message.fields[0].value for message in frame.messages] == ["0", "1", "2", "3", "4"]
    assert (other.messages, other.experts) == ([], [])


@pytest.mark.slow
@pytest.mark.parametrize("size", [1, 2, 3, 7, 20, 1000])
def test_jtcp_is_dissected_however_it_is_cut_into_segments(size: int, lua: Path, tmp_path: Path) -> None:
    messages = [ReportLocalPose(x=float(n)).encode() for n in range(6)]
    stream = b"\x02" + b"".join(datagram(message)[1:] for message in messages)
    segments = [stream[at : at + size] for at in range(0, len(stream), size)]
    shown = frames(lua, tcp_capture(segments, tmp_path / "tcp.pcap"))
    found = [message for frame in shown for message in frame.messages]
    assert [difference(one, expected(registry.decode(other))) for one, other in zip(found, messages, strict=True)] == [
        ""
    ] * 6
    assert not any(frame.experts for frame in shown)


@pytest.mark.slow
def test_jserial_is_dissected_on_a_user_link_type(lua: Path, tmp_path: Path) -> None:
    message = RequestControl(authority_code=0x10).encode()  # a DLE, which is sent twice
    frame = jserial.frame(datagram(message, 0x1010))
    damaged = bytearray(frame)
    damaged[-1] ^= 1
    capture = serial_capture([frame, frame + frame, bytes(damaged), frame[:9]], tmp_path / "serial.pcap")
    one, two, wrong, short = frames(lua, capture, "-o", USER_LINK_TYPE)
    assert [len(each.messages) for each in (one, two, wrong, short)] == [1, 2, 1, 0]
    assert difference(one.messages[0], expected(registry.decode(message))) == ""
    assert (one.experts, wrong.experts) == ([], ["jaus.malformed.checksum"])
    assert short.experts == ["jaus.malformed.truncated"]


@pytest.mark.slow
def test_a_definition_of_the_user_is_shown(tmp_path: Path) -> None:
    file = tmp_path / "thing.xml"
    file.write_text(definition(), encoding="utf-8")
    known = jauspy.load(str(file))
    kinds = [known.by_name(name) for name in ("SetThing", "QueryThing", "ReportThing")]
    chosen = targets(known, known.schema, [kind.NAME for kind in kinds])  # type: ignore[arg-type]
    payloads = [seed.data for seed in from_schemas([target for target in chosen if target.cls in kinds])]
    capture = capture_of(map(datagram, payloads), tmp_path / "thing.pcapng")
    contents = [read_message(payload, known) for payload in payloads]
    assert list(mismatches(written(tmp_path, known), capture, contents)) == []
    assert len(payloads) > 5


MUTANTS: Final = {
    "byte order": ("range:le_uint()", "range:uint()"),
    "presence bits": ("return math.floor(range(byte, 1):uint() / 2^(bit % 8)) % 2 == 1", "return true"),
    "scale": ("return node.lower + raw * node.step", "return raw * node.step"),
    "trailing bytes": ("if not reader.ended and reader.at < reader.stop then", "if false then"),
    "list": ("for number = 0, count - 1 do", "for number = 1, count - 1 do"),
    "units": ('if node.units then item:append_text(" " .. node.units) end', ""),
    "values": ("ranges[i] <= value and", ""),
    "arm": ("local arm = node[tag + 1]", "local arm = node[1]"),
    "optional fields": (",optional=true", ""),
    "bits": ("shift=4", "shift=3"),
    "largest raw value": ("top=65535", "top=65534"),
    "type of a number": ('code="f"', 'code="I"'),
    "type of a count": ('count="H"', 'count="B"'),
    "path": ("jaus.mobility.", "jaus.moblity."),
    "name of a value": ('[1]="', '[2]="'),
    "nested": ("if reader.depth < MAX_NESTING then", "if false then"),
}


@pytest.fixture(scope="module")
def some_seeds(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, list[Content]]:
    """A capture of messages, right and damaged ones, and what our decoder reads in them."""
    valid, damaged = seeds()
    payloads = valid[:400] + damaged
    capture = capture_of(map(datagram, payloads), tmp_path_factory.mktemp("seeds") / "seeds.pcapng")
    return capture, [read_message(payload, registry) for payload in payloads]


@pytest.mark.slow
@pytest.mark.parametrize("name", MUTANTS)
def test_mistakes_in_the_dissector_are_noticed(
    name: str, lua: Path, some_seeds: tuple[Path, list[Content]], tmp_path: Path
) -> None:
    capture, contents = some_seeds
    right, wrong = MUTANTS[name]
    text = lua.read_text("utf-8")
    assert right in text
    mutant = tmp_path / "mutant.lua"
    mutant.write_text(text.replace(right, wrong), encoding="utf-8")
    assert any(mismatches(mutant, capture, contents))
