#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""However a run ends, an output is the old file whole or the new file whole."""
import concurrent.futures
import fcntl
import itertools
import os
import pathlib
import random
import resource
import signal
import subprocess
import tempfile
import time
import unittest

from command import BAD_ACCESS, COMMAND, SUCCESS, CommandTest, main, with_pages

RUNS = 100
SEED = 20
SIGNALS = (signal.SIGKILL, signal.SIGINT, signal.SIGTERM)
COMMANDS = ("sample keys.csv --count 40000 --derivatives 3", "convert many.csv", "smooth some.csv",
            "reduce some.csv --tolerance 1e-3deg")
OLD = "precious\n"


def keys(count):
    return "t,qw,qx,qy,qz\n" + "".join(f"{t},1,0,{t % 7 / 9e4},{t % 3 / 9e4}\n" for t in range(count))


class TornOutput(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("many.csv", keys(20000))
        self.write("some.csv", keys(500))

    def started(self, command, output):
        return subprocess.Popen([COMMAND, *command.split(), "-o", output], cwd=self.folder, stderr=subprocess.DEVNULL)

    def whole_runs(self):
        """The complete output and the duration [s] of each command."""
        for i, command in enumerate(COMMANDS):
            begun = time.monotonic()
            self.assertEqual(self.started(command, f"whole{i}.csv").wait(60), SUCCESS)
            yield self.read(f"whole{i}.csv"), time.monotonic() - begun

    def test_a_signal_at_any_moment_tears_nothing(self):
        whole = list(self.whole_runs())
        dice = random.Random(SEED)

        def ended(i):
            """What the file holds after a signal, what it may hold, and the signal."""
            which, sent, moment = i % len(COMMANDS), SIGNALS[i % len(SIGNALS)], dice.random()
            output = self.folder / f"out{i}.csv"
            output.write_text(OLD, "utf-8")
            process = self.started(COMMANDS[which], output.name)
            time.sleep(moment * whole[which][1])
            process.send_signal(sent)
            code = process.wait(60)
            return output, {-sent: {OLD, whole[which][0]}, SUCCESS: {whole[which][0]}}.get(code, set()), sent

        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            for output, allowed, sent in pool.map(ended, range(RUNS)):
                self.assertIn(output.read_text("utf-8"), allowed, f"{output.name} after signal {sent}")
                if sent != signal.SIGKILL:
                    self.assertFalse(output.with_name(output.name + ".part").exists(), output.name)

    def test_a_file_that_may_not_grow_leaves_the_old_one(self):
        def limited(handler):
            signal.signal(signal.SIGXFSZ, handler)
            resource.setrlimit(resource.RLIMIT_FSIZE, (10000, 10000))

        self.write("out.csv", OLD)
        for command, handler in itertools.product(COMMANDS, (signal.SIG_IGN, signal.SIG_DFL)):
            with self.subTest(command, handler=handler):
                done = self.run_command(command.split() + ["-o", "out.csv"], preexec_fn=lambda: limited(handler))
                self.assertEqual((done.returncode, done.stderr),
                                 (BAD_ACCESS, "orispline: out.csv: cannot write: File too large\n"))
                self.assertEqual(self.read("out.csv"), OLD)
                self.assertFalse((self.folder / "out.csv.part").exists())

    def test_what_a_killed_run_leaves_the_next_one_removes(self):
        for i, command in enumerate(COMMANDS):
            with self.subTest(command):
                output = self.folder / f"next{i}.csv"
                part = output.with_name(output.name + ".part")
                process = self.started(command, output.name)
                deadline = time.monotonic() + 60
                while not part.exists() and process.poll() is None and time.monotonic() < deadline:
                    time.sleep(1e-4)
                process.kill()
                process.wait(60)
                if not part.exists():
                    part.write_text("torn", "utf-8")  # it was done before it could be killed
                done = self.run_command(command.split() + ["-o", output.name])
                self.assertEqual(done.returncode, SUCCESS)
                self.assertFalse(part.exists())

    def test_a_run_leaves_the_part_of_another_that_lives(self):
        self.output_of("convert keys.csv -o out.csv --quiet")
        with open(self.folder / "out.csv.part", "w", encoding="utf-8") as part:
            fcntl.flock(part, fcntl.LOCK_EX)
            self.output_of("convert keys.csv -o out.csv --quiet")
            self.assertTrue((self.folder / "out.csv.part").exists())
        self.output_of("convert keys.csv -o out.csv --quiet")
        self.assertFalse((self.folder / "out.csv.part").exists())

    @with_pages
    def test_a_report_that_cannot_be_written_leaves_the_table(self):
        table = self.output_of("compare some.csv --keep-every 10 --methods slerp,auto --csv")

        def limited():
            resource.setrlimit(resource.RLIMIT_FSIZE, (10000, 10000))

        done = self.run_command("compare some.csv --keep-every 10 --methods slerp,auto --csv --report out.html",
                                preexec_fn=limited)
        self.assertEqual((done.returncode, done.stderr), (BAD_ACCESS, "orispline: out.html: cannot write: File too large\n"))
        self.assertEqual([row.split(",")[0] for row in done.stdout.splitlines()],
                         [row.split(",")[0] for row in table.splitlines()])
        self.assertEqual(list(self.folder.glob("out.html*")), [])

    def test_a_full_file_system_leaves_the_old_file(self):
        with tempfile.TemporaryDirectory() as place:
            mounted = os.geteuid() == 0 and subprocess.run(
                ["mount", "-t", "tmpfs", "-o", "size=8k", "tmpfs", place], stderr=subprocess.DEVNULL, check=False).returncode == 0
            if not mounted:
                raise unittest.SkipTest("only root may mount a small file system")
            try:
                output = pathlib.Path(place) / "out.csv"
                output.write_text(OLD, "utf-8")
                for command in COMMANDS:
                    with self.subTest(command):
                        done = self.run_command(command.split() + ["-o", str(output)])
                        self.assertEqual((done.returncode, done.stderr),
                                         (BAD_ACCESS, f"orispline: {output}: cannot write: No space left on device\n"))
                        self.assertEqual([output], list(output.parent.iterdir()))
                        self.assertEqual(output.read_text("utf-8"), OLD)
            finally:
                subprocess.run(["umount", place], check=True)


if __name__ == "__main__":
    main()
