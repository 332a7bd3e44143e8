"""`jauspy send --control` with components that list less than they have, as those of other vendors do."""

from __future__ import annotations

import pytest
from tests.helpers.robot import FakeDrive
from tests.modules.cameras import FakeVideo

from jauspy.cli.send import send_in_control
from jauspy.component.component import loop_time
from jauspy.errors import ControlRejected, JausError, RequestError
from jauspy.geometry.poses import Transform
from jauspy.ids import JausID
from jauspy.messages.core import ReleaseControl, RequestControl, Resume, SetTime
from jauspy.messages.environment_sensing import SetVisualSensorConfiguration
from jauspy.messages.mobility import SetWrenchEffort
from jauspy.platform.camera import CameraSetup
from jauspy.services.core import AccessControl, Discovery, Time
from jauspy.services.environment_sensing import VideoCamera, VisualSensor
from jauspy.services.mobility import PrimitiveDriver, Vehicle
from jauspy.testing import VirtualNetwork

COMPONENT = JausID(126, 1, 11)
DRIVE = SetWrenchEffort(propulsive_linear_effort_x=40.0)


async def send(network: VirtualNetwork, message, authority=200, hold=0.0):
    await send_in_control(network.ocu(), COMPONENT, message, authority=authority, hold=hold, within=None, max_wait=2.0)


@pytest.mark.parametrize("services", [[], [Discovery]], ids=["without Discovery", "with Discovery"])
async def test_a_service_that_inherits_access_control_is_enough(virtual_network, services):
    drive = FakeDrive(clock=loop_time)
    made = [PrimitiveDriver(Vehicle(drive)), AccessControl(timeout=5), *(each() for each in services)]
    async with virtual_network.component(COMPONENT, made, core=False):
        await send(virtual_network, DRIVE)
        first, *_, last = (each.payload for each in virtual_network.sent(SetWrenchEffort))
        assert virtual_network.sent(Resume)
        assert virtual_network.sent(ReleaseControl)
        assert (first, last) == (DRIVE.encode(), SetWrenchEffort(propulsive_linear_effort_x=0.0).encode())
        assert any(linear == pytest.approx(0.4, abs=0.01) for linear, _ in drive.efforts)


async def test_an_effort_is_repeated_for_hold_seconds_and_ends_with_zero(virtual_network):
    drive = FakeDrive(clock=loop_time)
    made = [PrimitiveDriver(Vehicle(drive)), AccessControl(timeout=5), Discovery()]
    async with virtual_network.component(COMPONENT, made, core=False):
        await send(virtual_network, DRIVE, hold=1.05)
        *efforts, zero = (each.payload for each in virtual_network.sent(SetWrenchEffort))
        assert efforts == [DRIVE.encode()] * 6
        assert zero == SetWrenchEffort(propulsive_linear_effort_x=0.0).encode()
        assert drive.efforts[-1] == (0.0, 0.0)


async def test_a_component_without_management_is_not_resumed(virtual_network, capsys):
    async with virtual_network.component(COMPONENT, [Time(), AccessControl(timeout=5)], core=False):
        await send(virtual_network, SetTime())
    assert virtual_network.sent(RequestControl)
    assert virtual_network.sent(SetTime)
    assert not virtual_network.sent(Resume)
    assert "126.1.11 does not report a status" in capsys.readouterr().err


async def test_refusals_and_silence_are_reported(virtual_network):
    with pytest.raises(JausError, match=r"126\.1\.11"):
        await send(virtual_network, DRIVE)
    access = AccessControl(default_authority=100, timeout=5)
    async with virtual_network.component(COMPONENT, [Time(), access], core=False):
        with pytest.raises(ControlRejected, match="gives control to authority 100 and above; requested with 50"):
            await send(virtual_network, SetTime(), authority=50)


async def test_refused_settings_of_a_sensor_are_reported(virtual_network):
    video = FakeVideo(CameraSetup("arm", "link", 1.0))
    services = [VisualSensor({1: VideoCamera(Transform, source=video)}), AccessControl(timeout=5)]
    kind = SetVisualSensorConfiguration

    def settings(**values):
        record = kind.VisualSensorConfigurationRec(1, exposure_mode=kind.ExposureMode.MANUAL, **values)
        return kind(kind.RequestIdRec(1), [record])

    async with virtual_network.component(COMPONENT, services):
        await send(virtual_network, settings(shutter_speed=0.02))
        with pytest.raises(RequestError, match=r"126\.1\.11 refused the settings: exposure times are 0\.001"):
            await send(virtual_network, settings(shutter_speed=4.0))
    assert video.imaging.shutter == pytest.approx(0.02, abs=0.001)
