"""Point clouds as bytes and as files."""

from __future__ import annotations

import struct
from pathlib import Path

import pytest

from jauspy.cloud.stream import Cloud, decode, save
from jauspy.errors import ConfigError, DecodeError

POINTS = struct.pack("<6f", 1.0, 2.0, 3.0, -1.0, 0.5, 0.25)
COLOURED = struct.pack("<6f", 1.0, 2.0, 3.0, 1.0, 0.5, 0.0)


def test_bytes_match_the_documented_table() -> None:
    data = Cloud(POINTS, "lidar_link", 1700000000.5, 3, 0xDEADBEEF, 7).encode()
    header = "4a504331 0300 0a00 02000000 efbeadde 0700000000000000 00002040fc54d941"
    assert data[:32] == bytes.fromhex(header)
    assert data[32:42] == b"lidar_link"
    assert data[42:] == POINTS


@pytest.mark.parametrize("cloud", [Cloud(POINTS, "a", 1.0), Cloud(COLOURED, "ü", 2.0, 6, 1, 2), Cloud(b"", "", 0.0)])
def test_encoded_cloud_decodes_to_the_same(cloud: Cloud) -> None:
    assert decode(cloud.encode()) == cloud


def test_rows_are_numbers() -> None:
    assert Cloud(POINTS, "a", 0.0).rows() == [(1.0, 2.0, 3.0), (-1.0, 0.5, 0.25)]
    assert len(Cloud(COLOURED, "a", 0.0, 6)) == 1


@pytest.mark.parametrize(
    ("damage", "said"),
    [
        (lambda data: b"", "not a point cloud"),
        (lambda data: b"X" + data[1:], "not a point cloud"),
        (lambda data: data[:-1], "the header says"),
        (lambda data: data + b"\0", "the header says"),
        (lambda data: data[:4] + b"\x05\0" + data[6:], "of 3 or 6"),
        (lambda data: data[:8] + b"\xff\xff\xff\xff" + data[12:], "4294967295 points"),
        (lambda data: data[:32] + b"\xff" + data[33:], "not UTF-8"),
    ],
)
def test_damaged_message_error_names_the_problem(damage, said: str) -> None:
    with pytest.raises(DecodeError, match=said):
        decode(damage(Cloud(POINTS, "a", 0.0).encode()))


def test_incomplete_points_are_rejected() -> None:
    with pytest.raises(ValueError, match="13 bytes are no points of 3"):
        Cloud(b"\0" * 13, "a", 0.0).encode()


def test_the_name_of_a_frame_stays_in_its_line(tmp_path: Path) -> None:
    """A publisher does not write the header."""
    save(Cloud(COLOURED, "a\nelement vertex 9\r\x1b[2Jé", 0.0, 6), tmp_path / "a.ply")
    header, _, _ = (tmp_path / "a.ply").read_bytes().partition(b"end_header\n")
    assert header.count(b"\nelement") == 1
    assert b"comment frame a\\nelement vertex 9\\r\\x1b[2J\\xe9\n" in header


def test_ply(tmp_path: Path) -> None:
    save(Cloud(COLOURED, "lidar_link", 0.0, 6), tmp_path / "a.ply")
    header, _, body = (tmp_path / "a.ply").read_bytes().partition(b"end_header\n")
    assert b"element vertex 1\n" in header
    assert header.count(b"property uchar") == 3
    assert struct.unpack("<3f3B", body) == (1.0, 2.0, 3.0, 255, 128, 0)


def test_pcd(tmp_path: Path) -> None:
    save(Cloud(POINTS, "lidar_link", 0.0), tmp_path / "a.pcd")
    header, _, body = (tmp_path / "a.pcd").read_bytes().partition(b"DATA binary\n")
    assert b"FIELDS x y z\nSIZE 4 4 4\n" in header
    assert b"POINTS 2\n" in header
    assert body == POINTS


def test_other_file_types_are_rejected(tmp_path: Path) -> None:
    with pytest.raises(ConfigError, match=r"written as \.pcd or \.ply"):
        save(Cloud(POINTS, "a", 0.0), tmp_path / "a.xyz")
    with pytest.raises(ConfigError, match="cannot be written: No such file"):
        save(Cloud(POINTS, "a", 0.0), tmp_path / "nowhere" / "a.ply")
