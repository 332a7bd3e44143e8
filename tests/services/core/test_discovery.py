from __future__ import annotations

import pytest

from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages.core import (
    ComponentRec,
    CreateEvent,
    Event,
    QueriedComponentRec,
    QueriedNodeRec,
    QueryConfiguration,
    QueryIdentification,
    QueryServiceList,
    QueryServices,
    QuerySubsystemList,
    RegisterServices,
    ReportIdentification,
    ReportServices,
    ReportSubsystemList,
    ServiceRec,
    SubsystemRec,
)
from jauspy.protocol.header import MAX_PAYLOAD
from jauspy.services.core import Discovery, Identity, Liveness, discovery
from jauspy.services.core.discovery import (
    MAX_COMPONENTS,
    MAX_FILTERS,
    MAX_REGISTRATION,
    MAX_REPORT,
    REGISTRATION_LIFETIME,
    OfferedService,
    offered_services,
)
from jauspy.services.host import Host

A = "42.1.1"
MANIPULATOR = ServiceRec("urn:jaus:jss:manipulator:PrimitiveManipulator", 2, 0)


def services(*wanted: tuple[int, int]) -> QueryServices:
    return QueryServices([QueryServices.NodeSeq(QueriedNodeRec(n), [QueriedComponentRec(c)]) for n, c in wanted])


def registration(host: Host) -> RegisterServices:
    return RegisterServices([ServiceRec(*offer) for offer in offered_services(host)])


def listed(report: ReportServices) -> dict[tuple[int, int], list[str]]:
    return {
        (node.node_rec.node_id, component.component_rec.component_id): [each.uri for each in component.service_list]
        for node in report.node_list
        for component in node.component_list
    }


@pytest.fixture
def rig(make):
    rig = make(Discovery({2: Identity("A robot", 10001)}), Liveness())
    rig.tell("101.1.5", RegisterServices([MANIPULATOR]))
    rig.tell("101.2.1", RegisterServices([MANIPULATOR]))
    return rig


@pytest.mark.parametrize(
    ("level", "type", "name"), [(1, 10001, "jauspy"), (2, 10001, "A robot"), (3, 40001, None), (4, 60001, None)]
)
def test_identification_at_all_levels(rig, level, type, name) -> None:
    answer = rig.ask(A, QueryIdentification(level))
    assert isinstance(answer, ReportIdentification)
    assert (answer.query_type, answer.type) == (level, type)
    assert name in (None, answer.identification)


@pytest.mark.parametrize(
    "query", [QueryIdentification(0), QueryIdentification(77), QueryConfiguration(1), QueryConfiguration(9)]
)
def test_reserved_levels_are_not_answered(rig, query) -> None:
    assert rig.tell(A, query) == []


def test_configuration_of_subsystem_and_node(rig) -> None:
    def found(level: int) -> list[tuple[int, list[ComponentRec]]]:
        return [(n.node_rec.node_id, n.component_list) for n in rig.ask(A, QueryConfiguration(level)).node_list]

    assert found(2) == [(1, [ComponentRec(1, 0), ComponentRec(5, 0)]), (2, [ComponentRec(1, 0)])]
    assert found(3) == [(1, [ComponentRec(1, 0), ComponentRec(5, 0)])]


def test_subsystem_list_names_this_component(rig) -> None:
    assert rig.ask(A, QuerySubsystemList()) == ReportSubsystemList([SubsystemRec(101, 1, 1)])


def test_services_with_wildcards_and_without(rig) -> None:
    own = [f"urn:jaus:jss:core:{name}" for name in ("Discovery", "Events", "Liveness", "Transport")]
    other = [MANIPULATOR.uri]
    assert listed(rig.ask(A, services((255, 255)))) == {(1, 1): own, (1, 5): other, (2, 1): other}
    assert listed(rig.ask(A, services((1, 255)))) == {(1, 1): own, (1, 5): other}
    assert listed(rig.ask(A, services((255, 1)))) == {(1, 1): own, (2, 1): other}
    assert listed(rig.ask(A, services((1, 5), (2, 1)))) == {(1, 5): other, (2, 1): other}
    assert listed(rig.ask(A, services((9, 9)))) == {}


def test_inherited_services_are_listed_with_their_versions(robot) -> None:
    (node,) = robot.ask(A, services((255, 255))).node_list
    offers = {
        (each.uri.rpartition(":")[2], each.major_version_number, each.minor_version_number)
        for each in node.component_list[0].service_list
    }
    assert offers == {
        (name, 1, 1)
        for name in (
            "Transport", "Events", "AccessControl", "Management", "Discovery", "Liveness", "Time",
            "PrimitiveDriver", "VelocityStateSensor", "LocalPoseSensor",
        )
    }  # fmt: skip


def service_list(subsystem: int, node: int, component: int, wanted: str | None = None) -> QueryServiceList:
    q = QueryServiceList
    return q(
        [
            q.SubsystemSeq(
                q.SubsystemRec(subsystem), [q.NodeSeq(QueriedNodeRec(node), [q.ComponentRec(component, wanted)])]
            )
        ]
    )


def test_service_list_with_search_filter(rig) -> None:
    def found(query: QueryServiceList) -> dict[tuple[int, int, int], list[str]]:
        return {
            (subsystem.subsystem_rec.subsystem_id, *where): uris
            for subsystem in rig.ask(A, query).subsystem_list
            for where, uris in listed(subsystem).items()
        }

    assert set(found(service_list(65535, 255, 255))) == {(101, 1, 1), (101, 1, 5), (101, 2, 1)}
    assert found(service_list(101, 255, 255, "Liveness")) == {(101, 1, 1): ["urn:jaus:jss:core:Liveness"]}
    assert found(service_list(102, 255, 255)) == {}
    assert found(service_list(101, 1, 5, "core")) == {}


def test_registration_replaces_entries_and_ignores_other_subsystems(rig) -> None:
    other = ServiceRec("urn:example:Other", 1, 0)
    rig.tell("101.1.5", RegisterServices([other]))
    rig.tell("102.1.5", RegisterServices([MANIPULATOR]))
    assert listed(rig.ask(A, services((1, 5)))) == {(1, 5): [other.uri]}
    assert rig.host.counters["foreign_registration"] == 1
    assert len(rig.ask(A, QueryConfiguration(2)).node_list) == 2


def test_own_entry_cannot_be_replaced(rig) -> None:
    before = rig.ask(A, services((1, 1)))
    rig.tell("101.1.1", RegisterServices([MANIPULATOR]))
    assert rig.ask(A, services((1, 1))) == before


def test_the_directory_is_bounded(rig) -> None:
    for node in range(1, 255):
        for component in (1, 2):
            rig.tell(f"101.{node}.{component}", RegisterServices([MANIPULATOR] * 255))
    discovery = rig.host.service(Discovery).directory
    assert len(discovery.all()) == MAX_COMPONENTS + 1
    assert rig.host.counters["registration_dropped"] > 0
    assert discovery.all()[JausID(101, 1, 5)] == ((MANIPULATOR.uri, 2, 0),)
    rig.ask(A, services((255, 255)))


def flood(rig, components: int) -> None:
    """Register as much as messages carry."""
    for number in range(components):
        long = [ServiceRec(f"urn:x:{number:03}:{i:02}:".ljust(100, "x"), 1, 0) for i in range(39)]
        rig.tell(f"101.{1 + number // 200}.{10 + number % 200}", RegisterServices(long))


def test_services_of_a_component_are_bounded(rig) -> None:
    flood(rig, 1)
    uris = listed(rig.ask(A, services((1, 10))))[1, 10]
    assert len(uris) == MAX_REGISTRATION // 103
    assert rig.host.counters["registration_cut"] == 1


def test_reports_fit_one_packet(rig) -> None:
    own = listed(rig.ask(A, services((1, 1))))
    flood(rig, 300)
    report = rig.ask(A, services((255, 255)))
    assert len(report.encode()) <= MAX_PAYLOAD
    assert own.items() <= listed(report).items()
    early = {(1, 5), (2, 1)}
    assert early <= listed(report).keys(), "who was there before the flood is still found"
    every = rig.ask(A, service_list(65535, 255, 255))
    assert len(every.encode()) <= MAX_PAYLOAD
    (subsystem,) = every.subsystem_list
    assert own.items() <= listed(subsystem).items()
    assert rig.host.counters["report_cut"] == 2
    assert len(rig.ask(A, QueryConfiguration(2)).encode()) <= MAX_PAYLOAD
    rig.ask(A, CreateEvent(1, 0, 1.0, services((255, 255))))
    ((_, _, event),) = rig.run(0.5)
    assert isinstance(event, Event)
    assert len(event.encode()) <= MAX_PAYLOAD


def test_typical_robot_is_reported_completely(rig, robot) -> None:
    for component in range(20, 28):
        rig.tell(f"101.1.{component}", registration(robot.host))
    assert len(listed(rig.ask(A, services((1, 255))))) == 10
    assert rig.host.counters["report_cut"] == 0


def test_own_services_are_reported_as_far_as_they_fit(rig) -> None:
    discovery = rig.host.service(Discovery).directory
    discovery.register(rig.ID, [OfferedService(f"{number:02}".ljust(255, "x"), 1, 0) for number in range(60)])
    report = rig.ask(A, services((255, 255)))
    assert len(listed(report)[1, 1]) == MAX_REPORT // 258
    assert len(report.encode()) <= MAX_PAYLOAD


@pytest.mark.parametrize("sign", [RegisterServices([MANIPULATOR]), QueryIdentification(2), QuerySubsystemList()])
def test_registrations_expire_without_messages(rig, sign) -> None:
    rig.run(REGISTRATION_LIFETIME - 1)
    rig.tell("101.1.5", sign)
    rig.run(2)
    assert set(listed(rig.ask(A, services((255, 255))))) == {(1, 1), (1, 5)}
    rig.run(REGISTRATION_LIFETIME)
    assert set(listed(rig.ask(A, services((255, 255))))) == {(1, 1)}
    assert rig.ask(A, QueryConfiguration(2)).node_list[0].component_list == [ComponentRec(1, 0)]


def test_expired_registrations_make_room(rig) -> None:
    flood(rig, MAX_COMPONENTS)
    rig.tell("101.99.1", RegisterServices([MANIPULATOR]))
    assert listed(rig.ask(A, services((99, 1)))) == {}
    rig.run(REGISTRATION_LIFETIME)
    rig.tell("101.99.1", RegisterServices([MANIPULATOR]))
    assert listed(rig.ask(A, services((99, 1)))) == {(99, 1): [MANIPULATOR.uri]}


@pytest.mark.parametrize("name", ["Ωmega", "x" * 256])
def test_name_that_cannot_be_encoded_is_rejected(name) -> None:
    with pytest.raises(ConfigError, match="Latin-1 text of up to 255 bytes"):
        Identity(name, 10001)


def test_registered_component_without_discovery_is_listed(rig, make) -> None:
    other = make(Liveness())
    rig.tell("101.1.9", registration(other.host))
    assert listed(rig.ask(A, services((1, 9)))) == {
        (1, 9): [f"urn:jaus:jss:core:{n}" for n in ("Events", "Liveness", "Transport")]
    }


def test_empty_registration_or_unreachable_component_is_removed(rig) -> None:
    rig.tell("101.1.5", RegisterServices([]))
    assert set(listed(rig.ask(A, services((255, 255))))) == {(1, 1), (2, 1)}
    rig.host.unreachable(JausID.parse("101.2.1"), rig.now)
    rig.host.unreachable(rig.ID, rig.now)
    assert set(listed(rig.ask(A, services((255, 255))))) == {(1, 1)}


@pytest.mark.slow
def test_a_query_with_tens_of_thousands_of_wildcards_looks_each_component_up_once(rig, monkeypatch) -> None:
    flood(rig, MAX_COMPONENTS)
    looked_up = 0

    def counted(id, _real=discovery._addresses):
        nonlocal looked_up
        looked_up += 1
        return _real(id)

    monkeypatch.setattr(discovery, "_addresses", counted)
    rig.ask(A, QueryServices([QueryServices.NodeSeq(QueriedNodeRec(255), [QueriedComponentRec(255)] * 255)] * 255))
    assert looked_up == MAX_COMPONENTS + 1


def test_search_filters_add_up_and_are_bounded(rig) -> None:
    query = service_list(101, 1, 1, "Liveness")
    more = service_list(101, 255, 1, "Discovery").subsystem_list
    (subsystem,) = rig.ask(A, QueryServiceList(query.subsystem_list + more)).subsystem_list
    assert listed(subsystem)[1, 1] == ["urn:jaus:jss:core:Discovery", "urn:jaus:jss:core:Liveness"]
    nonsense = [service_list(101, 1, 1, f"nonsense {n}").subsystem_list[0] for n in range(MAX_FILTERS)]
    assert rig.ask(A, QueryServiceList(nonsense + query.subsystem_list)).subsystem_list == []
    assert rig.host.counters["query_cut"] == 1
