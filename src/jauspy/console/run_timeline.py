"""The timeline of a recorded run (MCAP of `jauspy record`): tracks, values, events, and pictures by time.

`python -m jauspy.console.run_timeline FILE` prints it as JSON: the console reads files of strangers in a process of its
own, which has limits of memory and time. Times are seconds since the beginning of the run; positions are metres in the
local frame of each robot, x forward and y left of where it started (REP-103).
"""

from __future__ import annotations

import os
import resource
import struct
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO, Final

import orjson

from jauspy.capture.dissect import read_message
from jauspy.capture.dissector import Dissector
from jauspy.capture.ip import DatagramAssembler
from jauspy.codec.message import Message
from jauspy.console.reports import fields_of
from jauspy.errors import ConfigError, JausError
from jauspy.export.films import H264, VIDEO_SCHEMA, compressed_video, protobuf_fields
from jauspy.geometry.poses import Pose, jaus_pose
from jauspy.messages import registry
from jauspy.printable import printable
from jauspy.recording.foxglove_messages import LOG
from jauspy.recording.mcap_records import MAX_CHUNK, chunk_records
from jauspy.recording.mcap_summary import read_summary
from jauspy.recording.run_files import DATAGRAMS, ENCODING
from jauspy.video.h264_payload import IDR, nal_type, split_nals

if TYPE_CHECKING:
    from mcap.records import Channel, ChunkIndex
    from mcap.summary import Summary

MAX_POINTS: Final = 1500
"""Values of a series, evenly spread over the run."""
MAX_SERIES: Final = 400
MAX_TRACK: Final = 5000
"""Points of a robot's track."""
MAX_ROBOTS: Final = 32
MAX_CAMERAS: Final = 16
MAX_PICTURES: Final = 200_000
"""Pictures of a camera whose times are told."""
MAX_EVENTS: Final = 2000
MAX_TEXT: Final = 300
"""Characters of an event."""
MAX_SEGMENT: Final = 16 << 20
"""Bytes of pictures that are read at once."""
MAX_MEMORY: Final = 3 << 30
"""Bytes of addresses of the process that reads a file."""
MAX_CPU_TIME: Final = 300
"""Seconds."""
PICTURE_HEADER: Final = struct.Struct("<IB3xd")
"""Before each picture of `pictures`: its bytes, 1 for one that can be decoded alone, and its time in seconds."""


@dataclass(slots=True)
class _Series:
    name: str
    unit: str
    points: list[tuple[float, float]] = field(default_factory=list)


@dataclass
class Timeline:
    """What a run has; `for_browser` is its JSON."""

    start: float
    """Seconds since 1970, UTC."""
    seconds: float
    tracks: dict[str, list[tuple[float, float, float, float]]] = field(default_factory=dict)
    """Time, x, y and yaw (radians), by component."""
    series: dict[tuple[str, str], _Series] = field(default_factory=dict)
    cameras: dict[str, list[tuple[float, bool]]] = field(default_factory=dict)
    """Times of pictures, and whether each can be decoded alone, by topic."""
    events: list[tuple[float, int, str, str]] = field(default_factory=list)
    """Time, level of foxglove.Log (3 is a warning, 4 an error), component and text."""
    left_out: dict[str, int] = field(default_factory=dict)
    """What was beyond a limit, by its kind."""

    def leave_out(self, kind: str) -> None:
        """Count what is beyond a limit."""
        self.left_out[kind] = self.left_out.get(kind, 0) + 1

    def for_browser(self) -> dict[str, Any]:
        """The timeline as JSON."""
        series = sorted(self.series.values(), key=lambda each: each.name)
        return {
            "start": self.start,
            "seconds": self.seconds,
            "tracks": self.tracks,
            "series": [{"name": each.name, "unit": each.unit, "points": each.points} for each in series],
            "cameras": [
                {"topic": topic, "times": [time for time, _ in pictures], "keys": [int(key) for _, key in pictures]}
                for topic, pictures in self.cameras.items()
            ],
            "events": self.events,
            "left_out": self.left_out,
        }


def read_timeline(path: Path) -> Timeline:
    """The timeline of a recorded run; raises `ConfigError` for a file that is damaged or no MCAP file."""
    with _opened(path) as file:
        summary = _summary(file, path)
        statistics = summary.statistics
        if statistics is None or not statistics.message_count:
            raise ConfigError(f"{path.name} has no messages")
        start, end = statistics.message_start_time, statistics.message_end_time
        timeline = Timeline(start / 1e9, max(0.0, (end - start) / 1e9))
        try:
            _Reader(timeline, summary.channels, _video_topics(summary)).read(_messages(file, summary.chunk_indexes))
        except Exception as error:  # noqa: BLE001 - what a parser of others raises for damaged files is not listed
            raise _damaged(path, error) from None
    return timeline


def pictures(path: Path, topic: str, begin: float, end: float) -> bytes:
    """The pictures of a camera between two times of the run, each after a `PICTURE_HEADER`; at most `MAX_SEGMENT`.

    Raises `ConfigError` for a file that is damaged or no MCAP file.
    """
    with _opened(path) as file:
        summary = _summary(file, path)
        if summary.statistics is None:
            return b""
        start = summary.statistics.message_start_time
        first, last = start + round(begin * 1e9), start + round(end * 1e9)
        wanted = {number for number, name in _video_topics(summary).items() if name == topic}
        chunks = [
            chunk
            for chunk in summary.chunk_indexes
            if wanted & chunk.message_index_offsets.keys()
            and chunk.message_end_time >= first
            and chunk.message_start_time < last
        ]
        found, size = list[bytes](), 0
        try:
            for number, time, data in _messages(file, chunks):
                if number not in wanted or not first <= time < last:
                    continue
                format, _, video = compressed_video(data)
                if format == H264:
                    size += len(video)
                    if size > MAX_SEGMENT:
                        break
                    found.append(PICTURE_HEADER.pack(len(video), _is_key(video), (time - start) / 1e9) + video)
        except Exception as error:  # noqa: BLE001 - what a parser of others raises for damaged files is not listed
            raise _damaged(path, error) from None
        return b"".join(found)


def _damaged(path: Path, error: Exception) -> ConfigError:
    return ConfigError(f"{path.name} is damaged: {printable(str(error) or type(error).__name__)[:200]}")


def _opened(path: Path) -> BinaryIO:
    try:
        return os.fdopen(os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK), "rb")
    except OSError as error:
        raise ConfigError(f"{path.name} cannot be read: {error.strerror}") from None


def _summary(file: BinaryIO, path: Path) -> Summary:
    """The summary with the index of chunks; raises `ConfigError`."""
    read_summary(file, path.name)  # says why a file has none
    from mcap.reader import SeekingReader  # noqa: PLC0415 - of the extra `recording`

    file.seek(0)
    try:
        found = SeekingReader(file, record_size_limit=MAX_CHUNK).get_summary()
    except Exception as error:  # noqa: BLE001 - what a parser of others raises for damaged files is not listed
        raise _damaged(path, error) from None
    assert found is not None, "`read_summary` has found one"
    found.chunk_indexes.sort(key=lambda chunk: chunk.message_start_time)
    return found


def _messages(file: BinaryIO, chunks: Sequence[ChunkIndex]) -> Iterator[tuple[int, int, bytes]]:
    """Channel, time (ns) and data of the messages in these chunks; raises what the parser raises."""
    from mcap.data_stream import ReadDataStream  # noqa: PLC0415 - of the extra `recording`
    from mcap.records import Chunk, Message as McapMessage  # noqa: PLC0415

    for index in chunks:
        if index.chunk_length > MAX_CHUNK or index.uncompressed_size > MAX_CHUNK:
            raise ValueError(f"a chunk of {max(index.chunk_length, index.uncompressed_size)} bytes")
        file.seek(index.chunk_start_offset)
        stream = ReadDataStream(file)
        if stream.read1() != 0x06 or stream.read8() > MAX_CHUNK:
            raise ValueError(f"no chunk at {index.chunk_start_offset}")
        for record in chunk_records(Chunk.read(stream)):
            if isinstance(record, McapMessage):
                yield record.channel_id, record.log_time, record.data


def _video_topics(summary: Summary) -> dict[int, str]:
    """The topics with video, by channel."""
    schemas = {number for number, schema in summary.schemas.items() if schema.name == VIDEO_SCHEMA}
    return {number: channel.topic for number, channel in summary.channels.items() if channel.schema_id in schemas}


def _is_key(video: bytes) -> bool:
    return any(nal_type(nal) == IDR for nal in split_nals(video) if nal)


class _Reader:
    """Fills a timeline from the messages of a file."""

    def __init__(self, timeline: Timeline, channels: dict[int, Channel], video: dict[int, str]) -> None:
        self._timeline = timeline
        self._video = video
        self._datagrams = {
            number
            for number, channel in channels.items()
            if (channel.topic, channel.message_encoding) == (DATAGRAMS, ENCODING)
        }
        self._log = {number for number, channel in channels.items() if channel.topic == LOG}
        self._dissector = Dissector(registry)
        self._assembler = DatagramAssembler()
        self._next: dict[tuple[str, str], float] = {}
        self._step = timeline.seconds / MAX_POINTS
        self._track_step = timeline.seconds / MAX_TRACK

    def read(self, messages: Iterator[tuple[int, int, bytes]]) -> None:
        """Read all messages: channel, time (ns) and data."""
        for channel, nanoseconds, data in messages:
            time = round(nanoseconds / 1e9 - self._timeline.start, 4)
            if channel in self._datagrams:
                for datagram in self._assembler.add(data):
                    self._take_datagram(time, datagram.payload)
            elif channel in self._video:
                self._take_picture(time, self._video[channel], data)
            elif channel in self._log:
                self._take_event(time, data)

    def _take_datagram(self, time: float, payload: bytes) -> None:
        for part in self._dissector.dissect(payload, self._timeline.start + time).parts:
            message = part.content.message
            if message is None:
                continue
            inside = getattr(message, "report_message", None)  # of an event
            if isinstance(inside, bytes):
                inside = read_message(inside, registry).message
            report = inside if isinstance(inside, Message) else message
            if report.NAME.startswith("Report"):
                self._take_report(time, str(part.packet.source), report)

    def _take_report(self, time: float, source: str, report: Message) -> None:
        if report.NAME == "ReportLocalPose":
            self._take_pose(time, source, report)
        key = (source, report.NAME)
        if time < self._next.get(key, 0.0):
            return
        self._next[key] = time + 0.9 * self._step
        timeline = self._timeline
        for each in fields_of(report):
            if each.number is None:
                continue
            name = f"{source} {report.NAME.removeprefix('Report')}.{each.path}"
            series = timeline.series.get((source, name))
            if series is None:
                if len(timeline.series) >= MAX_SERIES:
                    timeline.leave_out("values of further fields")
                    continue
                series = timeline.series[source, name] = _Series(printable(name), each.unit)
            series.points.append((time, each.number))

    def _take_pose(self, time: float, source: str, report: Any) -> None:
        if report.x is None or report.y is None:
            return
        track = self._timeline.tracks.get(source)
        if track is None:
            if len(self._timeline.tracks) >= MAX_ROBOTS:
                self._timeline.leave_out("poses of further robots")
                return
            track = self._timeline.tracks[source] = []
        if not track or time - track[-1][0] >= 0.9 * self._track_step:
            pose = jaus_pose(Pose(x=report.x, y=report.y, yaw=report.yaw or 0.0))
            track.append((time, round(pose.x, 3), round(pose.y, 3), round(pose.yaw, 4)))

    def _take_picture(self, time: float, topic: str, data: bytes) -> None:
        cameras = self._timeline.cameras
        if topic not in cameras and len(cameras) >= MAX_CAMERAS:
            self._timeline.leave_out("pictures of further cameras")
            return
        times = cameras.setdefault(topic, [])
        format, _, video = compressed_video(data)
        if format != H264 or len(times) >= MAX_PICTURES:
            self._timeline.leave_out("pictures")
            return
        times.append((time, _is_key(video)))

    def _take_event(self, time: float, data: bytes) -> None:
        """Take a line of foxglove.Log: level, text and name are its fields 2, 3 and 4."""
        values = dict(protobuf_fields(data))
        level, text, name = (values.get(number) for number in (2, 3, 4))
        if len(self._timeline.events) >= MAX_EVENTS:
            self._timeline.leave_out("events")
            return
        self._timeline.events.append((time, level if isinstance(level, int) else 0, _text(name), _text(text)))


def _text(part: object) -> str:
    return printable(part.decode(errors="replace"))[:MAX_TEXT] if isinstance(part, bytes) else ""


def main() -> int:
    """Print the timeline of a file as JSON, or `{"problem": "..."}`."""
    os.nice(10)
    resource.setrlimit(resource.RLIMIT_AS, (MAX_MEMORY, MAX_MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (MAX_CPU_TIME, MAX_CPU_TIME))
    try:
        content: dict[str, Any] = read_timeline(Path(sys.argv[1])).for_browser()
    except JausError as error:
        content = {"problem": str(error)}
    except MemoryError:
        content = {"problem": f"{Path(sys.argv[1]).name} needs more memory than the console gives it"}
    sys.stdout.buffer.write(orjson.dumps(content))
    return 0


if __name__ == "__main__":
    sys.exit(main())
