"""What need not be written twice: methods nobody calls, and messages that another service or version has as well."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import fields, replace
from typing import Any

from jauspy.codec.names import module_alias
from jauspy.codec.plan import ClassPlan, GridPlan, ItemPlan, ModulePlan, ObjectPlan, RepeatPlan, UnionPlan
from jauspy.schema.model import Message, Node


def mark_called(modules: Iterable[ModulePlan]) -> None:
    """Find the classes that are not read and written in place: arms of variants, and all of more than one form."""
    for made in _classes(cls for module in modules for cls in module.classes):
        for slot in made.slots:
            for used in _called(slot.item):
                used.called = True


def _classes(classes: Iterable[Any]) -> Iterator[ClassPlan]:
    for made in classes:
        if isinstance(made, ClassPlan):
            yield made
            yield from _classes(made.nested)


def _called(item: ItemPlan) -> tuple[ClassPlan, ...]:
    match item:
        case UnionPlan():
            return item.arms
        case RepeatPlan() | GridPlan():
            return _called(item.item)
        case ObjectPlan() if item.cls.kind != "composite" or item.cls.presence:
            return (item.cls,)
        case _:
            return ()


def share_messages(modules: Iterable[ModulePlan], services: set[str]) -> None:
    """Let equal messages of several services or versions be one class; the others derive from it.

    Queries are equal when the reports on them are.

    The first module by name has the class, so that imports go one way only.
    """
    first: dict[object, tuple[ModulePlan, ClassPlan]] = {}
    for module in sorted(modules, key=lambda module: module.name):
        for made in module.classes:
            if made.message is None:
                continue
            answer = made.answer and made.answer.message and _key(made.answer.message, services)
            key = (_key(made.message, services), made.is_query, answer)
            if key not in first:
                first[key] = (module, made)
                continue
            owner, original = first[key]
            if owner is not module:
                made.same_as = f"{module_alias(owner.name)}.{original.name}"


def _key(message: Message, services: set[str]) -> object:
    return (message.name, message.code, message.is_command, _bare(message.body, services))


def _bare(value: Any, services: set[str]) -> Any:
    """A node without the names of services that declare parts of it: these do not show in a class."""
    if isinstance(value, tuple):
        return tuple(_bare(part, services) for part in value)
    if not isinstance(value, Node):
        return value
    parts = {field.name: _bare(getattr(value, field.name), services) for field in fields(value)}
    if value.declared is not None and value.declared.set_id in services:
        parts["declared"] = None
    return replace(value, **parts)
