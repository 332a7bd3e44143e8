"""CM-VIS: a camera, with its pan-tilt unit if it has one."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar, Final

from jauspy.geometry.denavit_hartenberg import pan_tilt_frame
from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import Transform
from jauspy.geometry.urdf import Joint
from jauspy.platform.contract import RobotParts
from jauspy.platform.lights import Lamp, lamps_of
from jauspy.platform.motors import Motors
from jauspy.services import iop, manipulator
from jauspy.services.environment_sensing import (
    DigitalResourceDiscovery,
    DigitalVideo,
    DigitalVideoCapabilities,
    H264VideoEncoding,
    StillImage,
    StillImageData,
    VideoCamera,
    VideoSource,
    VideoStreams,
    VisualSensor,
)
from jauspy.services.service import Service

from .joints import MOTOR_DATA, joint_description
from .kind import Kind, Module, ModuleBuild, ServiceEntry, Stoppable
from .mounting import frame_of, joint_of, mount_of

_PAN_TILT: Final = "the group of joints that pan and tilt the camera"


@dataclass(frozen=True, slots=True)
class VisionContext:
    """Parts from which the services of a CM-VIS are made."""

    module: ClassVar[str] = "CM-VIS"
    robot: RobotParts
    streams: VideoStreams
    """The streams of its cameras, by sensor id, with their receivers."""
    pan_tilt: manipulator.PanTilt | None
    """The unit that turns the camera."""
    lamps: tuple[Lamp, ...] = ()
    """The lamps that light what the camera sees."""
    mount: iop.Mount | None = None
    """The joint that carries that unit."""

    @property
    def moving(self) -> Stoppable | None:
        """The pan-tilt unit."""
        return self.pan_tilt


def _camera(make: Callable[[VideoStreams], Service]) -> ServiceEntry[VisionContext]:
    return ServiceEntry(VisionContext, lambda context: make(context.streams))


def _pan_tilt(make: Callable[[manipulator.PanTilt], Service]) -> ServiceEntry[VisionContext]:
    return ServiceEntry(
        VisionContext, lambda context: make(context.pan_tilt) if context.pan_tilt else None, needs=_PAN_TILT
    )


def _described(context: VisionContext) -> Service | None:
    return joint_description(context.robot, context.pan_tilt) if context.pan_tilt else None


def _extended(context: VisionContext) -> Service | None:
    motors = Motors.of(context.robot)
    if context.pan_tilt is None or motors is None:
        return None
    names = [joint.name for joint in context.pan_tilt.joints.joints]
    return iop.ExtendedPrimitivePanTilt(names, motors.state, context.mount)


SERVICES: Final[Mapping[str, ServiceEntry[Any]]] = {
    "VisualSensor": _camera(lambda streams: VisualSensor(streams.cameras)),
    "DigitalVideo": _camera(DigitalVideo),
    "H264VideoEncoding": _camera(lambda streams: H264VideoEncoding(streams.cameras)),
    "StillImage": _camera(lambda streams: StillImage(streams.cameras)),
    "DigitalResourceDiscovery": _camera(DigitalResourceDiscovery),
    "AEODRSDigitalVideo": _camera(iop.AEODRSDigitalVideo),
    "IOPH264VideoEncoding": _camera(lambda streams: iop.H264VideoEncoding(streams.cameras)),
    "AEODRSVideoIlluminator": ServiceEntry(
        VisionContext,
        lambda context: iop.VideoIlluminator(context.lamps, context.streams.cameras) if context.lamps else None,
        needs="lamps ([[lights]]) for its camera",
    ),
    "PrimitivePanTilt": _pan_tilt(manipulator.PrimitivePanTilt),
    "ExtendedPrimitivePanTilt": ServiceEntry(VisionContext, _extended, needs=f"{_PAN_TILT}, and {MOTOR_DATA}"),
    "PanTiltJointPositionSensor": _pan_tilt(manipulator.PanTiltJointPositionSensor),
    "PanTiltJointPositionDriver": _pan_tilt(manipulator.PanTiltJointPositionDriver),
    "PanTiltJointVelocitySensor": _pan_tilt(manipulator.PanTiltJointVelocitySensor),
    "PanTiltJointVelocityDriver": _pan_tilt(manipulator.PanTiltJointVelocityDriver),
    "PanTiltMotionProfileService": _pan_tilt(manipulator.PanTiltMotionProfile),
    "PanTiltSpecificationService": _pan_tilt(manipulator.PanTiltSpecification),
    "JointDescription": ServiceEntry(VisionContext, _described, needs=_PAN_TILT),
}


class Vision(Kind[VisionContext]):
    """The kind CM-VIS."""

    type: ClassVar[str] = "CM-VIS"
    services: ClassVar[Mapping[str, ServiceEntry[Any]]] = SERVICES
    own_keys: ClassVar[frozenset[str]] = frozenset({"group", "camera"})

    def context(self, build: ModuleBuild) -> VisionContext:
        """The camera, and the unit that carries it."""
        pan_tilt = _pan_tilt_of(build)
        camera = _mounted(build, build.videos[build.module.camera or ""])
        streams = VideoStreams({1: camera}, build.video_targets)
        return VisionContext(build.robot, streams, pan_tilt, _lamps_for(build), mount_of(build))

    def check(self, module: Module, needs: Mapping[str, Sequence[str]]) -> None:
        """Check that there are joints for the services that need them, and that a camera is named."""
        super().check(module, needs)
        if _PAN_TILT in needs and module.group is None:
            raise ValueError(f"group: is missing; {needs[_PAN_TILT][0]} needs {_PAN_TILT}")
        if module.camera is None:
            raise ValueError("camera: is missing; a CM-VIS needs the name of one of [[cameras]]")

    def joint_frame(self, chain: Sequence[Joint], number: int) -> Transform:
        """The frame of the pan-tilt unit."""
        return pan_tilt_frame(chain)

    def older_versions(self, context: VisionContext, services: Sequence[Service]) -> Iterator[Service]:
        """The capabilities of the video, and the still images."""
        for service in services:
            if isinstance(service, DigitalVideo):
                yield DigitalVideoCapabilities(context.streams.cameras)
            elif isinstance(service, StillImage):
                yield StillImageData(service)


def _mounted(build: ModuleBuild, source: VideoSource) -> VideoCamera:
    """A camera; one outside of the robot is mounted nowhere on it."""
    if source.setup.outside is not None:
        return VideoCamera(Transform, is_fixed=False, source=source)
    tree, link = FrameTree(build.model.description), source.setup.link
    mount = joint_of(build.modules, build.model, link)
    return VideoCamera(frame_of(tree, link, build.robot.groups), tree.is_fixed(link), mount, source=source)


def _lamps_for(build: ModuleBuild) -> tuple[Lamp, ...]:
    """The lamps on the camera's link; without any, those on no camera's link. A camera that is not mounted has none."""
    links = {camera.name: camera.link for camera in build.model.cameras if camera.outside is None}
    own = links.get(build.module.camera or "")
    if own is None:
        return ()
    lamps = lamps_of(build.robot)
    return tuple(lamp for lamp in lamps if lamp.setup.link == own) or tuple(
        lamp for lamp in lamps if lamp.setup.link not in links.values()
    )


def _pan_tilt_of(build: ModuleBuild) -> manipulator.PanTilt | None:
    """The unit that carries the module's camera; None if the camera has none of its own."""
    if build.module.group is None:
        return None
    base = build.model.groups[build.module.group].base
    return manipulator.PanTilt(build.joints, frame_of(FrameTree(build.model.description), base, build.robot.groups))
