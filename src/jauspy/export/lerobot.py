"""Data sets for learning from teleoperated runs, in LeRobot's format v3.0: one run is one episode.

Layout: https://huggingface.co/docs/lerobot/lerobot-dataset-v3. Import it after `extra.need_video`.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fnmatch import fnmatchcase
from fractions import Fraction
from pathlib import Path
from typing import Any, Final, TypeAlias

import av
import numpy as np
import pyarrow as pa
from av.video.stream import VideoStream
from numpy.typing import NDArray
from pyarrow import parquet

from jauspy.codec.field_paths import leaves
from jauspy.codec.rounding import rounded_dict
from jauspy.errors import ConfigError
from jauspy.export.films import pictures
from jauspy.export.rtp_streams import RecordedPicture
from jauspy.export.tables import make_folder
from jauspy.inspection.traffic import SeenMessage
from jauspy.video.h264 import H264Decoder

Floats: TypeAlias = NDArray[np.float64]
Image: TypeAlias = NDArray[np.uint8]

STATE: Final = (
    "ReportJointPositions",
    "ReportPanTiltJointPositions",
    "ReportEndEffectorPose",
    "ReportEndEffectorEffort",
    "ReportServoState",
    "ReportLocalPose",
    "ReportVelocityState",
)
"""Messages whose numbers are the observation, if they are recorded."""
ACTION: Final = (
    "SetJointPositions",
    "SetJointVelocity",
    "SetJointVelocities",
    "SetJointEffort",
    "SetJointEfforts",
    "SetPanTiltJoint*",
    "SetEndEffectorPose",
    "SetEndEffectorVelocityState",
    "SetEndEffectorEffort",
    "SetServoTarget",
    "SetWrenchEffort",
    "SetVelocityCommand",
)
"""Messages whose numbers are the action."""
NO_MEASUREMENTS: Final = ("time_stamp", "request_id")
"""First parts of the paths of numbers that are no measurements."""
VERSION: Final = "v3.0"
FILE: Final = "chunk-000/file-000"
"""All episodes are in the first file of each kind; LeRobot reads files of any size."""
MAX_SAMPLES: Final = 5_000_000
"""Messages of a run whose numbers are used."""
RESOLUTION: Final = 1e-6
"""Seconds by which what was received may be newer than its frame: times since 1970 are rounded to a quarter of it."""
SAMPLED_IMAGES: Final = 100
"""Images of an episode from which statistics are made."""
QUANTILES: Final = {"q01": 0.01, "q10": 0.1, "q50": 0.5, "q90": 0.9, "q99": 0.99}
CODEC: Final = {"crf": "23", "g": "2", "preset": "fast"}
"""Each second picture is a key picture, since training reads pictures in any order."""


@dataclass(frozen=True, slots=True)
class DatasetSettings:
    """What is in a data set; `state` and `action` are names of messages, with wildcards."""

    fps: int = 10
    task: str = "teleoperation"
    state: tuple[str, ...] = STATE
    action: tuple[str, ...] = ACTION


@dataclass(frozen=True, slots=True)
class Dataset:
    """What was written."""

    episodes: int
    frames: int
    state: tuple[str, ...]
    action: tuple[str, ...]
    cameras: tuple[str, ...]


@dataclass(slots=True)
class _Signal:
    """The numbers of one kind of message of one component."""

    times: list[float] = field(default_factory=list)
    rows: list[dict[str, float]] = field(default_factory=list)

    @property
    def columns(self) -> list[str]:
        """The numbers that all of the messages have."""
        return [name for name in self.rows[0] if all(name in row for row in self.rows)]


@dataclass(slots=True)
class _Run:
    """One recording."""

    path: Path
    state: dict[str, _Signal] = field(default_factory=dict)
    action: dict[str, _Signal] = field(default_factory=dict)
    cameras: dict[str, tuple[float, float]] = field(default_factory=dict)
    """When the first picture came that decodes alone, and the last one."""
    grid: Floats = field(default_factory=lambda: np.empty(0))
    """The times of the frames."""


def export_lerobot(
    runs: Mapping[Path, Iterable[SeenMessage]], folder: Path, settings: DatasetSettings = DatasetSettings()
) -> Dataset:
    """Write a data set of recordings into a new folder.

    A frame has the newest state, command and pictures that were received by its time. An episode begins when there is
    one of each, and ends with the first of them that ends, commands excepted: the last one stays. Raises `ConfigError`
    if something is in none of the runs, or not in all.
    """
    found = [_read(path, messages, settings) for path, messages in runs.items()]
    state, action = (_common_columns(found, kind) for kind in ("state", "action"))
    cameras = tuple(sorted(set.intersection(*(set(run.cameras) for run in found))))
    for run in found:
        run.grid = _grid(run, cameras, settings.fps)
    make_folder(folder)
    episodes = [_Episode(number, run, state, action) for number, run in enumerate(found)]
    for camera in cameras:
        _write_video(folder, camera, episodes, settings.fps)
    _write_data(folder, episodes)
    _write_tasks(folder, settings.task)
    _write_episodes(folder, episodes, cameras, settings)
    _write_info(folder, episodes, state, action, settings)
    frames = sum(len(episode.grid) for episode in episodes)
    return Dataset(len(episodes), frames, tuple(state), tuple(action), cameras)


# --- reading ----------------------------------------------------------------------------------------------------------


def _read(path: Path, messages: Iterable[SeenMessage], settings: DatasetSettings) -> _Run:
    run, count = _Run(path), 0
    for seen in messages:
        message, packet = seen.part.content.message, seen.part.packet
        if message is None:
            continue
        if any(fnmatchcase(message.NAME, name) for name in settings.state):
            signals, component = run.state, packet.source
        elif any(fnmatchcase(message.NAME, name) for name in settings.action):
            signals, component = run.action, packet.destination  # clients have other ids in each run
        else:
            continue
        numbers = _numbers(rounded_dict(message))
        if not numbers:
            continue
        count += 1
        if count > MAX_SAMPLES:
            raise ConfigError(f"{path} has more than {MAX_SAMPLES} messages of state and action; choose some of them")
        signal = signals.setdefault(f"{component}.{message.NAME}", _Signal())
        signal.times.append(seen.time)
        signal.rows.append(numbers)
    for recorded in pictures(path):
        first, _ = run.cameras.get(recorded.camera, (math.nan, math.nan))
        if recorded.camera not in run.cameras and not (recorded.picture.is_idr and recorded.picture.whole):
            continue
        run.cameras[recorded.camera] = (recorded.time if math.isnan(first) else first), recorded.time
    return run


def _numbers(values: Mapping[str, Any]) -> dict[str, float]:
    """The finite numbers of a message by their paths."""
    found = {}
    for path, value in leaves(values):
        is_number = isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)
        if is_number and path.partition(".")[0] not in NO_MEASUREMENTS:
            found[path] = float(value)
    return found


def _common_columns(runs: Sequence[_Run], kind: str) -> list[str]:
    """The columns that are in all runs; raises `ConfigError` if there are none."""
    columns: list[list[str]] = []
    for run in runs:
        signals: dict[str, _Signal] = getattr(run, kind)
        columns.append([f"{name}.{column}" for name, signal in sorted(signals.items()) for column in signal.columns])
        if not columns[-1]:
            raise ConfigError(f"{run.path} has no message for --{kind}; see `jauspy info` and name one that it has")
    common = set.intersection(*map(set, columns))
    if not common:
        raise ConfigError(f"the recordings have nothing in common for --{kind}: other robots, or other messages")
    return [name for name in columns[0] if name in common]


def _grid(run: _Run, cameras: Sequence[str], fps: int) -> Floats:
    """The times of the frames of a run."""
    signals = (*run.state.values(), *run.action.values())
    start = max([*(signal.times[0] for signal in signals), *(run.cameras[camera][0] for camera in cameras)])
    end = min([*(signal.times[-1] for signal in run.state.values()), *(run.cameras[camera][1] for camera in cameras)])
    count = math.floor((end - start) * fps) + 1
    if count < 2:
        raise ConfigError(
            f"{run.path}: state, commands and pictures do not overlap: all have begun {start - end:.1f} s after the "
            "first has ended; choose messages with --state and --action"
        )
    return start + np.arange(count) / fps


def _sampled(signals: Mapping[str, _Signal], columns: Sequence[str], grid: Floats) -> Floats:
    """The newest values at each time, a row for each."""
    found = {}
    for name, signal in signals.items():
        newest = np.searchsorted(np.asarray(signal.times), grid + RESOLUTION, side="right") - 1
        for column in signal.columns:
            values = np.asarray([row[column] for row in signal.rows])
            found[f"{name}.{column}"] = values[np.maximum(newest, 0)]
    return np.stack([found[name] for name in columns], axis=1)


class _Episode:
    """The frames of one run."""

    def __init__(self, number: int, run: _Run, state: Sequence[str], action: Sequence[str]) -> None:
        self.number, self.path, self.grid = number, run.path, run.grid
        self.vectors = {
            "observation.state": _sampled(run.state, state, run.grid).astype(np.float32),
            "action": _sampled(run.action, action, run.grid).astype(np.float32),
        }
        self.images: dict[str, _ImageStatistics] = {}

    def statistics(self) -> dict[str, dict[str, Any]]:
        """Statistics of each feature."""
        found = {name: _statistics([values]) for name, values in self.vectors.items()}
        return found | {_key(camera): images.summary() for camera, images in self.images.items()}


def _statistics(parts: Sequence[NDArray[np.float32]]) -> dict[str, Any]:
    values = np.concatenate(parts).astype(np.float64)
    found = {"min": values.min(0), "max": values.max(0), "mean": values.mean(0), "std": values.std(0)}
    found |= {name: np.quantile(values, part, axis=0) for name, part in QUANTILES.items()}
    return {name: each.tolist() for name, each in found.items()} | {"count": [len(values)]}


class _ImageStatistics:
    """Statistics of the colours of images, from 0 to 1."""

    def __init__(self) -> None:
        self.count, self.pixels = 0, 0
        self.least, self.most = np.ones(3), np.zeros(3)
        self.sum, self.squares = np.zeros(3), np.zeros(3)

    def add(self, image: Image) -> None:
        """Add an image."""
        colours = image.reshape(-1, 3) / 255.0
        self.count, self.pixels = self.count + 1, self.pixels + len(colours)
        self.least, self.most = np.minimum(self.least, colours.min(0)), np.maximum(self.most, colours.max(0))
        self.sum, self.squares = self.sum + colours.sum(0), self.squares + (colours**2).sum(0)

    def __add__(self, other: _ImageStatistics) -> _ImageStatistics:
        both = _ImageStatistics()
        both.count, both.pixels = self.count + other.count, self.pixels + other.pixels
        both.least, both.most = np.minimum(self.least, other.least), np.maximum(self.most, other.most)
        both.sum, both.squares = self.sum + other.sum, self.squares + other.squares
        return both

    def summary(self) -> dict[str, Any]:
        """Of the shape (3, 1, 1), as LeRobot has it."""
        mean = self.sum / max(1, self.pixels)
        deviation = np.sqrt(np.maximum(0.0, self.squares / max(1, self.pixels) - mean**2))
        found = {"min": self.least, "max": self.most, "mean": mean, "std": deviation}
        return {name: each.reshape(3, 1, 1).tolist() for name, each in found.items()} | {"count": [self.count]}


# --- video ------------------------------------------------------------------------------------------------------------


def _key(camera: str) -> str:
    return f"observation.images.{camera.replace('.', '_')}"


def _write_video(folder: Path, camera: str, episodes: Sequence[_Episode], fps: int) -> None:
    """One file with the frames of all episodes, encoded again: one picture for each frame."""
    path = folder / "videos" / _key(camera) / f"{FILE}.mp4"
    path.parent.mkdir(parents=True)
    with av.open(str(path), "w") as container:
        stream = container.add_stream("libx264", rate=fps, options=CODEC)
        assert isinstance(stream, VideoStream)
        stream.codec_context.max_b_frames = 0
        stream.pix_fmt = "yuv420p"
        stream.width = stream.height = 0
        count = 0
        for episode in episodes:
            statistics = episode.images.setdefault(camera, _ImageStatistics())
            step = max(1, len(episode.grid) // SAMPLED_IMAGES)
            recorded = (picture for picture in pictures(episode.path) if picture.camera == camera)
            for number, image in enumerate(_held(recorded, episode.grid)):
                if not stream.width:
                    stream.height, stream.width = (size - size % 2 for size in image.shape[:2])
                if number % step == 0:
                    statistics.add(image)
                frame = av.VideoFrame.from_ndarray(image, format="rgb24")
                frame = frame.reformat(width=stream.width, height=stream.height, format="yuv420p")
                frame.pts, frame.time_base = count, Fraction(1, fps)
                container.mux(stream.encode(frame))
                count += 1
        container.mux(stream.encode(None))


def _held(recorded: Iterable[RecordedPicture], grid: Floats) -> Iterator[Image]:
    """The newest image at each time of the grid; before the first one, the first."""
    decoder, newest, at = H264Decoder(), None, 0
    for picture in recorded:
        image = decoder.decode(picture.picture)
        if image is None:
            continue
        newest = image if newest is None else newest
        while at < len(grid) and grid[at] + RESOLUTION < picture.time:
            yield np.asarray(newest)
            at += 1
        newest = image
        if at == len(grid):
            return
    if newest is None:
        raise ConfigError("the pictures of a camera cannot be decoded; leave its recording out")
    for _ in range(at, len(grid)):
        yield np.asarray(newest)


# --- files ------------------------------------------------------------------------------------------------------------


def _write_data(folder: Path, episodes: Sequence[_Episode]) -> None:
    columns: dict[str, Any] = {}
    for name in episodes[0].vectors:
        values = np.concatenate([episode.vectors[name] for episode in episodes])
        columns[name] = pa.FixedSizeListArray.from_arrays(pa.array(values.reshape(-1)), values.shape[1])
    times = [(episode.grid - episode.grid[0]).astype(np.float32) for episode in episodes]
    lengths = [len(episode.grid) for episode in episodes]
    total = sum(lengths)
    columns["timestamp"] = pa.array(np.concatenate(times))
    columns["frame_index"] = pa.array(np.concatenate([np.arange(length) for length in lengths]))
    columns["episode_index"] = pa.array(np.repeat([episode.number for episode in episodes], lengths))
    columns["index"] = pa.array(np.arange(total))
    columns["task_index"] = pa.array(np.zeros(total, np.int64))
    _write_table(folder / "data" / f"{FILE}.parquet", pa.table(columns))


def _write_tasks(folder: Path, task: str) -> None:
    """The tasks as pandas writes them: their texts are the index."""
    entry = {"pandas_type": "int64", "numpy_type": "int64", "metadata": None}
    text = {"pandas_type": "unicode", "numpy_type": "object", "metadata": None}
    names = {"name": None, "field_name": None, **text, "metadata": {"encoding": "UTF-8"}}
    metadata = {
        "index_columns": ["task"],
        "column_indexes": [names],
        "columns": [
            {"name": "task_index", "field_name": "task_index", **entry},
            {"name": "task", "field_name": "task", **text},
        ],
        "creator": {"library": "pyarrow", "version": pa.__version__},
        "pandas_version": "2.0.0",
    }
    table = pa.table({"task_index": pa.array([0], pa.int64()), "task": pa.array([task])})
    _write_table(folder / "meta/tasks.parquet", table.replace_schema_metadata({"pandas": json.dumps(metadata)}))


def _write_episodes(
    folder: Path, episodes: Sequence[_Episode], cameras: Sequence[str], settings: DatasetSettings
) -> None:
    rows, begin = [], 0
    for episode in episodes:
        length = len(episode.grid)
        row: dict[str, Any] = {
            "episode_index": episode.number,
            "tasks": [settings.task],
            "length": length,
            "data/chunk_index": 0,
            "data/file_index": 0,
            "dataset_from_index": begin,
            "dataset_to_index": begin + length,
            "meta/episodes/chunk_index": 0,
            "meta/episodes/file_index": 0,
        }
        for key in map(_key, cameras):
            row |= {f"videos/{key}/chunk_index": 0, f"videos/{key}/file_index": 0}
            row[f"videos/{key}/from_timestamp"] = begin / settings.fps
            row[f"videos/{key}/to_timestamp"] = (begin + length) / settings.fps
        for feature, statistics in episode.statistics().items():
            row |= {f"stats/{feature}/{name}": values for name, values in statistics.items()}
        rows.append(row)
        begin += length
    _write_table(folder / "meta/episodes" / f"{FILE}.parquet", pa.Table.from_pylist(rows))


def _write_info(
    folder: Path, episodes: Sequence[_Episode], state: Sequence[str], action: Sequence[str], settings: DatasetSettings
) -> None:
    scalar = {"dtype": "int64", "shape": [1], "names": None}
    features: dict[str, Any] = {
        "observation.state": {"dtype": "float32", "shape": [len(state)], "names": list(state)},
        "action": {"dtype": "float32", "shape": [len(action)], "names": list(action)},
        "timestamp": {**scalar, "dtype": "float32"},
        **dict.fromkeys(("frame_index", "episode_index", "index", "task_index"), scalar),
    }
    total = {name: _statistics([episode.vectors[name] for episode in episodes]) for name in episodes[0].vectors}
    for camera in episodes[0].images:
        features[_key(camera)] = _video_feature(folder / "videos" / _key(camera) / f"{FILE}.mp4", settings.fps)
        images = _ImageStatistics()
        for episode in episodes:
            images += episode.images[camera]
        total[_key(camera)] = images.summary()
    info = {
        "codebase_version": VERSION,
        "robot_type": "jaus",
        "total_episodes": len(episodes),
        "total_frames": sum(len(episode.grid) for episode in episodes),
        "total_tasks": 1,
        "chunks_size": 1000,
        "data_files_size_in_mb": 100,
        "video_files_size_in_mb": 200,
        "fps": settings.fps,
        "splits": {"train": f"0:{len(episodes)}"},
        "data_path": "data/chunk-{chunk_index:03d}/file-{file_index:03d}.parquet",
        "video_path": "videos/{video_key}/chunk-{chunk_index:03d}/file-{file_index:03d}.mp4",
        "features": features,
    }
    (folder / "meta/info.json").write_text(json.dumps(info, indent=2), encoding="utf-8")
    (folder / "meta/stats.json").write_text(json.dumps(total, indent=2), encoding="utf-8")


def _video_feature(path: Path, fps: int) -> dict[str, Any]:
    with av.open(str(path)) as container:
        video = container.streams.video[0]
        size = {"video.height": video.height, "video.width": video.width}
        kind = {"video.codec": video.codec.canonical_name, "video.pix_fmt": video.pix_fmt, "video.is_depth_map": False}
        info = {**size, **kind, "video.fps": fps, "video.channels": 3, "has_audio": False}
        shape = [video.height, video.width, 3]
    return {"dtype": "video", "shape": shape, "names": ["height", "width", "channels"], "info": info}


def _write_table(path: Path, table: Any) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    parquet.write_table(table, path)
