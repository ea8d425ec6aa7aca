#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Keeps how long the parts of a run take: timed.py FILE PART COMMAND... runs a command and adds its times to the file;
timed.py FILE --table prints them; timed.py FILE --begin forgets them.

The clock is the wall's. Processor time is that of the command and all that it waited for; the largest process is the one of
them that held most memory at once.
"""
import pathlib
import resource
import subprocess
import sys
import time


def run(file, part, command):
    begin = time.monotonic()
    status = subprocess.run(command, check=False).returncode
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    with file.open("a", encoding="utf-8") as rows:
        rows.write(f"{part}\t{time.monotonic() - begin}\t{used.ru_utime + used.ru_stime}\t{used.ru_maxrss}\n")
    return status if status >= 0 else 128 - status


def table(file):
    rows = [line.split("\t") for line in file.read_text("utf-8").splitlines()]
    print(f"\n{'how the time was spent':<28}{'clock':>9}{'processor':>12}{'largest process':>18}")
    for part, clock, processor, kilobytes in rows:
        print(f"{part:<28}{float(clock):>7.0f} s{float(processor):>10.0f} s{float(kilobytes) / 1e6:>15.2f} GB")
    print(f"{'together':<28}{sum(float(r[1]) for r in rows):>7.0f} s{sum(float(r[2]) for r in rows):>10.0f} s")


def main():
    file, words = pathlib.Path(sys.argv[1]), sys.argv[2:]
    if words == ["--table"]:
        return table(file)
    if words == ["--begin"]:
        file.parent.mkdir(parents=True, exist_ok=True)
        return file.write_text("", "utf-8") and None
    return run(file, words[0], words[1:])


if __name__ == "__main__":
    sys.exit(main())
