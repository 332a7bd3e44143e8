"""Messages inside messages are of the registry that decodes the outer one."""

from __future__ import annotations

import json
from typing import Any

import pytest

from jauspy.codec.message import MAX_NESTING, Message
from jauspy.errors import EncodeError
from jauspy.messages import registry
from jauspy.messages.core import CreateEvent, QueryTime

LEVEL = b"\x01\xd0\x05"


def event_with(inside: Message | bytes) -> bytes:
    return CreateEvent(1, 1, 0.0, inside).encode()


def inside_of(message: Any) -> Any:
    assert isinstance(message, CreateEvent)
    return message.query_message


def test_user_defined_message_in_a_built_in_one_is_decoded(folder: Any) -> None:
    folder.add("Lamp")
    own = folder.load()
    level = own.by_name("SetLevel")(5)
    data = event_with(LEVEL)
    assert inside_of(own.decode(data)) == level
    assert inside_of(own.decode(data, strict=False)[0]) == level
    assert inside_of(own.decode(data + b"\0", strict=False)[0]) == level, "also when there is something to put up with"
    assert own.decode(data).encode() == data
    assert inside_of(registry.decode(data)) == LEVEL
    assert inside_of(CreateEvent.decode(data)) == LEVEL


def test_messages_are_decoded_several_levels_deep(folder: Any) -> None:
    folder.add("Lamp")
    own = folder.load()
    deep = inside_of(own.decode(event_with(event_with(LEVEL))))
    assert inside_of(deep).NAME == "SetLevel"


def test_ambiguous_nested_message_stays_bytes(folder: Any) -> None:
    folder.add("Lamp", code="2011")
    own = folder.load()
    data = event_with(QueryTime(3))
    assert inside_of(registry.decode(data)) == QueryTime(3)
    assert inside_of(own.decode(data)) == QueryTime(3).encode()


def test_user_defined_message_in_a_dictionary_is_converted(folder: Any) -> None:
    folder.add("Lamp")
    own = folder.load()
    message = own.decode(event_with(LEVEL))
    outer = {"message": message.NAME, "fields": json.loads(json.dumps(message.to_dict()))}
    assert own.from_dict(outer) == message
    with pytest.raises(EncodeError, match=r"^query_message\.message: no message SetLevel of urn:acme"):
        registry.from_dict(outer)


def test_dictionaries_have_the_nesting_limit_of_messages() -> None:
    fields: dict[str, Any] = QueryTime(3).to_dict()
    nested = {"message": "QueryTime", "fields": fields}
    for _ in range(MAX_NESTING):
        fields = {**CreateEvent(1, 1, 0.0, b"").to_dict(), "query_message": nested}
        nested = {"message": "CreateEvent", "fields": fields}
    message = registry.from_dict(nested)
    assert registry.decode(message.encode()) == message
    with pytest.raises(EncodeError, match="nested more than 8 deep"):
        registry.from_dict({"message": "CreateEvent", "fields": {**fields, "query_message": nested}})
