"""Version 1.0 of services beside 1.1 and 2.0: which are listed, and that their messages are the same on the wire."""

from __future__ import annotations

import pytest

from jauspy.schema.differences import compare_bodies
from jauspy.schema.inheritance import lineage, parents_among
from jauspy.schema.loader import load_builtin
from jauspy.schema.model import MessageDefinition
from jauspy.services.definitions import (
    OLDER_SERVICES,
    OLDER_VERSION,
    RENAMED_SERVICES,
    answered_in_older_version,
)

MOBILITY = "urn:jaus:jss:mobility:"
MANIPULATOR = "urn:jaus:jss:manipulator:"
SENSING = "urn:jaus:jss:environmentSensing:"
SCHEMA = load_builtin()
PARENT_OF = parents_among(SCHEMA.services)
HARMLESS = (
    "SensorID: value 0 ALL_SENSORS added",
    "SensorID: allowed any",  # 0 is a number like others in version 1.0, and stands for all sensors in 2.0
    "ImagingMode",  # more modes
    ".ImagingModes.",
    "JAUS MESSAGE u32",  # the largest message is smaller
    "H264VideoEncodingErrorRec added",
    "DigitalAudioSensorErrorRec added",
    "DigitalAudioOutputErrorRec added",
    "VideoIlluminatorErrorRec added",
    "units one -> percent",
    "added (optional",  # the last ones of their records, which components that offer version 1.0 do not send
)


def messages(urn: str, version: str) -> dict[int, MessageDefinition]:
    line = lineage(SCHEMA.service(urn, version), PARENT_OF)
    return {message.code: message for each in line for message in (*each.inputs, *each.outputs)}


def inputs(*urns: str) -> set[int]:
    newest = {urn: SCHEMA.service(urn, None) for urn in urns}
    return {m.code for urn in urns for each in lineage(newest[urn], PARENT_OF) for m in each.inputs}


def ancestors(*urns: str) -> set[str]:
    return {each.id for urn in urns for each in lineage(SCHEMA.service(urn, None), PARENT_OF)}


@pytest.mark.parametrize("urn", OLDER_SERVICES)
def test_messages_of_both_versions_are_the_same_on_the_wire(urn: str) -> None:
    newest: dict[int, MessageDefinition] = {}
    for service in SCHEMA.services:
        if service.version != OLDER_VERSION and ":" in service.id:
            newest |= {message.code: message for message in (*service.inputs, *service.outputs)}
    changes = [
        f"{message.name}: {change}"
        for code, message in messages(urn, OLDER_VERSION).items()
        if code in newest
        for change in compare_bodies(message.body, newest[code].body)
        if change.kind == "wire" and not any(each in f"{change}" for each in HARMLESS)
    ]
    assert changes == []


def test_a_service_is_listed_when_all_of_its_inputs_are_taken() -> None:
    driver = f"{MANIPULATOR}ManipulatorJointPositionDriver"
    needed = [driver, f"{MANIPULATOR}ManipulatorJointMotionProfile"]
    assert driver not in answered_in_older_version(
        ancestors(*needed), inputs(*needed)
    )  # it lacks QueryManipulatorSpecifications
    needed.append(f"{MANIPULATOR}ManipulatorSpecificationService")
    assert driver in answered_in_older_version(ancestors(*needed), inputs(*needed))


def test_services_that_have_another_name_now_are_listed_under_the_old_one() -> None:
    driver = f"{MOBILITY}LocalWaypointListDriver"
    found = set(answered_in_older_version(ancestors(driver), inputs(driver)))
    assert {driver, f"{MOBILITY}ListManager"} <= found
    assert f"{MANIPULATOR}ListManager" not in found
    assert set(RENAMED_SERVICES) <= set(OLDER_SERVICES)


@pytest.mark.parametrize("urn", [f"{MOBILITY}LocalVectorDriver", f"{SENSING}RangeSensor", f"{SENSING}AnalogVideo"])
def test_services_with_other_messages_are_not_listed(urn: str) -> None:
    assert urn not in set(answered_in_older_version(ancestors(urn), inputs(urn)))
