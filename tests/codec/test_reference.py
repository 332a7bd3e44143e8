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


@pytest.fixture(scope="module")
def models() -> dict[str, m.Message]:
    return {message.name: message for service in load_builtin().services for message in service.messages}


def test_explain(models: dict[str, m.Message]) -> None:
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


def test_explain_covers_every_byte(models: dict[str, m.Message]) -> None:
    services = RegisterServices([RegisterServices.ServiceRec("urn:a", 1, 2)] * 2)
    data = services.encode()
    rows = reference.explain(models["RegisterServices"], data)
    assert [offset for row in rows for offset in range(row.offset, row.offset + row.length)] == list(range(len(data)))
    assert rows[2].path == "service_list[0].uri.count"


def test_errors(models: dict[str, m.Message]) -> None:
    with pytest.raises(DecodeError) as caught:
        reference.parse(models["ReportStatus"], b"\x02\x40\x01\x00")
    assert (caught.value.path, caught.value.offset) == ("reserved", 4)
    assert "stream read less" in caught.value.reason
    assert "Error in path" not in caught.value.reason
    with pytest.raises(DecodeError, match="is not allowed"):
        reference.parse(models["ConfirmControl"], b"\x0f\x00\x07")
    with pytest.raises(EncodeError):
        reference.build(models["ConfirmControl"], {})


def test_construct_is_not_imported_by_the_codec() -> None:
    code = "import sys; from jauspy.messages import registry; list(registry); print('construct' in sys.modules)"
    assert (
        subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True).stdout.strip()
        == "False"
    )
    assert len(registry) > 0
