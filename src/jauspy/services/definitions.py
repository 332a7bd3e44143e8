"""The definitions and messages that a component runs: built-in ones, and those that its services provide."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from difflib import get_close_matches
from functools import cache
from typing import Final

from jauspy import messages
from jauspy.codec.registry import Registry
from jauspy.errors import ConfigError
from jauspy.messages import registry
from jauspy.schema.inheritance import ParentOf, lineage, most_derived_first, parents_among
from jauspy.schema.loader import Wanted, load_needed, versions_of
from jauspy.schema.model import Schema, ServiceDefinition as Definition
from jauspy.schema.state_tree import check_behavior
from jauspy.services.service import Service


def schema_for(services: Iterable[Service]) -> Schema:
    """The definitions of these services and of all they inherit from; those that services provide come first.

    Raises `SchemaError` with file and line when the behaviour of a provided one is wrong, which loading does not check.
    """
    services = list(services)
    schema = _schema(services, every_version=False)
    ids = [definition.id for definition in schema.services]
    if len(set(ids)) < len(ids):
        # Two versions of one parent: an older version of some service may fit.
        schema = _schema(services, every_version=True)
    provided = {service.urn for service in services if service.definitions is not None}
    check_behavior([definition for definition in schema.services if definition.id in provided], schema.services)
    return schema


def _schema(services: Iterable[Service], *, every_version: bool) -> Schema:
    provided = [registry.schema for registry in _registries(services) if registry.schema is not None]
    definitions = {definition.key: definition for schema in provided for definition in schema.services}
    parents = [definition.inherits_from for definition in definitions.values() if definition.inherits_from is not None]
    wanted: set[Wanted] = {parent.key for parent in parents if parent.key not in definitions}
    defined = {urn for urn, _ in definitions}
    for service in services:
        if service.urn not in defined:
            every = every_version and service.version is None
            wanted |= {(service.urn, version) for version in (versions_of(service.urn) if every else [service.version])}
    needed = load_needed(frozenset(wanted))
    return Schema(
        services=(*definitions.values(), *(service for service in needed.services if service.key not in definitions))
    )


def registry_for(services: Iterable[Service]) -> Registry:
    """The messages that these services provide, and all built-in ones."""
    provided = _registries(services)
    if len(provided) == 1:
        return provided[0]
    if not provided:
        return messages.registry
    return Registry(dict.fromkeys(entry for schema in provided for entry in schema.entries))


def _registries(services: Iterable[Service]) -> list[Registry]:
    found = {id(service.definitions): service.definitions for service in services}
    return [schema for schema in found.values() if schema is not None]


def definitions_of(services: Iterable[Service], schema: Schema) -> dict[str, Definition]:
    """The definitions that a component runs, by URN, most derived first, all ancestors included.

    Raises `ConfigError` if a service has none, or if services need different versions of one parent.
    """
    parent_of = _parents(schema)
    found: dict[str, Definition] = {}
    # Services with the fewest versions, and services that no other one inherits from, choose first.
    services = sorted(services, key=lambda service: len(_versions(service, schema)))
    inherited = _inherited(services, schema, parent_of)
    for service in services:
        if service.version is not None or service.urn not in inherited:
            _add(found, _choose(found, service, schema, parent_of), parent_of)
    for service in services:
        if service.urn not in found:
            _add(found, _choose(found, service, schema, parent_of), parent_of)
    return {ancestor.id: ancestor for ancestor in most_derived_first(found.values(), parent_of)}


def _parents(schema: Schema) -> ParentOf[Definition]:
    def parent_of(definition: Definition) -> Definition | None:
        parent = definition.inherits_from
        return None if parent is None else _lookup(schema, parent.id, parent.version, definition.name)

    return parent_of


def _versions(service: Service, schema: Schema) -> list[Definition]:
    """The definitions that a service may run, oldest first."""
    return [
        definition
        for definition in schema.services
        if definition.id == service.urn and service.version in (None, definition.version)
    ]


def _choose(
    found: Mapping[str, Definition], service: Service, schema: Schema, parent_of: ParentOf[Definition]
) -> Definition:
    """The newest version that shares its ancestors with those found; the newest of all when none does."""
    newest = _lookup(schema, service.urn, service.version, type(service).__name__)
    return next(
        (version for version in reversed(_versions(service, schema)) if _fits(found, version, parent_of)), newest
    )


def _fits(found: Mapping[str, Definition], definition: Definition, parent_of: ParentOf[Definition]) -> bool:
    return all(
        found.get(ancestor.id, ancestor).version == ancestor.version for ancestor in lineage(definition, parent_of)
    )


def _inherited(services: Iterable[Service], schema: Schema, parent_of: ParentOf[Definition]) -> set[str]:
    """The ids of all ancestors of the services; the version of an ancestor is chosen by what inherits from it."""
    found: set[str] = set()
    for service in services:
        definition = _lookup(schema, service.urn, service.version, type(service).__name__)
        found |= {ancestor.id for ancestor in lineage(definition, parent_of) if ancestor.id != service.urn}
    return found


def _add(found: dict[str, Definition], definition: Definition, parent_of: ParentOf[Definition]) -> None:
    for ancestor in lineage(definition, parent_of):
        existing = found.setdefault(ancestor.id, ancestor)
        if existing.version != ancestor.version:
            raise ConfigError(
                f"{definition.name} needs {ancestor.id} {ancestor.version}, but another service of this component "
                f"needs {existing.version}; give each version a component of its own"
            )


def _lookup(schema: Schema, urn: str, version: str | None, who: str) -> Definition:
    if not any(service.id == urn and version in (None, service.version) for service in schema.services):
        known = ", ".join(f"{service.version}" for service in schema.services if service.id == urn)
        which = f"{urn} {version}" if version else urn
        hint = f"versions there: {known}" if known else _suggestion(schema, urn)
        raise ConfigError(f"{who}: no definition of {which} is loaded ({hint})")
    return schema.service(urn, version)


def _suggestion(schema: Schema, urn: str) -> str:
    known = {definition.id for definition in schema.services} | {entry.service for entry in registry.entries}
    by_end = sorted(name for name in known if name.endswith(f":{urn}"))
    meant = (by_end or get_close_matches(urn, known, 1, 0.9))[:1]
    hint = "one of your own is given by `definitions=jauspy.load(...)`"
    return f"did you mean {meant[0]}? {hint}" if meant else hint


_CORE: Final = "urn:jaus:jss:core:"
_MOBILITY: Final = "urn:jaus:jss:mobility:"
_MANIPULATOR: Final = "urn:jaus:jss:manipulator:"
_SENSING: Final = "urn:jaus:jss:environmentSensing:"
OLDER_VERSION: Final = "1.0"

OLDER_SERVICES: Final[tuple[str, ...]] = (
    *(f"{_CORE}{name}" for name in ("Transport", "Events", "AccessControl", "Management")),
    *(f"{_CORE}{name}" for name in ("Discovery", "Time", "Liveness", "Liveliness")),
    *(f"{_MOBILITY}{name}" for name in ("PrimitiveDriver", "VelocityStateSensor", "VelocityStateDriver")),
    *(f"{_MOBILITY}{name}" for name in ("AccelerationStateSensor", "LocalPoseSensor", "GlobalPoseSensor")),
    *(f"{_MOBILITY}{name}" for name in ("LocalWaypointDriver", "GlobalWaypointDriver", "GlobalVectorDriver")),
    *(f"{_MOBILITY}{name}" for name in ("ListManager", "LocalWaypointListDriver", "GlobalWaypointListDriver")),
    *(f"{_MANIPULATOR}Manipulator{name}" for name in ("JointPositionSensor", "JointVelocitySensor")),
    *(f"{_MANIPULATOR}Manipulator{name}" for name in ("JointForceTorqueSensor", "ActuatorForceTorqueDriver")),
    *(f"{_MANIPULATOR}Manipulator{name}" for name in ("JointPositionDriver", "JointVelocitiesDriver")),
    *(f"{_MANIPULATOR}Manipulator{name}" for name in ("EndEffectorPoseSensor", "EndEffectorVelocityStateSensor")),
    *(f"{_MANIPULATOR}Manipulator{name}" for name in ("EndEffectorPoseDriver", "EndEffectorVelocityStateDriver")),
    *(f"{_MANIPULATOR}Manipulator{name}" for name in ("JointPositionsListDriver", "EndEffectorPoseListDriver")),
    *(f"{_MANIPULATOR}{name}" for name in ("ListManager", "PrimitiveManipulator", "PrimitiveEndEffector")),
    *(f"{_MANIPULATOR}{name}" for name in ("PrimitivePanTilt", "PanTiltJointPositionSensor")),
    *(f"{_MANIPULATOR}{name}" for name in ("PanTiltJointVelocitySensor", "PanTiltJointPositionDriver")),
    f"{_MANIPULATOR}PanTiltJointVelocitiesDriver",
    *(f"{_SENSING}{name}" for name in ("VisualSensor", "DigitalVideo", "StillImage")),
)
"""The services whose version 1.0 can be listed beside 1.1 and 2.0, for clients that look for it only (ADR 118).

A message that both versions have is the same on the wire, so a component that answers the inputs of the older version
lists it too. Left out are the services whose messages differ: LocalVectorDriver, RangeSensor and AnalogVideo.
"""


RENAMED_SERVICES: Final = {
    f"{_CORE}Liveliness": (f"{_CORE}Liveness",),
    f"{_MOBILITY}ListManager": (f"{_MOBILITY}LocalWaypointListDriver", f"{_MOBILITY}GlobalWaypointListDriver"),
    f"{_MANIPULATOR}ListManager": (f"{_MANIPULATOR}ManipulatorListDriver",),
    f"{_MANIPULATOR}ManipulatorJointVelocitiesDriver": (f"{_MANIPULATOR}ManipulatorJointVelocityDriver",),
    f"{_MANIPULATOR}ManipulatorJointPositionsListDriver": (f"{_MANIPULATOR}ManipulatorJointPositionListDriver",),
    f"{_MANIPULATOR}PanTiltJointVelocitiesDriver": (f"{_MANIPULATOR}PanTiltJointVelocityDriver",),
}
"""Services that have another name now: one of the named ones does the same."""


def answered_in_older_version(services: Collection[str], inputs: Collection[int]) -> Iterator[str]:
    """The services whose version 1.0 is answered by a component with these services and inputs, which are message ids.

    A service is left out when the component lacks one of its inputs, or of those that it inherits.
    """
    for urn, codes in _older_inputs().items():
        if not set(RENAMED_SERVICES.get(urn, (urn,))).isdisjoint(services) and codes.issubset(inputs):
            yield urn


@cache
def _older_inputs() -> dict[str, frozenset[int]]:
    """The message ids that version 1.0 of each service takes, with those that it inherits."""
    schema = load_needed(frozenset((urn, OLDER_VERSION) for urn in OLDER_SERVICES))
    parent_of = parents_among(schema.services)
    lines = {urn: lineage(schema.service(urn, OLDER_VERSION), parent_of) for urn in OLDER_SERVICES}
    return {
        urn: frozenset(message.code for ancestor in line for message in ancestor.inputs) for urn, line in lines.items()
    }
