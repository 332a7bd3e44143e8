"""JAUS names to Python names: `Velocity_X` to `velocity_x`, `CONTROL ACCEPTED` to `CONTROL_ACCEPTED`; unit symbols."""

from __future__ import annotations

import keyword
import re
import unicodedata
from collections.abc import Callable, Iterable
from functools import lru_cache
from typing import Final

from jauspy.ids import service_set

_WORDS = re.compile(
    r"[A-Z]+s(?![a-z])"  # IDs
    r"|[A-Z]+\d*(?![a-z])"  # URI, P1, CBRN4
    r"|[A-Z]?[a-z]+(?:\d+d?(?![a-z]))?"  # Velocity, Joint1, Map2d
    r"|[A-Z]+"
    r"|\d+"
)
_ACRONYM_THEN_WORD = re.compile(r"([A-Z]+)([A-Z](?!s(?![a-z]))[a-z])")
_LETTERS = str.maketrans(
    {"ß": "ss", "ẞ": "SS", "æ": "ae", "Æ": "AE", "œ": "oe", "Œ": "OE", "ø": "o", "Ø": "O", "ł": "l", "Ł": "L"}
)
"""Letters that Unicode does not decompose."""
_DIMENSIONS = re.compile(r"(?<=\d)D(?![a-z])")
_RESERVED = frozenset(
    {"encode", "decode", "to_dict", "from_dict", "layout", "mro", "self", "cls"}  # of a message
    | {"int", "float", "str", "bytes", "list", "jd"}  # in its annotations
)
_RESERVED_CLASSES = frozenset({"IntEnum", "Self"})
_RESERVED_PACKAGES = frozenset({"registry"})
_RESERVED_MODULES = frozenset({"types"})  # those that services share


def plain(name: str) -> str:
    """Latin letters without their marks: `Grosse` of `Größe`."""
    decomposed = unicodedata.normalize("NFKD", name.translate(_LETTERS))
    return "".join(letter for letter in decomposed if not unicodedata.combining(letter))


@lru_cache(maxsize=4096)
def snake(name: str) -> str:
    """`PropulsiveLinearEffortX` to `propulsive_linear_effort_x`; `""` when there is no letter or digit in it."""
    text = _ACRONYM_THEN_WORD.sub(r"\1_\2", _DIMENSIONS.sub("d_", plain(name)))
    return "_".join(word.lower() for word in _WORDS.findall(text))


def method(name: str) -> str:
    """A valid name of a method, a module or a package."""
    text = snake(name) or "unnamed"
    if text[0].isdigit():
        text = f"n{text}"
    return f"{text}_" if keyword.iskeyword(text) else text


def attribute(name: str) -> str:
    """A valid attribute name that collides with nothing a message already has."""
    text = method(name)
    return f"{text}_" if text in _RESERVED else text


def constant(name: str) -> str:
    """A valid name of an enum member."""
    text = snake(name).upper() or "UNNAMED"
    return f"N{text}" if text[0].isdigit() else text


def class_name(name: str) -> str:
    """A valid class name, with the JAUS spelling if possible."""
    letters = unicodedata.normalize("NFKC", name)
    text = "".join(letter if f"a{letter}".isidentifier() else " " for letter in letters)
    text = re.sub(r"\s+", "_", text).strip("_") or "Unnamed"
    text = text[0].upper() + text[1:]
    # What is upper case, or stands behind another letter, may be composed differently.
    text = unicodedata.normalize("NFKC", text if text.isidentifier() else f"N{text}")
    return f"{text}_" if keyword.iskeyword(text) or text in _RESERVED_CLASSES else text


def unique(name: str, taken: Callable[[str], bool]) -> str:
    """`name`, or `name` with the lowest number from 2 that is free."""
    if not taken(name):
        return name
    number = 2
    while taken(f"{name}_{number}"):
        number += 1
    return f"{name}_{number}"


def attributes(names: Iterable[str], *reserved: str) -> list[str]:
    """The attribute names of one class, each unique in it."""
    made: list[str] = []
    for name in names:
        made.append(unique(attribute(name), lambda text: text in reserved or text in made))
    return made


def members(values: Iterable[tuple[int, str]]) -> dict[str, int]:
    """The members of an enumeration; several values of one name (as `Reserved`) get their value appended."""
    first: dict[int, str] = {}
    for value, name in values:
        first.setdefault(value, constant(name))
    names = list(first.values())
    made: dict[str, int] = {}
    for value, name in first.items():
        wanted = name if names.count(name) == 1 else f"{name}_{value}".replace("-", "MINUS_")
        made[unique(wanted, made.__contains__)] = value
    return made


def set_package(urn: str) -> str:
    """The package of the set of a service or type set: `environment_sensing` of `...:environmentSensing:Range`."""
    name = method(service_set(urn))
    return f"{name}_" if name in _RESERVED_PACKAGES else name


def version_package(version: str) -> str:
    """`v1_1` of `1.1`."""
    return "v" + re.sub(r"\W+", "_", version, flags=re.ASCII)


def service_module(name: str) -> str:
    """The module of a service."""
    module = attribute(name)
    return f"{module}_" if module in _RESERVED_MODULES else module


def module_alias(name: str) -> str:
    """The alias of a module where another one imports it: `core_v1_0_types` for `core.v1_0.types`."""
    return snake(name.replace(".", " ")) or name


def version_key(version: str) -> tuple[int, ...]:
    """Sort key of versions, for `1.1` and `v1_1` alike."""
    return tuple(int(part) for part in version.replace("v", "").replace("_", ".").split(".") if part.isdigit())


_SYMBOLS: Final = {
    "one": "",
    "meter": "m",
    "meter per second": "m/s",
    "meter per second squared": "m/s²",
    "radian": "rad",
    "radian per second": "rad/s",
    "second": "s",
    "minute": "min",
    "hertz": "Hz",
    "percent": "%",
    "rotations per minute": "rpm",
    "newton": "N",
    "newton meter": "N·m",
    "degree Celsius": "°C",
    "volt": "V",
    "ampere": "A",
    "pascal": "Pa",
    "kilogram": "kg",
}


def unit_symbol(units: str) -> str:
    """`m/s` for `meter per second`; units without a symbol are returned unchanged."""
    return _SYMBOLS.get(units, units)
