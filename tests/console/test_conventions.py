"""Axes and units of a page: one convention everywhere, of REP-103 unless JAUS's is chosen."""

from __future__ import annotations

import math

import pytest

from jauspy.console.conventions import AXES, CHOICES, Conventions
from jauspy.console.mission import Look, Step

YAW = math.radians(20.0)


def chosen(**wanted: str) -> Conventions:
    conventions = Conventions()
    conventions.set(wanted)
    return conventions


def test_a_robot_that_stands_to_the_left_and_has_turned_left() -> None:
    rep, jaus = chosen(), chosen(axes="JAUS")
    assert (rep.position(1.0, 0.34), rep.yaw(YAW)) == ("x 1.00 m, y 0.34 m", "yaw 20\u00b0")
    assert (jaus.position(1.0, 0.34), jaus.yaw(YAW)) == ("x 1.00 m, y -0.34 m", "heading 340\u00b0")
    assert rep.attitude(0.1, -0.2) == "pitch 6\u00b0, roll -11\u00b0"
    assert jaus.attitude(0.1, -0.2) == "pitch -6\u00b0, roll -11\u00b0"
    assert rep.position(-0.001, -0.001) == "x 0.00 m, y 0.00 m"


def test_plots_show_the_same_as_the_panel_drive() -> None:
    reported = {"y": -0.34, "yaw": -YAW}  # as on the wire
    for conventions, sign in ((chosen(), 1.0), (chosen(axes="JAUS"), -1.0)):
        factor, unit = conventions.plotted("LocalPose", "y", "m")
        assert (factor * reported["y"], unit) == (pytest.approx(sign * 0.34), "m")
        factor, unit = conventions.plotted("LocalPose", "yaw", "rad")
        assert (factor * reported["yaw"], unit) == (pytest.approx(sign * 20.0), "\u00b0")
    assert chosen().plotted("GlobalPose", "yaw", "rad")[0] > 0.0, "clockwise from true north, in both"
    assert chosen().plotted("LocalPose", "x", "m") == (1.0, "m")


def test_feet_and_radians() -> None:
    found = chosen(length="ft", angle="rad")
    assert found.position(0.3048, 3.048) == "x 1.00 ft, y 10.00 ft"
    assert found.speed(0.3048) == "1.0 ft/s"
    assert found.yaw(YAW) == "yaw 0.35 rad"
    assert found.plotted("VelocityState", "velocity_x", "m/s") == (pytest.approx(1.0 / 0.3048), "ft/s")


def test_texts_of_waypoints_ranges_and_steps_follow_the_choice() -> None:
    rep, feet = chosen(), chosen(length="ft", axes="JAUS")
    assert (rep.place(1.0, -0.001), rep.distance(2.5, 1), rep.exact_speed(0.4)) == ("1.00, 0.00 m", "2.5 m", "0.4 m/s")
    assert (feet.place(0.3048, 0.3048), feet.distance(0.3048)) == ("1.00, -1.00 ft", "1.00 ft")
    step = Step(0.3048, Look(pan=math.radians(90.0), tilt=0.0))
    assert step.shown(rep) == "0.3 m/s, look 90\u00b0, 0\u00b0"
    assert step.shown(chosen(length="ft", angle="rad")) == "1 ft/s, look 1.57 rad, 0.00 rad"


@pytest.mark.parametrize("yaw", [0.0, 0.001, -0.001, math.tau - 0.001])
def test_a_heading_is_less_than_a_full_turn(yaw: float) -> None:
    assert chosen(axes="JAUS").yaw(yaw) == "heading 0\u00b0"
    assert chosen(axes="JAUS", angle="rad").yaw(yaw) == "heading 0.00 rad"


def test_only_choices_that_exist_are_taken() -> None:
    changes: list[int] = []
    conventions = Conventions()
    conventions.on_change.append(lambda: changes.append(1))
    for asked in (None, 1, "JAUS", [], {"axes": "<b>"}, {"axes": ["JAUS"]}, {"colour": "red"}, {"axes": "REP-103"}):
        conventions.set(asked)
    assert changes == []
    assert conventions.chosen == {name: choices[0] for name, choices in CHOICES.items()}
    conventions.set({"axes": "JAUS", "length": "ft"})
    assert changes == [1]
    assert conventions.axes_text == AXES["JAUS"]
