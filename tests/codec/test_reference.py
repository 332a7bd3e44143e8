"""The reference explains every byte once, in order of the fields."""

from __future__ import annotations

import subprocess
import sys

import pytest

from jauspy.codec import reference
from jauspy.errors import DecodeError, EncodeError
from jauspy.messages import registry
from jauspy.messages.core import RegisterServices
from jauspy.messages.mobility import ReportVelocityState
from jauspy.schema import load_builtin, model as m

LONGITUDE = "needs 4 bytes (u32, -180 to 180 degree), 1 left"


@pytest.fixture(scope="module")
def models() -> dict[str, m.MessageDefinition]:
    return {message.name: message for service in load_builtin().services for message in service.messages}


def test_explain(models: dict[str, m.MessageDefinition]) -> None:
    data = ReportVelocityState(velocity_x=1.0, yaw_rate=0.5).encode()
    rows = reference.explain(models["ReportVelocityState"], data)
    assert [(row.offset, row.length, row.path) for row in rows] == [
        (0, 2, "message_id"),
        (2, 2, "presence_vector"),
        (4, 4, "velocity_x"),
        (8, 2, "yaw_rate"),
    ]
    assert rows[1].value == ["velocity_x", "yaw_rate"]
    assert rows[2].value == pytest.approx(1.0)
    assert rows[2].raw == int.from_bytes(data[4:8], "little")


def test_explain_covers_every_byte(models: dict[str, m.MessageDefinition]) -> None:
    services = RegisterServices([RegisterServices.ServiceRec("urn:a", 1, 2)] * 2)
    data = services.encode()
    rows = reference.explain(models["RegisterServices"], data)
    assert [offset for row in rows for offset in range(row.offset, row.offset + row.length)] == list(range(len(data)))
    assert rows[2].path == "service_list[0].uri.count"


@pytest.mark.parametrize(
    ("name", "data", "last"),
    [
        (
            "ReportGlobalPose",
            "0244030000000000ff",
            (8, 1, "longitude", LONGITUDE),
        ),
        ("ReportGlobalPose", "0244", (2, 0, "presence_vector", "needs 2 bytes, 0 left")),
        ("ReportStatus", "0240010000000000", (7, 1, "", "1 byte more than the definition has")),
        ("RegisterServices", "000b02047572", (4, 2, "service_list[0].uri", "needs 4 bytes, 2 left")),
        (
            "RegisterServices",
            "000bff00010200",
            (7, 0, "service_list[1].major_version_number", "needs 1 byte (u8), 0 left"),
        ),
        (
            "ReportJointPositions",
            "024601",
            (3, 0, "joint_position_list[0].joint_position.choice", "needs 1 byte, 0 left"),
        ),
        ("SetTravelSpeedExt", "2f0c0900000000", (2, 1, "speed.choice", "type 9 is not defined, only 0, 1, 2, 3")),
    ],
)
def test_explain_ends_at_the_damage(
    models: dict[str, m.MessageDefinition], name: str, data: str, last: tuple[object, ...]
) -> None:
    message = models[name]
    payload = message.code.to_bytes(2, "little") + bytes.fromhex(data)[2:]
    rows = reference.explain(message, payload)
    assert (rows[-1].offset, rows[-1].length, rows[-1].path, rows[-1].problem) == last
    assert [row.damaged for row in rows] == [False] * (len(rows) - 1) + [True]
    assert sum(row.length for row in rows) <= len(payload)


def test_explain_of_a_huge_count_takes_no_memory(models: dict[str, m.MessageDefinition]) -> None:
    message = models["SetElement"]
    data = message.code.to_bytes(2, "little") + b"\x01\xff\xff\xff"
    assert len(reference.explain(message, data)) < 10


def test_errors(models: dict[str, m.MessageDefinition]) -> None:
    with pytest.raises(DecodeError) as caught:
        reference.parse(models["ReportStatus"], b"\x02\x40\x01\x00")
    assert (caught.value.path, caught.value.offset) == ("reserved", 4)
    assert "stream read less" in caught.value.reason
    assert "Error in path" not in caught.value.reason
    with pytest.raises(DecodeError, match="is not allowed"):
        reference.parse(models["ConfirmControl"], b"\x0f\x00\x07")
    with pytest.raises(DecodeError, match="1 byte more"):
        reference.parse(models["ConfirmControl"], b"\x0f\x00\x01\x00")
    with pytest.raises(EncodeError):
        reference.build(models["ConfirmControl"], {})


@pytest.mark.slow
def test_construct_is_not_imported_by_the_codec() -> None:
    code = "import sys; from jauspy.messages import registry; list(registry); print('construct' in sys.modules)"
    assert (
        subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True).stdout.strip()
        == "False"
    )
    assert len(registry) > 0
