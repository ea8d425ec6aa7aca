# SPDX-License-Identifier: Apache-2.0
"""The commands of the package: `orispline`, which is in it, and `orispline-tables`, where what that needs is installed."""
from __future__ import annotations

import os
import pathlib
import subprocess
import sys

COMMAND = pathlib.Path(__file__).parent / "bin" / ("orispline.exe" if os.name == "nt" else "orispline")


def main() -> int:
    """Runs it in the place of this process, or waits for it where that cannot be."""
    arguments = [str(COMMAND), *sys.argv[1:]]
    if os.name == "nt":
        return subprocess.run(arguments, check=False).returncode
    os.execv(COMMAND, arguments)


def tables() -> int:
    """Runs it, or says what to install."""
    try:
        from .tables._command import main as run
    except ImportError as error:
        print(f"orispline-tables: {str(error).removeprefix('orispline.tables: ')}", file=sys.stderr)
        return 3
    return run()
