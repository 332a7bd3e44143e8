"""The generator is deterministic, its committed output is up to date, and names are what people expect."""

from __future__ import annotations

from pathlib import Path

import pytest

from jauspy.codec.dynamic import load_schema
from jauspy.codec.fast import MOST_MASKS, Masks
from jauspy.codec.generator import generate
from jauspy.codec.names import attribute, class_name, constant, members, set_package
from jauspy.errors import SchemaError
from jauspy.schema import load_builtin, model as m

MESSAGES = Path(__file__).parents[2] / "src" / "jauspy" / "messages"


def test_committed_messages_are_what_the_schemas_give() -> None:
    present = {path.relative_to(MESSAGES).as_posix(): path.read_text("utf-8") for path in MESSAGES.rglob("*.py")}
    generated = generate(load_builtin())
    assert present.keys() == generated.keys()
    assert [name for name in generated if generated[name] != present[name]] == []


def test_lists_of_nothing_are_refused() -> None:
    nothing = m.Record(name="Nothing", fields=())
    body = m.List(name="Endless", count=m.Count("u32", 0, 2**32 - 1), element=nothing)
    with pytest.raises(SchemaError, match="message Bomb: list Endless"):
        generate(_schema(body))


def test_lists_in_lists_in_lists() -> None:
    body: m.Composite = m.Record(name="R", fields=(m.FixedField(name="X", type="u8"),))
    for _ in range(16):
        body = m.Sequence(name="S", items=(m.List(name="L", count=m.Count("u8", 0, 9), element=body),))
    one = load_schema(_schema(body)).by_name("Bomb")
    data = b"\1\0" + b"\1" * 16 + b"\7"
    assert one.decode(data).encode() == data
    too_many = m.List(name="Last", count=m.Count("u8", 0, 9), element=body)
    with pytest.raises(SchemaError, match="message Bomb: 'Last' has more than 16 lists and arrays"):
        generate(_schema(too_many))


def _schema(body: m.Composite) -> m.Schema:
    message = m.Message(name="Bomb", code=1, is_command=False, body=body)
    service = m.Service(name="Bad", id="urn:example:test:Bad", version="1.0", jsidl="1.1", outputs=(message,))
    return m.Schema(services=(service,))


@pytest.mark.parametrize(
    ("jaus", "ours"),
    [
        ("PropulsiveLinearEffortX", "propulsive_linear_effort_x"),
        ("Velocity_X", "velocity_x"),
        ("Position_RMS", "position_rms"),
        ("RequestID", "request_id"),
        ("URI", "uri"),
        ("P1_Latitude", "p1_latitude"),
        ("GPS_SpeedOverGround", "gps_speed_over_ground"),
        ("CostMap2DCenterVar", "cost_map2d_center_var"),
        ("SensorIDs", "sensor_ids"),
        ("class", "class_"),
        ("encode", "encode_"),
        ("3rd", "n3_rd"),
        ("", "unnamed"),
    ],
)
def test_attribute_names(jaus: str, ours: str) -> None:
    assert attribute(jaus) == ours


def test_other_names() -> None:
    assert constant("periodic events not supported") == "PERIODIC_EVENTS_NOT_SUPPORTED"
    assert members([(0, "Reserved"), (1, "Reserved"), (2, "Go"), (2, "Again")]) == {
        "RESERVED_0": 0,
        "RESERVED_1": 1,
        "GO": 2,
    }
    assert class_name("powerPlant status") == "PowerPlant_status"
    assert set_package("urn:jaus:jss:environmentSensing:Range") == "environment_sensing"
    assert set_package("urn:example:vendor:Lamp") == "vendor"
    assert set_package("urn:jaus:jss:exp:aeodrs:HealthMonitor") == "exp"


def test_letters_with_marks_become_plain_ones() -> None:
    assert attribute("Größe") == "grosse"
    assert attribute("Émission_Ångström") == "emission_angstrom"
    assert constant("ŒUVRE") == "OEUVRE"


def test_packers_of_masks_are_bounded() -> None:
    masks = Masks("2x", tuple((1 << bit, "B") for bit in range(16)))
    for mask in range(3 * MOST_MASKS):
        assert masks[mask].size == 2 + mask.bit_count()
    assert len(masks) <= MOST_MASKS
