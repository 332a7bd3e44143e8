"""Valid messages in any order, from clients that come and go: nothing is a bug, and what may not move stands."""

from __future__ import annotations

from random import Random

import pytest
from tests.helpers.sampling import sampled

from jauspy.fuzz.messages import MessageMaker, Style, targets
from jauspy.messages import registry
from jauspy.messages.core import (
    ClearEmergency,
    CreateCommandEvent,
    CreateEvent,
    RequestControl,
    Resume,
    SetElement,
    SetEmergency,
)
from jauspy.messages.mobility import QueryLocalPose, SetLocalWaypoint, SetWrenchEffort
from jauspy.schema import load_builtin
from jauspy.services.core import AccessControl, Discovery, Events, Liveness, Management, Time
from jauspy.services.mobility import (
    GlobalPose,
    GlobalPoseSensor,
    GlobalVectorDriver,
    GlobalWaypointListDriver,
    LocalPoseSensor,
    LocalVectorDriver,
    LocalWaypointDriver,
    LocalWaypointListDriver,
    PrimitiveDriver,
    Vehicle,
    VelocityStateDriver,
)

KINDS = (
    PrimitiveDriver,
    VelocityStateDriver,
    LocalVectorDriver,
    GlobalVectorDriver,
    LocalWaypointDriver,
    LocalWaypointListDriver,
    GlobalWaypointListDriver,
    LocalPoseSensor,
    GlobalPoseSensor,
)
OFTEN = (RequestControl, Resume, SetEmergency, ClearEmergency, CreateEvent, CreateCommandEvent, SetElement)
TARGETS = {each.cls: each for each in targets(registry, load_builtin())}
INNER = [TARGETS[each] for each in (QueryLocalPose, SetWrenchEffort, SetLocalWaypoint, Resume)]


def step(rig, drive, random: Random) -> None:
    """One thing that happens to a component."""
    chance, client = random.random(), rig.ID.parse(f"42.1.{random.randint(1, 3)}")
    if chance < 0.7:
        inputs = [each for each in rig.host._bound.inputs.values() if each in TARGETS]
        kind = random.choice(OFTEN if random.random() < 0.5 else inputs)
        payload = MessageMaker(random, random.choice(list(Style)), INNER).message(TARGETS[kind])
        rig.host.receive(payload, client, rig.now)
    elif chance < 0.9:
        rig.run(random.uniform(0.0, 2.0))
    elif chance < 0.95:
        rig.host.unreachable(client, rig.now)
    elif chance < 0.98:
        rig.host.leave(rig.now)
        rig.host.take_id(rig.ID.parse(f"101.1.{random.randint(1, 250)}"), rig.now)
        assert len(rig.host.service(Events).subscriptions) == 0
        assert rig.host.controller is None or rig.host.status.name == "EMERGENCY"
    else:
        rig.host.close(rig.now)
        assert drive.effort == (0.0, 0.0)
    rig.sent()


@pytest.mark.slow
@pytest.mark.parametrize("seed", sampled(range(40), 10))
def test_random_inputs_raise_nothing_and_move_nothing_without_control(make, drive, seed) -> None:
    random, vehicle = Random(seed), Vehicle(drive, name="test", origin=GlobalPose(60.0, 25.0, 10.0, 0.0))
    core = (Discovery(), Liveness(), Time(), Management(), AccessControl(timeout=2), Events(timeout=1))
    rig = make(*(kind(vehicle) for kind in KINDS), *core)
    for _ in range(200):
        step(rig, drive, random)
        assert rig.host.status.name == "READY" or drive.effort == (0.0, 0.0)
    assert rig.host.counters["action_failed"] == 0
