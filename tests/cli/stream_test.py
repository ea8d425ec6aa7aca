#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What `orispline sample` makes while it reads is what it makes of all keys at once, byte for byte, in little memory.

With --sort all keys are held; sorting those that are in order changes nothing.
"""
import functools
import itertools
import json
import math
import os
import random
import subprocess
import sys
import threading

from command import BAD_DATA, BAD_USAGE, COMMAND, CommandTest, main

EPOCH = 1700000000


def keys(count, seed=1):
    """A tumbling body at uneven times, with now and then the other sign and a norm that is a little off."""
    dice = random.Random(seed)
    t, angle = 0.0, [0.0, 0.0, 0.0]
    for i in range(count):
        t += dice.uniform(0.01, 0.03)
        angle = [a + dice.uniform(-0.1, 0.15) for a in angle]
        half = [a / 2 for a in angle]
        norm = math.hypot(*half) or 1.0
        q = [math.cos(norm), *(math.sin(norm) * h / norm for h in half)]
        scale = dice.choice((1, 1, -1)) * dice.choice((1, 1, 1.0000213))
        yield round(t, 6), [scale * c for c in q], [10 * math.sin(0.3 * t), 0.1 * i, 1e4 - t]


@functools.cache
def csv(count, seed=1):
    rows = ["t,qw,qx,qy,qz,px,py,pz"]
    rows += [",".join(map(repr, (t, *q, *p))) for t, q, p in keys(count, seed)]
    return "\n".join(rows) + "\n"


def told(output):
    """What is printed, without that of all keys which a stream does not say."""
    if not output.startswith("{"):
        return output
    document = json.loads(output)
    return document | {"warnings": [warning for warning in document["warnings"] if warning["code"] != "overshot_span"]}


class Streamed(CommandTest):
    """More keys than a piece has, so that there are several."""

    COUNT = 40000

    def assert_same(self, arguments, suffix="csv", **options):
        """Samples, summary and exit code, of a file and through a pipe, with the keys held and without."""
        self.assertNotIn("--sort", arguments)
        held = self.run_command(f"sample {arguments} --sort -o held.{suffix}", **options)
        done = self.run_command(f"sample {arguments} -o streamed.{suffix}", **options)
        # Where a curve swings away is said of keys that are all at hand.
        said = ["".join(line for line in text.splitlines(True) if " away from the shortest way, " not in line)
                for text in (done.stderr.replace("streamed", "held"), held.stderr)]
        self.assertEqual(*said)
        self.assertEqual((done.returncode, told(done.stdout.replace("streamed", "held"))), (held.returncode, told(held.stdout)))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue((self.folder / f"held.{suffix}").read_bytes() == (self.folder / f"streamed.{suffix}").read_bytes(),
                        f"{arguments}: the samples differ")

    def test_every_local_method_has_the_samples_of_all_keys(self):
        self.write("keys.csv", csv(18001))
        methods = [method for method in json.loads(self.output_of("methods --json")) if method["support_keys"]]
        self.assertGreaterEqual(len(methods), 28)
        for method in methods:
            with self.subTest(method["name"]):
                self.assert_same(f"keys.csv --method {method['name']} --rate 25 --derivatives 3")

    def test_rates_far_above_and_far_below_that_of_the_keys(self):
        self.write("keys.csv", csv(self.COUNT))
        for rate in ("0.003", "1e-7", "0.7", "49.9", "333.3"):
            self.assert_same(f"keys.csv --rate {rate}")

    def test_ranges_that_do_not_end_where_the_keys_do(self):
        self.write("keys.csv", csv(20000))
        for times in ("--from=-3.5", "--to 500.25", "--from 100 --to 230.1", "--from 3 --to 3", "--from -2 --to=-1",
                      "--from 5000 --to 5001", "--from 390 --to 410"):
            for method in ("auto", "beta", "bspline"):
                self.assert_same(f"keys.csv --method {method} --rate 40 {times}")

    def test_times_of_today_in_every_format(self):
        rows = list(keys(20000))
        texts = {"keys.tum": "", "degrees.csv": "t_ms,px_mm,py_mm,pz_mm,roll_deg,pitch_deg,yaw_deg\n",
                 "euroc.csv": "#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z []\n"}
        for t, q, p in rows:
            second, micros, place = EPOCH + int(t), f"{round(1e6 * (t % 1)):06}", ",".join(map(repr, p))
            texts["keys.tum"] += " ".join([f"{second}.{micros}", *map(repr, (*p, *q[1:], q[0]))]) + "\n"
            texts["degrees.csv"] += f"{second}{micros[:3]}.{micros[3:]},{place},{t!r},{30 * math.sin(t)!r},{3 * t!r}\n"
            texts["euroc.csv"] += f"{second}{micros}000,{place},{','.join(map(repr, q))}\n"
        for name, text in texts.items():
            self.write(name, text)
            for suffix in ("csv", "tum", "npy"):
                self.assert_same(f"{name} --rate 25", suffix)
            self.assert_same(f"{name} --rate 25 --output-format euroc")

    def test_options_of_reading_and_of_writing(self):
        self.write("keys.csv", csv(20000))
        for options in ("--signs as-given --method slerp", "--conjugate", "--time-scale 2",
                        "--frame world --derivatives 2", "--output-orientation euler", "--threads 1", "--threads 7",
                        "--ends natural --method timed-c2", "--ends rest,clamped --end-rate=0,0,1 --method timed-c2",
                        "--start-rate=0.1,0,0 --method timed-c2", "--set tension=0.3 --method timed-c2",
                        "--set hold=1", "--method bspline:degree=5", "--extrapolate error", "--extrapolate segment",
                        "--extrapolate nan --from=-3", "--json"):
            self.assert_same(f"keys.csv --rate 40 {options}")

    def test_repairs_rates_and_parameters_of_the_keys(self):
        lines = [f"{t!r},{','.join(map(repr, q))},{0.1 * i % 1!r},0.1,-0.2,0.3"
                 for i, (t, q, _) in enumerate(keys(20000))]
        for i in range(0, 20000, 501):
            lines.insert(i + 1, lines[i])
            lines.insert(i, "nan" + lines[i][lines[i].index(","):])
        self.write("keys.csv", "t,qw,qx,qy,qz,tension,wx,wy,wz\n" + "\n".join(lines))
        for method in ("timed-c2", "quintic", "hermite-c2", "auto"):
            self.assert_same(f"keys.csv --drop-duplicates --drop-invalid --rate 40 --method {method}")

    def test_a_last_sample_that_rounding_hides_stands_at_the_end(self):
        for step in (0.1, 0.3, 1e-10):
            self.write("keys.csv", "t,qw,qx,qy,qz\n" + "".join(f"{round(i * step, 12)!r},1,0,0,0\n" for i in range(33000)))
            for rate in (10, 3, 1e-4):
                self.assert_same(f"keys.csv --rate {rate}")

    def test_few_keys(self):
        for count in range(1, 9):
            self.write("keys.csv", csv(count))
            for method in ("slerp", "auto", "timed-c2", "squad-timed"):
                self.assert_same(f"keys.csv --rate 100 --method {method}")


class Pipes(CommandTest):
    def test_a_pipe_is_read_like_a_file(self):
        text = csv(40000)
        self.write("keys.csv", text)
        from_file = self.run_command("sample keys.csv --rate 60")
        from_pipe = self.run_command("sample - --rate 60", input=text)
        self.assertTrue(from_file.stdout == from_pipe.stdout)
        self.assertEqual(from_pipe.stderr, from_file.stderr.replace("keys.csv", "-"))

    def test_samples_that_overwrite_the_keys_are_those_of_all_keys(self):
        self.write("keys.csv", csv(40000))
        expected = self.output_of("sample keys.csv --rate 60")
        with open(self.folder / "keys.csv", "r+", encoding="utf-8") as file:
            done = subprocess.run([COMMAND, "sample", "keys.csv", "--rate", "60", "--quiet"], cwd=self.folder, stdout=file,
                                  check=False)
        self.assertEqual(done.returncode, 0)
        self.assertTrue(self.read("keys.csv").startswith(expected))

    @staticmethod
    def feed(pipe):
        """Keys without an end, as long as somebody reads them."""
        try:
            pipe.write(csv(20000).encode())
            for second in itertools.count(1000):
                pipe.write(f"{second},1,0,0,0,0,0,0\n".encode())
        except BrokenPipeError:
            pass

    def test_samples_come_while_the_keys_do(self):
        with subprocess.Popen([COMMAND, "sample", "-", "--rate", "60", "--derivatives", "0"], cwd=self.folder,
                              stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            threading.Thread(target=self.feed, args=(process.stdin,), daemon=True).start()
            self.assertEqual(process.stdout.readline(), b"t,qw,qx,qy,qz,px,py,pz\n")
            self.assertTrue(process.stdout.readline().startswith(b"0.0"))
            process.kill()


class LateErrors(CommandTest):
    """What is wrong behind the first piece is said as before, and leaves the old output."""

    COUNT = 40000

    def assert_refused(self, row, code, message, options=""):
        self.write("keys.csv", csv(self.COUNT) + row)
        self.write("out.csv", "precious")
        done = self.run_command(f"sample keys.csv --rate 60 -o out.csv {options}")
        self.assertEqual((done.returncode, done.stdout), (code, ""), done.stderr)
        self.assertTrue(done.stderr.startswith(f"orispline: {message}"), done.stderr)
        self.assertEqual(self.read("out.csv"), "precious")
        self.assertEqual([path.name for path in self.folder.iterdir() if "part" in path.name], [])

    def test_a_row_that_is_none(self):
        self.assert_refused("9999,1,0\n", BAD_DATA, "keys.csv:40002: key 40000: found 3 cells, wanted 8\n")
        self.assert_refused("9999,1,0,zero,0,0,0,0\n", BAD_DATA, "keys.csv:40002:4: key 40000: found 'zero', wanted a number")

    def test_a_key_that_is_none(self):
        self.assert_refused("9999,1,1,0,0,0,0,0\n", BAD_DATA,
                            "keys.csv:40002: key 40000: the quaternion has norm 1.41421, wanted 1 within 0.02 "
                            "(--normalise takes any norm but 0)\n")
        self.assert_refused("1,1,0,0,0,0,0,0\n", BAD_DATA, "keys.csv:40002: key 40000: time 1 comes after ")

    def test_times_that_the_curve_does_not_cover(self):
        self.assert_refused("", BAD_USAGE, "--from 5000 is after the end at ", "--from 5000")
        self.assert_refused("", BAD_USAGE, "--to -1 is before the start at ", "--to=-1")
        self.assert_refused("", BAD_USAGE, "time 4999.99", "--to 5000 --extrapolate error")
        self.assert_refused("", BAD_USAGE, "time -1 is outside the curve, wanted ", "--from=-1 --extrapolate error")


class Memory(CommandTest):
    """By how much more a run takes for more keys or samples, beside one that holds all keys."""

    # A small process in between, for what a child has of its parent before it becomes the command counts as its own.
    MEASURED = """
import resource, subprocess, sys
code = subprocess.call(sys.argv[1:])
print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)
sys.exit(code)
"""

    def peak(self, arguments, lines=()):
        """Of a run that reads these lines from a pipe."""
        # A build with AddressSanitizer keeps freed memory back unless told otherwise.
        environment = {**os.environ, "ASAN_OPTIONS": "quarantine_size_mb=0:thread_local_quarantine_size_kb=0"}
        command = [sys.executable, "-c", self.MEASURED, COMMAND, "sample", *arguments.split(), "--quiet", "-o", os.devnull]
        with subprocess.Popen(command, cwd=self.folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                              env=environment) as process:
            for line in lines:
                process.stdin.write(line)
            process.stdin.close()
            peak = int(process.stdout.read())
            self.assertEqual(process.wait(), 0)
        return peak

    @staticmethod
    def seconds(count):
        """So many seconds of keys at 100 Hz."""
        yield b"t,qw,qx,qy,qz\n"
        for second in range(count):
            yield "".join(f"{second}.{i:02},1,0,0,0\n" for i in range(100)).encode()

    def growth(self, arguments):
        """From few keys, which fill all buffers, to three times as many more."""
        few, many = (self.peak(f"- --threads 2 {arguments}", self.seconds(count)) for count in (600, 2400))
        return many - few

    def test_memory_does_not_grow_with_the_keys(self):
        held = self.growth("--rate 100 --sort")
        for rate in (100, 0.01):
            self.assertLess(self.growth(f"--rate {rate}"), held / 4)

    def test_memory_does_not_grow_with_the_samples(self):
        few, many = (self.peak(f"keys.csv --count {count}") for count in (40000, 400000))
        self.assertLess(many, 1.2 * few)

    def test_memory_does_not_grow_with_the_samples_of_a_pause(self):
        self.write("keys.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n1,1,0,0,0\n2,1,0,0,0\n30,0.8,0.6,0,0\n31,1,0,0,0\n")
        few, many = (self.peak(f"keys.csv --rate {rate} --threads 2") for rate in (5000, 50000))
        self.assertLess(many, 1.2 * few)


if __name__ == "__main__":
    main()
