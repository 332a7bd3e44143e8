"""A schema to Python source: one module per service, deterministic, ready to be committed or executed."""

from __future__ import annotations

import re
from collections.abc import Iterable

from jauspy.codec.generator_classes import class_lines
from jauspy.codec.generator_fixed import Constants
from jauspy.codec.generator_packages import NOTE, packages, root, table
from jauspy.codec.names import module_alias
from jauspy.codec.plan import ModulePlan
from jauspy.codec.planner import plan
from jauspy.schema.model import Schema


def generate(schema: Schema, package: str = "jauspy.messages", base: str | None = None) -> dict[str, str]:
    """The source of all files of `package`, by path relative to it; its registry is layered over that of `base`.

    Raises `SchemaError` for what cannot be decoded in bounded time, and for lists that are nested too deeply.
    """
    modules = plan(schema)
    names = [module.name for module in modules]
    files = {f"{module.name.replace('.', '/')}.py": module_source(module, package, names) for module in modules}
    files |= packages(modules, package)
    files["__init__.py"] = root(package, base)
    files["_table.py"] = table(modules, package, _files(schema) if base else None)
    return dict(sorted(files.items()))


def _files(schema: Schema) -> dict[tuple[str, str], str]:
    """Where the services are defined; what is built in knows that by itself, and may be anywhere."""
    return {service.key: service.where.file for service in schema.services if service.where}


def module_source(module: ModulePlan, package: str, names: Iterable[str]) -> str:
    """The source of one module, which imports those of the modules `names` that it speaks of."""
    body: list[str] = []
    constants = Constants()
    for made in module.classes:
        body += ["", "", *class_lines(made, module, constants)]
    body += ["", "", *constants.lines()]
    body += [f"{made.name}.REPORT = {made.answer.name}" for made in module.classes if made.answer]
    text = "\n".join(body).replace(f"{module_alias(module.name)}.", "")
    lines = [f'"""{module.doc} {NOTE}"""', "", "from __future__ import annotations", ""]
    lines += ["from dataclasses import dataclass"] if "@dataclass" in text else []
    lines += ["from enum import IntEnum"] if "(IntEnum)" in text else []
    typing = ", ".join(name for name in ("ClassVar", "Self") if re.search(rf"\b{name}\b", text))
    lines += [f"from typing import {typing}"] if typing else []
    lines += [""] if lines[-1] else []
    lines += ["from jauspy.codec import runtime as rt"] if "rt." in text else []
    lines += [f"from {package} import registry as _registry"] if "_registry" in text else []
    spoken_of = set(re.findall(r"\b(\w+)\.", text))
    for name in sorted(names):
        if module_alias(name) not in spoken_of:
            continue
        head, _, tail = f"{package}.{name}".rpartition(".")
        lines.append(f"from {head} import {tail} as {module_alias(name)}")
    return "\n".join(lines) + "\n" + text + "\n"
