"""Write the service definitions of IOP v3 and AEODRS to `schemas/`, their golden rows, and the table of docs/iop.md.

python -m tools.iop_tables schemas|rows|page
"""

from __future__ import annotations

import argparse
import sys

from . import golden, jsidl, page
from .table import TableError, read_all


def main() -> int:
    """Exit status 1 for a table that cannot be read."""
    parser = argparse.ArgumentParser(prog="python -m tools.iop_tables", description=__doc__)
    parser.add_argument("what", choices=["schemas", "rows", "page"])
    options = parser.parse_args()
    try:
        tables = read_all()
    except TableError as error:
        print(error, file=sys.stderr)
        return 1
    write = {"schemas": lambda: jsidl.write(tables), "rows": lambda: golden.write(tables), "page": page.write}
    for path in write[options.what]():
        print(path)
    return 0


if __name__ == "__main__":
    sys.exit(main())
