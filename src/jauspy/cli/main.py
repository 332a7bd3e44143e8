"""The `jauspy` command: its verbs, and how errors, Ctrl-C and closed pipes end it."""

from __future__ import annotations

import errno
import importlib
import inspect
import os
import re
import sys
from pathlib import Path
from typing import Annotated, Any, Final

import typer
import typer.core
import typer.main

from jauspy import __version__
from jauspy.cli import console
from jauspy.errors import JausError

VERBS: Final = {
    "demo": (
        "jauspy.cli.demo:demo",
        "Run the whole system: a simulated robot drives to a table, finds a can, grasps and lifts it.",
    ),
    "up": ("jauspy.cli.up:up", "Run a robot, and a node manager if none runs in the local root."),
    "node-manager": (
        "jauspy.cli.node_manager:node_manager",
        "Route JAUS between the components of this machine and the network.",
    ),
    "ls": ("jauspy.cli.ls:ls", "List subsystems, nodes, components and services that answer discovery."),
    "health": (
        "jauspy.cli.health:health",
        "Show a robot's battery, and the health of its drives, cameras and computers.",
    ),
    "doctor": ("jauspy.cli.doctor:doctor", "Find why two parties do not talk, and how to mend it."),
    "query": ("jauspy.cli.query:query", "Query a component and print its answer."),
    "send": ("jauspy.cli.send:send", "Send a command or any other message that has no answer."),
    "teleop": ("jauspy.cli.teleop:teleop", "Drive a robot with the keys of the terminal, or with a gamepad."),
    "follow": (
        "jauspy.cli.follow:follow",
        "Have one robot follow another along its path, until Ctrl-C or until following ends.",
    ),
    "navigate": (
        "jauspy.cli.navigate:navigate",
        "Drive a robot to a point, around what its sensors see.",
    ),
    "navigate-trials": (
        "jauspy.cli.navigate_trials:navigate_trials",
        "Drive inc1 to many goals in simulated worlds, and report how many it reaches without touching anything.",
    ),
    "retrotraverse": (
        "jauspy.cli.retrotraverse:retrotraverse",
        "Drive a robot back along the path by which it came.",
    ),
    "console": (
        "jauspy.cli.operator_console:console_page",
        "Operate robots in the browser: cameras, driving, arm, emergency stop.",
    ),
    "guard": (
        "jauspy.cli.guard:guard",
        "Show the guards of a robot against self collision and obstacles, or switch them.",
    ),
    "handoff": (
        "jauspy.cli.handoff:handoff",
        "Ask the client in control of a component to hand it over, or answer those who ask.",
    ),
    "log": (
        "jauspy.cli.log:log",
        "Show the log of a robot's traffic, which the robot keeps itself, or switch it.",
    ),
    "estop": ("jauspy.cli.estop:estop", "Stop all robots, one robot or one component, and list which have stopped."),
    "pose": ("jauspy.cli.pose:pose", "Move a robot's arm and flippers to a named pose, or list its poses."),
    "tf": ("jauspy.cli.tf:tf", "Show the poses of a running robot's frames: each in its parent, or TO in FROM."),
    "planner": (
        "jauspy.cli.planner:planner",
        "Plan motions of a robot's arm around obstacles for operators (service MotionPlanner), until Ctrl-C.",
    ),
    "reach": (
        "jauspy.cli.reach:reach",
        "Move the tool of an arm to a pose, or its joints to positions, around what the robot's sensors see.",
    ),
    "grasp": (
        "jauspy.cli.grasp:grasp",
        "Grasp a thing that the robot's depth cameras see: look, plan, approach, close, lift, and check that it holds.",
    ),
    "map": (
        "jauspy.cli.map:map_robot",
        "Map with a robot's lidar while the robot is driven, and write the map in the format of ROS's map_server.",
    ),
    "scene": (
        "jauspy.cli.scene:scene",
        "Show what a robot sees around it: voxels of its lidars and depth cameras, in the frame of its base.",
    ),
    "video": (
        "jauspy.cli.video:video",
        "Request the video of a camera, and print commands that show it; or record it.",
    ),
    "still": ("jauspy.cli.still:still", "Take a picture with a camera and save it."),
    "listen": ("jauspy.cli.sound:listen", "Record what a robot's microphone hears."),
    "announce": ("jauspy.cli.sound:announce", "Play a WAV file on a robot's loudspeaker."),
    "decode": ("jauspy.cli.decode:decode", "Print the JAUS messages in a capture file or in hex text."),
    "dissector": (
        "jauspy.cli.dissector:dissector",
        "Write a dissector for Wireshark and tshark: a Lua file with all messages.",
    ),
    "echo": (
        "jauspy.cli.echo:echo",
        "Print messages as the node manager of this machine routes them, until Ctrl-C.",
    ),
    "hz": (
        "jauspy.cli.rates:hz",
        "Measure how often messages come: rate, shortest and longest interval, and their standard deviation.",
    ),
    "bw": (
        "jauspy.cli.rates:bw",
        "Measure how many bytes a second messages take: packets with their headers, without those of UDP and IP.",
    ),
    "monitor": (
        "jauspy.cli.monitor.verb:monitor",
        "Watch subsystems, components and their messages on a full screen, live or from a capture.",
    ),
    "graph": ("jauspy.cli.rates:graph", "Show who talks to whom: the messages between components, with their rates."),
    "record": ("jauspy.cli.record:record", "Record what the node manager of this machine routes, until Ctrl-C."),
    "live": (
        "jauspy.cli.live:live",
        "Show what the node manager of this machine routes in Foxglove, live.",
    ),
    "flight-recorder": (
        "jauspy.cli.flight_recorder:flight_recorder",
        "Keep the last traffic of this machine in memory, and write it to a file when something happens, until Ctrl-C.",
    ),
    "info": (
        "jauspy.cli.info:info",
        "Tell what is in a recording: its time, and messages by sender and name.",
    ),
    "export": (
        "jauspy.cli.export:export",
        "Write a recording as tables, video, a capture, or a data set for learning.",
    ),
    "replay": (
        "jauspy.cli.replay:replay",
        "Send again what clients sent in a recording, and compare the answers with the recorded ones.",
    ),
    "audit": (
        "jauspy.cli.operators:audit",
        "Verify an audit log: name the first line that was changed or removed, or cut off at the end.",
    ),
    "conformance": ("jauspy.cli.conformance:conformance", "Test a robot or component of any vendor, step by step."),
}
KEY_VERBS: Final = {
    "new": (
        "jauspy.cli.operators:new",
        "Write a new key, and print what to add to the robots' operators file.",
    ),
    "show": ("jauspy.cli.operators:show", "Print the lines for the robots' operators file again."),
}
NEW_VERBS: Final = {
    "component": (
        "jauspy.cli.new.component:component",
        "Write a package with a component that offers a service: methods, a program, tests and a README.",
    ),
    "example": ("jauspy.cli.new.example:example", "Write an example program to begin with, or list the examples."),
    "definition": (
        "jauspy.cli.new.definition:definition",
        "Write the definition (JSIDL) of a service that reports numbers, takes commands and has states.",
    ),
    "robot": (
        "jauspy.cli.new.robot:robot",
        "Write a first TOML file for a robot of which there is a URDF only, so that it moves in the simulation.",
    ),
}
SCHEMA_VERBS: Final = {
    "ls": (
        "jauspy.cli.schema.ls:ls",
        "List service definitions: set, name, version, parent service, number of messages.",
    ),
    "show": (
        "jauspy.cli.schema.show:show",
        "Show a message (fields, bytes, units, ranges) or a service (messages, states, transitions).",
    ),
    "lint": (
        "jauspy.cli.schema.lint:lint",
        "Check definitions for mistakes that break other tools, as FILE:LINE: severity: code: sentence.",
    ),
    "diff": ("jauspy.cli.schema.diff:diff", "Compare definitions: messages, fields, values and behaviour."),
    "generate": (
        "jauspy.cli.schema.generate:generate",
        "Write message classes as a Python package: typed, byte-exact, like `jauspy.messages`.",
    ),
}
CELL_VERBS: Final = {
    "demo": (
        "jauspy.cli.cell.tasks:demo",
        "Do everything in one run: build the arm, throw, step, take it apart, build the car, drive off with the arm.",
    ),
    "assemble": (
        "jauspy.cli.cell.tasks:assemble",
        "Build an arm with five joints: the UR10 takes modules out of the bins and joins them.",
    ),
    "lift": (
        "jauspy.cli.cell.tasks:lift",
        "Take a box off the moving conveyor with the modular arm, and throw it into the marked area.",
    ),
    "throws": (
        "jauspy.cli.cell.tasks:throws",
        "Throw a box ten times, each aim corrected by where the boxes before came to rest.",
    ),
    "step": ("jauspy.cli.cell.tasks:step", "Step with the modular arm from platform to platform, and back."),
    "take-apart": (
        "jauspy.cli.cell.tasks:take_apart",
        "Take the modular arm apart: the UR10 puts its parts back into their bins.",
    ),
    "car": ("jauspy.cli.cell.tasks:car", "Build the car, put the arm on top, and drive both off the conveyor."),
    "kpi": (
        "jauspy.cli.cell.measurements:kpi",
        "Measure how soon the arm comes to rest after a release, with both controllers.",
    ),
    "iso9283": (
        "jauspy.cli.cell.measurements:iso9283",
        "Measure accuracy and repeatability of both arms, before and after a calibration.",
    ),
    "kitting": (
        "jauspy.cli.cell.trials:kitting",
        "Fill kitting orders with the UR10 alone and with an arm that it built, scored as in ARIAC 2018.",
    ),
    "trial": (
        "jauspy.cli.cell.ariac:trial",
        "Fill kitting orders of a trial with changes and faults, scored by the rules of ARIAC 2023.",
    ),
    "design": (
        "jauspy.cli.cell.design:design",
        "Choose modules for a task: the cheapest chain found that reaches all goals.",
    ),
    "all": ("jauspy.cli.cell.all:all_tasks", "Run everything once; write films, plots and a page of results."),
    "trials": ("jauspy.cli.cell.trials:trials", "Run a task with many seeds, and report how often it succeeds."),
}
CAN_VERBS: Final = {
    "drives": ("jauspy.cli.can:drives", "List the nodes on a robot's bus: state, error, voltage, firmware."),
    "simulate": ("jauspy.cli.can:simulate", "Simulate all drives of a robot on a CAN bus, until Ctrl-C."),
    "home": ("jauspy.cli.can:home", "Have drives search for their home positions, one after the other. Joints move."),
    "fault": ("jauspy.cli.can:fault", "Make a simulated drive fail."),
}
FUZZ_VERBS: Final = {
    "codec": ("jauspy.cli.fuzz:codec", "Decode valid, random and damaged messages and check invariants."),
    "target": (
        "jauspy.cli.fuzz_target:target",
        "Send legal and damaged messages to a component or node manager in each of its states.",
    ),
    "python": (
        "jauspy.cli.fuzz_python:python",
        "Run a Python function with damaged messages, guided by the lines that they reach.",
    ),
    "replay": ("jauspy.cli.fuzz:replay", "Check the bytes of a saved finding again."),
}
"""The function of each verb and its line in the help. A verb's module is imported when the verb runs, so that `--help`
is fast."""

PANELS: Final = {
    "Run robots": ("demo", "up", "node-manager", "cell", "can"),
    "Look and operate": (
        *("ls", "health", "query", "send", "teleop", "navigate", "follow", "retrotraverse", "console"),
        *("guard", "estop", "handoff", "pose", "reach", "grasp", "planner", "log", "tf", "map", "scene"),
        *("video", "still", "listen", "announce"),
    ),
    "Traffic": (
        *("decode", "echo", "hz", "bw", "graph", "monitor", "live"),
        *("record", "flight-recorder", "info", "replay", "export", "dissector"),
    ),
    "Test": ("conformance", "fuzz", "navigate-trials", "doctor"),
    "Definitions and projects": ("schema", "new"),
    "Keys and audit": ("keys", "audit"),
}
"""The verbs by their heading in `jauspy --help`; others are listed first, as commands."""
PANEL_OF: Final = {verb: panel for panel, verbs in PANELS.items() for verb in verbs}

GROUPS: Final = {
    "jauspy": VERBS,
    "new": NEW_VERBS,
    "schema": SCHEMA_VERBS,
    "keys": KEY_VERBS,
    "cell": CELL_VERBS,
    "can": CAN_VERBS,
    "fuzz": FUZZ_VERBS,
}

WRITE_ERRORS: Final = frozenset({errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO})
"""Errors of writing results that only the user can resolve."""


class VerbGroup(typer.core.TyperGroup):
    """Imports the module of a verb when the verb is called.

    An error becomes one sentence and an exit status: 1 failed, 2 wrong use, 130 Ctrl-C.
    """

    error_status = 1

    def resolve_command(self, ctx: Any, args: list[str]) -> tuple[str | None, Any, list[str]]:
        """Replace the placeholder of a verb, which has only its line of help, by the verb itself."""
        name, command, rest = super().resolve_command(ctx, args)
        verb = GROUPS[str(self.name)].get(str(name))
        return name, load_verb(str(name), verb[0]) if verb else command, rest

    def invoke(self, ctx: Any) -> Any:
        """Run the verb; with `--debug` errors keep their traceback."""
        try:
            try:
                return super().invoke(ctx)
            finally:
                sys.stdout.flush()
        except BrokenPipeError:
            # The reader closed the pipe, as in `jauspy decode ... | head`.
            console.discard_stdout()
            raise typer.Exit(0) from None
        except JausError as error:
            if ctx.find_root().params.get("debug"):
                raise
            console.error(str(error))
            raise typer.Exit(self.error_status) from None


class SchemaGroup(VerbGroup):
    """Errors have exit status 2, because 1 is a result: lint found something, or definitions differ."""

    error_status = 2


def load_verb(name: str, target: str) -> Any:
    """The command of a verb, from `module:function`; a module with an `app` has subcommands."""
    path, _, function = target.partition(":")
    module = importlib.import_module(path)
    verb = getattr(module, function)
    help_text = _help_text(verb.__doc__ or "")
    if isinstance(group_app := getattr(module, "app", None), typer.Typer):
        command = typer.main.get_command(group_app)
        command.help = help_text
        return command
    single = typer.Typer(add_completion=False, rich_markup_mode="rich")
    single.command(name, help=help_text)(verb)
    return typer.main.get_command(single)


def _help_text(doc: str) -> str:
    """A docstring with one line a paragraph, for the help to wrap; indented lines (examples) stay lines."""
    paragraphs = inspect.cleandoc(doc).split("\n\n")
    return "\n\n".join(re.sub(r"\n(?! )", " ", paragraph) for paragraph in paragraphs)


def _add(group: typer.Typer, verbs: dict[str, tuple[str, str]]) -> None:
    for name, (_, line) in verbs.items():
        group.command(name, help=line, rich_help_panel=PANEL_OF.get(name) if group is app else None)(_placeholder)


def _placeholder() -> None:
    """Never called: `resolve_command` replaces it."""


app = typer.Typer(
    cls=VerbGroup,
    name="jauspy",
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    rich_markup_mode="rich",
    context_settings={"help_option_names": ["-h", "--help"]},
)
new_app = typer.Typer(
    cls=VerbGroup,
    name="new",
    no_args_is_help=True,
    help="Write a service definition (JSIDL), or a component with tests, to start from.",
)
schema_app = typer.Typer(
    cls=SchemaGroup,
    name="schema",
    no_args_is_help=True,
    help="Read, check, compare and use service definitions (JSIDL): those built in, and your own.\n\n"
    "Exit status of every verb: 0 success; 1 lint found something or diff found a difference; 2 wrong use, or a name "
    "or file that does not exist or cannot be read.",
)
keys_app = typer.Typer(
    cls=VerbGroup, name="keys", no_args_is_help=True, help="Make the keys with which operators seal their commands."
)
cell_app = typer.Typer(
    cls=VerbGroup,
    name="cell",
    no_args_is_help=True,
    help="Tasks of the modular factory cell: simulated in this process, on virtual time, unless said otherwise.",
)
can_app = typer.Typer(
    cls=VerbGroup, name="can", no_args_is_help=True, help="Servo drives on a robot's CAN bus: real and simulated ones."
)
fuzz_app = typer.Typer(
    cls=VerbGroup,
    name="fuzz",
    no_args_is_help=True,
    help="Test the codec, and running targets, with random and damaged messages.",
)


def _version(value: bool) -> None:
    if value:
        console.print_lines(f"jauspy {__version__}")
        raise typer.Exit


@app.callback()
def _options(
    debug: Annotated[
        bool, typer.Option("--debug", help="Show the traceback of an error.", envvar="JAUSPY_DEBUG")
    ] = False,
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Print the version.")
    ] = False,
) -> None:
    """JAUS for Python: control unmanned ground vehicles, implement their components, and decode their traffic.

    Ids are SUBSYSTEM.NODE.COMPONENT, as in 101.1.102. Values are in SI units and radians.

    To try it: [bold]jauspy demo[/], or [bold]jauspy up inc1[/] in one terminal and [bold]jauspy ls[/] in another.
    """


_add(app, VERBS)
for _group, _verbs in (
    (new_app, NEW_VERBS),
    (schema_app, SCHEMA_VERBS),
    (keys_app, KEY_VERBS),
    (cell_app, CELL_VERBS),
    (can_app, CAN_VERBS),
    (fuzz_app, FUZZ_VERBS),
):
    _add(_group, _verbs)
    app.add_typer(_group, rich_help_panel=PANEL_OF.get(str(_group.info.name)))


def main() -> None:
    """The console script."""
    if not _open_streams():
        console.error("standard output is closed; redirect it to /dev/null to discard the results")
        sys.exit(1)
    try:
        app()
    except OSError as error:
        if error.errno not in WRITE_ERRORS or "--debug" in sys.argv:
            raise
        console.discard_stdout()
        console.error(f"the results cannot be written: {error.strerror}")
        sys.exit(1)


def _open_streams() -> bool:
    """Open closed standard streams on /dev/null, so that no socket gets their number; false if stdout was closed.

    A closed standard input is an empty one; without standard error, errors are not shown.
    """
    has_output = sys.stdout is not None
    for name, mode in (("stdin", "r"), ("stdout", "w"), ("stderr", "w")):
        if getattr(sys, name) is None:
            setattr(sys, name, Path(os.devnull).open(mode, encoding="utf-8"))  # noqa: SIM115 - until the process ends
    return has_output


if __name__ == "__main__":
    main()
