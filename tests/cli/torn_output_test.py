#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""However a run ends, an output is the old file whole or the new file whole."""
import contextlib
import fcntl
import itertools
import os
import pathlib
import resource
import signal
import subprocess
import tempfile
import time
import unittest

from command import BAD_ACCESS, COMMAND, CommandTest, main, with_pages

COMMANDS = ("sample keys.csv --count 40000 --derivatives 3", "convert many.csv", "smooth some.csv",
            "reduce some.csv --tolerance 1e-3deg")
OLD = "precious\n"


def keys(count):
    return "t,qw,qx,qy,qz\n" + "".join(f"{t},1,0,{t % 7 / 9e4},{t % 3 / 9e4}\n" for t in range(count))


def wait_for(process, happened):
    """Until it has happened, or the process has ended; how long that takes does not matter."""
    while process.poll() is None and not happened():
        time.sleep(0.01)


class TornOutput(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("many.csv", keys(20000))
        self.write("some.csv", keys(500))

    @contextlib.contextmanager
    def waiting(self, output):
        """A run that has written a part of its output, and waits for more keys, which do not come."""
        part = self.folder / f"{output}.part"
        with subprocess.Popen([COMMAND, *"sample - --rate 2 -o".split(), output], cwd=self.folder, stdin=subprocess.PIPE,
                              stderr=subprocess.DEVNULL) as process:
            process.stdin.write(keys(40000).encode())
            process.stdin.flush()
            wait_for(process, lambda: part.exists() and part.stat().st_size > 0)
            yield process, part

    def test_a_signal_leaves_the_old_file_and_the_next_run_removes_the_part_of_a_killed_one(self):
        for sent in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL):
            with self.subTest(sent.name):
                self.write("out.csv", OLD)
                with self.waiting("out.csv") as (process, part):
                    process.send_signal(sent)
                    self.assertEqual(process.wait(), -sent)
                self.assertEqual(self.read("out.csv"), OLD)
                self.assertEqual(part.exists(), sent == signal.SIGKILL)
        self.output_of("convert keys.csv -o out.csv --quiet")
        self.assertFalse(part.exists())

    def test_a_signal_leaves_the_outputs_that_are_complete(self):
        os.mkfifo(self.folder / "waits.csv")
        words = "sample keys.csv some.csv waits.csv --rate 2 --threads 4 --output-folder out --quiet".split()
        whole = {name: self.output_of(f"sample {name} --rate 2") for name in ("keys.csv", "some.csv")}
        done = [self.folder / "out" / name for name in whole]
        with subprocess.Popen([COMMAND, *words], cwd=self.folder, stderr=subprocess.DEVNULL) as process:
            with open(self.folder / "waits.csv", "w", encoding="utf-8"):  # opened as soon as it is read
                wait_for(process, lambda: all(path.exists() for path in done))
                process.send_signal(signal.SIGTERM)
                self.assertEqual(process.wait(), -signal.SIGTERM)
        self.assertEqual({path.name: path.read_text("utf-8") for path in (self.folder / "out").iterdir()}, whole)

    def test_a_signal_leaves_no_part_of_many_outputs_that_wait_for_each_other(self):
        count, files = 1100, resource.getrlimit(resource.RLIMIT_NOFILE)[1]
        if files < count + 100:
            raise unittest.SkipTest(f"a process may have {files} open files")
        (self.folder / "in").mkdir()
        for i in range(count):
            self.write(f"in/{i:04}.csv", keys(3))
        os.mkfifo(self.folder / "waits.csv")
        words = "sample in waits.csv --rate 2 --threads 2 --output-folder out --all-or-none --quiet".split()
        with subprocess.Popen([COMMAND, *words], cwd=self.folder, stderr=subprocess.DEVNULL) as process:
            with open(self.folder / "waits.csv", "w", encoding="utf-8"):  # opened as soon as it is read, which is at the end
                wait_for(process, lambda: len(list((self.folder / "out").glob("*.part"))) == count)
                process.send_signal(signal.SIGINT)
                self.assertEqual(process.wait(), -signal.SIGINT)
        self.assertEqual(list((self.folder / "out").iterdir()), [])

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

    def test_every_command_removes_the_part_that_a_killed_run_left(self):
        for command in COMMANDS:
            with self.subTest(command):
                self.write("out.csv.part", "torn")
                self.output_of(f"{command} -o out.csv --quiet")
                self.assertFalse((self.folder / "out.csv.part").exists())

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
