"""What a step sets for the sake of its effect is as it was when the step is over."""

from __future__ import annotations

import pytest
from tests.conformance.simulated import examined, robot

from jauspy.conformance import Profile, Step
from jauspy.conformance.state_tests.sensors import SETTINGS
from jauspy.ids import JausID
from jauspy.messages.manipulator import QueryJointMotionProfile, QueryPanTiltMotionProfile

READY = "Controlled.Available.Ready"
CAMERA, LASER = JausID(101, 1, 106), JausID(101, 1, 108)
SENSORS = [
    pytest.param("sensing-2.0", LASER if "Range" in each.query.NAME else CAMERA, each.query, id=each.field)
    for each in SETTINGS
    if each.field != "horizontal_field_of_view"  # our cameras refuse another one
]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("profile", "target", "query"),
    [
        *SENSORS,
        pytest.param("manipulator-2.0", JausID(101, 1, 104), QueryJointMotionProfile(), id="arm"),
        pytest.param("manipulator-2.0", JausID(101, 1, 107), QueryPanTiltMotionProfile(), id="pan-tilt"),
    ],
)
def test_settings_are_restored(profile, target, query):
    virtual_target = robot(name="inc1", component=target.component, tick=None)
    reported = []

    def look(tester):
        reported.append(tester.client("42.1.1").ask(query, type(query).REPORT))

    asking = Profile("asking", "x", (Step("1", "x", look),))
    examined(asking, virtual_target, target)
    command = query.NAME.replace("Query", "Set", 1)
    report = examined(profile, virtual_target, target, only=(f"{READY}/{command}/controller",))
    assert report.status == 0
    examined(asking, virtual_target, target)
    assert reported[0] == reported[1]


@pytest.mark.slow
def test_clock_is_restored():
    virtual_target = robot(component=1, tick=None)
    only = "NotControlled.Available.Standby/SetTime/other-client", f"{READY}/SetTime/controller"
    assert examined("core-1.1", virtual_target, JausID(105, 1, 1), only=only).status == 0
    (part,) = virtual_target.components.values()
    assert abs(part.host.clock_offset.total_seconds()) < 0.1
