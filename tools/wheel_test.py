"""Build the wheel, install it alone into a fresh environment, and use it there.

`--download` only fills the wheelhouse with what the wheel depends on, so that the test itself needs no network.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path
from zipfile import ZipFile

ROOT = Path(__file__).resolve().parents[1]
WHEELHOUSE = Path(sys.prefix) / "wheelhouse"
EXTRAS = ("cli", "node-manager", "robot", "conformance")
CORE = """
import asyncio, jauspy
from jauspy.messages.core import QueryStatus
from jauspy.services.core import Liveness
assert QueryStatus().encode().hex() == "0220"
jauspy.OCU("42.1.1"), jauspy.Component("101.1.1", [Liveness()])
"""
QUERY_STATUS = "02 00 1000 01 0b017e00 14017e00 0220 0400"


def run(*command: str | Path, cwd: Path = ROOT) -> str:
    """Run a command and return what it printed; ends the program when it fails."""
    done = subprocess.run(list(map(str, command)), cwd=cwd, capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(f"wheel-test: {' '.join(map(str, command))} failed:\n{done.stdout}{done.stderr}")
    return done.stdout


def expect(what: str, text: str) -> None:
    """End the program unless `what` is in `text`."""
    if what not in text:
        sys.exit(f"wheel-test: expected {what!r} in:\n{text}")


def download() -> None:
    """Fill the wheelhouse with the dependencies of the core and of the extras that are tested."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    extras = project["optional-dependencies"]
    wanted = {each for name in EXTRAS for each in extras[name] if not each.startswith("jauspy[")}
    run(sys.executable, "-m", "pip", "wheel", "-q", "-w", WHEELHOUSE, *project["dependencies"], *sorted(wanted))


def main() -> None:
    """Build, install, try."""
    with tempfile.TemporaryDirectory(prefix="jauspy-wheel-") as name:
        folder = Path(name)
        run(sys.executable, "-m", "build", "--wheel", "--no-isolation", "--outdir", folder, ROOT)
        (wheel,) = folder.glob("*.whl")
        with ZipFile(wheel) as archive:
            expect("jauspy/console/locale/de/LC_MESSAGES/console.mo", " ".join(archive.namelist()))
        run(sys.executable, "-m", "venv", folder / "venv")
        python, jauspy = folder / "venv" / "bin" / "python", folder / "venv" / "bin" / "jauspy"
        install = (python, "-m", "pip", "install", "-q", "--no-index", "--find-links", WHEELHOUSE)
        run(*install, wheel)
        run(python, "-c", CORE, cwd=folder)
        without = subprocess.run([jauspy, "ls"], capture_output=True, text=True, check=False)
        expect("pip install 'jauspy[cli]'", without.stderr)
        run(*install, f"{wheel}[cli]")
        expect("decode", run(jauspy, "--help", cwd=folder))
        run(jauspy, "new", "example", "own_service", "-o", folder / "new")
        expect("winch.xml", " ".join(path.name for path in (folder / "new").iterdir()))
        expect("QueryStatus", run(jauspy, "decode", QUERY_STATUS, cwd=folder))
        expect("PrimitiveDriver", run(python, "-c", "import jauspy.schema as s; print(s.load_builtin())", cwd=folder))
        without = subprocess.run([jauspy, "up", "inc1"], capture_output=True, text=True, check=False)
        expect("pip install 'jauspy[", without.stderr)
        run(*install, f"{wheel}[robot,conformance]")
        expect("inc1", run(python, "-c", "from jauspy.robot.robot_files import known; print(known())", cwd=folder))
        expect("--backend", run(jauspy, "up", "--help", cwd=folder))
        print(f"wheel-test: {wheel.name} ({wheel.stat().st_size / 1e3:.0f} kB) works alone")


if __name__ == "__main__":
    if "--download" in sys.argv[1:]:
        download()
    else:
        main()
