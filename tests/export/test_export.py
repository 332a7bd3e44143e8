"""Exports are read back by the libraries of others: csv, pyarrow, PyAV, mcap, and against LeRobot's format."""

from __future__ import annotations

import csv
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import av
import numpy as np
import pytest
from tests.export.conftest import HEIGHT, RATE, SECONDS, START, WIDTH, picture
from typer.testing import CliRunner

from jauspy.capture.reader import CaptureReader
from jauspy.cli.main import app
from jauspy.errors import ProtocolError
from jauspy.export.films import compressed_video

parquet = pytest.importorskip("pyarrow.parquet", reason="pyarrow is of the extra `export`")
RunFile = Callable[..., Path]
PICTURES = int(SECONDS * RATE)


def run(*arguments: object, status: int = 0) -> Any:
    result = CliRunner().invoke(app, ["export", *map(str, arguments)])
    assert result.exit_code == status, result.output
    return result


def csv_rows(path: Path) -> list[dict[str, str]]:
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


def test_csv_has_a_table_of_each_sender_and_message(run_file: RunFile, tmp_path: Path) -> None:
    assert "91 messages in 4 files" in run(run_file(), "--csv").stderr
    folder = tmp_path / "run-csv"
    assert sorted(path.name for path in folder.iterdir()) == [
        "101.1.103_ReportIdentification.csv",
        "101.1.103_ReportJointPositions.csv",
        "42.1.1_SetEndEffectorEffort.csv",
        "42.1.1_SetJointPositions.csv",
    ]
    rows = csv_rows(folder / "101.1.103_ReportJointPositions.csv")
    assert len(rows) == 30
    assert float(rows[7]["time"]) == pytest.approx(START + 0.7, abs=1e-4)
    assert float(rows[7]["joint_position_list[0].joint_position.value"]) == pytest.approx(0.07, abs=1e-6)
    assert (rows[7]["joint_position_list[1].joint_position.choice"], rows[7]["destination"]) == ("RADIAN", "42.1.1")


def test_text_of_the_network_is_no_formula_in_csv(run_file: RunFile, tmp_path: Path) -> None:
    recording = run_file()
    run(recording, "--csv")
    run(recording, "--parquet")
    name = "101.1.103_ReportIdentification"
    assert csv_rows(tmp_path / f"run-csv/{name}.csv")[0]["identification"] == "'=HYPERLINK(1)"
    table = parquet.read_table(tmp_path / f"run-parquet/{name}.parquet")
    assert table["identification"].to_pylist() == ["=HYPERLINK(1)"]


def test_parquet_has_types(run_file: RunFile, tmp_path: Path) -> None:
    run(run_file(), "--parquet", "-o", tmp_path / "tables", "--filter", "msg == ReportJointPositions")
    (path,) = (tmp_path / "tables").iterdir()
    table = parquet.read_table(path)
    types = {name: str(table.schema.field(name).type) for name in table.column_names}
    assert (types["time"], types["sequence"], types["destination"]) == ("double", "int64", "string")
    assert types["joint_position_list[0].joint_position.value"] == "double"
    assert table.num_rows == 30
    assert table.schema.metadata[b"service"].endswith(b"ManipulatorJointPositionSensor")


def frames_of(path: Path) -> list[tuple[float, np.ndarray]]:
    with av.open(str(path)) as container:
        return [(float(frame.time), frame.to_ndarray(format="rgb24")) for frame in container.decode(video=0)]


def test_mp4_has_the_pictures_at_their_times(run_file: RunFile, tmp_path: Path) -> None:
    assert f"{PICTURES} pictures" in run(run_file(), "--mp4").stdout
    frames = frames_of(tmp_path / "run-mp4/10.0.0.1-5004.mp4")
    assert len(frames) == PICTURES
    assert [time for time, _ in frames] == pytest.approx([number / RATE for number in range(PICTURES)], abs=1e-3)
    for number, (_, image) in enumerate(frames):
        assert abs(float(image.mean()) - picture(number).mean()) < 3


def mcap_with_video(path: Path, packets: list[tuple[float, bytes]]) -> None:
    """The same video as Foxglove's library writes it."""
    foxglove = pytest.importorskip("foxglove", reason="foxglove-sdk is of the extra `recording`")
    from foxglove.channels import CompressedVideoChannel
    from foxglove.messages import CompressedVideo, Timestamp

    from jauspy.video.h264_payload import Depacketiser, join_nals
    from jauspy.video.rtp import RtpPacket

    context, depacketiser = foxglove.Context(), Depacketiser()
    writer = foxglove.open_mcap(path, context=context)
    channel = CompressedVideoChannel("/101.1.106/../video", context=context)
    for time, data in packets:
        for found in depacketiser.feed(RtpPacket.decode(data)):
            nanoseconds = round((START + time) * 1e9)
            stamp = Timestamp(sec=nanoseconds // 10**9, nsec=nanoseconds % 10**9)
            message = CompressedVideo(timestamp=stamp, frame_id="camera", data=join_nals(found.nals), format="h264")
            channel.log(message, log_time=nanoseconds)
    writer.close()


def test_mp4_of_a_channel_of_compressed_video(tmp_path: Path, packets: list[tuple[float, bytes]]) -> None:
    mcap_with_video(tmp_path / "run.mcap", packets)
    run(tmp_path / "run.mcap", "--mp4")
    (path,) = (tmp_path / "run-mp4").iterdir()
    assert path.name == "101.1.106-..-video.mp4"
    frames = frames_of(path)
    assert len(frames) == PICTURES
    assert frames[-1][0] == pytest.approx((PICTURES - 1) / RATE, abs=1e-3)


def test_damaged_mcap_files_are_said_to_be_damaged(tmp_path: Path, packets: list[tuple[float, bytes]]) -> None:
    mcap_with_video(tmp_path / "run.mcap", packets)
    whole = (tmp_path / "run.mcap").read_bytes()
    for place in range(10, len(whole), len(whole) // 9):
        cut = tmp_path / f"cut{place}.mcap"
        cut.write_bytes(whole[:place])
        result = CliRunner().invoke(app, ["export", str(cut), "--mp4"])
        assert "damaged" in result.stderr or f": {PICTURES} pictures" in result.stdout, place  # nothing but the summary
        cut.write_bytes(whole[:place] + b"\xff" * 40 + whole[place + 40 :])
        assert CliRunner().invoke(app, ["export", str(cut), "--mp4", "-o", f"{cut}-2"]).exit_code in {0, 1}


def test_tables_are_bounded(run_file: RunFile, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("jauspy.export.tables.MAX_TABLES", 2)
    monkeypatch.setattr("jauspy.export.tables.MAX_COLUMNS", 4)
    assert "30 42.1.1 SetJointPositions, beyond 2 tables are in no table" in run(run_file(), "--csv").stderr
    assert len(list((tmp_path / "run-csv").iterdir())) == 2
    assert all(len(csv_rows(path)[0]) <= 4 for path in (tmp_path / "run-csv").iterdir())


@pytest.mark.parametrize("data", [b"\x1a\xff", b"\xff" * 20, b"\x0b", b"\x1a\x05ab", b"\x08"])
def test_damaged_protobuf_is_an_error(data: bytes) -> None:
    with pytest.raises(ProtocolError):
        compressed_video(data)


def test_pcapng_of_an_mcap_file(run_file: RunFile, tmp_path: Path) -> None:
    pytest.importorskip("foxglove", reason="foxglove-sdk is of the extra `recording`")
    source, mcap, back = run_file(video=False), tmp_path / "run.mcap", tmp_path / "back.pcapng"
    CliRunner().invoke(app, ["record", str(mcap), "--capture", str(source)])
    run(mcap, "--pcapng", "-o", back, "--filter", "msg == SetJointPositions")
    with source.open("rb") as one, back.open("rb") as two:
        before = [row.payload for row in CaptureReader(one, name="one") if row.payload[13:15] == b"\x02\x06"]
        after = [row.payload for row in CaptureReader(two, name="two")]
    assert after == before
    assert len(after) == 30


# --- LeRobot ----------------------------------------------------------------------------------------------------------


@pytest.fixture
def dataset(run_file: RunFile, tmp_path: Path) -> Path:
    folder = tmp_path / "set"
    runs = run_file("one"), run_file("two", 0.5)
    result = run(*runs, "--lerobot", "-o", folder, "--fps", 5, "--task", "grasp the can")
    assert "2 episodes, 30 frames at 5 Hz" in result.stderr
    assert "camera  10.0.0.1-5004" in result.stdout
    return folder


@pytest.mark.slow
def test_a_data_set_has_the_files_of_lerobot(dataset: Path) -> None:
    files = {str(path.relative_to(dataset)) for path in dataset.rglob("*") if path.is_file()}
    assert files == {
        "meta/info.json",
        "meta/stats.json",
        "meta/tasks.parquet",
        "meta/episodes/chunk-000/file-000.parquet",
        "data/chunk-000/file-000.parquet",
        "videos/observation.images.10_0_0_1-5004/chunk-000/file-000.mp4",
    }
    info = json.loads((dataset / "meta/info.json").read_text())
    assert (info["codebase_version"], info["fps"], info["total_frames"]) == ("v3.0", 5, 30)
    assert info["features"]["observation.images.10_0_0_1-5004"]["shape"] == [HEIGHT, WIDTH, 3]
    assert info["features"]["action"]["names"] == [
        "101.1.103.SetJointPositions.joint_position_list[0].joint_position.value",
        "101.1.103.SetJointPositions.joint_position_list[1].joint_position.value",
        "101.1.104.SetEndEffectorEffort.end_effector_effort",
    ]
    assert set(info["features"]) == {
        *parquet.read_schema(dataset / "data/chunk-000/file-000.parquet").names,
        "observation.images.10_0_0_1-5004",
    }


@pytest.mark.slow
def test_frames_have_the_newest_state_and_command(dataset: Path) -> None:
    rows = parquet.read_table(dataset / "data/chunk-000/file-000.parquet").to_pylist()
    start = 0.05  # the first picture, after the first state and command
    for row in rows:
        time = start + row["frame_index"] / 5
        offset = 0.5 * row["episode_index"]
        newest = np.floor(time * 10 + 1e-6) / 10
        assert row["observation.state"] == pytest.approx([0.1 * newest + offset, -1.0], abs=1e-5)
        assert row["action"] == pytest.approx([0.1 * newest + offset + 0.05, -1.0, newest * 10], abs=0.01)
        assert row["timestamp"] == pytest.approx(row["frame_index"] / 5)
    assert [row["index"] for row in rows] == list(range(30))
    assert [row["episode_index"] for row in rows] == [0] * 15 + [1] * 15


@pytest.mark.slow
def test_pictures_belong_to_frames(dataset: Path) -> None:
    frames = frames_of(dataset / "videos/observation.images.10_0_0_1-5004/chunk-000/file-000.mp4")
    assert [time for time, _ in frames] == pytest.approx([number / 5 for number in range(30)], abs=1e-4)
    for number, (_, image) in enumerate(frames):
        shown = number % 15 * RATE // 5
        assert abs(float(image.mean()) - picture(shown).mean()) < 4
    episodes = parquet.read_table(dataset / "meta/episodes/chunk-000/file-000.parquet").to_pylist()
    key = "videos/observation.images.10_0_0_1-5004"
    assert [(row[f"{key}/from_timestamp"], row["dataset_from_index"], row["length"]) for row in episodes] == [
        (0.0, 0, 15),
        (3.0, 15, 15),
    ]


@pytest.mark.slow
def test_statistics_are_those_of_the_frames(dataset: Path) -> None:
    stats = json.loads((dataset / "meta/stats.json").read_text())
    table = parquet.read_table(dataset / "data/chunk-000/file-000.parquet")
    state = np.array(table["observation.state"].to_pylist())
    assert stats["observation.state"]["mean"] == pytest.approx(state.mean(0).tolist())
    assert stats["observation.state"]["count"] == [30]
    assert np.array(stats["observation.images.10_0_0_1-5004"]["mean"]).shape == (3, 1, 1)


def test_nothing_is_overwritten_and_errors_are_one_sentence(run_file: RunFile, tmp_path: Path) -> None:
    recording, silent = run_file(), run_file("silent", video=False)
    run(recording, "--csv")
    for arguments, problem in (
        ([recording, "--csv"], "exists already"),
        ([recording, "--parquet", "-o", tmp_path / "run-csv"], "exists already"),
        ([recording, recording, "--csv"], "only --lerobot takes several"),
        ([silent, "--mp4"], "has no H.264 video"),
        ([silent, "--pcapng", "-o", tmp_path / "x.mcap"], "does not end in .pcapng"),
        ([silent, "--lerobot", "--action", "SetWrenchEffort"], "has no message for --action"),
        ([tmp_path / "none.pcapng", "--csv"], "cannot be read"),
    ):
        assert problem in run(*arguments, status=1).stderr
    run(recording, status=2)
    run(recording, "--csv", "--mp4", status=2)
    assert not (tmp_path / "silent-mp4").exists()
