"""Written messages are deterministic, up to date and typed; names are what people expect."""

from __future__ import annotations

import sys
from pathlib import Path
from subprocess import run

import pytest

from jauspy.codec.build import load_schema
from jauspy.codec.codegen import MAX_CACHED_PACKERS, Masks
from jauspy.codec.names import attribute, class_name, constant, members, set_package
from jauspy.codec.source import generate
from jauspy.errors import SchemaError
from jauspy.schema import load_builtin, model as m

MESSAGES = Path(__file__).parents[2] / "src" / "jauspy" / "messages"
WHERE = m.SourceLocation("odd.xml", 1)


@pytest.mark.slow
def test_committed_messages_match_the_schemas() -> None:
    present = {path.relative_to(MESSAGES).as_posix(): path.read_text("utf-8") for path in MESSAGES.rglob("*.py")}
    generated = generate(load_builtin())
    assert present.keys() == generated.keys()
    assert [name for name in generated if generated[name] != present[name]] == []


def test_lists_of_empty_items_are_rejected() -> None:
    nothing = m.Record(name="Nothing", fields=())
    body = m.List(name="Endless", count=m.Count("u32", 0, 2**32 - 1), element=nothing)
    with pytest.raises(SchemaError, match="message Bomb: list Endless"):
        generate(_schema(body))


def test_nested_lists_are_supported() -> None:
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
    message = m.MessageDefinition(name="Bomb", code=1, is_command=False, body=body)
    service = m.ServiceDefinition(name="Bad", id="urn:example:test:Bad", version="1.0", jsidl="1.1", outputs=(message,))
    return m.Schema(services=(service,))


@pytest.mark.slow
def test_generated_code_is_typed(tmp_path: Path, odd_models: dict[str, m.MessageDefinition]) -> None:
    """Also where names are those of types, and numbers of a variable field integers and floats."""
    names = ("List", "Int", "Float", "Str", "Bytes", "rt", "Size")
    kinds: tuple[m.Scalar, ...] = ("u8", "f32", "u16")
    choices = tuple(m.TypeChoice(index, kind, "one") for index, kind in enumerate(kinds))
    fields = (*(m.FixedField(name=name, type="u8") for name in names), m.VariableField(name="Any", choices=choices))
    first = m.MessageDefinition(name="IntEnum", code=1, is_command=False, body=m.Record(name="R", fields=fields))
    messages = (
        first,
        m.MessageDefinition(name="Self", code=2, is_command=False, body=first.body),
        *odd_models.values(),
    )
    service = m.ServiceDefinition(
        name="Odd", id="urn:odd:x:Odd", version="1.0", jsidl="1.1", outputs=messages, where=WHERE
    )
    for path, text in generate(m.Schema(services=(service,)), "odd", "jauspy.messages").items():
        file = tmp_path / "odd" / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    command = [sys.executable, "-m", "mypy", "--strict", "odd"]
    checked = run(command, check=False, cwd=tmp_path, capture_output=True, text=True)
    assert checked.returncode == 0, checked.stdout


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
        ("List", "list_"),
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
    assert class_name("IntEnum") == "IntEnum_"
    assert set_package("urn:jaus:jss:environmentSensing:Range") == "environment_sensing"
    assert set_package("urn:example:vendor:Lamp") == "vendor"
    assert set_package("urn:jaus:jss:exp:aeodrs:HealthMonitor") == "exp"


def test_diacritics_are_removed() -> None:
    assert attribute("Größe") == "grosse"
    assert attribute("Émission_Ångström") == "emission_angstrom"
    assert constant("ŒUVRE") == "OEUVRE"


def test_packer_cache_is_bounded() -> None:
    masks = Masks("2x", tuple((1 << bit, "B") for bit in range(16)))
    for mask in range(3 * MAX_CACHED_PACKERS):
        assert masks[mask].size == 2 + mask.bit_count()
    assert len(masks) <= MAX_CACHED_PACKERS
