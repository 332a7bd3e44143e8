"""Messages, one package per service set. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import Final

from jauspy.codec.registry import Registry
from jauspy.messages._table import TABLE

registry: Final = Registry(TABLE)
"""All messages, by name and by code; modules are imported on use."""
