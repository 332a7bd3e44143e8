"""Compiles a world in MJCF within limits of memory and time: `python -m jauspy_sim.worlds.mjcf_trial FILE`."""

from __future__ import annotations

import resource
import sys


def main(path: str, memory: str, seconds: str) -> int:
    """0 if it can be compiled; 1 if it has a mistake, which is printed; 2 if memory is short."""
    resource.setrlimit(resource.RLIMIT_AS, (int(memory), int(memory)))
    resource.setrlimit(resource.RLIMIT_CPU, (int(seconds), int(seconds)))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    import mujoco  # noqa: PLC0415 - within the limits

    try:
        mujoco.MjData(mujoco.MjSpec.from_file(path).compile())
    except (ValueError, FileNotFoundError) as error:
        if "allocate" in str(error):
            return 2
        sys.stdout.write(str(error))
        return 1
    except (MemoryError, RuntimeError, mujoco.FatalError):
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
