"""`jauspy decode` in this process: what it prints, and its exit status."""

import json
import struct
import subprocess
import sys
from pathlib import Path

import dpkt
import pytest
from typer.testing import CliRunner

from jauspy.capture import writer
from jauspy.cli.main import app
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.protocol import junior

GOLDEN = Path(__file__).parents[1] / "golden" / "sae_management.hex"
CAPTURES = Path(__file__).parents[3] / "shared" / "captures"
QUERY_STATUS = "02001000010a017e0014017e0002200200"
REPORT_STATUS = "020015000114017e000a017e00024002000000000200"


def run(*arguments, status=0):
    result = CliRunner().invoke(app, ["decode", *map(str, arguments)])
    assert result.exit_code == status, result.output
    return result


def objects(*arguments, status=0):
    return [json.loads(line) for line in run(*arguments, "--json", status=status).stdout.splitlines()]


def pcap(path, payloads):
    with path.open("wb") as file:
        writer = dpkt.pcap.Writer(file)
        for number, payload in enumerate(payloads):
            udp = dpkt.udp.UDP(sport=3794, dport=3794, data=payload)
            udp.ulen = 8 + len(payload)
            ip = dpkt.ip.IP(src=b"\x0a\0\0\1", dst=b"\x0a\0\0\2", p=17, data=udp)
            writer.writepkt(bytes(dpkt.ethernet.Ethernet(data=ip, type=0x0800)), ts=100.0 + number)
    return path


def sae_packets(found):
    """The checks both forms of the SAE capture must pass."""
    assert len(found) == 22
    assert all(not item["errors"] and item["reencodes"] for item in found)
    messages = [item["messages"][0] for item in found]
    assert all(message["reencodes"] for message in messages)
    deviating = {message["message"] for message in messages if message["deviations"]}
    assert deviating == {"SetEmergency", "ClearEmergency"}  # they use emergency code 0, which the standard has not
    named = [message["message"] for message in messages]
    assert named[:5] == ["RequestControl", None, "ConfirmControl", "QueryStatus", "ReportStatus"]
    assert messages[0]["source"] == "126.1.20"
    assert messages[0]["broadcast"] == "GLOBAL"
    assert messages[0]["ack"] == "REQUIRED"
    assert messages[0]["fields"] == {"authority_code": 200}
    assert (messages[1]["ack"], messages[1]["code"]) == ("ACK", None)


def test_golden_capture_as_hex_reencodes_exactly():
    found = objects(GOLDEN)
    sae_packets(found)
    assert [item["hex"] for item in found] == GOLDEN.read_text().split()


@pytest.mark.skipif(not CAPTURES.is_dir(), reason="the captures are not here")
def test_sae_capture_reencodes_exactly():
    found = objects(CAPTURES / "sae_management.pcap")
    sae_packets(found)
    assert [item["hex"] for item in found] == GOLDEN.read_text().split()
    assert found[0]["n"] == 1
    assert found[0]["destination"] == "239.255.0.1:3794"
    assert found[0]["time"] == pytest.approx(1297197788.124, abs=1e-3)


@pytest.mark.skipif(not CAPTURES.is_dir(), reason="the captures are not here")
def test_unknown_messages_in_a_capture_are_no_failure():
    found = objects(CAPTURES / "cop_waypoint_run_2013.pcap")
    assert len(found) == 752
    assert not [item["errors"] for item in found if item["errors"]]
    lines = run(CAPTURES / "cop_waypoint_run_2013.pcap").stdout
    assert "ReportIdentification" in lines


def test_text_output_has_a_heading_and_the_fields():
    text = run(REPORT_STATUS).stdout
    assert "126.1.10 → 126.1.20  ReportStatus (4002h)" in text
    assert "status: STANDBY (2)" in text
    assert "\x1b" not in text


@pytest.mark.parametrize("text", ["0220", "0x02 0x20", "02:20"])
def test_bare_message_is_decoded(text):
    [item] = objects(text)
    assert item["messages"][0]["message"] == "QueryStatus"
    assert "source" not in item["messages"][0]


def test_option_as_selects_the_kind_of_bytes():
    assert objects("0220", "--as", "datagram", status=1)[0]["errors"]
    assert objects(QUERY_STATUS, "--as", "message", status=1)[0]["messages"][0]["message"] == "Shutdown"


def test_packed_datagrams_show_every_message():
    packed = "02" + QUERY_STATUS[2:] + REPORT_STATUS[2:]
    [item] = objects(packed)
    assert [message["message"] for message in item["messages"]] == ["QueryStatus", "ReportStatus"]
    assert item["reencodes"]
    assert "   + " in run(packed).stdout


def test_legacy_headers_are_shown_without_failure(tmp_path):
    opc = b"JAUS01.0" + bytes.fromhex("060202420101ffff01010182000075f4")
    v1 = bytes.fromhex("0100000010060201000000000014017e0000000000")
    path = pcap(tmp_path / "old.pcap", [opc, v1])
    assert [item["note"] for item in objects(path)] == ["AS5669 v1/OPC header, not decoded"] * 2
    assert run(path).stdout.count("not decoded") == 2


def test_invalid_bytes_are_shown_and_fail(tmp_path):
    good = bytes.fromhex(QUERY_STATUS)
    truncated_message = bytes.fromhex("02001100010a017e0014017e00024000" + "0200")
    path = pcap(tmp_path / "bad.pcap", [b"", b"\xff" * 30, good[:-3], truncated_message, good])
    found = objects(path, status=1)
    assert len(found) == 5
    assert [bool(item["errors"]) for item in found] == [True, True, True, False, False]
    assert found[3]["messages"][0]["message"] == "ReportStatus"
    assert "needs" in found[3]["messages"][0]["deviations"][0]
    assert not found[3]["reencodes"]
    text = run(path, status=1).stdout
    assert "packet not readable: empty" in text
    assert "encodes to 02 40" in text


def test_fragments_are_not_decoded_as_messages(tmp_path):
    first = bytearray.fromhex(QUERY_STATUS)
    first[4] = 0x41
    [item] = objects(bytes(first).hex())
    assert item["messages"][0]["data_flag"] == "FIRST"
    assert item["messages"][0]["message"] is None


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["pcap", "hex"])
def test_standard_input_accepts_captures_and_hex(tmp_path, kind):
    path = pcap(tmp_path / "x.pcap", [bytes.fromhex(QUERY_STATUS)])
    data = path.read_bytes() if kind == "pcap" else f"# two\n{QUERY_STATUS}\n".encode()
    done = subprocess.run(
        [sys.executable, "-m", "jauspy.cli.main", "decode", "-", "--json"], input=data, stdout=-1, check=True
    )
    assert json.loads(done.stdout)["messages"][0]["message"] == "QueryStatus"


@pytest.mark.slow
@pytest.mark.parametrize("form", ["--json", ""])
def test_closed_pipe_causes_no_failure_or_traceback(form):
    command = f"{sys.executable} -m jauspy.cli.main decode - {form} | head -1"
    lines = GOLDEN.read_text() * 200
    done = subprocess.run(
        ["bash", "-o", "pipefail", "-c", command], input=lines.encode(), capture_output=True, check=False
    )
    assert (done.returncode, done.stderr) == (0, b"")
    assert len(done.stdout.splitlines()) == 1


@pytest.mark.slow
@pytest.mark.parametrize(
    ("command", "sentence"),
    [
        ("decode 0220 >/dev/full", "the results cannot be written: No space left on device"),
        ("decode 0220 --json >/dev/full", "the results cannot be written: No space left on device"),
        ("--help >/dev/full", "the results cannot be written: No space left on device"),
        ("decode - <&-", "standard input is empty"),
        ("decode 0220 >&-", "standard output is closed; redirect it to /dev/null to discard the results"),
    ],
)
def test_closed_and_full_streams_cause_one_sentence(command, sentence):
    done = subprocess.run(
        ["bash", "-c", f"{sys.executable} -m jauspy.cli.main {command}"], capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stderr) == (1, f"Error: {sentence}\n")


@pytest.mark.parametrize("cut", [1, 2, 3, 8, 13])
def test_truncated_datagram_is_not_decoded_as_message(cut):
    [item] = objects(QUERY_STATUS[: -2 * cut], status=1)
    assert "packet not readable: truncated" in item["errors"][0]
    assert item["messages"] == []


def test_message_that_resembles_a_datagram_is_decoded_as_message():
    pose = registry.by_name("ReportGlobalPose")(latitude=30.0, longitude=-120.0, altitude=12.0, yaw=0.5).encode()
    assert (pose[0], len(pose) >= 15) == (2, True)
    assert objects(pose.hex())[0]["messages"][0]["message"] == "ReportGlobalPose"
    assert objects(pose.hex() + "00", status=1)[0]["errors"]


@pytest.mark.parametrize(
    ("pack", "text"), [(junior.connect, "Connect from 126.1.20"), (junior.accept, "Accept to 126.1.20")]
)
def test_control_messages_of_the_junior_protocol_are_decoded(pack, text):
    data = pack(JausID(126, 1, 20)).hex()
    assert run(data).stdout == f"{text}, of the Junior local protocol (21 bytes)\n"
    assert objects(data)[0]["note"].startswith(text)


def test_a_mirror_begins_with_registrations_and_not_with_undecoded_lines(tmp_path):
    """On a network the same bytes are a packet with an old header, such as Shutdown."""
    id = JausID(101, 1, 102)
    local, remote = ("127.101.1.102", 3794), ("192.168.1.5", 3794)
    rows = [(local, local, junior.accept(id)), (remote, local, bytes.fromhex(QUERY_STATUS))]
    rows.append((remote, local, junior.accept(id)))
    path = tmp_path / "mirror.pcapng"
    path.write_bytes(writer.preamble() + b"".join(writer.packet(*row, number) for number, row in enumerate(rows)))
    first, second, third = run(path).stdout.splitlines()
    assert "Accept to 101.1.102, of the Junior local protocol" in first
    assert "QueryStatus" in second
    assert "not decoded" in third


def test_truncated_capture_is_shown_and_fails(tmp_path):
    path = pcap(tmp_path / "x.pcap", [bytes.fromhex(QUERY_STATUS)] * 2)
    path.write_bytes(path.read_bytes()[:-1])
    result = run(path, status=1)
    assert result.stdout.count("QueryStatus") == 1
    assert "is damaged or cut off after frame 1" in result.stderr


def test_capture_without_packets_is_reported(tmp_path):
    result = run(pcap(tmp_path / "x.pcap", []))
    assert (result.stdout, result.stderr) == ("", "the capture has no packets\n")


def test_control_byte_ff_is_decoded_with_a_note():
    [item] = objects(QUERY_STATUS[:8] + "ff" + QUERY_STATUS[10:])
    assert item["messages"][0]["message"] == "QueryStatus"
    assert "control byte FF" in item["messages"][0]["deviations"][0]
    assert item["reencodes"]


def test_explain_shows_offsets_and_bytes():
    text = run("--explain", REPORT_STATUS).stdout
    assert "02 40" in text
    assert "STANDBY" in text


def test_explain_shows_the_fields_up_to_the_damage():
    result = run("--explain", "--as", "message", "024403000000", status=1)
    rows = [line.split() for line in result.stdout.splitlines()]
    assert ["2", "03", "00", "presence_vector", "3", "latitude,", "longitude"] in rows
    (damage,) = (line for line in result.stdout.splitlines() if line.split()[:1] == ["4"])
    assert damage.endswith("latitude                needs 4 bytes (u32, -90 to 90 degree), 2 left")
    [item] = objects("--explain", "--as", "message", "024403000000", status=1)
    [*_, presence, last] = item["messages"][0]["explained"]
    assert (presence["value"], presence["damaged"]) == (["latitude", "longitude"], False)
    assert (last["offset"], last["field"], last["damaged"]) == (4, "latitude", True)


def test_explain_shows_damage_in_messages_of_a_vendor(tmp_path):
    xml = str(tmp_path / "battery.xml")
    made = CliRunner().invoke(app, ["new", "definition", "urn:example:Battery", "charge:percent", "-o", xml])
    assert made.exit_code == 0, made.output
    text = run("--explain", "--as", "message", "--schemas", xml, "02d00100ff", status=1).stdout
    assert "needs 8 bytes (f64 percent), 2 left" in text


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["nowhere.pcap"], "there is no file 'nowhere.pcap', and as hex text it is wrong: 'n'"),
        (["022"], "odd number of hexadecimal digits"),
        (["."], "cannot be read: Is a directory"),
    ],
)
def test_invalid_input_causes_one_sentence(arguments, sentence):
    result = run(*arguments, status=1)
    assert result.stderr.startswith("Error: ")
    assert sentence in result.stderr
    assert len(result.stderr.splitlines()) == 1


@pytest.mark.parametrize(
    "content", [b"", b"\x00\xff\x80 garbage", b"hello\n", struct.pack("<I", 0xA1B2C3D4), b"\n\r\r\n"]
)
def test_garbage_files_cause_one_sentence(tmp_path, content):
    path = tmp_path / "garbage"
    path.write_bytes(content)
    result = run(path, status=1)
    assert "Error: " in result.stderr
    assert "Traceback" not in result.output


def test_wrong_usage_ends_with_status_2():
    assert "neither a UDP port" in run("0220", "--port", "many", status=2).output


@pytest.mark.parametrize(
    "text", ["ffff0102", "01080000", "0208ff0100ff00ffffffffff"], ids=["unknown", "cut", "cut, too"]
)
def test_invalid_bare_message_fails(text):
    objects(text, status=1)


def test_message_that_begins_like_a_legacy_header_is_decoded():
    message = registry.by_name("ConfirmSensorConfiguration", version="2.0")
    data = "01085a0100043412010d4c5457442f6d5f4267654d6961"
    [found] = objects(data)
    assert found["messages"][0]["message"] == message.NAME
    assert found["reencodes"]
