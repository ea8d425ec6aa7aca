#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""summary.py JUNIT: where the time of a run of the tests went, and what was skipped and why.

JUNIT is what `ctest --output-junit JUNIT --test-output-size-passed 100000` wrote: reasons stand at the end of outputs.
"""
import collections
import re
import sys
import xml.etree.ElementTree as xml

# The first pattern that a test's name begins with; all else is a test of the library.
GROUPS = {
    "package": r"package\.",
    "command": r"cli\.|shown\.|scenes\.(?!\w*_test)|benchmarks\.",
    "pages and studio": r"page\.|studio\.|npm\.",
    "Python": r"python\.",
    "house and site": r"house\.|site\.",
}
LIBRARY = "library, C++"


def group_of(name):
    return next((group for group, pattern in GROUPS.items() if re.match(pattern, name)), LIBRARY)


def reasons_in(output):
    """What a test says about what it skipped: its own lines, those of pytest, and those of GoogleTest, which gives a reason in the next."""
    lines = output.splitlines()
    for place, line in enumerate(lines):
        if re.match(r"([\w ]+: )?skipped\b", line):
            yield re.sub(r"^skipped:? *", "", line)
        elif found := re.match(r"SKIPPED \[\d+\] (.*)", line):
            yield found[1]
        elif re.match(r".+:\d+: Skipped$", line):
            yield lines[place + 1] if place + 1 < len(lines) else ""


def skips_of(case):
    """The test and a reason, for all that one test of ctest skipped."""
    reasons = list(reasons_in(case.findtext("system-out") or ""))
    if case.get("status") == "notrun" and not reasons:
        skipped = case.find("skipped")
        reasons = [skipped.get("message") if skipped is not None else "was not run"]
    return [(case.get("name"), reason) for reason in reasons]


def printed(cases):
    seconds, counts = collections.Counter(), collections.Counter()
    for case in cases:
        seconds[group_of(case.get("name"))] += float(case.get("time"))
        counts[group_of(case.get("name"))] += 1
    yield "Time of the tests, added up [s]:"
    for group in (LIBRARY, *GROUPS):
        yield f"  {group:16}{seconds[group]:9.1f} in {counts[group]} tests"
    skips = [skip for case in cases for skip in skips_of(case)]
    yield f"Skipped: {len(skips) or 'nothing'}"
    for name, reason in skips:
        yield f"  {name}: {reason}"


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__.splitlines()[0])
    print("\n".join(printed(list(xml.parse(sys.argv[1]).iter("testcase")))))
