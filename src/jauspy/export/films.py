"""Video in recordings: H.264 as RTP in captures, and as channels of foxglove.CompressedVideo in MCAP files."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, BinaryIO, Final

from jauspy.codec.names import unique
from jauspy.codec.registry import Registry
from jauspy.errors import ConfigError, ProtocolError
from jauspy.export.rtp_streams import UNSAFE, RecordedPicture, RtpStreams
from jauspy.export.tables import MAX_NAME, make_folder
from jauspy.recording.mcap_capture import open_capture_file
from jauspy.recording.mcap_records import MAGIC, mcap_records
from jauspy.video.h264_payload import PPS, SPS, Picture, nal_type, split_nals
from jauspy.video.rtp import CLOCK_RATE

if TYPE_CHECKING:
    from jauspy.video.recorder import Recorder

VIDEO_SCHEMA: Final = "foxglove.CompressedVideo"
H264: Final = "h264"


def pictures(path: Path, registry: Registry | None = None) -> Iterator[RecordedPicture]:
    """The pictures in a recording, in the order of their ends; raises `ConfigError`.

    With a registry, RTP streams have the ids of the cameras that the messages of the recording name.
    """
    streams = RtpStreams(registry)
    try:
        with path.open("rb") as file:
            if file.peek(len(MAGIC)).startswith(MAGIC):
                yield from _channel_pictures(path)
            for datagram in open_capture_file(file, name=str(path), port=None):
                yield from streams.feed(datagram)
    except OSError as error:
        raise ConfigError(f"{path} cannot be read: {error.strerror}") from None


def _channel_pictures(path: Path) -> Iterator[RecordedPicture]:
    """The pictures of the channels with video; raises `ConfigError` for a damaged file."""
    try:
        with path.open("rb") as file:
            yield from _decoded_channels(file)
    except (ConfigError, OSError):
        raise
    except Exception as error:  # noqa: BLE001 - what a parser of others raises for damaged files is not listed
        raise ConfigError(f"{path} is damaged: {str(error) or type(error).__name__}") from None


def _decoded_channels(file: BinaryIO) -> Iterator[RecordedPicture]:
    """The pictures of all channels; their clock is the time stamp of each message, else its log time."""
    from mcap.records import Channel, Message, Schema  # noqa: PLC0415 - of the extra `recording`

    video: set[int] = set()
    cameras: dict[str, str] = {}
    names: dict[int, str] = {}
    for record in mcap_records(file):
        if isinstance(record, Schema) and record.name == VIDEO_SCHEMA:
            video.add(record.id)
        elif isinstance(record, Channel) and record.schema_id in video:
            if record.topic not in cameras:
                cameras[record.topic] = unique(_camera_of(record.topic), lambda name: name in cameras.values())
            names[record.id] = cameras[record.topic]
        elif isinstance(record, Message) and record.channel_id in names:
            format, time, data = compressed_video(record.data)
            if format == H264:
                ticks = (time or record.log_time) * CLOCK_RATE // 1_000_000_000
                picture = Picture(ticks & 0xFFFFFFFF, tuple(split_nals(data)), whole=True)
                yield RecordedPicture(names[record.channel_id], record.log_time / 1e9, picture)


def _camera_of(topic: str) -> str:
    """A topic as a name that is safe in a path."""
    return UNSAFE.sub("-", topic).strip("-.")[:MAX_NAME] or "camera"


# --- foxglove.CompressedVideo -----------------------------------------------------------------------------------------

_TIMESTAMP, _DATA, _FORMAT = 1, 3, 4
"""Fields of the message in protobuf."""
_VARINT, _FIXED64, _LENGTH, _FIXED32 = 0, 1, 2, 5


def compressed_video(data: bytes) -> tuple[str, int, bytes]:
    """Format, time stamp (ns, 0 if there is none) and bytes of a message in protobuf; raises `ProtocolError`."""
    format, time, video = "", 0, b""
    for number, value in protobuf_fields(data):
        if number == _TIMESTAMP and isinstance(value, bytes):
            parts = {inner: part for inner, part in protobuf_fields(value) if isinstance(part, int)}
            time = parts.get(1, 0) * 1_000_000_000 + parts.get(2, 0)
        elif number == _DATA and isinstance(value, bytes):
            video = value
        elif number == _FORMAT and isinstance(value, bytes):
            format = value.decode(errors="replace")
    return format, time, video


def protobuf_fields(data: bytes) -> Iterator[tuple[int, int | bytes]]:
    """Number and value of each field (https://protobuf.dev/programming-guides/encoding)."""
    at = 0
    while at < len(data):
        tag, at = _varint(data, at)
        kind = tag & 7
        if kind == _VARINT:
            value, at = _varint(data, at)
            yield tag >> 3, value
            continue
        if kind == _LENGTH:
            size, at = _varint(data, at)
        elif kind in (_FIXED64, _FIXED32):
            size = 8 if kind == _FIXED64 else 4
        else:
            raise ProtocolError("malformed", f"protobuf with wire type {kind}")
        if at + size > len(data):
            raise ProtocolError("malformed", "protobuf that is cut off")
        yield tag >> 3, data[at : at + size]
        at += size


def _varint(data: bytes, at: int) -> tuple[int, int]:
    value = 0
    for shift in range(0, 70, 7):
        if at >= len(data):
            break
        byte = data[at]
        value |= (byte & 0x7F) << shift
        at += 1
        if byte < 0x80:
            return value, at
    raise ProtocolError("malformed", "protobuf with a number that does not end")


# --- MP4 --------------------------------------------------------------------------------------------------------------


def export_films(path: Path, folder: Path) -> dict[Path, int]:
    """Write an MP4 file of each camera into a new folder, with the pictures as they are; returns pictures by file.

    A film begins with the first picture that can be decoded alone. After a change of the picture's size or parameters
    the next film begins. Raises `ConfigError` if there is no video.
    """
    films: dict[str, _Film] = {}
    try:
        with ExitStack() as stack:
            for recorded in pictures(path):
                film = films.get(recorded.camera)
                if film is None:
                    if not films:
                        make_folder(folder)
                    film = films[recorded.camera] = stack.enter_context(_Film(folder, recorded.camera))
                film.add(recorded.picture)
    except ConfigError as error:
        if any(film.files for film in films.values()):
            raise ConfigError(f"{error}; the video before that is in {folder}") from None
        raise
    written = {file: count for film in films.values() for file, count in film.files.items()}
    if not written:
        if films:
            folder.rmdir()
        raise ConfigError(f"{path} has no H.264 video: RTP in a capture, or {VIDEO_SCHEMA} in an MCAP file")
    return written


class _Film(ExitStack):
    """The files of one camera."""

    def __init__(self, folder: Path, camera: str) -> None:
        super().__init__()
        self.files: dict[Path, int] = {}
        self._folder, self._camera = folder, camera
        self._recorder: Recorder | None = None
        self._path = Path()
        self._parameters: frozenset[bytes] = frozenset()

    def add(self, picture: Picture) -> None:
        """Write a picture, if a film has begun or begins with it."""
        from jauspy.video.recorder import Recorder  # noqa: PLC0415 - of the extra `video`

        parameters = frozenset(unit for unit in picture.nals if nal_type(unit) in {SPS, PPS})
        if self._recorder is not None and parameters and parameters != self._parameters:
            self.close()
            self._recorder = None
        if self._recorder is None:
            if not (picture.is_idr and picture.whole and parameters):
                return
            number = f"-{len(self.files) + 1}" if self.files else ""
            self._path, self._parameters = self._folder / f"{self._camera}{number}.mp4", parameters
            self._recorder = self.enter_context(Recorder(self._path))
        self._recorder.add(picture)
        self.files[self._path] = self._recorder.pictures
