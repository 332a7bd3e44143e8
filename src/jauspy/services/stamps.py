"""Time stamps of reports: UTC day of month and time of day, to the millisecond."""

from __future__ import annotations
