"""Grasps of computed things: room for palm and fingers, and faces between them."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

pytest.importorskip("scipy", reason="scipy is not installed")

from tests.helpers.robot import described
from tests.planning.test_objects import seen_box

from jauspy.planning.grasp_candidates import SUPPORT_ROOM, Candidate, Gripper, candidates, gripper_of
from jauspy.planning.objects import Plane, SeenObject

FOOT = (0.12, 0.0)
OPENING = 0.1


@pytest.fixture(scope="module")
def gripper() -> Gripper:
    model = described("inc1")[1]
    return gripper_of(model, model.groups["gripper"], "tool_link", OPENING)


def box(size: tuple[float, float, float], yaw: float = 0.4) -> SeenObject:
    centre = np.array((0.9, 0.1, size[2] / 2.0))
    points = seen_box(np.random.default_rng(0), centre, np.array(size), yaw)[::6]
    x, y, z = map(float, centre)
    return SeenObject(points, (x, y, z), yaw, size, Plane((0.0, 0.0), 0.0), True, "")


def corners(size: tuple[float, float, float], yaw: float, candidate: Candidate) -> Any:
    """The corners of the true box, in the frame of the tool."""
    signs = np.array([(a, b, c) for a in (-0.5, 0.5) for b in (-0.5, 0.5) for c in (-0.5, 0.5)]) * size
    c, s = math.cos(yaw), math.sin(yaw)
    points = signs @ np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]]) + (0.9, 0.1, size[2] / 2.0)
    return (points - np.array(candidate.pose.position)) @ np.array(candidate.pose.rotation)


def test_the_gripper_has_its_shapes_from_the_description(gripper: Gripper) -> None:
    assert gripper.is_finger.tolist() == [False, True, True]
    assert gripper.tip == pytest.approx(0.025)
    assert gripper.pad == pytest.approx(0.015)
    inner = np.abs(gripper.places[1:, 1]) - gripper.halves[1:, 1]
    assert inner == pytest.approx([OPENING / 2.0, OPENING / 2.0])


@pytest.mark.slow
@pytest.mark.parametrize("size", [(0.08, 0.06, 0.1), (0.22, 0.04, 0.04)])
def test_the_best_grasps_have_two_faces_between_the_fingers(gripper: Gripper, size: tuple[float, float, float]) -> None:
    ranked = candidates(box(size), gripper, FOOT)
    assert [one.cost for one in ranked] == sorted(one.cost for one in ranked)
    for one in ranked[:3]:
        assert one.width == pytest.approx(min(size), abs=0.025)
        low = np.array(one.pose.position) + gripper.corners() @ np.array(one.pose.rotation).T
        assert low[:, 2].min() >= SUPPORT_ROOM - 1e-9
        if max(size) < OPENING:  # all of it is between the open fingers
            assert np.abs(corners(size, 0.4, one)[:, 1]).max() < OPENING / 2.0


@pytest.mark.slow
def test_what_is_wider_than_the_gripper_has_no_grasp(gripper: Gripper) -> None:
    assert candidates(box((0.15, 0.14, 0.13)), gripper, FOOT) == []
    assert candidates(box((0.08, 0.06, 0.1)), replace(gripper, opening=0.06), FOOT) == []


def test_what_is_flat_on_its_surface_has_no_grasp(gripper: Gripper) -> None:
    assert candidates(box((0.08, 0.06, 0.008)), gripper, FOOT) == []
