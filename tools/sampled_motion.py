# SPDX-License-Identifier: Apache-2.0
"""Motions as the command writes them."""

import subprocess

from rotations import norm


class Motion:
    """The columns of a file of samples."""

    def __init__(self, text):
        lines = [line for line in text.splitlines() if not line.startswith("#")]
        self.names = lines[0].split(",")
        self.rows = [[float(x) for x in line.split(",")] for line in lines[1:]]
        self.t = self.column("t")
        self.q = self.vectors("qw", 4)

    def column(self, name):
        i = self.names.index(name)
        return [row[i] for row in self.rows]

    def vectors(self, name, size=3):
        i = self.names.index(name)
        return [tuple(row[i:i + size]) for row in self.rows]

    def sizes(self, name):
        return [norm(v) for v in self.vectors(name)]


def sampled(command, keys, rate, options):
    """The motion that the command makes of the text of a key file."""
    call = [command, "sample", "-", "--input-format", "csv", "--rate", str(rate), *options]
    return Motion(subprocess.run(call, input=keys, check=True, capture_output=True, text=True).stdout)
