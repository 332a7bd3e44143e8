"""`jauspy send --control` with components that list less than they have, as those of other vendors do."""

from __future__ import annotations

import asyncio

import pytest
from tests.helpers.robot import FakeDrive
from tests.robot.cameras import FakeVideo

from jauspy.backends.kinematic import KinematicDrive
from jauspy.cli.send import send_in_control, send_without_control
from jauspy.component.component import loop_time
from jauspy.errors import ControlRejected, JausError, RequestError
from jauspy.geometry.poses import Transform
from jauspy.ids import JausID
from jauspy.messages.core import (
    QueryIdentification,
    QueryServices,
    ReleaseControl,
    RequestControl,
    Reset,
    Resume,
    SetTime,
)
from jauspy.messages.environment_sensing import SetVisualSensorConfiguration
from jauspy.messages.mobility import SetWrenchEffort
from jauspy.platform.camera import CameraSetup
from jauspy.services.core import AccessControl, Discovery, Management, Time
from jauspy.services.core.discovery import COMPONENT as COMPONENT_LEVEL, Identity
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


async def send_freely(network: VirtualNetwork, message, to=COMPONENT):
    await send_without_control(network.ocu(), to, message, max_wait=2.0)


@pytest.mark.slow
@pytest.mark.parametrize("authority", [None, 200], ids=["without control", "with control"])
async def test_reset_ends_failure_with_and_without_control(virtual_network, monkeypatch, capsys, authority):
    driver = JausID(101, 1, 102)

    async def reset():
        if authority is None:
            await send_freely(virtual_network, Reset(), driver)
        else:
            ocu = virtual_network.ocu()
            await send_in_control(ocu, driver, Reset(), authority=authority, hold=0.0, within=None, max_wait=2.0)

    def no_bus(self: KinematicDrive, linear_x: float, rotational_z: float, linear_y: float = 0.0) -> None:
        raise OSError("no such bus")

    async with virtual_network.robot() as runner:
        with monkeypatch.context() as broken:
            broken.setattr(KinematicDrive, "set_effort", no_bus)
            with pytest.raises(RequestError):
                await send_in_control(
                    virtual_network.ocu(), driver, DRIVE, authority=200, hold=2.0, within=None, max_wait=2.0
                )
            assert runner.faults
            with pytest.raises(JausError, match="in Failure: send Reset, which needs no control in this state"):
                await send_freely(virtual_network, DRIVE, driver)
            with pytest.raises(ControlRejected, match=r"FAILURE.*; send Reset, which needs no control in this state"):
                await send_in_control(
                    virtual_network.ocu(), driver, DRIVE, authority=200, hold=0.0, within=None, max_wait=2.0
                )
        await reset()
        assert not runner.faults
        assert "101.1.102 has left Failure" in capsys.readouterr().err


async def test_reset_of_a_component_that_stays_in_failure_says_so(virtual_network):
    async with virtual_network.component(COMPONENT, [Management(), AccessControl(timeout=5)], core=False) as component:
        component.host.fire("Failure")
        await asyncio.sleep(0.1)
        with pytest.raises(RequestError, match=r"Reset was sent, but 126\.1\.11 is still in Failure"):
            await send_freely(virtual_network, Reset())


async def test_component_that_answers_discovery_only_exists(virtual_network, monkeypatch):
    answered = {QueryIdentification.CODE, QueryServices.CODE}
    drive = PrimitiveDriver(Vehicle(FakeDrive(clock=loop_time)))
    made = [drive, AccessControl(timeout=5), Discovery({COMPONENT_LEVEL: Identity("base", 60001)})]
    async with virtual_network.component(COMPONENT, made, core=False) as component:
        handle = component.host.receive

        def receive(payload: bytes, source: JausID, now: float) -> None:
            if int.from_bytes(payload[:2], "little") in answered:
                handle(payload, source, now)

        monkeypatch.setattr(component.host, "receive", receive)
        await send_freely(virtual_network, DRIVE)
    with pytest.raises(RequestError, match="may not exist"):
        await send_freely(virtual_network, DRIVE)
