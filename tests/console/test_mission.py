"""Missions: their file, no-go areas, the way on the globe, and files that were made to do harm."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("pydantic", reason="needs the extra 'console'")

from jauspy.console.geographic_frame import GeographicFrame, frame_of
from jauspy.console.mission import Area, Look, Mission, Step, Still, Wait, crossing
from jauspy.console.route import Waypoint
from jauspy.console.saved_files import SavedFiles
from jauspy.console.users import User
from jauspy.errors import ConfigError
from jauspy.geometry.geodesy import Geodetic
from jauspy.messages.mobility import ReportGlobalPose, ReportLocalPose

SQUARE = Area(((1.0, -1.0), (2.0, -1.0), (2.0, 1.0), (1.0, 1.0)), "pond")
ROUND = Mission(
    (Waypoint(1.0, 2.0), Waypoint(-3.0, 0.5), Waypoint(0.0, 0.0)),
    (Step(0.4, Wait(seconds=5.0)), Step(None, Look(pan=0.5, tilt=-0.2)), Step(1.0, Still(camera="front"))),
    (SQUARE,),
)
FRAME = GeographicFrame(Geodetic(math.radians(48.0), math.radians(11.0)), math.radians(30.0))


def test_a_mission_survives_its_file() -> None:
    assert Mission.from_json(ROUND.to_json("inc1")) == ROUND
    on_globe = Mission.from_json(ROUND.to_json("inc1", frame=FRAME), frame=FRAME)
    for before, after in zip(ROUND.waypoints, on_globe.waypoints, strict=True):
        assert (after.x, after.y) == pytest.approx((before.x, before.y), abs=0.003)
    assert on_globe.steps == ROUND.steps
    with pytest.raises(ConfigError, match="does not report where it is on the globe"):
        Mission.from_json(ROUND.to_json("inc1", frame=FRAME))


def test_the_frame_of_a_robot_that_has_turned_and_moved() -> None:
    x, y, yaw = 3.0, -4.0, 1.2
    latitude, longitude = FRAME.to_globe(x, y)
    local = ReportLocalPose(x=x, y=-y, yaw=-yaw)
    globe = ReportGlobalPose(latitude=latitude, longitude=longitude, yaw=math.remainder(FRAME.heading - yaw, math.tau))
    found = frame_of(local, globe)
    assert found is not None
    assert found.heading == pytest.approx(FRAME.heading)
    assert found.to_local(*FRAME.to_globe(10.0, 20.0)) == pytest.approx((10.0, 20.0), abs=1e-3)
    north = FRAME.to_globe(math.cos(FRAME.heading), math.sin(FRAME.heading))
    assert north[1] == pytest.approx(11.0, abs=1e-9), "x cos h + y sin h leads to the north"
    assert frame_of(local, ReportGlobalPose(latitude=48.0)) is None


def test_legs_and_waypoints_in_no_go_areas() -> None:
    assert crossing([(0, 0), (0, 3), (3, 3), (3, 0)], [SQUARE]) == ""
    assert crossing([(0, 0), (1.5, 0)], [SQUARE]) == "waypoint 1 is in the no-go area pond"
    assert crossing([(0, 0), (0, 2), (3, -2)], [SQUARE]) == "the way to waypoint 2 leads through the no-go area pond"
    assert crossing([(0, 1), (3, 1)], [Area(SQUARE.corners)]) != "", "along an edge"
    assert crossing([(1.5, 0.0), (5.0, 0.0)], [SQUARE]) != "", "out of it"


def broken(**changes: Any) -> dict[str, Any]:
    return {**json.loads(ROUND.to_json("inc1")), **changes}


HOSTILE = [
    ({"format": "other"}, "format"),
    ({"version": 2}, "version"),
    ({"frame": "moon"}, "frame"),
    ({"extra": 1}, "extra"),
    ({"waypoints": [{"x": 1.0}]}, "waypoints.0: needs x and y"),
    ({"waypoints": [{"x": 1.0, "y": 2.0, "latitude": 1.0, "longitude": 1.0}]}, "waypoints.0: needs x and y"),
    ({"waypoints": [{"x": "1", "y": 2.0}]}, "waypoints.0.x"),
    ({"waypoints": [{"x": True, "y": 2.0}]}, "waypoints.0.x"),
    ({"waypoints": [{"x": 1e300, "y": 2.0}]}, "waypoints.0.x"),
    ({"waypoints": [{"x": 0.0, "y": 0.0, "speed": -1.0}]}, "waypoints.0.speed"),
    ({"waypoints": [{"x": 0.0, "y": 0.0, "speed": 1e9}]}, "waypoints.0.speed"),
    ({"waypoints": [{"x": 0.0, "y": 0.0, "speed": 1e-9}]}, "waypoints.0.speed"),
    ({"waypoints": [{"x": 0.0, "y": 0.0, "action": {"kind": "fire"}}]}, "waypoints.0.action"),
    ({"waypoints": [{"x": 0.0, "y": 0.0, "action": {"kind": "wait", "seconds": 1e9}}]}, "waypoints.0.action"),
    ({"waypoints": [{"x": 0.0, "y": 0.0, "action": {"kind": "still", "camera": "x" * 65}}]}, "waypoints.0.action"),
    ({"waypoints": [{"x": 0.0, "y": 0.0}] * 101}, "waypoints"),
    ({"no_go": [{"corners": [{"x": 0.0, "y": 0.0}] * 2}]}, "no_go.0.corners"),
    ({"no_go": [{"corners": [{"x": 0.0, "y": 0.0}] * 3}] * 51}, "no_go"),
    ({"no_go": [{"corners": [{"x": 0.0, "y": 0.0}, {"x": 1.0, "y": 0.0}, {"latitude": 1.0}]}]}, "no_go.0.corners.2"),
]


def test_every_mistake_is_one_sentence_with_its_place() -> None:
    for changes, said in HOSTILE:
        with pytest.raises(ConfigError, match=f"m.json: {said}"):
            Mission.from_json(json.dumps(broken(**changes)), "m.json")
    for text in ("", "[]", "{", "null", '{"a": NaN}', "[" * 100_000, "x" * (1 << 21), b"\xff\xfe\x00"):
        with pytest.raises(ConfigError, match=r"m.json: ") as found:
            Mission.from_json(text, "m.json")
        assert "\n" not in str(found.value)
        assert len(str(found.value)) < 400
    for text in (broken(waypoints=[{"x": float("inf"), "y": 0.0}]), broken(waypoints=[{"x": float("nan"), "y": 0.0}])):
        with pytest.raises(ConfigError, match=r"m.json: "):
            Mission.from_json(json.dumps(text), "m.json")


def test_far_places_on_the_globe_are_refused() -> None:
    text = json.dumps(broken(frame="global", no_go=[], waypoints=[{"latitude": -48.0, "longitude": -169.0}]))
    with pytest.raises(ConfigError, match="km from the robot's origin"):
        Mission.from_json(text, frame=FRAME)


def test_missions_are_saved_beside_trajectories_with_their_author(tmp_path: Path) -> None:
    files = SavedFiles(101, "inc1", User("anna", "operator", 127), lambda _: None, tmp_path)
    files.save_mission("round", ROUND, "inc1")
    assert files.missions() == ["round"]
    assert files.trajectories() == []
    found = files.mission("round")
    assert (found.waypoints, found.author.by) == (ROUND.waypoints, "anna")
    for name in ("../round", "/etc/passwd", "..", "a/b", ""):
        with pytest.raises(ConfigError, match="a name is 1 to"):
            files.save_mission(name, ROUND, "inc1")
    files.delete_mission("round")
    assert files.missions() == []
