# SPDX-License-Identifier: Apache-2.0
"""A curve in a notebook whose keys are edited there, while Python hears of it.

Needs anywidget: `pip install 'orispline[notebook]'`.
"""
from __future__ import annotations

try:
    import anywidget as _anywidget  # noqa: F401
except ImportError:
    raise ImportError("orispline.notebook: found no anywidget, wanted it installed: pip install 'orispline[notebook]'", name="anywidget") from None

from ._widget import Widget

__all__ = ["Widget"]
