"""Where lidars, cameras and other sensors are mounted on a robot."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import JAUS_FROM_REP_103, Transform, jaus_frame
from jauspy.geometry.urdf import JointKind
from jauspy.ids import JausID
from jauspy.platform.description import RobotModel
from jauspy.platform.joints import JointGroup, joint_positions
from jauspy.services import iop
from jauspy.services.environment_sensing import JointMount
from jauspy.services.iop import MountSite

from .kind import Module, ModuleBuild


def frame_of(tree: FrameTree, link: str, groups: Mapping[str, JointGroup]) -> Callable[[], Transform]:
    """Returns a link's present frame in the root link's frame (REP-103)."""
    if tree.is_fixed(link):
        fixed = tree.pose(link)
        return lambda: fixed
    return lambda: tree.pose(link, joint_positions(groups.values()))


def joint_of(modules: Mapping[JausID, Module], model: RobotModel, link: str) -> JointMount | None:
    """The last joint before a link, if a CM-MAN or a CM-VIS moves it; None for one that is fixed, or on a finger."""
    description = model.description
    moving = [joint for joint in description.chain(description.root(), link) if joint.kind is not JointKind.FIXED]
    for id, module in modules.items() if moving else ():
        group = model.groups.get(module.moves or "")
        if group is None or moving[-1].name not in group.joints:
            continue
        number = 1 + group.joints.index(moving[-1].name)
        frame = module.kind.joint_frame(description.chain(group.base, group.tip), number)
        if frame is not None:
            return JointMount(id, number, frame.inverse() @ _at_zero(model, group.base, link) @ JAUS_FROM_REP_103)
    return None


def mount_sites(modules: Mapping[JausID, Module], model: RobotModel) -> list[MountSite]:
    """Where the modules of a robot are: their first joint, or the link of their sensor; none for the chassis itself."""
    cameras = {camera.name: camera for camera in model.cameras}
    found: list[MountSite] = []
    for id, module in modules.items():
        links: list[str] = []
        if (group := model.groups.get(module.moves or "")) is not None:
            links = [model.description.chain(group.base, group.tip)[0].child]
        elif module.camera is not None and (camera := cameras.get(module.camera)) is not None:
            links = [camera.link] * (camera.outside is None)
        elif module.type == "CM-SEN":
            links = [lidar.link for lidar in model.lidars]
        found += [_site(id, module, modules, model, link) for link in links]
    return found


def _site(id: JausID, module: Module, modules: Mapping[JausID, Module], model: RobotModel, link: str) -> MountSite:
    """The place of a link of a module; of one that the module itself moves, at zero, where its first joint is."""
    carriers = {other: carrier for other, carrier in modules.items() if other != id and carrier.type == "CM-MAN"}
    mount = joint_of(carriers, model, _fixed_parent(model, link) if module.moves else link)
    if mount is not None:
        if module.moves is None:
            return MountSite(id.node, id.component, mount.frame, mount.number)
        offset = _at_zero(model, _fixed_parent(model, link), link)
        return MountSite(id.node, id.component, mount.frame @ jaus_frame(offset), mount.number)
    return MountSite(id.node, id.component, jaus_frame(_at_zero(model, model.description.root(), link)))


def _fixed_parent(model: RobotModel, link: str) -> str:
    return model.description.chain(model.description.root(), link)[-1].parent


def mount_of(build: ModuleBuild) -> iop.Mount | None:
    """The joint of another module that carries the joints which this module moves; None for those on the chassis."""
    group = build.model.groups.get(build.module.moves or "")
    mount = joint_of(build.modules, build.model, group.base) if group is not None else None
    return None if mount is None else (mount.manipulator, mount.number)


def _at_zero(model: RobotModel, base: str, link: str) -> Transform:
    """The frame of `link` in that of `base`, with all joints at zero."""
    tree = FrameTree(model.description)
    return tree.pose(base).inverse() @ tree.pose(link)
