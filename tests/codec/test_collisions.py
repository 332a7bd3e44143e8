"""A folder of somebody else's JSIDL: mixed versions, ids that mean several things, files that are something else."""

from __future__ import annotations

import logging
from typing import Any

import pytest

import jauspy
from jauspy.codec.registry import Collision, MessageEntry, Registry
from jauspy.errors import ConfigError, DecodeError, SchemaError
from jauspy.messages import registry


def fresh(own: Registry) -> list[Collision]:
    """The collisions that are not there without the user's files."""
    return [collision for collision in own.collisions if collision not in registry.collisions]


def test_versions_of_a_service_coexist(folder: Any) -> None:
    folder.add("Lamp", version="1.0", jsidl="1.0")
    folder.add("Lamp", version="1.10", type="unsigned short integer")
    folder.add("Lamp", version="1.9", type="unsigned integer")
    own = folder.load()
    assert own.decode(b"\x01\xd0\x05\x00").VERSION == "1.10"
    assert own.decode(b"\x01\xd0\x05", version="1.0").VERSION == "1.0"
    assert own.decode(b"\x01\xd0\x05\x00\x00\x00", service="urn:acme:things:Lamp", version="1.9").to_dict() == {
        "level": 5
    }
    assert fresh(own) == []


def test_services_of_two_vendors_with_one_name_coexist(folder: Any) -> None:
    folder.add("Lamp", vendor="acme", code="D001")
    folder.add("Lamp", vendor="best", code="D002", message="SetLamp")
    own = folder.load()
    assert own.decode(b"\x01\xd0\x05").SERVICE == "urn:acme:things:Lamp"
    assert own.decode(b"\x02\xd0\x05").SERVICE == "urn:best:things:Lamp"


def test_collision_error_names_both_files_and_service_resolves_it(folder: Any, caplog) -> None:
    lamp = folder.add("Lamp")
    horn = folder.add("Horn", message="Honk", type="unsigned short integer")
    with caplog.at_level(logging.WARNING):
        own = folder.load()
    [collision] = fresh(own)
    assert collision.code == 0xD001
    assert {entry.name for entry in collision.entries} == {"SetLevel", "Honk"}
    assert set(collision.files) == {str(lamp), str(horn)}
    for text in (str(collision), caplog.text):
        assert str(lamp) in text
        assert str(horn) in text
    assert own.decode(b"\x01\xd0\x05", service="urn:acme:things:Lamp").NAME == "SetLevel"
    assert own.decode(b"\x01\xd0\x05\x00", service="urn:acme:things:Horn").NAME == "Honk"
    assert own.decode(b"\x01\xd0\x05", service="urn:acme:things:Lamp", strict=False)[0].NAME == "SetLevel"
    with pytest.raises(DecodeError, match=r"message id 0xD001 is .* specify the service"):
        own.decode(b"\x01\xd0\x05")


def test_the_same_message_in_two_services_is_no_collision(folder: Any) -> None:
    folder.add("Lamp")
    folder.add("LampClient", units="percent")
    own = folder.load()
    assert fresh(own) == []
    assert own.decode(b"\x01\xd0\x05").NAME == "SetLevel"


def test_equal_bodies_with_different_names_collide(folder: Any) -> None:
    folder.add("Lamp")
    folder.add("Horn", message="Honk")
    assert len(fresh(folder.load())) == 1


def test_collision_with_a_built_in_message_is_listed(folder: Any, caplog) -> None:
    path = folder.add("Lamp", code="4002")
    own = folder.load()
    [collision] = fresh(own)
    assert str(path) in collision.files
    assert any(file.endswith("Management.xml") for file in collision.files)
    assert own.decode(b"\x02\x40\x05", service="urn:acme:things:Lamp").NAME == "SetLevel"
    assert own.decode(b"\x02\x40\x01\x00\x00\x00\x00", service="urn:jaus:jss:core:Management").NAME == "ReportStatus"
    assert "0x4002" in caplog.text
    assert own.nesting.message(b"\x02\x40\x05") == b"\x02\x40\x05"


def test_newer_set_replaces_an_older_one_despite_other_names(folder: Any) -> None:
    """As the manipulator set did: services and messages were renamed from 1.0 to 2.0, their ids stayed."""
    folder.add("JointEfforts", urn="urn:jaus:jss:arms:JointEfforts", message="SetEfforts")
    kind = {"version": "2.0", "type": "unsigned short integer"}
    folder.add("JointEffort", urn="urn:jaus:jss:arms:JointEffort", message="SetEffort", **kind)
    own = folder.load()
    assert fresh(own) == []
    assert own.decode(b"\x01\xd0\x05\x00").NAME == "SetEffort"
    assert own.decode(b"\x01\xd0\x05", version="1.0").NAME == "SetEfforts"


@pytest.mark.slow
def test_newer_vendor_service_does_not_hide_another_one(folder: Any) -> None:
    """Vendors count the versions of each service; only the sets of the standard are published as a whole."""
    lamp = folder.add("Lamp", version="1.0")
    horn = folder.add("Horn", version="2.0", message="Honk", type="unsigned short integer")
    own = folder.load()
    [collision] = fresh(own)
    assert set(collision.files) == {str(lamp), str(horn)}
    assert own.decode(b"\x01\xd0\x05", service="Lamp").NAME == "SetLevel"
    with pytest.raises(DecodeError, match="specify the service"):
        own.decode(b"\x01\xd0\x05")


def test_redefined_service_replaces_the_built_in_one(folder: Any) -> None:
    folder.add("Time", urn="urn:jaus:jss:core:Time", version="1.1", message="SetTime", code="0011")
    own = folder.load()
    assert own.decode(b"\x11\x00\x05").to_dict() == {"level": 5}
    with pytest.raises(ConfigError, match=r"no message QueryTime 1\.1"):
        own.by_name("QueryTime", version="1.1")
    assert registry.by_name("QueryTime").NAME == "QueryTime"


def test_other_xml_in_a_folder_is_ignored(folder: Any) -> None:
    folder.add("Lamp")
    (folder.path / "package.xml").write_text("<package><name>vendor</name></package>")
    assert folder.load().by_name("SetLevel").CODE == 0xD001
    with pytest.raises(SchemaError, match="expected a JSIDL document"):
        jauspy.load(folder.path / "package.xml")
    (folder.path / "broken.xml").write_text("<service_def")
    with pytest.raises(SchemaError, match="not well-formed"):
        folder.load()


def test_misspelt_state_does_not_prevent_use_of_messages(folder: Any) -> None:
    path = folder.add("Lamp")
    start = (
        '<start state_machine_name="M" state_name="Nowhere"/><state_machine name="M"><state name="A"/></state_machine>'
    )
    text = path.read_text().replace('is_stateless="true"/>', f'is_stateless="false">{start}</protocol_behavior>')
    path.write_text(text)
    assert folder.load().by_name("SetLevel").CODE == 0xD001


def test_file_of_a_generated_message_is_its_module() -> None:
    one = MessageEntry(1, "A", "urn:a:b:C", "1.0", "somewhere.c", "A")
    assert Registry([one]).file_of(one) == "somewhere.c"
    assert registry.file_of(registry.entries[0]).endswith(".xml")


def test_only_published_collisions_are_built_in() -> None:
    assert {collision.code for collision in registry.collisions} == {0xB514, 0xF92A, 0xF932}


def test_repeated_id_in_a_service_is_resolved_by_name() -> None:
    """The published CBRNSensor has that."""
    data = registry.by_name("RNDetailedMeasurement")(station_number=1, measurement="x").encode()
    [collision] = [each for each in registry.collisions if each.code == 0xF932]
    assert {entry.name for entry in collision.entries} == {"RNDetailedMeasurement", "CBDetailedMeasurement"}
    for hints in ({}, {"service": "iop:CBRNSensor"}, {"version": "1.1"}):
        with pytest.raises(DecodeError, match=r"0xF932 is .*RNDetailedMeasurement.* and .*; specify the message"):
            registry.decode(data, **hints)  # type: ignore[call-overload]
    assert registry.decode(data, message="CBDetailedMeasurement").NAME == "CBDetailedMeasurement"
    assert registry.decode(data, message="rndetailedmeasurement", strict=False)[0].NAME == "RNDetailedMeasurement"
    assert registry.nesting.message(data) == data
    with pytest.raises(DecodeError, match=r"unknown message id 0xF932 SetLevel"):
        registry.decode(data, message="SetLevel")


def test_repeated_id_in_a_user_defined_service_collides(folder: Any, caplog) -> None:
    folder.add("Lamp", message="SetLevel", again="SetShade")
    with caplog.at_level(logging.WARNING):
        own = folder.load()
    [collision] = fresh(own)
    assert [entry.name for entry in collision.entries] == ["SetLevel", "SetShade"]
    assert "0xD001" in caplog.text
    assert "decoding needs the message" in caplog.text
    assert own.decode(b"\x01\xd0\x05", message="SetShade").NAME == "SetShade"


def test_service_is_found_by_the_end_of_its_urn(folder: Any) -> None:
    folder.add("Lamp")
    folder.add("Horn", message="Honk")
    own = folder.load()
    for name in ("Lamp", "things:lamp", "acme:things:Lamp", "urn:acme:things:Lamp"):
        assert own.decode(b"\x01\xd0\x05", service=name).NAME == "SetLevel"
        assert own.by_name("setlevel", service=name).NAME == "SetLevel"
    with pytest.raises(DecodeError, match="unknown message id 0xD001 of amp"):
        own.decode(b"\x01\xd0\x05", service="amp")
    with pytest.raises(ConfigError, match="no message Honk of Lamp is known"):
        own.by_name("Honk", service="Lamp")


def test_version_alone_may_be_ambiguous(folder: Any) -> None:
    folder.add("Lamp")
    folder.add("Horn", message="Honk")
    with pytest.raises(DecodeError, match="specify the service"):
        folder.load().decode(b"\x01\xd0\x05", version="1.0")
