# SPDX-License-Identifier: Apache-2.0
"""The command `orispline`, which is in the package."""
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
