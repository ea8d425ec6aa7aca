# SPDX-License-Identifier: Apache-2.0
"""The test programs of a mutated build: which mutants each comes by, and which it kills."""
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import time

MEMORY_KB, FILE_BLOCKS = 6_000_000, 4_000_000  # of a mutant that does not know where to stop
TIME_FACTOR, TIME_MORE = 5.0, 10.0  # times that of the original, and seconds


class Program:
    """A test program: all cases of a GoogleTest executable, or one script that tests the command."""

    def __init__(self, name, command, folder, environment, is_script):
        self.name, self.command, self.folder = name, command, folder
        self.environment, self.is_script = environment, is_script
        self.seconds, self.reached = 0.0, set()

    def run(self, environment, limit, scratch):
        """The exit status, "time" where it took too long."""
        shutil.rmtree(scratch, ignore_errors=True)
        scratch.mkdir(parents=True)
        limited = ["sh", "-c", f'ulimit -v {MEMORY_KB}; ulimit -f {FILE_BLOCKS}; ulimit -c 0; exec "$@"', "sh", *self.command]
        places = {"TMPDIR": str(scratch), "TEST_TMPDIR": str(scratch)}
        with subprocess.Popen(limited, cwd=self.folder, env={**os.environ, **self.environment, **environment, **places},
                              stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                              start_new_session=True) as process:
            try:
                return process.wait(limit)
            except subprocess.TimeoutExpired:
                return "time"
            finally:
                try:
                    os.killpg(process.pid, signal.SIGKILL)
                except ProcessLookupError:
                    pass


def rapidcheck_parameters(tree):
    """Those that the tests set, without the search for a smaller counterexample."""
    text = (tree / "tests/support/properties.hpp").read_text("utf-8")
    return re.search(r'setenv\("RC_PARAMS", "([^"]*)"', text)[1] + " noshrink=1"


def programs(build, tree, pattern):
    """What ctest knows, a program once: the GoogleTest executables, then the scripts."""
    listed = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1"], check=True, capture_output=True)
    found = {}
    for test in json.loads(listed.stdout)["tests"]:
        properties = {p["name"]: p["value"] for p in test["properties"]}
        command = test.get("command", [])
        if not command or not pathlib.Path(command[0]).exists() or not set(properties.get("LABELS", [])).isdisjoint({"house", "page"}):
            continue
        if not re.search(pattern, test["name"]) or test["name"].startswith("benchmarks"):
            continue
        environment = dict(entry.split("=", 1) for entry in properties.get("ENVIRONMENT", []))
        folder = properties.get("WORKING_DIRECTORY", str(build))
        if "program" in properties.get("LABELS", []):  # whole, not in the halves that ctest knows
            name = pathlib.Path(command[0]).name
            environment = {"GTEST_FAIL_FAST": "1", "RC_PARAMS": rapidcheck_parameters(tree)}
            found[name] = Program(name, [command[0]], folder, environment, False)
        elif test["name"].startswith("cli.") and pathlib.Path(environment["ORISPLINE_COMMAND"]).exists():
            found[test["name"]] = Program(test["name"], [*command, "--failfast"], folder, environment, True)
    return list(found.values())


def record(program, folder, count):
    """Runs the original: its time, and which mutants it comes by."""
    reached = folder / "reached"
    shutil.rmtree(reached, ignore_errors=True)
    reached.mkdir(parents=True)
    before = time.monotonic()
    status = program.run({"ORISPLINE_MUTANTS_REACHED": str(reached)}, 1800, folder / "record")
    program.seconds = time.monotonic() - before
    for path in reached.iterdir():
        program.reached |= {i for i, mark in enumerate(path.read_bytes()[:count]) if mark}
    return status


def untried(mutant, known, before):
    """The programs that come by a mutant and did not run it in an earlier trial: the fast ones first, scripts last."""
    done = before["programs"] if before else ()
    reaching = (p for p in known if mutant.id in p.reached and p.name not in done)
    return sorted(reaching, key=lambda p: (p.is_script, p.seconds))


def tried(mutant, known, before, scratch):
    """What became of a mutant: a dictionary for the results. `before`: that of an earlier trial with other programs."""
    start = time.monotonic()
    result = {"status": "not reached", "by": None, "programs": [], "seconds": 0.0, **(before or {})}
    for program in untried(mutant, known, before):
        status = program.run({"ORISPLINE_MUTANT": str(mutant.id)}, TIME_FACTOR * program.seconds + TIME_MORE, scratch)
        result["programs"] = [*result["programs"], program.name]
        result["status"] = "survived"
        if status != 0:
            how = "time" if status == "time" else "signal" if status < 0 else "test"
            result |= {"status": "killed", "by": program.name, "how": how}
            break
    result["seconds"] = round(result["seconds"] + time.monotonic() - start, 2)
    return result
