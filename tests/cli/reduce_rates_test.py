#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`orispline reduce --method hermite-c1`: keys with rates that were sought, and clips that are closed."""
import math

from command import BAD_USAGE, main, rows_of, table_of
from small_scenes import SceneTest, angle_between, parts_of_glb, samplers_of

HEADER = "t,qw,qx,qy,qz,wx,wy,wz"


def tumbling(count):
    """A motion without corners about an axis that turns, at 50 Hz."""
    rows = ["t,qw,qx,qy,qz"]
    for k in range(count):
        t = 0.02 * k
        half, tilt = math.radians(40 * math.sin(1.3 * t) + 25 * t) / 2, 0.8 * math.sin(0.7 * t)
        rows.append(f"{t:.2f},{math.cos(half)!r},{math.sin(half) * math.cos(tilt)!r},{math.sin(half) * math.sin(tilt)!r},0")
    return "\n".join(rows) + "\n"


class ReduceRates(SceneTest):
    def setUp(self):
        super().setUp()
        self.write("motion.csv", tumbling(301))

    def test_keys_and_rates_give_the_recording_again(self):
        for tolerance in (0.05, 0.5):
            told = self.json_of(f"reduce motion.csv --method hermite-c1 --tolerance {tolerance}deg -o keys.csv")
            lines = table_of(self.read("keys.csv"))
            self.assertEqual((lines[0], len(lines) - 1), (HEADER, told["keys"]))
            auto = self.json_of(f"reduce motion.csv --method auto --tolerance {tolerance}deg -o other.csv")
            self.assertLess(told["keys"], 0.75 * auto["keys"])
            self.output_of("sample keys.csv --times motion.csv -o again.csv")  # the file names its method
            farthest = max(angle_between(row[1:5], again[1:5]) for row, again in
                           zip(rows_of(self.read("motion.csv")), rows_of(self.read("again.csv")), strict=True))
            self.assertAlmostEqual(farthest, told["error_max_deg"], delta=1e-9)
            self.assertLessEqual(farthest, tolerance)

    def test_the_keys_are_rows_of_the_recording_and_their_rates_are_those_of_the_motion(self):
        self.output_of("reduce motion.csv --method hermite-c1 --tolerance 0.01deg -o keys.csv")
        given = {row[0]: row[1:] for row in rows_of(self.read("motion.csv"))}
        self.output_of("sample motion.csv --times keys.csv --method auto -o rates.csv")
        near = {row[0]: row[5:8] for row in rows_of(self.read("rates.csv"))}
        keys = rows_of(self.read("keys.csv"))
        for row in keys:
            self.assertEqual(row[1:5], given[row[0]])
        for row in keys[1:-1]:
            self.assertLess(math.dist(row[5:8], near[row[0]]), 0.03)  # [rad/s], of up to 1.8

    def test_a_file_without_room_for_rates_is_refused_before_it_is_written(self):
        done = self.run_command("reduce motion.csv --method hermite-c1 --tolerance 0.5deg -o keys.tum")
        self.assertEqual(done.returncode, BAD_USAGE)
        self.assertIn("keys.tum: a TUM file has no columns for the rates of the keys, with which the tolerance holds, wanted CSV",
                      done.stderr)
        self.assertFalse((self.folder / "keys.tum").exists())

    def test_rates_are_estimated_where_the_keys_may_move_or_positions_count(self):
        self.output_of("reduce motion.csv --method hermite-c1 --tolerance 0.5deg --refit -o keys.csv")
        self.assertEqual(table_of(self.read("keys.csv"))[0], "t,qw,qx,qy,qz")
        self.output_of("reduce motion.csv --method hermite-c1 --set form=cumulative --tolerance 0.5deg -o keys.csv")
        self.assertEqual(table_of(self.read("keys.csv"))[0], "t,qw,qx,qy,qz")

    def test_keys_of_a_skeleton_have_one_rate_each(self):
        told = self.json_of("reduce arm.bvh --tolerance 0.2deg --method hermite-c1 -o small.glb")
        self.assertEqual(told["method"], "hermite-c1")
        self.assertLessEqual(told["angle_deg"]["largest"], 0.2)
        self.assertLess(told["rotation_keys"], told["rotation_keys_before"] / 5)
        document, _ = parts_of_glb(self.folder / "small.glb")
        for sampler in samplers_of(document, "rotation").values():
            self.assertEqual(sampler["interpolation"], "CUBICSPLINE")

    def test_only_free_tangents_can_be_tied_at_the_seam(self):
        for method in ("cubicspline", "hermite-c1"):
            told = self.json_of(f"reduce arm.bvh --tolerance 0.2deg --closed --method {method} -o small.glb")
            self.assertEqual((told["rotation_tracks"], told["open_tracks"]), (2, 1))  # the elbow ends elsewhere
            self.assertLessEqual(told["angle_deg"]["largest"], 0.2)
        self.assert_fails("reduce arm.bvh --tolerance 0.2deg --closed --method auto -o other.glb", BAD_USAGE,
                          "--closed: found the method auto, wanted cubicspline, or hermite-c1 in its form chart: their tangents are free")
        self.assertFalse((self.folder / "other.glb").exists())


if __name__ == "__main__":
    main()
