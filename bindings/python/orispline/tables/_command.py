# SPDX-License-Identifier: Apache-2.0
"""The command `orispline-tables`: the functions of `orispline.tables`, from files to a file."""
from __future__ import annotations

import argparse
import os
import re
import sys
import warnings
from collections.abc import Callable, Sequence
from typing import Any, NoReturn

from .. import _core
from .._blending import Blending, among, read_blending
from .._checks import FRAMES
from .._evaluation import BEYOND
from .._errors import AccessError, ArgumentError, Error
from .._options import FIELDS
from . import _jobs
from ._files import written
from ._progress import Bar

_ARGUMENT = re.compile(r"(?<![\w'])([a-z_]+)=(?=[, ]|$)")  # as messages for Python name an argument


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs the command. What it ends with: 0, 1 for bad data, 2 for bad arguments, 3 for files, 130 after Ctrl-C."""
    try:
        try:
            return _run(arguments)
        finally:
            sys.stdout.flush()
    except OSError as error:  # of standard output, to which nothing more can go
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return _failed(AccessError(f"standard output: cannot be written: {error.strerror}"))


def _run(arguments: Sequence[str] | None) -> int:
    options = vars(_parser().parse_args(arguments))
    command, output, partition_by, quiet = (options.pop(name) for name in ("command", "output", "partition_by", "quiet"))
    if os.path.lexists(output) and partition_by is None and os.path.isdir(output):
        return _failed(ArgumentError(f"--output: found the folder {output}, wanted a file, or --partition-by"))
    shown = Bar() if not quiet and sys.stderr.isatty() else None
    places = [options.pop(name) for name in ("source", "at") if name in options]
    files = options.pop("blending", None) or []
    stated = {name: value for name, value in options.items() if value is not None}
    try:
        stated.update(_methods_stated(stated, [read_blending(file) for file in files]))
        with warnings.catch_warnings():
            warnings.showwarning = _say
            reader = getattr(_jobs, command)(*places, **stated, progress=shown.keys if shown else None)
            summary = written(reader, output, partition_by, shown=shown.rows if shown else None)
    except KeyboardInterrupt:
        return _failed("interrupted: nothing was written", 130)
    except Error as error:
        return _failed(error)
    finally:
        if shown:
            shown.clear()
    print(summary)
    for message in summary.first_errors:
        print(f"  {message}", file=sys.stderr)
    return 0


def _methods_stated(stated: dict[str, Any], own: list[Blending]) -> dict[str, Any]:
    """The methods among the options, those of one's own with their blending functions."""
    found: dict[str, Any] = {}
    if "method" in stated:
        found["method"] = among(stated["method"], own)
    if "methods" in stated:
        cores = [one._core for one in own]
        found["methods"] = [among(one, own) for typed in stated["methods"] for one in _core.method_texts(typed, cores)]
    return found


def _say(message: Any, *_: Any, **__: Any) -> None:
    print(f"orispline-tables: {message}", file=sys.stderr)


def _failed(why: Any, code: int | None = None) -> int:
    _say(_ARGUMENT.sub(lambda name: "--" + name[1].replace("_", "-"), str(why)))
    if code is not None:
        return code
    return 2 if isinstance(why, ArgumentError) else 3 if isinstance(why, AccessError) else 1


class _Parser(argparse.ArgumentParser):
    """One that says in a line what it does not understand."""

    def print_help(self, file: Any = None) -> None:
        """As argparse does, which says nothing where it cannot."""
        (file or sys.stdout).write(self.format_help())

    def error(self, message: str) -> NoReturn:
        self.exit(2, f"{self.prog}: {message} ({self.prog} --help lists all options)\n")


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(
        prog="orispline-tables", allow_abbrev=False,
        description="Resamples, smooths, reduces, averages and compares tables of many tracks, which are Parquet files. One row is one key.")
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    for add in (_resample, _evaluate, _smooth, _reduce, _mean, _compare):
        add(commands)
    return parser


def _command(commands: Any, name: str, summary: str, *, sides: bool = False) -> argparse.ArgumentParser:
    """One of them, with the options that all have."""
    parser: argparse.ArgumentParser = commands.add_parser(name, help=summary, description=summary[0].upper() + summary[1:] + ".",
                                                          allow_abbrev=False)
    parser.add_argument("source", nargs="+", metavar="FILE", help="Parquet files, patterns or folders of keys")
    if sides:
        parser.add_argument("--at", nargs="+", required=True, metavar="FILE", help="Parquet files of the rows to add orientations to")
    else:
        parser.add_argument("--assume-sorted", action="store_true", default=None, help="the rows are in order of track and time")
    parser.add_argument("-o", "--output", required=True, metavar="FILE", help="file to write, as its ending says: .parquet, .arrow or "
                        ".csv; or folder with --partition-by")
    parser.add_argument("--by", type=_names, metavar="NAME,…", help="columns that tell tracks apart (default: track)")
    parser.add_argument("--time", metavar="NAME", help="column of times: seconds, timestamps, durations or dates (default: t)")
    parser.add_argument("--quaternion", type=_names, metavar="X,Y,Z,W", help="columns of the quaternion, or one of structs or lists (default: qx,qy,qz,qw)")
    parser.add_argument("--normalise", "--normalize", action="store_true", default=None, help="take quaternions of any norm but 0")
    parser.add_argument("--errors", choices=_jobs.ERRORS, help="what a bad track becomes: a row with its message (default), the end of "
                        "the work, or nothing")
    parser.add_argument("--threads", type=int, metavar="N", help="at most so many at work; 0, the default, means one for each core")
    parser.add_argument("--memory-limit", metavar="SIZE", help="what putting rows in order may take before it uses the disk (default: 1GB)")
    parser.add_argument("--partition-by", type=_names, metavar="NAME,…", help="write a folder of files, one for each value")
    parser.add_argument("--quiet", action="store_true", help="show no progress")
    return parser


def _motion(parser: argparse.ArgumentParser, derivatives: int) -> None:
    parser.add_argument("--position", type=_names, metavar="X,Y,Z", help="columns of positions [m]")
    parser.add_argument("--derivatives", type=int, metavar="ORDER", help=f"highest order of the rates, 0 to 3 (default: {derivatives})")
    parser.add_argument("--frame", choices=FRAMES, help="frame of angular rates (default: body)")


def _resample(commands: Any) -> None:
    parser = _command(commands, "resample", "even samples of every track, with rates")
    _motion(parser, 1)
    _method(parser, "as of orispline (default: auto)")
    parser.add_argument("--rate", metavar="HZ", help="samples per second, such as 100 or 30000/1001 (default: 100)")
    parser.add_argument("--align", choices=_jobs.ALIGNMENTS, help="begin at each track's first key (default), or use the same times in all")
    parser.add_argument("--gap", type=float, metavar="S", help="leave longer intervals between keys empty")


def _evaluate(commands: Any) -> None:
    parser = _command(commands, "evaluate", "the orientation of each track at the rows of another table", sides=True)
    _motion(parser, 0)
    _method(parser, "as of orispline (default: auto)")
    parser.add_argument("--extrapolate", choices=BEYOND, help="what times outside the keys get (default: nan, none)")


def _smooth(commands: Any) -> None:
    parser = _command(commands, "smooth", "every track without its noise, with rates")
    _motion(parser, 1)
    parser.add_argument("--rate", metavar="HZ", help="even samples instead of those at the keys")
    _of_task(parser, "SmoothOptions", without=("gyro", "gyro_noise", "gyro_offset", "gyro_bias", "sigma"))


def _reduce(commands: Any) -> None:
    parser = _command(commands, "reduce", "the fewest keys of every track within a tolerance")
    parser.add_argument("--position", type=_names, metavar="X,Y,Z", help="columns of positions [m]")
    parser.add_argument("--tolerance", required=True, metavar="ANGLE", help="such as 0.1deg or 2mrad")
    _method(parser, "of the curve through the keys that are kept")
    _of_task(parser, "ReduceOptions", without=("tolerance", "values"))


def _mean(commands: Any) -> None:
    parser = _command(commands, "mean", "the mean or the median of every group of rows, or of its windows in time")
    parser.add_argument("--position", type=_names, metavar="X,Y,Z", help="columns of positions [m]")
    parser.add_argument("--weight", metavar="NAME", help="column of weights")
    _of_task(parser, "MeanOptions", without=())


def _compare(commands: Any) -> None:
    parser = _command(commands, "compare", "how near methods come to every track, of which some samples become keys")
    parser.add_argument("--methods", action="append", metavar="METHOD,…",
                        help="a method with its settings, or a list of methods; repeatable (default: all)")
    _blending(parser)
    parser.add_argument("--keep-every", type=int, metavar="N", help="keep every N-th sample as a key (default: 8)")
    parser.add_argument("--leave-out", action="store_true", default=None, help="estimate the error from the keys alone as well")
    parser.add_argument("--no-least-energy", dest="least_energy", action="store_false", default=None,
                        help="do not look for the least possible energy, which takes a quarter of a millisecond a key")


def _method(parser: argparse.ArgumentParser, use: str) -> None:
    parser.add_argument("--method", metavar="NAME[:SETTING=VALUE…]", help=use)
    _blending(parser)


def _blending(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--blending", action="append", metavar="FILE", help="JSON file with blending functions of your own, which are a "
                        "method by the name that it says")


def _of_task(parser: argparse.ArgumentParser, table: str, without: tuple[str, ...]) -> None:
    """The options of a task, as the library states them."""
    for field in FIELDS[table]:
        if field["name"] in without:
            continue
        words = list(field["words"]) or None
        parser.add_argument("--" + field["name"].replace("_", "-"), choices=words, metavar=None if words else "NUMBER",
                            help=(field["sentence"][0].lower() + field["sentence"][1:]).replace("%", "%%"))


def _list_of(what: str) -> Callable[[str], list[str]]:
    def listed(text: str) -> list[str]:
        return [name for name in text.split(",") if name]
    listed.__name__ = what
    return listed


_names = _list_of("names")
