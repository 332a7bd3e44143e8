"""Reads messages of Foxglove's schemas with Google's library, by the descriptors that are published with them."""

from __future__ import annotations

from typing import Any

import pytest


def decoded(name: str, descriptors: bytes, data: bytes) -> Any:
    """The message; raises if the bytes do not fit the schema, or have fields that it does not have."""
    pytest.importorskip("google.protobuf", reason="protobuf is of the group `dev`")
    from google.protobuf import descriptor_pb2, descriptor_pool, message_factory, unknown_fields

    pool = descriptor_pool.DescriptorPool()
    for file in descriptor_pb2.FileDescriptorSet.FromString(descriptors).file:
        pool.Add(file)
    message = message_factory.GetMessageClass(pool.FindMessageTypeByName(name)).FromString(data)
    assert not len(unknown_fields.UnknownFieldSet(message)), f"{name} has unknown fields"
    assert message.SerializeToString(deterministic=True)
    return message
