"""Profile iop-v3: inc1 passes, and each seeded fault is named by the sentence of its step."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from contextlib import ExitStack

import pytest
from tests.conformance.injectors import Injector, deaf_to, field, instead as replaced, patched, short, without
from tests.conformance.simulated import examined, robot

from jauspy.conformance import Report, Verdict, find
from jauspy.conformance.profile import Offers
from jauspy.conformance.profiles import iop_v3
from jauspy.conformance.state_tests.plan import service_profile
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages import core, iop, registry
from jauspy.schema import load_builtin
from jauspy.schema.inheritance import lineage, parents_among
from jauspy.services.core import AccessControl
from jauspy.services.iop import AEODRSDigitalVideo, EnhancedAccessControl, PlatformState, UnsolicitedHeartbeat

PLATFORM = JausID(101, 255, 255)
MASTER = "101.1.110"


def run(inject: Injector | None = None, *only: str) -> Report:
    """The profile against inc1, with a fault or without."""
    part, virtual_target, patches = inject() if inject else (None, None, [])
    with ExitStack() as stack:
        for patch in patches:
            stack.enter_context(patch)
        target = robot(*(one for one in (part, virtual_target) if one), name="inc1", tick=None)
        return examined("iop-v3", target, PLATFORM, only=only)


@pytest.mark.slow
def test_inc1_passes():
    report = run()
    assert [f"{step.id}: {step.reason}" for step in report.failures] == []
    assert report.problem == ""
    assert report.status == 0
    assert len(report.results) >= 100
    skipped = [step.id for step in report.results if step.verdict is Verdict.SKIPPED]
    assert skipped == ["101.1.110/NodeIDAllocator"]  # which has no query


def services(change: Callable[[core.ServiceRec], core.ServiceRec | None]) -> Injector:
    """Each service in a list of services is another one, or missing."""

    def changed(report: core.ReportServices) -> None:
        for node in report.node_list:
            for component in node.component_list:
                component.service_list = [new for one in component.service_list if (new := change(one)) is not None]

    return replaced(core.ReportServices, changed)


def missing(urn: str) -> Injector:
    return services(lambda service: None if service.uri == urn else service)


def older(urn: str) -> Injector:
    def change(service: core.ServiceRec) -> core.ServiceRec:
        if service.uri == urn:
            service.minor_version_number = 0
        return service

    return services(change)


DEMANDED = [
    *(f"urn:jaus:jss:core:{name}" for name in iop_v3.PLATFORM_CORE),
    *(f"urn:jaus:jss:iop:{name}" for name in iop_v3.PLATFORM),
]


@pytest.mark.slow
@pytest.mark.parametrize("urn", DEMANDED)
def test_missing_service_of_the_platform(urn):
    name = urn.rpartition(":")[2]
    report = run(missing(urn), "platform")
    assert [(step.id, step.verdict) for step in report.failures] == [(f"platform/{name}", Verdict.FAIL)]
    assert report.failures[0].reason == (
        f"no component of 101.255.255 offers {urn}; each platform must offer it in 1.1"
    )


@pytest.mark.slow
@pytest.mark.parametrize("urn", DEMANDED[2:])
def test_wrong_version_of_a_service_of_the_platform(urn):
    name = urn.rpartition(":")[2]
    (failure,) = run(older(urn), "platform").failures
    assert failure.id == f"platform/{name}"
    assert failure.reason == f"{MASTER} offers {name} 1.0, not 1.1"


@pytest.mark.parametrize("name", iop_v3.EVERY_COMPONENT[1:])
def test_missing_core_service_of_each_component(name):
    report = run(missing(f"urn:jaus:jss:core:{name}"), *(f"101.1.{number}/services" for number in range(102, 111)))
    assert report.failures != ()
    assert all(step.reason.endswith(f"does not offer {name} 1.1") for step in report.failures)


def inert(self: object) -> None:
    """Do nothing."""


def deaf(self: object, message: object) -> None:
    """Send nothing."""


def keeps(self: object, client: object, authority: object, operator: object) -> None:
    """Hand nothing over."""


def pretends(self: object, request: object, code: object) -> None:
    """Nothing is told."""


def no_camera(self: object, query: object) -> None:
    """Know no camera."""


FAULTS: dict[str, tuple[Injector, str, Verdict, str]] = {
    "report without an answer": (
        without(iop.ReportPlatformMode),
        "mode",
        Verdict.SILENT,
        "no ReportPlatformMode FF23h came in 3 s",
    ),
    "query that is not understood": (
        deaf_to(iop.QueryPlatformState),
        "state",
        Verdict.SILENT,
        "no ReportPlatformState FF28h came in 3 s",
    ),
    "report with a byte too few": (
        short(iop.ReportHandoffTimeout),
        "handoff/time-out",
        Verdict.MALFORMED,
        "ReportHandoffTimeout FF36h from 101.1.110 is malformed",
    ),
    "core query without an answer": (
        without(core.ReportTimeout),
        "101.1.102/QueryTimeout",
        Verdict.SILENT,
        "no ReportTimeout 4003h came in 3 s",
    ),
    "query of a capability without an answer": (
        without(iop.ReportSoftwareVersion),
        f"{MASTER}/SoftwareVersionReporting",
        Verdict.SILENT,
        "no ReportSoftwareVersion F999h came in 3 s",
    ),
    "query for a camera without an answer": (
        patched(AEODRSDigitalVideo, send_report_aimpoint_parameters=no_camera),
        "101.1.106/AEODRSDigitalVideo/QueryAimpointParameters",
        Verdict.SILENT,
        "no ReportAimpointParameters F805h came in 3 s",
    ),
    "components that do not follow into the emergency": (
        patched(PlatformState, _send_all=deaf),
        "state/emergency",
        Verdict.FAIL,
        "101.1.109, 101.1.113 is not in EMERGENCY",
    ),
    "wrong state after a command": (
        field(iop.ReportPlatformState, platform_state=iop_v3.State.OPERATIONAL),
        "state/emergency",
        Verdict.FAIL,
        "platform_state is 1 OPERATIONAL, not 4 EMERGENCY",
    ),
    "emergency that does not end at the components": (
        deaf_to(core.ClearEmergency),
        "state/emergency",
        Verdict.FAIL,
        "101.1.109, 101.1.113 is still in EMERGENCY",
    ),
    "command of a client without control that is carried out": (
        patched(AccessControl, is_controlling_client=lambda self: True),
        "state/no-control",
        Verdict.FAIL,
        "where nothing should",
    ),
    "platform that is not operational": (
        field(iop.ReportPlatformState, platform_state=iop_v3.State.SYSTEM_ABORT),
        "state",
        Verdict.FAIL,
        "platform_state is 3 SYSTEM_ABORT, not 1 OPERATIONAL",
    ),
    "grant that hands nothing over": (
        patched(AccessControl, hand_over=keeps),
        "handoff/granted",
        Verdict.FAIL,
        "component_id is 1, not 2",
    ),
    "requests that the client in control does not see": (
        without(iop.RequestReleaseControl),
        "handoff/denied",
        Verdict.SILENT,
        "no RequestReleaseControl FF38h came in 3 s",
    ),
    "decision that is not told": (
        patched(EnhancedAccessControl, _tell=pretends),
        "handoff/deferred",
        Verdict.SILENT,
        "no ConfirmHandoffRequest FF35h came in 3 s",
    ),
    "no heartbeat": (
        patched(UnsolicitedHeartbeat, broadcast_report_heart_beat_pulse=inert),
        "heartbeat",
        Verdict.SILENT,
        "no ReportHeartbeatPulse 4202h came in 12 s",
    ),
    "mode that is not among those supported": (
        field(iop.ReportSupportedPlatformModes, supported_platform_modes_list=[]),
        "mode",
        Verdict.FAIL,
        "does not hold: lists mode 0, which is the present one",
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", FAULTS)
def test_seeded_fault_is_named(name):
    inject, step, verdict, sentence = FAULTS[name]
    report = run(inject, step)
    failures = [result for result in report.failures if result.id.startswith(step)]
    assert failures, f"{name} is not caught"
    assert failures[0].verdict is verdict
    assert sentence in failures[0].reason


def test_target_without_services_is_an_error():
    with pytest.raises(ConfigError, match="lists no services"):
        iop_v3.steps(Offers({JausID(101, 1, 1): frozenset()}))


def definitions() -> Iterable[str]:
    return sorted({service.id for service in load_builtin().services if service.id.startswith(iop_v3.PROFILE_SETS)})


@pytest.mark.parametrize("urn", definitions())
def test_steps_are_generated_for_every_service_of_the_profile(urn):
    found = [service for service in load_builtin().services if service.id == urn]
    parent_of = parents_among(load_builtin().services)
    offers = Offers({JausID(101, 1, 1): frozenset(one.key for service in found for one in lineage(service, parent_of))})
    steps = service_profile(urn, registry).plan(offers)
    assert bool(steps) == any(service.messages for service in found)  # broadcasts are tested by steps of their own


SINGLE = (
    ("PlatformState", 110, "Controlled.Available"),
    ("Communicator", 110, "Controlled.Available.Ready"),
    ("AEODRSDigitalVideo", 106, "NotControlled"),
    ("AEODRSVideoIlluminator", 106, "NotControlled"),
    ("H264VideoEncoding", 106, "Controlled.Available"),
)
"""Services whose inputs need particular values, or that send more than their definitions tell."""


@pytest.mark.slow
@pytest.mark.parametrize(("name", "component", "states"), SINGLE, ids=[name for name, *_ in SINGLE])
def test_inc1_passes_the_steps_of_one_service(name, component, states):
    urns = [urn for urn in definitions() if urn.endswith(f":{name}")]
    target = robot(name="inc1", component=component, tick=None)
    report = examined(service_profile(urns[0], registry), target, JausID(101, 1, component), only=(states,))
    assert [f"{step.id}: {step.reason}" for step in report.failures] == []
    assert any(step.verdict is Verdict.PASS for step in report.results)


def test_profile_is_listed():
    assert find("iop-v3").asks_for_services
