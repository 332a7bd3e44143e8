from __future__ import annotations

import pytest

from jauspy.errors import ConfigError
from jauspy.schema import model
from jauspy.services.definitions import definitions_of
from jauspy.services.service import Service


def definition(name: str, version: str, parent: tuple[str, str] | None = None) -> model.ServiceDefinition:
    reference = model.Reference("parent", *parent) if parent else None
    return model.ServiceDefinition(name=name, id=name, version=version, jsidl="1.1", inherits_from=reference)


SCHEMA = model.Schema(
    services=(
        definition("Base", "1.0"),
        definition("Base", "1.1"),
        definition("Middle", "1.0", ("Base", "1.0")),
        definition("Middle", "1.1", ("Base", "1.1")),
        definition("Old", "1.0", ("Middle", "1.0")),
        definition("New", "1.0", ("Middle", "1.1")),
        definition("Orphan", "1.0", ("Nobody", "1.0")),
    )
)


def service(urn: str, version: str | None = None) -> Service:
    class Made(Service, urn=urn, version=version):
        pass

    return Made()


def chosen(*services: Service) -> list[tuple[str, str]]:
    return [(each.id, each.version) for each in definitions_of(services, SCHEMA).values()]


def test_ancestors_are_included_most_derived_first() -> None:
    assert chosen(service("Old")) == [("Old", "1.0"), ("Middle", "1.0"), ("Base", "1.0")]


def test_service_without_version_uses_that_of_derived_services() -> None:
    expected = [("Old", "1.0"), ("Middle", "1.0"), ("Base", "1.0")]
    assert chosen(service("Base"), service("Middle"), service("Old")) == expected
    assert chosen(service("Old"), service("Middle"), service("Base")) == expected


def test_newest_version_is_the_default() -> None:
    assert chosen(service("Middle")) == [("Middle", "1.1"), ("Base", "1.1")]
    assert chosen(service("Middle", "1.0")) == [("Middle", "1.0"), ("Base", "1.0")]


def test_two_versions_of_a_service_are_rejected() -> None:
    with pytest.raises(ConfigError, match=r"needs Middle 1\.[01], but another service of this component needs 1\.[01]"):
        chosen(service("Old"), service("New"))
    with pytest.raises(ConfigError, match="give each version a component of its own"):
        chosen(service("Old"), service("Middle", "1.1"))


def test_missing_parent_is_named() -> None:
    with pytest.raises(ConfigError, match=r"Orphan: no definition of Nobody 1\.0"):
        chosen(service("Orphan"))
