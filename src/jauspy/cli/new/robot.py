"""`jauspy new robot`: write a first TOML file for a URDF.

Groups and sensors are derived from joints and links, or guessed.
"""

from __future__ import annotations

import json
import math
import re
import sys
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated, Final

import typer

from jauspy.cli import console
from jauspy.cli.new import write_new
from jauspy.cli.new.trial import try_wheels
from jauspy.errors import ConfigError
from jauspy.geometry.frames import FrameTree
from jauspy.geometry.urdf import UNGUIDED, Joint, JointKind, RobotDescription, inertials, parse_tree
from jauspy.geometry.vectors import GRAVITY
from jauspy.platform.description import RobotModel
from jauspy.platform.joint_control import ROTOR_ACCELERATION
from jauspy.platform.wheels import WheelJoints, WheelKind, WheelSetup, wheel_setup
from jauspy.robot import robot_files
from jauspy.robot.missing_parts import BOX, MissingPolicy
from jauspy.robot.urdf_files import expand_urdf, read_urdf
from jauspy.robot.urdf_paths import PackagePaths

BANDWIDTH: Final = 15.0
"""Rad/s, of the position controllers: about the speed at which real arms follow."""

GUESSED_MASS: Final = 2.0
"""Kilograms of a link whose mass is not given."""

GUESSED_SPEED: Final = {JointKind.PRISMATIC: 0.2}
"""M/s; 1 rad/s for joints that turn."""

WHEEL_SPEED: Final = 10.0
"""Rad/s, of wheels without limits."""

LEAST_EFFORT: Final = 5.0
"""N m or N: guess for a joint that carries nothing."""

WHEEL_FRICTION: Final = 1.0
"""Coefficient of wheels for which the URDF gives none."""

LEAST_INERTIA: Final = 0.001
"""Kg m^2, of the rotor and gear of a wheel."""

STEEPEST: Final = 0.5
"""Sine of the slope that wheels climb."""

TURNING_RESERVE: Final = 3.0
"""Effort of wheels as a multiple of what turning on the spot needs; the rest is for speed."""

MIN_LEVEL: Final = 0.9
"""Cosine between the axle of a wheel and the y axis."""

LIDAR_WORDS: Final = ("laser", "lidar", "velodyne", "hokuyo", "base_scan", "scan")
MAX_GROUP: Final = 32
MAX_CAMERAS: Final = 2
FIRST_COMPONENT: Final = 102


@dataclass(frozen=True, slots=True)
class Chain:
    """Joints that are commanded together."""

    name: str
    base: str
    tip: str
    joints: tuple[Joint, ...]


def first_file(description: RobotDescription, urdf: str, subsystem: int, extra: Mapping[str, object]) -> str:
    """The text of a TOML file; `urdf` is the path to be written, `extra` has further keys such as `package_path`."""
    wheels = _wheels(description)
    rolling = {*wheels.left, *wheels.right} if wheels else set()
    arms = _arm_joints(description)
    casters = {joint.name for joint in description.joints.values() if joint.kind is JointKind.CONTINUOUS} - arms
    chains = _chains(description, rolling | casters if wheels else rolling)
    masses = _Masses(description)
    limits: dict[str, dict[str, float]] = {}
    wheel_effort = _wheel_effort(description, wheels, masses.total) if wheels else 0.0
    for joint in description.joints.values():
        if joint.name in rolling:
            limits |= _missing_limits(joint, wheel_effort, WHEEL_SPEED)
        elif any(joint in chain.joints for chain in chains):
            limits |= _missing_limits(joint, 3.0 * masses.load(joint), GUESSED_SPEED.get(joint.kind, 1.0))
    lines = [
        f"# {description.name}: a first file, made from its URDF. What is marked as a guess is worth a look.",
        "",
        f"name = {_text(re.sub(r'[^ -~]', '_', description.name)[:64] or 'robot')}",
        f"urdf = {_text(urdf)}",
        *(f"{key} = {_value(value)}" for key, value in extra.items()),
        f"subsystem = {subsystem}",
        "node = 1",
        'backend = "sim"',
        'world = "empty"         # or "yard", "rough", or the path of a world: .xml, .sdf, .toml',
        "",
    ]
    number = FIRST_COMPONENT
    if wheels:
        lines += _module("CM-MOB", number, "drives the wheels")
        number += 1
    for chain in chains:
        hand = chain.name.startswith("gripper")
        group_key = "" if chain.name in ("arm", "gripper") else f'group = "{chain.name}"'
        lines += _module("CM-EEF" if hand else "CM-MAN", number, f"moves the group {chain.name}", group_key)
        number += 1
    lidars, cameras = _sensors(description)
    if lidars:
        lines += _module("CM-SEN", number, "reports what the lidars measure")
        number += 1
    for name, _ in cameras:
        lines += _module("CM-VIS", number, f"streams what the camera {name} sees", f'camera = "{name}"')
        number += 1
    if number == FIRST_COMPONENT:
        lines += _module("CM-SEN", number, "nothing moves")
    for name, link in lidars:
        lines += [
            "[[lidars]]              # a guess, by the link's name",
            f'name = "{name}"',
            f"link = {_text(link)}",
            "",
        ]
    for name, link in cameras:
        lines += ["[[cameras]]             # a guess, by the link's name", f'name = "{name}"']
        lines += [f"link = {_text(link)}      # looks along x, z is up", ""]
    if wheels:
        lines += ["[wheels]                # a guess: the continuous joints on both sides with level axles"]
        lines += ['type = "skid_steer"', f"left = {_value(wheels.left)}", f"right = {_value(wheels.right)}"]
        lines += [f"radius = {wheels.radius}"] if wheels.radius else []
        weakest = min(description.joint(name).effort or wheel_effort for name in rolling)
        lines += [f"inertia = {_number(max(LEAST_INERTIA, min(weakest, wheel_effort) / ROTOR_ACCELERATION))}"]
        lines += [""]
    for name, keys in limits.items():
        lines += [f"[joint_limits.{_key(name)}]  # guesses: the URDF has none, or zero"]
        lines += [f"{key} = {value}" for key, value in keys.items()]
        lines += [""]
    for chain in chains:
        lines += _group(chain, limits, masses)
    return "\n".join(lines).rstrip() + "\n"


def _module(type_: str, component: int, comment: str, more: str = "") -> list[str]:
    found = ["[[modules]]", f'type = "{type_}"', f"component = {component:<9} # {comment}"]
    return [*found, more, ""] if more else [*found, ""]


def _group(chain: Chain, limits: Mapping[str, Mapping[str, float]], masses: _Masses) -> list[str]:
    lines = [f"[groups.{_key(chain.name)}]", f"base = {_text(chain.base)}", f"tip = {_text(chain.tip)}", "rate = 500.0"]
    lines += ["joints = [               # gains: guesses from masses, lengths and efforts"]
    for given in chain.joints:
        joint = replace(given, effort=limits.get(given.name, {}).get("effort", given.effort))
        inertia = masses.inertia(joint) + joint.effort / ROTOR_ACCELERATION
        start = min(max(0.0, joint.lower), joint.upper)
        p, d = inertia * BANDWIDTH**2, 2.0 * inertia * BANDWIDTH
        position = f"{{ p = {_number(p)}, i = {_number(p)}, d = {_number(d)}, i_limit = {_number(joint.effort / 2)} }}"
        velocity = f"{{ p = {_number(d)}, i = {_number(d * BANDWIDTH / 2)}, i_limit = {_number(joint.effort)} }}"
        lines.append(
            f"  {{ name = {_text(joint.name)}, start = {start}, position = {position}, velocity = {velocity} }},"
        )
    return [*lines, "]", ""]


def _missing_limits(joint: Joint, effort: float, velocity: float) -> dict[str, dict[str, float]]:
    """The guesses for a joint, for those limits that the URDF does not give."""
    found: dict[str, float] = {}
    if joint.effort <= 0.0:
        found["effort"] = float(_number(max(LEAST_EFFORT, effort)))
    if joint.velocity <= 0.0:
        found["velocity"] = velocity
    return {joint.name: found} if found else {}


def _wheel_effort(description: RobotDescription, joints: WheelJoints, mass: float) -> float:
    """N m of each wheel, to climb a slope, and to turn on the spot, in which all wheels slide to the side.

    Friction of a wheel is one force: what drives it forward is missing to the side. The wheels slide when the driving
    forces times half of the track exceed what is left to the side times the distances of the axles from the middle.
    """
    wheels = _setup(description, joints).wheels
    weight = GRAVITY * mass / len(wheels)
    middle = sum(wheel.x for wheel in wheels) / len(wheels)
    half_base = sum(abs(wheel.x - middle) for wheel in wheels) / len(wheels)
    half_track = sum(abs(wheel.y) for wheel in wheels) / len(wheels)
    friction = max(description.friction.get(wheel.joint.child, WHEEL_FRICTION) for wheel in wheels)
    radius = max(wheel.radius for wheel in wheels)
    turning = friction * weight * half_base / math.hypot(half_base, half_track)
    return radius * max(STEEPEST * weight, TURNING_RESERVE * turning)


def _setup(description: RobotDescription, joints: WheelJoints) -> WheelSetup:
    """The wheels as measured, whether the URDF limits their joints or not."""
    powered = {
        name: replace(joint, effort=joint.effort or LEAST_EFFORT, velocity=joint.velocity or WHEEL_SPEED)
        for name, joint in description.joints.items()
    }
    return wheel_setup(replace(description, joints=powered), joints)


def _wheels(description: RobotDescription) -> WheelJoints | None:
    """The wheels, if there are as many on the left as on the right."""
    frames = FrameTree(description).poses()
    arms = _arm_joints(description)
    sides: dict[str, list[str]] = {"left": [], "right": []}
    heights = []
    for joint in description.joints.values():
        frame = frames[joint.child]
        level = abs(frame.rotate(joint.axis)[1]) > MIN_LEVEL
        aside = level and abs(frame.position[1]) > 0.01
        if joint.kind is JointKind.CONTINUOUS and joint.mimics is None and aside and joint.name not in arms:
            sides["left" if frame.position[1] > 0.0 else "right"].append(joint.name)
            heights.append(frame.position[2])
    if not sides["left"] or len(sides["left"]) != len(sides["right"]) or len(sides["left"]) > 8:
        return None
    left, right = tuple(sides["left"]), tuple(sides["right"])
    found = WheelJoints(type=WheelKind.SKID_STEER, left=left, right=right, steered=(), radius=None, inertia=0.02)
    height = round(abs(sum(heights) / len(heights)), 4) or 0.1
    for radius in (None, height):
        try:
            _setup(description, replace(found, radius=radius))
        except ConfigError:
            continue
        return replace(found, radius=radius)
    return None


def _arm_joints(description: RobotDescription) -> set[str]:
    """The continuous joints of arms and heads: they carry a joint with limits, or are carried by two."""
    parents = {joint.child: joint for joint in description.joints.values()}
    found: set[str] = set()
    for joint in description.joints.values():
        above, link = [], joint.parent
        while link in parents:
            above.append(parents[link])
            link = parents[link].parent
        guided = [joint for joint in above if _has_limits(joint)]
        if _has_limits(joint):
            found |= {joint.name for joint in above if joint.kind is JointKind.CONTINUOUS}
        elif joint.kind is JointKind.CONTINUOUS and len(guided) > 1:
            found.add(joint.name)
    return found


def _has_limits(joint: Joint) -> bool:
    return joint.is_independent and joint.kind is not JointKind.CONTINUOUS and joint.lower < joint.upper


def _chains(description: RobotDescription, used: Iterable[str]) -> list[Chain]:
    """The chains of joints that move, without branches, the longest first."""
    taken = set(used)
    below: dict[str, list[Joint]] = {}
    for joint in description.joints.values():
        below.setdefault(joint.parent, []).append(joint)

    def moving(link: str) -> list[Joint]:
        """The nearest joints below a link that move by themselves."""
        found: list[Joint] = []
        for joint in below.get(link, []):
            free = joint.is_independent and joint.name not in taken and joint.lower < joint.upper
            found += [joint] if free else moving(joint.child)
        return found

    found: list[Chain] = []
    starts = moving(description.root())
    while starts:
        start = starts.pop(0)
        joints, link = [start], start.child
        while len(following := moving(link)) == 1 and len(joints) < MAX_GROUP and not _is_hand(following[0], joints):
            joints.append(following[0])
            link = following[0].child
        starts += following
        found.append(Chain("", start.parent, _tip(below, link), tuple(joints)))
    return _named(sorted(found, key=lambda chain: -len(chain.joints)))


def _is_hand(joint: Joint, before: Sequence[Joint]) -> bool:
    """True for a joint that opens a gripper at the end of an arm."""
    words = ("finger", "gripper", "jaw", "knuckle", "hand")
    named = any(word in text.lower() for word in words for text in (joint.name, joint.child))
    return len(before) >= 3 and named and not any(word in before[-1].child.lower() for word in words)


def _tip(below: Mapping[str, list[Joint]], link: str) -> str:
    """The link at the end of a chain: the deepest one that is fixed to it and is called a tool, or else the last."""
    pending, tools = [link], [link]
    while pending:
        for joint in below.get(pending.pop(), []):
            if joint.kind is JointKind.FIXED:
                pending.append(joint.child)
                if re.search(r"tool|tcp|ee_|_ee|end_effector|grasp|hand_tcp|flange", joint.child.lower()):
                    tools.append(joint.child)
    return tools[-1]


def _named(chains: list[Chain]) -> list[Chain]:
    found, names = [], set[str]()
    for chain in chains:
        text = f"{chain.joints[0].name} {chain.joints[0].child}".lower()
        if len(chain.joints) <= 2 and re.search("finger|gripper|jaw|knuckle", text):
            name = "gripper"
        elif "arm" not in names and len(chain.joints) >= 3:
            name = "arm"
        else:
            name = re.sub(r"\W+", "_", chain.joints[0].child)[:60] or "group"
        unique, number = name, 2
        while unique in names:
            unique, number = f"{name}_{number}", number + 1
        names.add(unique)
        found.append(replace(chain, name=unique))
    return found


def _sensors(description: RobotDescription) -> tuple[list[tuple[str, str]], list[tuple[str, str]]]:
    """Names and links of lidars and cameras, by the names of the links."""
    links = [joint.child for joint in description.joints.values()]
    lidars = [
        link for link in links if any(word in link.lower() for word in LIDAR_WORDS) and "mount" not in link.lower()
    ]
    plain = [link for link in links if "camera" in link.lower() and not re.search("optical|mount|depth", link.lower())]
    first = [link for link in plain if link.lower().endswith(("camera_link", "camera", "rgb_frame"))] or plain
    named = [(re.sub(r"\W+", "_", link)[:60], link) for link in first[:MAX_CAMERAS]]
    return [("lidar", link) for link in lidars[:1]], named


class _Masses:
    """Masses that joints carry, to guess gains."""

    def __init__(self, description: RobotDescription) -> None:
        known = {inertial.link: inertial.mass for inertial in inertials(description.urdf)}
        self._mass = {link: known.get(link, 0.0) for link in description.links()}
        if not any(self._mass.values()):
            self._mass = dict.fromkeys(self._mass, GUESSED_MASS)
        self._below: dict[str, list[Joint]] = {}
        for joint in description.joints.values():
            self._below.setdefault(joint.parent, []).append(joint)
        self.total = sum(self._mass.values())

    def inertia(self, joint: Joint) -> float:
        """Inertia of everything that a joint moves, kg m^2 or kg: a quarter of that of the stretched arm."""
        slides = joint.kind is JointKind.PRISMATIC
        found = sum(mass * (1.0 if slides else max(0.03, reach) ** 2) for mass, reach in self._carried(joint.child))
        return found if slides else found / 4.0

    def load(self, joint: Joint) -> float:
        """The greatest torque or force by the weight of what a joint carries."""
        slides = joint.kind is JointKind.PRISMATIC
        return GRAVITY * sum(mass * (1.0 if slides else reach) for mass, reach in self._carried(joint.child))

    def _carried(self, link: str, reach: float = 0.0) -> list[tuple[float, float]]:
        """Masses, and how far their links are from the joint at most."""
        found, pending = [], [(link, reach)]
        while pending:
            name, far = pending.pop()
            found.append((self._mass[name], far + 0.05))
            pending += [
                (joint.child, far + math.hypot(joint.origin.x, joint.origin.y, joint.origin.z))
                for joint in self._below.get(name, [])
            ]
        return found


def _number(value: float) -> str:
    """A number with three digits, as a float of TOML."""
    text = f"{float(f'{value:.3g}'):.10f}".rstrip("0")
    return f"{text}0" if text.endswith(".") else text


def _text(value: str) -> str:
    return json.dumps(value, ensure_ascii=False)


def _key(name: str) -> str:
    return name if re.fullmatch(r"[A-Za-z0-9_-]+", name) else _text(name)


def _value(value: object) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{_key(str(key))} = {_value(entry)}" for key, entry in value.items()) + " }"
    if isinstance(value, tuple | list):
        return "[" + ", ".join(map(_value, value)) + "]"
    return str(value) if isinstance(value, float | int) else _text(str(value))


def relative(path: Path, folder: Path) -> str:
    """A path as it is written in a file of that folder."""
    try:
        return str(path.resolve().relative_to(folder.resolve()))
    except ValueError:
        return str(path.resolve())


def robot(
    *,
    urdf: Annotated[Path, typer.Argument(metavar="URDF", help="The URDF or xacro file.")],
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="FILE", help="Default: NAME.toml here, with the name of the URDF file."),
    ] = None,
    package_path: Annotated[
        list[Path] | None,
        typer.Option(
            "--package-path",
            metavar="DIRECTORY",
            help="Directory searched first for the packages of package:// and $(find ...); may be repeated.",
        ),
    ] = None,
    argument: Annotated[
        list[str] | None,
        typer.Option("--arg", metavar="NAME:=VALUE", help="An argument of the xacro file; may be repeated."),
    ] = None,
    subsystem: Annotated[int, typer.Option("--subsystem", min=1, max=65534, help="Its JAUS id.")] = 101,
    skip_missing_packages: Annotated[
        bool,
        typer.Option(
            "--skip-missing-packages",
            help="Leave out what the URDF includes of packages and files that are missing, with all that needs it.",
        ),
    ] = False,
    placeholder_meshes: Annotated[
        bool,
        typer.Option("--placeholder-meshes", help=f"Put a box of {BOX:g} m in the place of each missing mesh."),
    ] = False,
    expand_only: Annotated[
        bool,
        typer.Option("--expand-only", help="Print the expanded URDF, or write it to the file of -o; no TOML file."),
    ] = False,
) -> None:
    """Write a first TOML file for a robot of which there is a URDF only, so that it moves in the simulation.

    Groups are made of the chains of joints. Wheels, gains, missing limits, lidars and cameras are guessed, and marked.
    All packages, included files and meshes that are missing are listed at once. The choice to do without is written
    into the TOML file, so that they are used when they are installed later.

    Examples:
      jauspy new robot husky.urdf.xacro --arg laser_enabled:=true
      jauspy new robot husky.urdf.xacro --skip-missing-packages --placeholder-meshes
    """
    arguments = dict(_argument(assignment) for assignment in argument or ())
    given = tuple(package_path or ())
    policy = MissingPolicy(skip_missing_packages, placeholder_meshes)
    if expand_only:
        _expand(urdf, PackagePaths(given), arguments, policy, output)
        return
    path = output or Path(f"{urdf.name.split('.')[0]}.toml")
    # the model below tells what is left out
    description = read_urdf(str(urdf), PackagePaths(given), arguments, policy, tell=lambda _: None)
    extra: dict[str, object] = {}
    if given:
        extra["package_path"] = [relative(folder, path.parent) for folder in given]
    if arguments:
        extra["xacro_arguments"] = arguments
    chosen = {"skip_missing_packages": skip_missing_packages, "placeholder_meshes": placeholder_meshes}
    extra |= {key: True for key, is_chosen in chosen.items() if is_chosen}
    write_new({path: first_file(description, relative(urdf, path.parent), subsystem, extra)})
    if passed_over := _passed_over(description.urdf):
        console.print_lines(f"passed over in the URDF: {passed_over}")
    try:
        model = robot_files.robot_model(robot_files.load(path.absolute()))
    except ConfigError as error:
        console.error(f"{path} needs a correction: {error}")
        raise typer.Exit(1) from None
    if model.wheels is not None:
        _report_trial(model, model.wheels)
    console.print_lines(f"run it:  jauspy up {path}", f"in another world:  jauspy up {path} --world yard")


def _expand(
    urdf: Path, packages: PackagePaths, arguments: Mapping[str, str], policy: MissingPolicy, output: Path | None
) -> None:
    """Print the expanded URDF, or write it to a file."""
    folder = Path() if output is None else output.parent
    expanded = expand_urdf(str(urdf), packages, arguments, policy, folder)
    if output is not None:
        write_new({output: expanded})
    else:
        console.print_lines(*expanded.decode("ascii").expandtabs().splitlines())


def _report_trial(model: RobotModel, wheels: WheelSetup) -> None:
    """Print what the robot can do on wheels, and warn of what it cannot."""
    try:
        trial = try_wheels(model)
    except ConfigError as error:
        console.note(f"not tried in the simulation: {error}")
        return
    console.print_lines(
        f"in a trial with full effort it drives at {trial.speed:.2f} m/s and turns at {trial.turn_rate:.2f} rad/s"
    )
    if trial.cannot:
        weakest = min((wheel.joint for wheel in wheels.wheels), key=lambda joint: joint.effort)
        console.print_lines(
            f"Warning: it cannot {trial.cannot} in the simulation: raise the effort of its wheels (now "
            f"{weakest.effort:g} N m), as in [joint_limits.{_key(weakest.name)}], or give links that slide on the "
            'ground less friction: <gazebo reference="LINK"><mu1>0.1</mu1></gazebo>',
            file=sys.stderr,
        )


def _passed_over(urdf: str) -> str:
    """A note on elements of other programs, and on joints that are treated as fixed."""
    root = parse_tree(urdf)
    tags = Counter(str(element.tag) for element in root.iterchildren("gazebo", "transmission", "ros2_control"))
    parts = [f"{count} <{tag}>" for tag, count in tags.items()]
    unguided = [str(joint.get("name")) for joint in root.iterchildren("joint") if joint.get("type") in UNGUIDED]
    return ", ".join(parts + [f"joint {name} moves freely in the URDF, and is fixed here" for name in unguided])


def _argument(text: str) -> tuple[str, str]:
    name, found, value = text.partition(":=")
    if not found or not name:
        raise typer.BadParameter(f"{text!r} is not NAME:=VALUE", param_hint="--arg")
    return name, value
