"""PlatformState and PlatformMode: the component and the others of the platform go into a state together."""

from __future__ import annotations

import pytest

from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages.core import ClearEmergency, QueryStatus, RequestControl, Reset, SetEmergency, Shutdown
from jauspy.messages.iop import (
    ConfirmPlatformStateRequest,
    QueryPlatformMode,
    QueryPlatformState,
    QuerySupportedPlatformModes,
    ReportPlatformMode,
    SetPlatformMode,
    SetPlatformState,
)
from jauspy.protocol.header import Broadcast
from jauspy.services.core import AccessControl, Liveness, Management
from jauspy.services.iop import (
    PlatformMode,
    PlatformState,
    UnsolicitedBroadcastControlAvailable,
    UnsolicitedHeartbeat,
)

A, B = "42.1.1", "43.1.1"
OTHERS = [JausID(101, 1, 102), JausID(101, 1, 104)]
Wanted = SetPlatformState.PlatformState
STOP = SetEmergency.EmergencyCode.STOP
Mode = ReportPlatformMode.PlatformMode


@pytest.fixture
def rig(make):
    rig = make(AccessControl(timeout=0), Management(), PlatformState(OTHERS), PlatformMode())
    rig.tell(A, RequestControl(100))
    return rig


def state(rig):
    return rig.ask(B, QueryPlatformState()).platform_state


def acknowledge(rig, *, delivered: bool = True):
    """Acknowledge all that waits, until nothing more is sent; what was sent."""
    found = []
    while out := rig.host.poll_output(rig.now):
        for message in out:
            found.append((str(message.destination), message.payload))
            if message.on_acknowledged is not None:
                message.on_acknowledged(delivered)
    return found


def confirmed(wanted, *, accepted: bool = True):
    codes = ConfirmPlatformStateRequest.ResponseCode
    return ConfirmPlatformStateRequest(wanted, codes.TRANSITIONING if accepted else codes.INVALID_STATE)


def test_platform_is_operational_in_standby_and_ready(rig):
    assert state(rig) == Wanted.OPERATIONAL


def test_emergency_reaches_all_components_and_ends_for_all(rig):
    sent = rig.tell(A, SetPlatformState(Wanted.EMERGENCY))
    assert sent == [
        *((str(other), SetEmergency(STOP)) for other in OTHERS),
        (A, confirmed(Wanted.EMERGENCY)),
    ]
    assert state(rig) == Wanted.EMERGENCY
    assert rig.ask(B, QueryStatus()).status == 5
    sent = rig.tell(A, SetPlatformState(Wanted.OPERATIONAL))
    assert sent == [
        *((str(other), ClearEmergency(STOP)) for other in OTHERS),
        (A, confirmed(Wanted.OPERATIONAL)),
    ]
    assert state(rig) == Wanted.OPERATIONAL


def test_emergency_of_another_client_is_not_ended(rig):
    rig.tell(A, SetPlatformState(Wanted.EMERGENCY))
    rig.tell(B, SetEmergency(STOP))
    rig.tell(A, SetPlatformState(Wanted.OPERATIONAL))
    assert state(rig) == Wanted.EMERGENCY


@pytest.mark.parametrize("wanted", [Wanted.EMERGENCY, Wanted.SHUTDOWN, Wanted.INITIALIZE])
def test_client_without_control_changes_nothing(rig, wanted):
    assert rig.tell(B, SetPlatformState(wanted)) == []
    assert state(rig) == Wanted.OPERATIONAL


@pytest.mark.parametrize(("wanted", "command"), [(Wanted.SHUTDOWN, Shutdown), (Wanted.INITIALIZE, Reset)])
def test_other_components_are_controlled_and_then_commanded(rig, wanted, command):
    rig.host.receive(SetPlatformState(wanted).encode(), JausID.parse(A), rig.now)
    sent = acknowledge(rig)
    for other in OTHERS:
        assert [data for to, data in sent if to == str(other)] == [RequestControl(255).encode(), command().encode()]
    assert (A, confirmed(wanted).encode()) in sent
    assert state(rig) == (Wanted.SHUTDOWN if command is Shutdown else Wanted.OPERATIONAL)


def test_component_that_does_not_answer_is_counted_and_not_commanded(rig):
    rig.host.receive(SetPlatformState(Wanted.SHUTDOWN).encode(), JausID.parse(A), rig.now)
    sent = acknowledge(rig, delivered=False)
    assert not [data for _, data in sent if data == Shutdown().encode()]
    assert rig.host.counters["platform_state_not_delivered"] == len(OTHERS)


def test_reset_in_an_emergency_is_refused(rig):
    rig.tell(A, SetPlatformState(Wanted.EMERGENCY))
    assert rig.tell(A, SetPlatformState(Wanted.INITIALIZE)) == [(A, confirmed(Wanted.INITIALIZE, accepted=False))]
    assert state(rig) == Wanted.EMERGENCY


def test_platform_is_not_rendered_useless(rig):
    answer = rig.ask(A, SetPlatformState(Wanted.RENDER_USELESS))
    assert answer == confirmed(Wanted.RENDER_USELESS, accepted=False)
    assert state(rig) == Wanted.OPERATIONAL


def test_mode_is_reported_and_an_unsupported_one_is_counted(rig):
    assert rig.ask(B, QueryPlatformMode()) == ReportPlatformMode(Mode.STANDARD_OPERATING, 1)
    (supported,) = rig.ask(B, QuerySupportedPlatformModes()).supported_platform_modes_list
    assert supported.platform_mode == Mode.STANDARD_OPERATING
    assert rig.tell(A, SetPlatformMode(Mode.TRAINING)) == []
    assert rig.host.counters["platform_mode_unsupported"] == 1
    assert rig.ask(B, QueryPlatformMode()).platform_mode == Mode.STANDARD_OPERATING


def test_mode_changes_once_for_the_client_in_control(make):
    changes = []
    rig = make(Management(), PlatformMode([Mode.STANDARD_OPERATING, Mode.TRAINING], changes.append))
    rig.tell(B, SetPlatformMode(Mode.TRAINING))
    assert changes == []
    rig.tell(A, RequestControl(100))
    rig.tell(A, SetPlatformMode(Mode.TRAINING))
    rig.tell(A, SetPlatformMode(Mode.TRAINING))
    assert changes == [Mode.TRAINING]


def test_platform_without_modes_is_an_error():
    with pytest.raises(ConfigError, match="modes is empty"):
        PlatformMode(())


def test_two_broadcasts_of_one_component_keep_their_periods(make):
    rig = make(Liveness(), UnsolicitedHeartbeat(1.0), UnsolicitedBroadcastControlAvailable(2.5), Management())
    out = []
    while (due := rig.host.next_timeout()) is not None and due <= 5.0:
        rig.host.handle_timeout(due)
        out += [(due, message) for message in rig.host.poll_output(due)]
    assert {str(message.destination) for _, message in out} == {"65535.255.255"}
    assert {message.broadcast for _, message in out} == {Broadcast.GLOBAL}
    assert [when for when, message in out if message.payload == bytes.fromhex("0242")] == [1.0, 2.0, 3.0, 4.0, 5.0]
    assert [when for when, message in out if message.payload[:2] == bytes.fromhex("0d40")] == [2.5, 5.0]
