# SPDX-License-Identifier: Apache-2.0
"""The command `orispline-tables`, where what it needs is installed."""
from __future__ import annotations

import sys


def main() -> int:
    """Runs it, or says what to install."""
    try:
        from .tables._command import main as run
    except ImportError as error:
        print(f"orispline-tables: {str(error).removeprefix('orispline.tables: ')}", file=sys.stderr)
        return 3
    return run()
