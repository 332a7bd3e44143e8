"""A part of the shipped definitions is the same as in the whole."""

from __future__ import annotations

from pathlib import Path

import pytest
from lxml import etree

from jauspy.schema import builtin_paths, load_builtin, loader
from jauspy.schema.loader import load_needed
from jauspy.schema.model import Schema

CORE, MOBILITY = "urn:jaus:jss:core:", "urn:jaus:jss:mobility:"


def load(*wanted: tuple[str, str | None]) -> Schema:
    return load_needed(frozenset(wanted))


def keys(schema: Schema) -> set[tuple[str, str]]:
    return {service.key for service in schema.services}


def test_every_shipped_file_is_known() -> None:
    assert {path for versions in loader._index().values() for path in versions.values()} == set(builtin_paths())


@pytest.mark.parametrize("path", builtin_paths(), ids=lambda path: f"{path.parent.name}-{path.stem}")
def test_needed_sets_are_found_without_parsing(path: Path) -> None:
    names = ("inherits_from", "declared_type_set_ref", "declared_const_set_ref")
    root = etree.parse(path).getroot()
    parsed = {(e.get("id"), e.get("version")) for e in root.iter(*(f"{{*}}{name}" for name in names))}
    assert set(loader._keys(loader._REFERENCE, path.read_bytes())) == parsed


def test_only_needed_services_and_ancestors_are_loaded() -> None:
    names = ("Transport", "Events", "AccessControl", "Management")
    found = load((f"{MOBILITY}PrimitiveDriver", None))
    assert keys(found) == {(f"{MOBILITY}PrimitiveDriver", "1.1"), *((f"{CORE}{name}", "1.1") for name in names)}


def test_services_are_the_same_in_whatever_order_they_are_loaded() -> None:
    wanted = [
        (f"{CORE}Events", None),
        (f"{MOBILITY}LocalPathSegmentDriver", "1.0"),
        (f"{MOBILITY}PrimitiveDriver", None),
    ]
    found = []
    for order in (wanted, wanted[::-1]):
        loader.load_needed.cache_clear()
        loader._shipped_services.cache_clear()
        found.append([load(service) for service in order])
    assert found[0] == found[1][::-1]
    assert load(*wanted).services == tuple(sorted({*sum((s.services for s in found[0]), ())}, key=loader._order))


@pytest.mark.slow
def test_partially_loaded_services_equal_fully_loaded_ones() -> None:
    whole = load_builtin()
    assert load(*keys(whole)) == whole
    assert set(load((f"{MOBILITY}LocalPathSegmentDriver", "1.0")).services) <= set(whole.services)


def test_versions() -> None:
    liveness = f"{CORE}Liveness"
    assert load((liveness, None)).service(liveness).version == "1.1"
    assert (liveness, "1.1") not in keys(load((liveness, "1.0")))
    assert {version for id, version in keys(load((liveness, "7.7"))) if id == liveness} == {"1.0", "1.1"}


def test_unknown_services_are_ignored() -> None:
    assert load(("urn:x:Unknown", None), ("urn:x:Unknown", "1.0")).services == ()
