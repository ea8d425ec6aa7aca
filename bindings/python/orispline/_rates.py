# SPDX-License-Identifier: Apache-2.0
"""The rates of a gyro, at times of their own."""
from __future__ import annotations

from typing import Any

from ._arrays import Array, array_of, numbers
from ._errors import DataError


class Rates:
    """What a gyro measured, for `smooth`: body rates at times that need not be those of any orientation.

    Parameters
    ----------
    times : (n,) array
        Strictly increasing, as the times of the keys are: numbers, or stamps of NumPy or pandas. Their clock may differ by an offset, which
        `smooth` finds.
    rates : (n, 3) array
        [rad/s], body frame. Rows with NaN are left out.

    Raises
    ------
    ArgumentError, DataError
        Arrays of another shape or kind; lengths that differ.

    Examples
    --------
    >>> import orispline as ori
    >>> ori.Rates([0.0, 0.1, 0.2], [[0, 0, 1], [0, 0, 1.1], [0, 0, 1.2]])
    Rates(3 rates)
    """

    __slots__ = ("rates", "times")

    def __init__(self, times: Any, rates: Any) -> None:
        self.times = array_of("times", times)
        self.rates: Array = numbers("rates", rates, (None, 3))
        if self.times.shape != self.rates.shape[:1]:
            raise DataError(f"rates: found {len(self.rates)} rows and times of shape {self.times.shape}, wanted one rate for each time")

    def __len__(self) -> int:
        return len(self.rates)

    def __repr__(self) -> str:
        return f"Rates({len(self)} rates)"
