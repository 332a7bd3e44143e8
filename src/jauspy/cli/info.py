"""`jauspy info`: tell what is in a recording. It imports little, since reading a summary takes less than importing."""

from __future__ import annotations

import time
from collections import Counter
from pathlib import Path
from typing import Annotated, Any

import typer

from jauspy.cli import console
from jauspy.cli.options import Json
from jauspy.errors import ConfigError
from jauspy.recording.mcap_records import MAGIC
from jauspy.recording.mcap_summary import counted_summary, read_summary


def info(
    *,
    file: Annotated[Path, typer.Argument(metavar="FILE", help="A .mcap, .pcapng or .pcap file.")],
    json: Json = False,
) -> None:
    """Tell what is in a recording: its time, and messages by sender and name.

    The summary of an MCAP file is enough, whatever its size; other files, and those without a summary as after a crash,
    are read from the beginning to the end.

    Examples:
      jauspy info run.mcap
      jauspy info run.pcapng --json
    """
    try:
        with file.open("rb") as opened:
            is_mcap = opened.read(len(MAGIC)) == MAGIC or file.suffix == ".mcap"
        found = _mcap_info(file) if is_mcap else _capture_info(file)
    except OSError as error:
        raise ConfigError(f"{file} cannot be read: {error.strerror}") from None
    if json:
        console.print_json(found)
        return
    start, end = found["start"], found["end"]
    if start is not None:
        began = time.strftime("%Y-%m-%d %H:%M:%S", time.gmtime(start))
        console.print_lines(f"{file}: {found['bytes']} bytes, {end - start:.1f} s from {began} UTC")
    else:
        console.print_lines(f"{file}: {found['bytes']} bytes, no messages")
    rows = [(row["message"], row["source"], str(row["count"])) for row in found["messages"]]
    if rows:
        console.print_table(("message", "from", "count"), rows)


def _mcap_info(path: Path) -> dict[str, Any]:
    is_complete = True
    with path.open("rb") as opened:
        try:
            summary = read_summary(opened, str(path))
        except ConfigError as error:
            opened.seek(0)
            summary, problem = counted_summary(opened)
            if not summary.statistics.message_count:
                raise error from None
            is_complete = False
            console.note(f"{path} has no summary, as after a crash, and was read from its beginning" + _until(problem))
    counts = summary.statistics.channel_message_counts
    rows = []
    for number, channel in summary.channels.items():
        source, _, name = channel.topic.removeprefix("/").rpartition("/")
        if source and channel.message_encoding == "json":
            rows.append({"message": name, "source": source, "count": counts.get(number, 0)})
    has_any = bool(summary.statistics.message_count)
    return {
        "file": str(path),
        "bytes": path.stat().st_size,
        "complete": is_complete,
        "start": summary.statistics.message_start_time / 1e9 if has_any else None,
        "end": summary.statistics.message_end_time / 1e9 if has_any else None,
        "messages": sorted(rows, key=lambda row: (-int(row["count"]), str(row["message"]))),
    }


def _until(problem: str) -> str:
    return f" until it is damaged or cut off ({problem})" if problem else ""


def _capture_info(path: Path) -> dict[str, Any]:
    from jauspy.capture.reader import CaptureReader  # this and what follows take longer than a summary
    from jauspy.inspection.traffic import seen_messages
    from jauspy.messages import registry

    counts: Counter[tuple[str, str]] = Counter()
    start = end = None
    problem = ""
    with path.open("rb") as opened:
        try:
            for seen in seen_messages(CaptureReader(opened, name=str(path), port=None), registry, copies=True):
                counts[seen.name, str(seen.part.packet.source)] += 1
                start, end = (seen.time if start is None else start), seen.time
        except ConfigError as error:
            if not counts:
                raise
            problem = str(error)
            console.note(problem)
    rows = [{"message": name, "source": source, "count": count} for (name, source), count in counts.most_common()]
    return {
        "file": str(path),
        "bytes": path.stat().st_size,
        "complete": not problem,
        "start": start,
        "end": end,
        "messages": rows,
    }
