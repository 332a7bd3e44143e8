"""Keeps the cameras of the kinematic robot where its links are."""

from __future__ import annotations

import struct
from collections.abc import Mapping
from itertools import chain

from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import Transform
from jauspy.platform.contract import DriveBase
from jauspy.platform.description import RobotModel
from jauspy.platform.joints import JointGroup, joint_positions
from jauspy.platform.kinematic_camera import NUMBERS, FloorCamera
from jauspy.platform.shared_state import StateWriter


class KinematicCameras:
    """One memory for each link that carries cameras, with its frame in the world."""

    def __init__(self, robot: RobotModel, drive: DriveBase, groups: Mapping[str, JointGroup]) -> None:
        self._drive, self._groups = drive, groups
        self._tree = FrameTree(robot.description)
        self._states = {camera.link: StateWriter(NUMBERS) for camera in robot.cameras}
        self._positions: Mapping[str, float] = {}
        self._frames: Mapping[str, Transform] = {}
        """The links' frames in the root link's, at these positions: joints mostly rest."""
        self.cameras: Mapping[str, FloorCamera] = {
            setup.name: FloorCamera(setup, self._states[setup.link].descriptor) for setup in robot.cameras
        }
        self.show()

    def show(self) -> None:
        """The robot has moved."""
        if not self._states:
            return
        positions = joint_positions(self._groups.values())
        if positions != self._positions or not self._frames:
            self._positions = positions
            self._frames = {link: self._tree.pose(link, positions) for link in self._states}
        base = Transform.from_pose(self._drive.pose())
        for link, state in self._states.items():
            frame = base @ self._frames[link]
            state.write(struct.pack(f"={NUMBERS}d", *chain(*frame.rotation), *frame.position))

    def close(self) -> None:
        """Give the memory back; twice is fine."""
        for state in self._states.values():
            state.close()
        self._states = {}
