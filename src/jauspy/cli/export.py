"""`jauspy export`: recordings as tables, video, captures and data sets for learning."""

from __future__ import annotations

from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Annotated

import typer

from jauspy.capture.filters import Filter
from jauspy.capture.reader import up_to_damage
from jauspy.cli import console
from jauspy.cli.definitions import Definitions, SchemasOption, definitions
from jauspy.cli.options import DEFAULT_ROOT, FilterOption
from jauspy.cli.traffic import open_capture, traffic
from jauspy.errors import ConfigError
from jauspy.export.tables import export_tables
from jauspy.inspection.traffic import SeenMessage
from jauspy.recording.recorder import Recorder
from jauspy.video import need_video

FORMATS = {"csv": "-csv", "parquet": "-parquet", "mp4": "-mp4", "pcapng": ".pcapng", "lerobot": "-lerobot"}
"""What is appended to the name of the recording, by format."""


def export(
    *,
    files: Annotated[
        list[Path], typer.Argument(metavar="FILE", help="A .mcap, .pcapng or .pcap file; --lerobot takes several.")
    ],
    csv: Annotated[bool, typer.Option("--csv", help="A folder of tables, one of each sender and message.")] = False,
    parquet: Annotated[bool, typer.Option("--parquet", help="The same with types, for pandas and DuckDB.")] = False,
    mp4: Annotated[bool, typer.Option("--mp4", help="A folder of videos, one of each camera.")] = False,
    pcapng: Annotated[bool, typer.Option("--pcapng", help="The datagrams, for Wireshark.")] = False,
    lerobot: Annotated[
        bool, typer.Option("--lerobot", help="A data set for learning, format v3.0 of LeRobot; a file is an episode.")
    ] = False,
    output: Annotated[
        Path | None,
        typer.Option(
            "-o", "--output", metavar="PATH", help="A new folder, or file (--pcapng). Default: FILE and its format."
        ),
    ] = None,
    only: FilterOption = None,
    fps: Annotated[int, typer.Option("--fps", min=1, max=240, help="Frames a second of the data set.")] = 10,
    task: Annotated[
        str, typer.Option("--task", metavar="TEXT", help="What the operator did, for the data set.")
    ] = "teleoperation",
    state: Annotated[
        list[str] | None,
        typer.Option(
            "--state",
            metavar="MESSAGE",
            help="A message of the state, instead of the usual ones; may be repeated.",
        ),
    ] = None,
    action: Annotated[
        list[str] | None,
        typer.Option("--action", metavar="MESSAGE", help="A message of the action; may be repeated."),
    ] = None,
    schemas: SchemasOption = None,
) -> None:
    """Write a recording as tables, video, a capture, or a data set for learning.

    Nothing is overwritten. Values are in SI units and radians, times in seconds since 1970.

    Examples:
      jauspy export run.mcap --csv
      jauspy export run.mcap --parquet -o tables --filter 'msg == ReportLocalPose'
      jauspy export run.pcapng --mp4
      jauspy export run1.mcap run2.mcap --lerobot --fps 30 --task 'grasp the can'
    """
    chosen = [name for name, is_on in zip(FORMATS, (csv, parquet, mp4, pcapng, lerobot), strict=True) if is_on]
    if len(chosen) != 1:
        raise typer.BadParameter(f"give one of {', '.join(f'--{name}' for name in FORMATS)}")
    form = chosen[0]
    if len(files) > 1 and form != "lerobot":
        raise ConfigError(f"--{form} takes one file; only --lerobot takes several")
    if form == "mp4" and only is not None:
        raise ConfigError("--filter does not choose video; leave it out with --mp4")
    known = definitions(schemas)
    file = files[0]
    path = output or file.with_name(file.stem + FORMATS[form])
    match form:
        case "pcapng":
            _export_pcapng(file, path, known, only)
        case "mp4":
            _export_films(file, path)
        case "lerobot":
            _export_dataset(files, path, known, only, fps=fps, task=task, state=state, action=action)
        case _:
            _export_tables(file, path, form, known, only)


def _messages(file: Path, known: Definitions, only: str | None) -> Iterator[SeenMessage]:
    with traffic(file, DEFAULT_ROOT, known, only) as found:
        yield from found


def _export_tables(file: Path, folder: Path, form: str, known: Definitions, only: str | None) -> None:
    if form == "parquet":
        _need("pyarrow")
    done = export_tables(lambda: _messages(file, known, only), folder, f".{form}")
    console.print_table(("file", "rows"), [(path.name, str(count)) for path, count in done.files.items()])
    for what, count in done.left_out.most_common(10):
        console.note(f"{count} {what} are in no table")
    console.note(f"{sum(done.files.values())} messages in {len(done.files)} files: {folder}")


def _export_films(file: Path, folder: Path) -> None:
    need_video()
    from jauspy.export.films import export_films

    for path, count in export_films(file, folder).items():
        console.print_lines(f"{path}: {count} pictures")


def _export_pcapng(file: Path, path: Path, known: Definitions, only: str | None) -> None:
    if path.suffix != ".pcapng":
        raise ConfigError(f"{path} does not end in .pcapng")
    fits = None if only is None else Filter(only, known.registry)
    with open_capture(file, DEFAULT_ROOT) as capture:
        recorder = Recorder(path, known.registry, fits=fits)
        recorder.run(up_to_damage(capture, console.note))
    console.print_lines(f"{path}: {recorder.recorded.datagrams} datagrams, {recorder.recorded.bytes} bytes")


def _export_dataset(
    files: list[Path],
    folder: Path,
    known: Definitions,
    only: str | None,
    *,
    fps: int,
    task: str,
    state: list[str] | None,
    action: list[str] | None,
) -> None:
    _need("pyarrow")
    need_video()
    from jauspy.export.lerobot import ACTION, STATE, DatasetSettings, export_lerobot

    settings = DatasetSettings(fps, task, tuple(state or STATE), tuple(action or ACTION))
    done = export_lerobot({file: _messages(file, known, only) for file in files}, folder, settings)
    for title, names in (("state", done.state), ("action", done.action), ("camera", done.cameras)):
        for name in names or ("none",):
            console.print_lines(f"{title:<8}{name}")
    console.note(f"{done.episodes} episodes, {done.frames} frames at {fps} Hz: {folder}")


def _need(package: str) -> None:
    if find_spec(package) is None:
        raise ConfigError(f"this format needs {package}: pip install 'jauspy[export]'")
