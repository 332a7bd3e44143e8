"""WGS-84 against figures of other people, and the frame that lies on it against itself."""

from __future__ import annotations

import math

import pytest

from jauspy.geometry.geodesy import Geodetic, from_ecef, from_ned, to_ecef, to_ned
from jauspy.geometry.poses import Pose
from jauspy.services.mobility.reference_frames import GlobalFrame, GlobalPose

# Made with PROJ 9.5 (EPSG:4979 to EPSG:4978): latitude, longitude (degrees), height; x, y, z (m).
PROJ = [
    (0.0, 0.0, 0.0, (6378137.0, 0.0, 0.0)),
    (90.0, 0.0, 0.0, (0.0, 0.0, 6356752.314245179)),
    (38.593, -77.179, 20.0, (1107676.953551297, -4867200.372480316, 3957116.0129757696)),
    (-33.9, 151.2, 1000.0, (-4644673.372727284, 2553430.794572711, -3537803.093014235)),
]


def place(latitude: float, longitude: float, height: float = 0.0) -> Geodetic:
    return Geodetic(math.radians(latitude), math.radians(longitude), height)


@pytest.mark.parametrize(("latitude", "longitude", "height", "expected"), PROJ)
def test_earth_centred_coordinates(latitude, longitude, height, expected) -> None:
    assert to_ecef(place(latitude, longitude, height)) == pytest.approx(expected, abs=1e-6)


@pytest.mark.parametrize("latitude", [-90.0, -89.999, -45.0, 0.0, 1e-9, 38.6, 89.999, 90.0])
@pytest.mark.parametrize("longitude", [-180.0, -77.2, 0.0, 179.999])
@pytest.mark.parametrize("height", [-500.0, 0.0, 9000.0])
def test_ecef_and_back(latitude, longitude, height) -> None:
    point = to_ecef(place(latitude, longitude, height))
    assert to_ecef(from_ecef(point)) == pytest.approx(point, abs=1e-6)
    assert from_ecef(point).height == pytest.approx(height, abs=1e-6)


@pytest.mark.parametrize("origin", [place(38.6, -77.2, 20.0), place(-80.0, 179.9999), place(0.0, 0.0, -400.0)])
def test_offsets_are_north_east_and_down(origin) -> None:
    assert to_ned(origin, from_ned(origin, 120.0, -340.0, 5.0)) == pytest.approx((120.0, -340.0, 5.0), abs=1e-6)
    north = Geodetic(origin.latitude + 1e-5, origin.longitude, origin.height)
    assert to_ned(origin, north)[0] == pytest.approx(63.7, abs=0.5)
    assert to_ned(origin, north)[1] == pytest.approx(0.0, abs=1e-6)
    higher = Geodetic(origin.latitude, origin.longitude, origin.height + 7.0)
    assert to_ned(origin, higher) == pytest.approx((0.0, 0.0, -7.0), abs=1e-6)


def test_a_nautical_mile_is_a_minute_of_latitude() -> None:
    assert to_ned(place(45.0, 9.0), place(45.0 + 1 / 60, 9.0))[0] == pytest.approx(1852.2, abs=0.5)


@pytest.mark.parametrize("heading", [0.0, 0.7, -2.5, math.pi])
def test_points_convert_to_the_world_and_back(heading) -> None:
    frame = GlobalFrame(GlobalPose(38.6, -77.2, 20.0, heading))
    for x, y in ((0.0, 0.0), (100.0, 0.0), (-30.0, 400.0), (1000.0, 1000.0)):
        shown = frame.from_world(Pose(x=x, y=y))
        back = frame.to_world(shown.latitude, shown.longitude)
        assert (back.x, back.y) == pytest.approx((x, y), abs=2e-4)


def test_x_points_along_the_origin_s_heading() -> None:
    east = GlobalFrame(GlobalPose(38.6, -77.2, 20.0, math.pi / 2)).from_world(Pose(x=50.0))
    assert east.longitude > -77.2 + 5e-4
    assert east.latitude == pytest.approx(38.6, abs=1e-7)
    assert east.heading == pytest.approx(math.pi / 2, abs=1e-4)


def test_reported_headings_allow_for_the_convergence_of_meridians() -> None:
    frame = GlobalFrame(GlobalPose(60.0, 25.0, 0.0, 0.0))
    shown = frame.from_world(Pose(y=10_000.0))
    assert shown.heading == pytest.approx(math.radians(shown.longitude - 25.0) * math.sin(math.radians(60.0)))
    assert math.degrees(shown.heading) == pytest.approx(0.155, abs=0.005)


def test_setting_moves_the_anchor() -> None:
    frame = GlobalFrame(GlobalPose(38.6, -77.2, 20.0, 0.0))
    here = Pose(x=5.0, y=6.0, z=-1.0, yaw=0.5)
    frame.set(here, GlobalPose(10.0, 20.0, 30.0, 1.5))
    shown = frame.from_world(here)
    assert (shown.latitude, shown.longitude, shown.altitude, shown.heading) == pytest.approx((10.0, 20.0, 30.0, 1.5))
    assert frame.heading_to_world(1.5) == pytest.approx(0.5)
    ahead = frame.from_world(Pose(x=5.0 + math.cos(0.5), y=6.0 + math.sin(0.5), z=-1.0))
    assert ahead.longitude > shown.longitude + 8e-6, "the robot looks almost east"
