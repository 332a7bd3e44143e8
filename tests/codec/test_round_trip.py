"""Random valid messages of every kind survive the way to bytes and back, on both paths, and in JSON."""

from __future__ import annotations

import json
from collections.abc import Callable
from functools import partial
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings, strategies as st
from tests.helpers.sampling import sampled

from jauspy.codec import reference, slow_path
from jauspy.codec.message import Message
from jauspy.codec.registry import Registry
from jauspy.errors import DecodeError
from jauspy.messages import registry
from jauspy.schema import load_builtin, model as m

FEW = settings(max_examples=15, deadline=None, suppress_health_check=list(HealthCheck))
MORE = settings(max_examples=120, deadline=None, suppress_health_check=list(HealthCheck))
ODD = ("Everything", "Options", "Nothing", "Shapes", "Points", "Rounded")


def check(message: Message) -> bytes:
    data = message.encode()
    assert message._pack() == data
    assert slow_path.encode(message, clamp=False, strict=True) == data
    decoded = type(message).decode(data)
    assert type(message)._unpack(data, None) == decoded
    assert slow_path.decode(type(message), data) == decoded
    assert decoded.encode() == data
    assert slow_path.decode_tolerant(type(message), data) == (decoded, [])
    assert type(message).decode(data, strict=False) == (decoded, [])
    assert type(message).from_dict(json.loads(json.dumps(decoded.to_dict()))) == decoded
    return data


@pytest.mark.parametrize("entry", sampled(registry.entries, 40), ids=lambda entry: f"{entry.name}-{entry.version}")
def test_every_builtin_message(entry: Any, values_of: Any) -> None:
    layout = entry.load().layout()

    @FEW
    @given(values_of(layout))
    def run(message: Message) -> None:
        check(message)

    run()


@pytest.mark.slow
@pytest.mark.parametrize("name", ODD)
def test_every_feature(name: str, odd: Registry, odd_models: dict[str, m.MessageDefinition], values_of: Any) -> None:
    cls = odd.by_name(name)

    @MORE
    @given(values_of(cls.layout()))
    def run(message: Message) -> None:
        data = check(message)
        values = reference.parse(odd_models[name], data)
        assert reference.build(odd_models[name], values) == data

    run()


def agree(cls: type[Message], model: m.MessageDefinition, data: bytes) -> None:
    """The generated decoder and the reference accept the same bytes, and both give them back."""
    try:
        ours: Message | None = cls.decode(data)
    except DecodeError:
        ours = None
    try:
        theirs: dict[str, Any] | None = reference.parse(model, data)
    except DecodeError:
        theirs = None
    assert (ours is None) == (theirs is None), data.hex()
    if ours is not None and theirs is not None:
        assert ours.encode() == data
        assert reference.build(model, theirs) == data
    tolerant, deviations = cls.decode(data, strict=False)
    assert (not deviations) == (ours is not None)
    tolerant.to_dict()
    if ours is not None:
        assert tolerant == ours


@pytest.mark.slow
@pytest.mark.parametrize("name", ODD)
def test_mutated_messages(name: str, odd: Registry, odd_models: dict[str, m.MessageDefinition], values_of: Any) -> None:
    cls = odd.by_name(name)

    @MORE
    @given(values_of(cls.layout()), st.data())
    def run(message: Message, more: st.DataObject) -> None:
        agree(cls, odd_models[name], mutate(message.encode(), more))

    run()


@pytest.mark.slow
def test_mutated_builtin_messages(values_of: Any) -> None:
    models = {(s.id, s.version, msg.name): msg for s in load_builtin().services for msg in s.messages}
    entries = st.sampled_from(registry.entries)

    @settings(MORE, max_examples=100)
    @given(st.data())
    def run(more: st.DataObject) -> None:
        cls = more.draw(entries).load()
        message = more.draw(values_of(cls.layout()))
        agree(cls, models[cls.SERVICE, cls.VERSION, cls.NAME], mutate(message.encode(), more))

    run()


def mutate(data: bytes, more: st.DataObject) -> bytes:
    """Change, drop or add some bytes behind the id."""
    kind = more.draw(st.sampled_from(["change", "cut", "add"]))
    if kind == "change" and len(data) > 2:
        at = more.draw(st.integers(2, len(data) - 1))
        return data[:at] + more.draw(st.binary(min_size=1, max_size=1)) + data[at + 1 :]
    if kind == "cut":
        return data[: more.draw(st.integers(2, len(data)))]
    return data + more.draw(st.binary(max_size=4))


def rejected(decode: Callable[[bytes], object], data: bytes) -> DecodeError | None:
    """The error of a decoder; every other exception is a failure of the test."""
    try:
        decode(data)
    except DecodeError as error:
        return error
    return None


@MORE
@given(st.binary(max_size=80))
def test_random_bytes_raise_decode_errors_only(data: bytes) -> None:
    for decode in (registry.decode, partial(registry.decode, strict=False)):
        error = rejected(decode, data)
        assert error is None or 0 <= error.offset <= len(data)


@MORE
@given(st.sampled_from(registry.entries), st.binary(max_size=60))
def test_random_bodies_raise_decode_errors_only(entry: Any, body: bytes) -> None:
    data = entry.code.to_bytes(2, "little") + body
    error = rejected(entry.load().decode, data)
    assert error is None or (0 <= error.offset <= len(data) and error.reason)
    message, deviations = entry.load().decode(data, strict=False)
    if not any(deviation.lost for deviation in deviations):
        assert message.encode(strict=False) == data
