"""The steps of a public interoperability test that the services here are about, with the right answers.

The bytes are those the tester sent. Its clients are 42.1.1 and 42.2.1 .. 42.2.4.
"""

from __future__ import annotations

import struct
from collections import Counter

import pytest

from jauspy.services.core import AccessControl
from jauspy.services.mobility import LocalPoseSensor, LocalWaypointDriver, LocalWaypointListDriver, Vehicle

T, C1, C2, C3, C4 = "42.1.1", "42.2.1", "42.2.2", "42.2.3", "42.2.4"


class Judge:
    """Speaks in hex: message id and body."""

    def __init__(self, rig) -> None:
        self.rig = rig

    def __call__(self, client: str, code: str, body: str = "") -> list[str]:
        self.rig.run(0.02)
        self.rig.host.receive(
            struct.pack("<H", int(code, 16)) + bytes.fromhex(body), self.rig.ID.parse(client), self.rig.now
        )
        return [self.line(each) for each in self.rig.host.poll_output(self.rig.now)]

    @staticmethod
    def line(outgoing) -> str:
        code = int.from_bytes(outgoing.payload[:2], "little")
        return f"{outgoing.destination} {code:04X} {outgoing.payload[2:].hex()}".strip()


@pytest.fixture
def say(robot) -> Judge:
    return Judge(robot)


def test_steps_2_to_10_events(say) -> None:
    (services,) = say(T, "2B03", "01ff01ff")
    assert services.startswith(f"{T} 4B03 010101")
    assert say(T, "21F0", "0300") == [f"{T} 41F0 00"]
    (confirm,) = say(T, "01F0", "01003c00020000000222")
    id = confirm.split()[2][2:4]
    assert confirm == f"{T} 01F3 01{id}3c00"
    events = [(when, message) for when, _, message in say.rig.run(10.0)]
    assert len(events) in (10, 11)
    assert [message.sequence_number for _, message in events] == list(range(len(events)))
    assert say(T, "21F0", f"02{id}") == [f"{T} 41F0 0100{id}020000000222"]
    assert say(T, "2202") == [f"{T} 4202"]
    assert say(T, "01F0", "03001e000400000002440000") == [f"{T} 01F4 010305"]
    assert say(T, "01F1", f"04001e00{id}020000000222") == [f"{T} 01F3 04{id}1e00"]
    assert len(say.rig.run(10.01)) == 5
    assert say(T, "01F2", f"07{id}") == [f"{T} 01F3 07{id}1e00"]
    assert say.rig.run(10.0) == []
    assert say(T, "21F0", f"02{id}") == [f"{T} 41F0 00"]


def test_steps_11_to_19_discovery(say) -> None:
    assert say(T, "2202") == [f"{T} 4202"]
    assert len(say(T, "2B03", "01ff01ff")) == 1
    for level in ("01", "02", "03", "04"):
        (answer,) = say(T, "2B00", level)
        assert answer.startswith(f"{T} 4B00 {level}")
    assert say(T, "2B01", "02") == [f"{T} 4B01 0101010100"]
    assert say(T, "2B01", "03") == [f"{T} 4B01 0101010100"]
    assert say(T, "2B02") == [f"{T} 4B02 0165000101"]


STEPS_20_TO_48 = [
    (20, C1, "2003", "", [f"{C1} 4003 05"]),
    (21, C1, "200D", "", [f"{C1} 400D 0000000000"]),
    (22, C1, "000D", "00", [f"{C1} 000F 02"]),
    (23, C1, "000D", "dc", [f"{C1} 000F 00"]),
    (24, C1, "200D", "", [f"{C1} 400D 2a000201dc"]),
    (25, C1, "0001", "db", []),
    (26, C1, "2001", "", [f"{C1} 4001 db"]),
    (27, C2, "000D", "c8", [f"{C2} 000F 02"]),
    (28, C1, "200D", "", [f"{C1} 400D 2a000201db"]),
    (29, C3, "000D", "e7", [f"{C1} 0010 00", f"{C3} 000F 00"]),
    (30, C1, "200D", "", [f"{C1} 400D 2a000203e7"]),
    (31, C3, "000E", "", [f"{C3} 0010 00"]),
    (32, C4, "0006", "0100", []),
    (33, C1, "2002", "", [f"{C1} 4002 0500000000"]),
    (34, C1, "000D", "d2", [f"{C1} 000F 01"]),
    (35, C4, "0007", "0100", []),
    (36, C1, "000D", "dc", [f"{C1} 000F 00"]),
    (37, C1, "2002", "", [f"{C1} 4002 0200000000"]),
    (38, C1, "0004", "", []),
    (39, C1, "2002", "", [f"{C1} 4002 0100000000"]),
    (40, C1, "0003", "", []),
    (41, C1, "2002", "", [f"{C1} 4002 0200000000"]),
    (42, C1, "0005", "", [f"{C1} 0010 00"]),
    (43, C1, "2002", "", [f"{C1} 4002 0200000000"]),
    (44, C4, "0006", "0100", []),
    (45, C1, "2002", "", [f"{C1} 4002 0500000000"]),
    (46, C1, "000E", "", [f"{C1} 0010 00"]),
    (47, C4, "0007", "0100", []),
    (48, C1, "2002", "", [f"{C1} 4002 0200000000"]),
]


def test_steps_20_to_48_access_control_and_management(say) -> None:
    for step, client, code, body, answers in STEPS_20_TO_48:
        assert say(client, code, body) == answers, f"step {step}"


@pytest.fixture
def driver(make, drive) -> Judge:
    """A robot that goes to waypoints, too."""
    vehicle = Vehicle(drive)
    waypoints = (LocalWaypointDriver(vehicle), LocalWaypointListDriver(vehicle), LocalPoseSensor(vehicle))
    return Judge(make(*waypoints, AccessControl(default_authority=1, timeout=5)))


def test_steps_49_to_53_a_waypoint(driver) -> None:
    (speed,) = driver(T, "240A")
    assert speed.startswith(f"{T} 440A ")
    assert driver(T, "000D", "dc") == [f"{T} 000F 00"]

    assert driver(T, "040D", "00e2530080e2530080") == []
    assert driver(T, "240D", "00") == [f"{T} 440D 00e2530080e2530080"]
    assert driver(T, "000E") == [f"{T} 0010 00"]


def test_steps_54_to_61_a_list_of_waypoints(driver) -> None:
    assert len(driver(T, "240A")) == 1
    assert driver(T, "000D", "dc") == [f"{T} 000F 00"]
    assert driver(T, "041A", "2c01010000000000000b000d0400ffffff0fffffff0f") == [f"{T} 041C 2c"]
    assert driver(T, "241C") == [f"{T} 441C 0100"]
    assert driver(T, "241B") == [f"{T} 441B 01000100"]
    assert driver(T, "241E") == [f"{T} 441E 0000"], "nothing is carried out yet"
    assert driver(T, "240D", "00") == [f"{T} 440D 00ffffff0fffffff0f"]
    assert driver(T, "000E") == [f"{T} 0010 00"]


def test_steps_62_to_72_velocity_and_pose(say) -> None:
    full = {}
    for code, fields in (("2404", "4404"), ("2403", "4403")):
        (full[code],) = say(T, code, "ffff")
        vector = int.from_bytes(bytes.fromhex(full[code].split()[2][:4]), "little")
        assert full[code].startswith(f"{T} {fields}")
        assert vector == 0b101110111, "x, y, z, three angles or rates, and the time"
        assert say(T, code, "0000") == [f"{T} {fields} 0000"]
    where = {"unset": "0300ffffff7fffffff7f", "set": "0300eb51b87eeb51b87e"}

    def pose() -> str:
        (answer,) = say(T, "2403", "0300")
        return answer.removeprefix(f"{T} 4403 ")

    before = pose()
    assert before in (where["unset"], "03000000008000000080")
    assert say(T, "0403", where["set"]) == []
    assert pose() == before
    assert say(T, "000D", "dc") == [f"{T} 000F 00"]
    assert pose() == before
    assert say(T, "0403", where["set"]) == []
    assert pose() == where["set"]
    assert say(T, "2403", "0000") == [f"{T} 4403 0000"]
    assert say(T, "000E") == [f"{T} 0010 00"]


def test_steps_75_to_80_five_streams(say) -> None:
    queries = ("020000000222", "020000000d20", "040000000424ffff", "040000000324ffff", "020000000220")
    ids = []
    for request, query in enumerate(queries, 1):
        (confirm,) = say(T, "01F0", f"{request:02x}003c00{query}")
        assert confirm.startswith(f"{T} 01F3 {request:02x}")
        assert confirm.endswith("3c00")
        ids.append(confirm.split()[2][2:4])
    assert len(set(ids)) == 5
    kinds = Counter(type(message.report_message).__name__ for *_, message in say.rig.run(30.0))
    assert len(kinds) == 5
    assert set(kinds.values()) <= {30, 31}
