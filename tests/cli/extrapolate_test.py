#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What `orispline sample` writes for times outside the curve."""
import math

from command import KEYS, CommandTest, main, rows_of


class Extrapolate(CommandTest):
    def test_outside_the_keys_what_is_asked_for(self):
        half = math.sqrt(0.5)
        self.write("turn.csv", f"t,qw,qx,qy,qz,px,py,pz\n0,1,0,0,0,0,0,0\n1,{half},0,0,{half},2,0,0\n")
        ask = "sample turn.csv --method slerp --times t.csv --derivatives 1 --extrapolate "
        self.write("t.csv", "-1\n0.5\n2\n")
        turning, moving = [0, 0, math.pi / 2], [2, 0, 0]
        for word in ("rate", "segment"):  # a steady turn goes on by a quarter before and behind
            before, inside, behind = rows_of(self.output_of(ask + word))
            for found, wanted in ((before, [-1, half, 0, 0, -half, -2, 0, 0, *turning, *moving]),
                                  (behind, [2, 0, 0, 0, 1, 4, 0, 0, *turning, *moving])):
                for number, want in zip(found, wanted, strict=True):
                    self.assertAlmostEqual(number, want, delta=1e-14)
        self.assertEqual([rows_of(self.output_of(ask + word))[1] for word in ("hold", "nan", "rate")], [inside] * 3)
        lines = self.output_of(ask + "nan").splitlines()
        self.assertEqual([lines[1], lines[3]], ["-1" + 13 * ",nan", "2" + 13 * ",nan"])

    def test_outside_the_keys_the_formula_of_a_curve_goes_on_with_its_rates(self):
        ask = "sample keys.csv --method rotation-spline --times t.csv --derivatives 2 --extrapolate segment"
        step = 1e-4
        self.write("t.csv", f"{-1 - step!r}\n-1\n{-1 + step!r}\n")
        early, now, late = rows_of(self.output_of(ask))
        for k in range(3):
            self.assertAlmostEqual((late[5 + k] - early[5 + k]) / (2 * step), now[8 + k], delta=1e-5)
        self.assertNotEqual(now[8:], [0, 0, 0])

    def test_the_summary_says_what_samples_outside_do(self):
        for word, text in (("hold", "hold the end orientation"), ("nan", "are NaN"), ("rate", "keep the rate of the end"),
                           ("segment", "follow the formula of the end segment")):
            done = self.run_command(f"sample keys.csv --rate 1 --from -1 --to 4 --extrapolate {word} -o {word}.csv")
            self.assertIn(f"2 samples outside the curve {text}\n", done.stdout + done.stderr)
            self.assertEqual("outside_curve" in done.stderr or "lies outside" in done.stderr, word == "hold")

    def test_keys_from_a_pipe_go_on_outside_too(self):
        for word in ("nan", "rate", "segment"):
            ask = f"--rate 2 --from -1 --to 4 --method timed-c2 --extrapolate {word}"
            self.assertEqual(self.output_of(f"sample - {ask}", input=KEYS), self.output_of(f"sample keys.csv {ask}"))


if __name__ == "__main__":
    main()
