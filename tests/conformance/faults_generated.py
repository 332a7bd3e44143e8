"""Components that break their state machines; a sample for the profiles made from JSIDL."""

from __future__ import annotations

from typing import Final

from tests.conformance.injectors import (
    Fault,
    Injector,
    deaf_to,
    field,
    instead,
    later,
    patched,
    repacked,
    says,
    short,
    without,
    works,
)
from tests.conformance.mistakes import (
    ACCEPTED,
    anybody,
    anything,
    big_endian,
    chatty,
    clears_all,
    confirmed,
    elsewhere,
    goes_on,
    idle,
    not_notified,
    reports_pass,
    sixty_hertz,
    skipping,
    swapped_bits,
    to_winner,
    unmasked,
)

from jauspy.messages import core, mobility
from jauspy.services import presence_vectors
from jauspy.services.core import AccessControl, Events, ListManager, Management, events as event_reports

READY, STANDBY = "Controlled.Available.Ready", "Controlled.Available.Standby"
EMERGENCY, FREE = "Controlled.NotAvailable.Emergency", "NotControlled.Available.Standby"


def core_fault(name: str, steps: str, inject: Injector, profile: str = "core-1.1", fails: str = "") -> Fault:
    """Only these steps are run, all of which are to be tripped, unless it is said which."""
    only = tuple(steps.split())
    return Fault(name, profile, tuple(fails.split()) or only, inject, timeout=5, motion=True, still=True, only=only)


GENERATED: Final = (
    core_fault(
        "control not checked",
        f"{READY}/Standby/other-client {STANDBY}/Resume/other-client {READY}/ReleaseControl/other-client",
        patched(AccessControl, is_controlling_client=anybody),
    ),
    core_fault(
        "lists are taken from anybody",
        f"{STANDBY}/DeleteElement/other-client/an-unknown-one",
        patched(AccessControl, is_controlling_client=anybody),
    ),
    core_fault("the loser is not told", f"{READY}/RequestControl/other-client/more-authority", says(not_notified)),
    core_fault(
        "any authority takes over",
        f"{READY}/RequestControl/other-client/less-authority",
        patched(AccessControl, is_current_authority_less=anybody),
    ),
    core_fault(
        "the default authority does not count",
        f"{FREE}/RequestControl/other-client/authority-below-the-default",
        patched(AccessControl, is_default_authority_greater=lambda self, msg: False),
    ),
    core_fault(
        "control never ends by itself",
        f"{READY}/Timedout/controller/the-client-is-silent",
        patched(AccessControl, reset_timer=idle),
    ),
    core_fault(
        "authority may be raised",
        f"{READY}/SetAuthority/controller/more-authority",
        patched(AccessControl, is_authority_valid=anybody),
    ),
    core_fault(
        "authority cannot be lowered", f"{READY}/SetAuthority/controller/less-authority", deaf_to(core.SetAuthority)
    ),
    core_fault(
        "control is given during an emergency",
        f"{EMERGENCY}/RequestControl/other-client/more-authority",
        field(core.ConfirmControl, response_code=ACCEPTED),
    ),
    core_fault(
        "anybody clears an emergency",
        f"{EMERGENCY}/ClearEmergency/controller",
        patched(Management, is_id_stored=anybody, delete_id=clears_all),
    ),
    core_fault("emergency is ignored", f"{READY}/SetEmergency/other-client", deaf_to(core.SetEmergency)),
    core_fault("Reset is ignored", f"{READY}/Reset/controller", deaf_to(core.Reset)),
    core_fault("Standby is ignored", f"{READY}/Standby/controller", deaf_to(core.Standby)),
    core_fault("Shutdown is ignored", f"{READY}/Shutdown/controller", deaf_to(core.Shutdown)),
    core_fault("unknown events are cancelled", f"{FREE}/CancelEvent/other-client/an-unknown-one", reports_pass()),
    core_fault(
        "a report passes as a query", f"{FREE}/CreateEvent/other-client/a-report-instead-of-a-query", reports_pass()
    ),
    core_fault(
        "events are not updated", f"{FREE}/UpdateEvent/other-client/one-that-is-there", deaf_to(core.UpdateEvent)
    ),
    core_fault(
        "events never end",
        f"{FREE}/Timeout/other-client/an-event-is-not-renewed",
        patched(Events, reset_event_timer=idle),
    ),
    core_fault("events never come", f"{FREE}/EventOccurred/other-client/an-event-is-due", without(core.Event)),
    core_fault(
        "identification is always of the system",
        f"{FREE}/QueryIdentification/other-client/level-2",
        field(core.ReportIdentification, query_type=1),
    ),
    core_fault("ReportTime is short", f"{FREE}/QueryTime/other-client/all-fields", short(core.ReportTime)),
    core_fault("ReportControl is short", f"{FREE}/QueryControl/other-client", short(core.ReportControl)),
    core_fault(
        "commands are answered", f"{READY}/Standby/controller {READY}/Standby/other-client", chatty(core.Standby)
    ),
    core_fault(
        "wrong elements are confirmed",
        f"{STANDBY}/SetElement/controller/after-an-unknown-one",
        instead(core.RejectElementRequest, lambda message: core.ConfirmElementRequest(message.request_id)),
    ),
    core_fault(
        "time ignores the presence vector",
        f"{FREE}/QueryTime/other-client/no-fields",
        patched(presence_vectors, apply_presence_vectors=unmasked),
    ),
    core_fault(
        "poses ignore the presence vector",
        f"{FREE}/QueryLocalPose/other-client/no-fields",
        patched(presence_vectors, apply_presence_vectors=unmasked),
        profile="mobility-1.1",
    ),
    core_fault(
        "poses are short",
        f"{FREE}/QueryLocalPose/other-client/all-fields",
        short(mobility.ReportLocalPose),
        profile="mobility-1.1",
    ),
    core_fault(
        "speed is not reported",
        f"{FREE}/QueryTravelSpeed/other-client",
        deaf_to(mobility.QueryTravelSpeed),
        profile="mobility-1.1",
    ),
    core_fault(
        "waypoints are answered",
        f"{STANDBY}/SetLocalWaypoint/controller",
        chatty(mobility.SetLocalWaypoint),
        profile="mobility-1.1",
    ),
    core_fault(
        "events come faster than was confirmed",
        f"{FREE}/EventOccurred/other-client/an-event-is-due",
        patched(Events, _set_rate=sixty_hertz),
    ),
    core_fault("cancelled events go on", f"{FREE}/CancelEvent/other-client/one-that-is-there", goes_on()),
    core_fault(
        "events are confirmed and not kept",
        f"{FREE}/CreateEvent/other-client/a-new-one",
        instead(core.ReportEvents, lambda report: core.ReportEvents([])),
    ),
    core_fault(
        "an update makes another event", f"{FREE}/UpdateEvent/other-client/one-that-is-there", confirmed(2, event_id=99)
    ),
    core_fault("changes are not told", f"{READY}/CreateEvent/controller/of-changes", without(core.Event)),
    core_fault(
        "what has not changed is told, too",
        f"{READY}/CreateEvent/controller/of-changes",
        patched(event_reports, _is_due=anything),
    ),
    core_fault(
        "commands never take too long",
        f"{READY}/CommandExpired/controller/a-command-does-not-end",
        patched(Events, start_command_timer=idle),
    ),
    core_fault(
        "elements are confirmed and not kept",
        f"{STANDBY}/SetElement/controller/a-new-one",
        patched(ListManager, set_element=idle),
    ),
    core_fault(
        "lists take nothing",
        f"{STANDBY}/SetElement/controller/a-new-one",
        patched(ListManager, is_element_supported=lambda self, msg: False),
    ),
    core_fault(
        "deleted elements stay",
        f"{STANDBY}/DeleteElement/controller/one-that-is-there",
        patched(ListManager, delete_element=idle),
    ),
    core_fault(
        "lists take what nobody can carry out",
        f"{STANDBY}/SetElement/controller/an-unknown-message",
        instead(core.RejectElementRequest, lambda message: core.ConfirmElementRequest(message.request_id)),
    ),
    core_fault(
        "Resume works once",
        f"{STANDBY}/Resume/controller {READY}/Standby/controller {READY}/Reset/controller",
        later(core.Resume, 2, deaf_to(core.Resume)),
        fails=f"{READY}/Reset/controller",
    ),
    core_fault(
        "travel speeds are not used",
        f"{READY}/SetTravelSpeed/controller",
        deaf_to(mobility.SetTravelSpeed),
        profile="mobility-1.1",
    ),
    core_fault(
        "velocities are taken from anybody",
        f"{READY}/SetVelocityCommand/other-client/for-now",
        patched(AccessControl, is_controlling_client=anybody),
        profile="mobility-1.1",
    ),
    core_fault(
        "waypoints are forgotten",
        f"{READY}/QueryLocalWaypoint/controller/all-fields-of-one-that-was-set",
        deaf_to(mobility.SetLocalWaypoint),
        profile="mobility-1.1",
    ),
    core_fault(
        "lists are not carried out",
        f"{READY}/ExecuteList/controller/from-an-existing-one",
        deaf_to(mobility.ExecuteList),
        profile="mobility-1.1",
    ),
    core_fault("the time is not set", f"{READY}/SetTime/controller", deaf_to(core.SetTime)),
    core_fault(
        "the time is set by anybody",
        f"{READY}/SetTime/other-client",
        patched(AccessControl, is_controlling_client=anybody),
    ),
    core_fault("events are numbered by twos", f"{FREE}/EventOccurred/other-client/an-event-is-due", skipping()),
    core_fault(
        "answers come from another component",
        f"{FREE}/QueryTime/other-client/all-fields",
        works(repacked(elsewhere(9, core.ReportTime))),
    ),
    core_fault(
        "the winner is told instead of the loser", f"{READY}/RequestControl/other-client/more-authority", to_winner()
    ),
    core_fault(
        "control ends earlier than the timeout says",
        f"{READY}/Timedout/controller/the-client-is-silent",
        field(core.ReportTimeout, timeout=10),
    ),
    core_fault(
        "control ends later than the timeout says",
        f"{READY}/Timedout/controller/the-client-is-silent",
        field(core.ReportTimeout, timeout=2),
    ),
    core_fault(
        "the end of a command is not told",
        f"{FREE}/CreateCommandEvent/other-client/a-new-one",
        without(core.CommandEvent),
    ),
    core_fault(
        "an ignored command has succeeded",
        f"{FREE}/CreateCommandEvent/other-client/a-new-one",
        field(core.CommandEvent, command_result=core.CommandEvent.CommandResult.SUCCESSFUL),
    ),
    core_fault(
        "presence bits are mixed up",
        f"{FREE}/QueryLocalPose/other-client/some-fields",
        swapped_bits(mobility.QueryLocalPose),
        profile="mobility-1.1",
    ),
    core_fault(
        "efforts and poses are taken from anybody",
        f"{READY}/SetWrenchEffort/other-client {READY}/SetLocalPose/other-client",
        patched(AccessControl, is_controlling_client=anybody),
        profile="mobility-1.1",
    ),
    core_fault(
        "efforts are taken and not used",
        f"{READY}/SetWrenchEffort/controller",
        deaf_to(mobility.SetWrenchEffort),
        profile="mobility-1.1",
    ),
    core_fault(
        "efforts have the wrong byte order",
        f"{READY}/SetWrenchEffort/controller",
        big_endian(mobility.ReportWrenchEffort, 4),
        profile="mobility-1.1",
    ),
)
