"""Golden rows of an independent implementation: values to bytes, bytes to values, bytes to message to bytes."""

from __future__ import annotations

import json
from types import ModuleType
from typing import Any

import pytest

from jauspy.codec import reference, slow_path
from jauspy.codec.message import Message
from jauspy.messages import registry
from jauspy.schema import model as m


def test_values_to_bytes(rows: list[Any], vectors: ModuleType) -> None:
    for row in rows:
        with row.named():
            cls = vectors.find(registry, row)
            assert vectors.to_ours(cls.layout(), row.values).encode() == row.right


def test_bytes_to_values(rows: list[Any], vectors: ModuleType) -> None:
    for row in rows:
        with row.named():
            cls = vectors.find(registry, row)
            expected = vectors.to_ours(cls.layout(), row.values)
            assert vectors.raw_of(cls.layout(), cls.decode(row.right)) == vectors.raw_of(cls.layout(), expected)


def test_bytes_to_message_to_bytes(rows: list[Any], vectors: ModuleType) -> None:
    for row in rows:
        with row.named():
            cls = vectors.find(registry, row)
            for data in (row.theirs, row.right):
                message = cls.decode(data)
                assert message.encode() == data
                assert cls.from_dict(json.loads(json.dumps(message.to_dict()))) == message


def test_slow_path_agrees_with_straight_line_code(rows: list[Any], vectors: ModuleType) -> None:
    for row in rows:
        with row.named():
            cls = vectors.find(registry, row)
            message = cls._unpack(row.right, None)
            assert slow_path.decode(cls, row.right) == message
            assert slow_path.decode_tolerant(cls, row.right) == cls.decode(row.right, strict=False) == (message, [])
            assert message._pack() == slow_path.encode(message, clamp=False, strict=True) == row.right
            assert slow_path.encode(message, clamp=True, strict=False) == row.right


@pytest.mark.slow
def test_reference_agrees(
    rows: list[Any], vectors: ModuleType, models: dict[tuple[str, str, str], m.MessageDefinition]
) -> None:
    for row in rows:
        with row.named():
            check_reference(vectors.find(registry, row), row.right, models)


def check_reference(cls: type[Message], data: bytes, models: dict[tuple[str, str, str], m.MessageDefinition]) -> None:
    model = models[cls.SERVICE, cls.VERSION, cls.NAME]
    values = reference.parse(model, data)
    assert close(plain(cls.decode(data).to_dict()), values)
    assert reference.build(model, values) == data


def plain(value: Any) -> Any:
    """The form of the reference: messages inside messages are bytes."""
    if isinstance(value, dict):
        if "message" in value and "fields" in value:
            return {"hex": registry.from_dict(value).encode().hex()}
        return {key: plain(part) for key, part in value.items()}
    return [plain(part) for part in value] if isinstance(value, list) else value


def close(ours: Any, theirs: Any) -> bool:
    if isinstance(ours, dict) and isinstance(theirs, dict):
        return ours.keys() == theirs.keys() and all(close(ours[key], theirs[key]) for key in ours)
    if isinstance(ours, list) and isinstance(theirs, list):
        return len(ours) == len(theirs) and all(map(close, ours, theirs))
    if isinstance(ours, float) and isinstance(theirs, float):
        return ours == pytest.approx(theirs, rel=1e-12, abs=1e-9)
    return bool(ours == theirs)


OWN_SERVICES = "urn:jauspy:"
"""Beginning of the URNs of services that only this package defines, for which nobody else has rows."""


def test_every_message_of_others_has_a_row(vectors: ModuleType) -> None:
    covered = {(row.code, row.message, row.version) for row in vectors.existing_rows(vectors.COMMITTED)}
    others = [entry for entry in registry.entries if not entry.service.startswith(OWN_SERVICES)]
    assert covered == {(entry.code, entry.name, entry.version) for entry in others}


def test_committed_rows_stay_small(vectors: ModuleType) -> None:
    assert sum(file.stat().st_size for file in vectors.COMMITTED.glob("*.jsonl")) <= 1_500_000


def test_full_set(vectors: ModuleType) -> None:
    if not vectors.SHARED.is_dir():
        pytest.skip(f"the full set is not at {vectors.SHARED}")
    wrong = []
    for row in vectors.existing_rows(vectors.SHARED):
        cls = vectors.find(registry, row)
        values = vectors.to_ours(cls.layout(), row.values)
        decoded = cls.decode(row.right)
        same = vectors.raw_of(cls.layout(), decoded) == vectors.raw_of(cls.layout(), values)
        if not same or values.encode() != row.right or cls.decode(row.theirs).encode() != row.theirs:
            wrong.append(str(row))
    assert not wrong
