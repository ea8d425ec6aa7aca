#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Samples that orispline smooth writes in the place of keys: bit for bit those of 'sample' on the keys that it writes."""
import json
import math
import random

from command import BAD_USAGE, CommandTest, main, rows_of

GYRO_COLUMNS, POSITION_COLUMNS = ",wx,wy,wz", ",px,py,pz"
OPTIONS = ("--rate 1000", "--rate 30000/1001 --include-end", "--count 77", "--rate 7 --from +1.3 --to +2.71",
           "--rate 50 --from=+-0.5 --to +9 --outside rate", "--rate 50 --from=+-0.5 --to +9 --outside leave-out",
           "--rate 50 --from=+-0.5 --to +9 --extrapolate nan", "--rate 60 --derivatives 3 --frame world", "--rate 60 --derivatives 0",
           "--rate 33 --output-orientation euler --output-angle-unit deg", "--times times.csv")


def recording(epoch="0", positions=False, gyro=False, gap=False, count=250, noise=0.02):
    """A turn about z with noise at 50 Hz, whose times are written with all of their digits from an epoch [s]."""
    dice = random.Random(2)
    lines = ["t,qw,qx,qy,qz" + POSITION_COLUMNS * positions + GYRO_COLUMNS * gyro]
    for i in range(count):
        if gap and 90 <= i < 120:
            continue
        t = i / 50
        half = 0.5 * math.sin(2 * t)
        x, y, z = (0.5 * dice.gauss(0, noise) for _ in range(3))
        w, c, s = math.sqrt(1 - x * x - y * y - z * z), math.cos(half), math.sin(half)
        row = [c * w - s * z, c * x - s * y, c * y + s * x, c * z + s * w]
        row += [f(t) + dice.gauss(0, noise) for f in (math.sin, math.cos, math.sqrt)] * positions
        row += [dice.gauss(0, noise), dice.gauss(0, noise), 2 * math.cos(2 * t) + dice.gauss(0, noise)] * gyro
        lines.append(written_time(epoch, 20 * i + i % 3) + "," + ",".join(map(repr, row)))
    return "\n".join(lines) + "\n"


def written_time(epoch, milliseconds):
    """Seconds with the nine digits of nanoseconds."""
    return f"{int(epoch) + milliseconds // 1000}.{milliseconds % 1000:03d}123457"


class SmoothSamples(CommandTest):
    def assert_samples_are_those_of_the_keys(self, arguments, *options):
        self.output_of(f"smooth {arguments} -o keys.csv --quiet")
        for option in options:
            with self.subTest(arguments=arguments, option=option):
                self.output_of(f"smooth {arguments} {option} -o direct.csv --quiet")
                self.output_of(f"sample keys.csv {option} -o indirect.csv --quiet")
                self.assertEqual(self.read("direct.csv").splitlines(), self.read("indirect.csv").splitlines())
                self.assertGreater(len(self.read("direct.csv").splitlines()), 5)

    def test_every_option_of_time_gives_the_rows_of_sample(self):
        self.write("noisy.csv", recording(positions=True))
        self.write("times.csv", "\n".join(f"{0.2 + 0.37 * k % 4!r}" for k in range(20)) + "\n")
        self.assert_samples_are_those_of_the_keys("noisy.csv", *OPTIONS)

    def test_a_late_epoch_changes_nothing(self):
        self.write("noisy.csv", recording("1700000000", positions=True))
        self.write("times.csv", "\n".join(written_time("1700000000", 137 * k) for k in range(30)) + "\n")
        self.assert_samples_are_those_of_the_keys("noisy.csv", *OPTIONS)

    def test_the_keys_of_a_gyro_are_those_of_its_rates_too(self):
        self.write("gyro.csv", recording("1700000000", gyro=True))
        self.assert_samples_are_those_of_the_keys("gyro.csv --gyro", "--rate 1000", "--count 77")
        poses, rates = ["t,qw,qx,qy,qz"], ["t,wx,wy,wz"]
        for i, line in enumerate(self.read("gyro.csv").splitlines()[1:]):
            cells = line.split(",")
            rates.append(",".join([cells[0], *cells[5:]]))
            if i % 5 == 2:
                poses.append(",".join(cells[:5]))
        self.write("poses.csv", "\n".join(poses) + "\n")
        self.write("rates.csv", "\n".join(rates) + "\n")
        self.assert_samples_are_those_of_the_keys("poses.csv --gyro-file rates.csv", "--rate 200", "--rate 10 --derivatives 3")

    def test_gaps_have_no_samples_or_empty_rows(self):
        self.write("noisy.csv", recording("1700000000", positions=True, gap=True))
        self.assert_samples_are_those_of_the_keys("noisy.csv --gap 0.3", "--rate 100", "--rate 100 --mark-gaps", "--count 500")
        times = [row[0] - 1700000000 for row in rows_of(self.output_of("smooth noisy.csv --gap 0.3 --rate 100 --quiet"))]
        self.assertEqual([t for t in times if 1.8 < t < 2.39], [])
        self.assertGreater(len([t for t in times if t > 2.4]), 200)

    def test_the_summary_counts_the_rows(self):
        self.write("noisy.csv", recording())
        count = lambda options: json.loads(self.output_of(f"smooth noisy.csv {options} --json -o out.csv"))["rows_written"]
        self.assertEqual(count("--count 40"), 40)
        self.assertEqual(count("--rate 10 --from=+-1 --to +1 --outside leave-out"), 11)

    def test_samples_outside_the_curve_are_an_error_where_they_are_to_be(self):
        self.write("noisy.csv", recording())
        done = self.run_command("smooth noisy.csv --rate 10 --to 20 --outside error -o out.csv")
        self.assertEqual((done.returncode, (self.folder / "out.csv").exists()), (BAD_USAGE, False))
        self.assertIn("time 19.900123457 is outside the curve, wanted 0.000123457 to ", done.stderr)

    def test_options_of_samples_want_samples(self):
        self.write("noisy.csv", recording())
        for option in ("--from 1", "--to 1", "--include-end", "--outside nan", "--extrapolate nan", "--mark-gaps", "--yes",
                       "--derivatives 1", "--frame world"):
            self.assert_fails(f"smooth noisy.csv {option}", BAD_USAGE, f"{option.split()[0]}: wanted --rate as well")
        self.assert_fails("smooth noisy.csv --rate 3 --count 5", BAD_USAGE,
                          "found 2 of --rate, --count and --times, wanted one of them, such as --rate 100")
        self.assert_fails("smooth noisy.csv --times noisy.csv -o noisy.csv", BAD_USAGE,
                          "-o: found 'noisy.csv', wanted another file than INPUT, which would be lost")
        self.assert_fails("smooth noisy.csv --times t.csv -o t.csv", BAD_USAGE,
                          "-o: found 't.csv', wanted another file than that of --times, which would be lost")
        self.assert_fails("smooth - --times -", BAD_USAGE,
                          "--times: found '-', wanted a file, since standard input is read once only")
        self.assert_fails("smooth noisy.csv --rate 1e9 --to 1e6", BAD_USAGE, "found a request for 1e+15 samples, wanted 1e+09 at most: "
                          "check the rate and the unit of the times; 'orispline smooth --yes' writes any number")


if __name__ == "__main__":
    main()
