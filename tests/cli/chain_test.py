#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""smooth, reduce, tune, retime, sample: each reads what the one before has written, settings included."""
import csv
import json
import math
import pathlib

from command import BAD_USAGE, CommandTest, main, table_of

DATA = pathlib.Path(__file__).resolve().parents[2] / "examples/data"
SHAPE = "--method timed-c2 --ends rest"


class Chain(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("flight.csv", (DATA / "flight_truth.csv").read_text("utf-8"))

    def summary(self, arguments):
        return json.loads(self.output_of(f"{arguments} --json"))

    def rows(self, name):
        return list(csv.DictReader(table_of(self.read(name))))

    def test_from_a_noisy_recording_to_a_motion_within_limits(self):
        self.output_of("smooth flight.csv -o clean.csv")
        reduced = self.summary(f"reduce clean.csv --tolerance 0.5deg {SHAPE} -o keys.csv")
        self.assertLess(reduced["keys"], reduced["samples"] / 4)
        tuned = self.summary(f"tune keys.csv {SHAPE} -o tuned.csv")
        self.assertLess(tuned["energy_after"], tuned["energy_before"])
        slow = self.summary(f"retime tuned.csv {SHAPE} --max-rate 60deg/s --max-acceleration 400deg/s2 -o slow.csv")
        self.assertGreater(slow["time_scale"], 1.5)
        self.output_of(f"sample slow.csv {SHAPE} --rate 200 -o motion.csv")

        for before, after in zip(self.rows("tuned.csv"), self.rows("slow.csv"), strict=True):
            self.assertEqual((before["tension"], before["tension2"]), (after["tension"], after["tension2"]))
        samples = self.rows("motion.csv")
        rates = [math.degrees(math.hypot(*(float(s[w]) for w in ("wx", "wy", "wz")))) for s in samples]
        accelerations = [math.degrees(math.hypot(*(float(s[a]) for a in ("ax", "ay", "az")))) for s in samples]
        self.assertLessEqual(max(rates), 60)
        self.assertLessEqual(max(accelerations), 400)
        self.assertAlmostEqual(max(max(rates) / 60, math.sqrt(max(accelerations) / 400)), 1, delta=0.02)
        self.assertLess(rates[0], 1e-9)  # at rest

    def test_keys_of_smooth_reduce_tune_and_retime_are_the_same_motion_where_nothing_is_to_be_done(self):
        self.output_of("smooth flight.csv -o clean.csv --quiet")
        self.output_of(f"reduce clean.csv --tolerance 1deg {SHAPE} -o keys.csv --quiet")
        self.output_of(f"tune keys.csv {SHAPE} -o tuned.csv --quiet")
        self.output_of(f"retime tuned.csv {SHAPE} --max-rate 1e6deg/s -o same.csv --quiet")
        sampled = [self.output_of(f"sample {name} {SHAPE} --rate 50 --quiet") for name in ("tuned.csv", "same.csv")]
        self.assertEqual(*sampled)
        self.assertNotEqual(sampled[0], self.output_of(f"sample keys.csv {SHAPE} --rate 50 --quiet"))

    def test_reduce_keeps_the_settings_of_the_samples_that_it_keeps(self):
        header, *lines = [line for line in self.read("flight.csv").splitlines() if not line.startswith("#")]
        tensions = [str(0.01 * (i % 7)) for i in range(len(lines))]
        self.write("tense.csv", "\n".join([header + ",tension", *map(",".join, zip(lines, tensions))]) + "\n")
        self.output_of("reduce tense.csv --tolerance 2deg --method quintic -o keys.csv")
        tension_at = dict(zip((float(line.split(",")[0]) for line in lines), tensions))
        keys = self.rows("keys.csv")
        self.assertLess(len(keys), len(lines) / 2)
        for key in keys:
            self.assertEqual(float(key["tension"]), float(tension_at[float(key["t"])]))
        # The tolerance holds with these tensions.
        distance = self.summary("sample keys.csv --method quintic --count 10 --truth flight.csv -o motion.csv")["truth"]
        self.assertLessEqual(distance["distance_max_deg"], 2)

    def test_settings_on_the_command_line_shape_what_reduce_and_retime_promise(self):
        self.output_of("reduce flight.csv --tolerance 1deg --method timed-c1 --tension=0.3 -o keys.csv")
        distance = self.summary(
            "sample keys.csv --method timed-c1 --tension=0.3 --count 10 --truth flight.csv -o motion.csv")["truth"]
        self.assertLessEqual(distance["distance_max_deg"], 1)
        plain = self.summary("retime keys.csv --method timed-c1 --max-rate 60deg/s -o plain.csv")
        tense = self.summary("retime keys.csv --method timed-c1:tension=0.3 --max-rate 60deg/s -o tense.csv")
        self.assertNotEqual(plain["time_scale"], tense["time_scale"])

    def test_what_slowing_and_reducing_cannot_keep_is_refused(self):
        for arguments, message in (
                ("retime keys.csv --method timed-c2 --start-rate=0,0,1 --max-rate 1deg/s",
                 "timed-c2: found a rate at an end, which slowing would change, wanted an end rule without one, such as "
                 "natural or rest"),
                ("retime keys.csv --method timed-c2:closed --max-rate 1deg/s",
                 "timed-c2: loops are not slowed, wanted an open curve"),
                ("retime keys.csv --method tcb --set continuity=0.5 --max-acceleration 1deg/s2",
                 "tcb: its angular velocity jumps at keys with these settings, which no slowing brings within a limit of "
                 "acceleration or torque, wanted others, with which it is C1"),
                ("retime keys.csv --method timed-c2 --tension=0,0.5,0 --max-rate 1deg/s -o slow.tum",
                 "-o: a TUM file has no column for tension, with which the limits hold, wanted CSV"),
                ("reduce keys.csv --method timed-c2:closed --tolerance 1deg",
                 "timed-c2: loops are not reduced, wanted an open curve"),
                ("reduce keys.csv --method quintic --ends cubic --tolerance 1deg",
                 "quintic: with these ends it needs 4 keys, wanted an end rule that needs 2, such as natural"),
                ("reduce keys.csv --tension=1 --tolerance 1deg",
                 "options that shape a curve want --method with one method as well")):
            with self.subTest(arguments):
                self.assert_fails(arguments, BAD_USAGE, message)


if __name__ == "__main__":
    main()
