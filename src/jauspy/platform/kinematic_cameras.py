"""Keeps the cameras of the kinematic robot where its links are."""

from __future__ import annotations

import struct
from collections.abc import Mapping
from itertools import chain

from jauspy.platform.contract import DriveBase
from jauspy.platform.description import Description, Joint, RobotModel
from jauspy.platform.frames3d import frame_at, frame_of
from jauspy.platform.joints import JointGroup
from jauspy.platform.kinematic_camera import NUMBERS, FloorCamera
from jauspy.platform.shared_state import StateWriter


class KinematicCameras:
    """One memory for each camera, with the camera's frame in the world."""

    def __init__(self, robot: RobotModel, drive: DriveBase, groups: Mapping[str, JointGroup]) -> None:
        self._drive, self._groups = drive, groups
        self._chains = [_chain(robot.description, camera.link) for camera in robot.cameras]
        self._states = [StateWriter(NUMBERS) for _ in robot.cameras]
        self.cameras: Mapping[str, FloorCamera] = {
            setup.name: FloorCamera(setup, state.descriptor)
            for setup, state in zip(robot.cameras, self._states, strict=True)
        }
        self.show()

    def show(self) -> None:
        """The robot has moved."""
        if not self._states:
            return
        positions = self._positions()
        base = frame_of(self._drive.pose())
        for joints, state in zip(self._chains, self._states, strict=True):
            frame = base
            for joint in joints:
                frame = frame.then(frame_at(joint, positions.get(joint.mimics or joint.name, 0.0)))
            state.write(struct.pack(f"={NUMBERS}d", *chain(*frame.rotation), *frame.origin))

    def close(self) -> None:
        """Give the memory back; twice is fine."""
        for state in self._states:
            state.close()
        self._states, self._chains = [], []

    def _positions(self) -> dict[str, float]:
        return {
            joint.name: position
            for group in self._groups.values()
            for joint, position in zip(group.joints, group.state().positions, strict=True)
        }


def _chain(description: Description, link: str) -> tuple[Joint, ...]:
    return description.chain(description.root(), link)
