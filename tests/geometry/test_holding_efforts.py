"""The efforts of joints that carry links."""

from __future__ import annotations

import math

import pytest

from jauspy.geometry.frames import HoldingEfforts
from jauspy.geometry.urdf import parse_urdf

MAST_WITH_BOOM = """
<robot name="crane">
  <link name="ground"/>
  <link name="mast"><inertial><origin xyz="0 0 1"/><mass value="4"/><inertia ixx="1"/></inertial></link>
  <link name="boom"><inertial><origin xyz="0.5 0 0"/><mass value="2"/><inertia ixx="1"/></inertial></link>
  <link name="hook"><inertial><mass value="3"/><inertia ixx="1"/></inertial></link>
  <joint name="lift" type="prismatic"><parent link="ground"/><child link="mast"/><axis xyz="0 0 1"/>
    <limit lower="0" upper="1" effort="100" velocity="1"/></joint>
  <joint name="swing" type="revolute"><parent link="mast"/><child link="boom"/><axis xyz="0 -1 0"/>
    <origin xyz="0 0 2"/><limit lower="-2" upper="2" effort="100" velocity="1"/></joint>
  <joint name="carry" type="fixed"><parent link="boom"/><child link="hook"/><origin xyz="1 0 0"/></joint>
</robot>
"""


@pytest.mark.parametrize("swing", [0.0, 0.7, math.pi / 2, -1.0])
def test_of_a_crane(swing: float) -> None:
    efforts = HoldingEfforts(parse_urdf(MAST_WITH_BOOM)).at({"lift": 0.3, "swing": swing})
    assert efforts == {
        "lift": pytest.approx(9.0 * 9.81),
        "swing": pytest.approx((2.0 * 0.5 + 3.0 * 1.0) * 9.81 * math.cos(swing), abs=1e-9),
    }


def test_a_joint_carries_those_that_mimic_it() -> None:
    mimic = MAST_WITH_BOOM.replace('upper="2" effort="100" velocity="1"/>', 'upper="2" effort="100" velocity="1"/>'
                                   '<mimic joint="lift" multiplier="0.5"/>')  # fmt: skip
    efforts = HoldingEfforts(parse_urdf(mimic)).at({"lift": 0.0})
    assert efforts == {"lift": pytest.approx(9.0 * 9.81 + 0.5 * 4.0 * 9.81)}
