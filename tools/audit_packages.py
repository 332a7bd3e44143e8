"""Known vulnerabilities of the installed packages, by pip-audit; exits with 1 if there are some.

pip-audit succeeds, too, when the service that lists vulnerabilities cannot be reached. Here that is one sentence.
"""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Mapping, Sequence
from typing import Any, Final

TIMEOUT: Final = 300.0
"""Seconds."""
OWN: Final = "jauspy"


def report(dependencies: Sequence[Mapping[str, Any]]) -> tuple[list[str], int]:
    """Lines about what was audited, and the exit status."""
    checked = [each for each in dependencies if "skip_reason" not in each]
    left_out = [each["name"] for each in dependencies if "skip_reason" in each and each["name"] != OWN]
    if not checked:
        return ["audit: nothing was checked, because the list of vulnerabilities cannot be reached"], 0
    lines = []
    for package in checked:
        for found in package["vulns"]:
            fixed = ", ".join(found["fix_versions"]) or "no version"
            lines.append(f"{package['name']} {package['version']}: {found['id']}, fixed in {fixed}")
    status = 1 if lines else 0
    lines.append(f"audit: packages: {len(checked)}, vulnerabilities: {len(lines)}")
    if left_out:
        lines.append(f"audit: not checked: {', '.join(left_out)}")
    return lines, status


def main() -> int:
    """Audit the packages of this interpreter."""
    command = (sys.executable, "-m", "pip_audit", "--local", "--progress-spinner", "off", "--format", "json")
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=TIMEOUT)
        dependencies = json.loads(done.stdout)["dependencies"]
    except (subprocess.TimeoutExpired, json.JSONDecodeError, KeyError):
        dependencies = []
    lines, status = report(dependencies)
    print(*lines, sep="\n")
    return status


if __name__ == "__main__":
    sys.exit(main())
