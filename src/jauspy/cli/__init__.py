"""The `jauspy` command: one module per verb, imported when the verb runs."""

from __future__ import annotations

import sys
from typing import Final

OPTIONAL_PACKAGES: Final = frozenset(
    {
        "av",
        "construct",
        "dpkt",
        "foxglove",
        "mcap",
        "numpy",
        "orjson",
        "prometheus_client",
        "pyarrow",
        "pydantic",
        "rich",
        "textual",
        "typer",
        "xacro",
        "yaml",
    }
)
"""Top-level packages that extras install and that verbs import."""

EXTRA_OF_VERB: Final = {
    "audit": "operators",
    "can": "can",
    "cell": "cell",
    "conformance": "conformance",
    "console": "console",
    "demo": "all",
    "export": "export",
    "keys": "operators",
    "live": "recording",
    "map": "map",
    "monitor": "monitor",
    "node-manager": "node-manager",
    "record": "recording",
    "replay": "recording",
    "still": "video",
    "teleop": "teleop",
    "tf": "robot",
    "up": "robot",
    "video": "video",
}
"""The extra that a verb needs; the others need `cli`."""


def main() -> None:
    """The console script; if a package is missing, it exits with a sentence that names the extra to install."""
    try:
        from jauspy.cli.main import main as run_verb

        run_verb()
    except ModuleNotFoundError as error:
        package = (error.name or "").partition(".")[0]
        if package not in OPTIONAL_PACKAGES:
            raise
        extra = next((EXTRA_OF_VERB[word] for word in sys.argv[1:] if word in EXTRA_OF_VERB), "cli")
        sys.exit(f"jauspy: this command needs the package {package}: pip install 'jauspy[{extra}]'")
