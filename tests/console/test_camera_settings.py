"""Settings of cameras and lights: what the robot offers is shown, and set."""

from __future__ import annotations

import asyncio

import pytest

from jauspy.console.camera_settings import LIGHTS, Setting, read_settings, sensor_name, write_setting
from jauspy.console.video import Attitude, AttitudeFeed
from jauspy.errors import RequestError
from jauspy.ocu.robot import ComponentClient, Robot
from jauspy.testing import VirtualNetwork


def named(settings: list[Setting]) -> dict[str, Setting]:
    return {each.label: each for each in settings}


def component_with(robot: Robot, service: str, name: str = "") -> ComponentClient:
    return robot.component(str(next(each.id for each in robot.components if each.find(service))))


@pytest.mark.slow
async def test_what_a_camera_offers_is_read_and_set(virtual_network: VirtualNetwork) -> None:
    async with virtual_network.robot(), virtual_network.ocu() as ocu:
        chassis = (await ocu.discover(101)).component(107)
        assert await sensor_name(chassis) == "chassis"
        settings, problems = await read_settings(chassis)
        assert problems == []
        found = named(settings)
        size, rate = found["size"], found["pictures"]
        assert size.choices is not None
        assert size.choices[size.value or 0] == "640 x 480"
        assert (rate.value, rate.low, rate.high) == (15, 1, 60)
        assert found["quality"].choices == {0: "low latency", 1: "slow connection", 5: "best quality"}
        assert found["exposure"].choices is not None
        assert "aperture priority" not in found["exposure"].choices.values(), "its aperture is fixed"
        assert "exposure time" not in found, "the camera chooses it"

        number = {name: number for number, name in found["exposure"].choices.items()}
        half = {name: number for number, name in size.choices.items()}["320 x 240"]
        for label, value in (
            ("size", half),
            ("pictures", 5),
            ("bit rate", 500),
            ("quality", 1),
            ("zoom", 50),
            ("exposure", number["manual"]),
        ):
            await write_setting(chassis, found[label], value)
        assert not chassis.is_controlled, "control is taken for a setting only"
        now = named((await read_settings(chassis))[0])
        assert now["size"].value == half
        assert [now[label].value for label in ("pictures", "bit rate", "quality")] == [5, 500, 1]
        assert now["zoom"].value == pytest.approx(50.0, abs=0.1)
        assert now["exposure time"].low == pytest.approx(0.001, abs=1e-3)
        with pytest.raises(RequestError, match="refuses that: frame rates are"):
            await write_setting(chassis, found["pictures"], 200)


@pytest.mark.slow
async def test_lights_that_the_robot_has_are_switched(virtual_network: VirtualNetwork) -> None:
    async with virtual_network.robot(), virtual_network.ocu() as ocu:
        lights = component_with(await ocu.discover(101), LIGHTS)
        found = named((await read_settings(lights))[0])
        assert {label: each.value for label, each in found.items()} == {"headlights": 0, "visible light source": 0}
        await write_setting(lights, found["headlights"], 1)
        now = named((await read_settings(lights))[0])
        assert (now["headlights"].value, now["visible light source"].value) == (1, 0)
        with pytest.raises(RequestError, match="did not switch fog lights"):
            await write_setting(lights, Setting(LIGHTS, "fog_lights", "fog lights", 0), 1)


@pytest.mark.slow
async def test_the_attitude_is_followed_while_somebody_looks(virtual_network: VirtualNetwork) -> None:
    async with virtual_network.robot(), virtual_network.ocu() as ocu:
        robot = await ocu.discover(101)
        feed, seen = AttitudeFeed(ocu, robot), list[Attitude]()
        feed.add(seen.append)
        assert seen == [Attitude()]
        await asyncio.sleep(3.0)
        assert seen[-1] == Attitude(0.0, 0.0, 0.0, 0.0)
        async with robot.control("drive"):
            await robot.drive(0.4, 0.5)
            await asyncio.sleep(2.0)
            assert 0.2 < (seen[-1].speed or 0.0) < 0.6
            assert 270.0 < (seen[-1].heading or 0.0) < 359.0, "to the left, and JAUS counts to the right"
            feed.remove(seen.append)
            count = len(seen)
            await asyncio.sleep(1.0)
            assert len(seen) == count
