"""The reference codec: a construct tree made of the same model, slow, simple, and aware of every offset.

It explains bytes field by field, and it is the oracle of the differential tests. Nothing on the way of a message
imports it. Values have the form of `Message.to_dict`, except that messages inside messages stay bytes.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from construct import ConstructError, Container

from jauspy.codec.reference_tree import Tree, tree_of
from jauspy.codec.reference_values import Explainer, Stacker
from jauspy.errors import DecodeError, EncodeError
from jauspy.schema.model import Message


@dataclass(frozen=True, slots=True)
class Row:
    """One number or string on the wire: where it is, which field it is, its raw form, and what that means."""

    offset: int
    length: int
    path: str
    raw: int | float | bytes
    value: Any


def explain(message: Message, data: bytes) -> list[Row]:
    """Every field of a message with its bytes; ids, presence vectors, counts and tags have rows of their own.

    Raises `DecodeError` when the structure cannot be read; values outside their set are shown as they are.
    """
    explainer = Explainer(strict=False)
    explainer.message(message, _parse(message, data))
    return [Row(*row) for row in explainer.rows]


def parse(message: Message, data: bytes) -> dict[str, Any]:
    """The values of a message, strict; raises `DecodeError`."""
    return Explainer(strict=True).message(message, _parse(message, data))


def build(message: Message, values: dict[str, Any]) -> bytes:
    """The inverse of `parse`; raises `EncodeError`."""
    try:
        built = tree_of(message).build(Stacker().message(message, values))
    except (ConstructError, KeyError, ValueError, TypeError, AttributeError) as error:
        raise EncodeError(str(error).strip() or type(error).__name__) from error
    assert isinstance(built, bytes)
    return built


def _parse(message: Message, data: bytes) -> Container:
    tree: Tree = tree_of(message)
    try:
        found = tree.parse(data)
    except ConstructError as error:
        *_, reason = str(error).splitlines() or [type(error).__name__]
        raise DecodeError(reason, path=_path(error), offset=len(data)) from error
    assert isinstance(found, Container)
    return found


def _path(error: ConstructError) -> str:
    """The field that could not be read; construct's own names of the parts around it say nothing."""
    parts = (error.path or "").split(" -> ")
    return ".".join(part.removeprefix("f_") for part in parts if part.startswith("f_"))
