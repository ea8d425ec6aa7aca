#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`orispline retime`: that limits hold everywhere, that the slowing is the least one, what is refused."""
import json
import math
import pathlib
import random

from command import BAD_ACCESS, BAD_DATA, BAD_USAGE, CommandTest, main, rows_of, table_of, with_pages
from page_data import HALF_FLOAT

ROBOT = pathlib.Path(__file__).resolve().parents[2] / "examples/data/robot_keys.csv"


def peaks(rows):
    """Largest angular velocity and acceleration [deg/s, deg/s²] of samples without positions."""
    return [math.degrees(max(math.hypot(*row[k:k + 3]) for row in rows)) for k in (5, 8)]


class Retime(CommandTest):
    def setUp(self):
        super().setUp()
        robot = [line.split(",")[:5] for line in ROBOT.read_text("utf-8").splitlines() if not line.startswith("#")]
        self.write("robot.csv", "".join(",".join(row) + "\n" for row in robot))

    def retimed(self, arguments):
        return json.loads(self.output_of(f"retime {arguments} -o slow.csv --json"))

    def sampled(self):
        """Evenly, and at the keys, where accelerations have their edges."""
        return [row for times in ("--count 40001", "--times slow.csv")
                for row in rows_of(self.output_of(f"sample slow.csv {times} --derivatives 2"))]

    def test_a_geodesic_is_slowed_by_its_rate(self):
        self.write("keys.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n1,0.7071067811865476,0,0,0.7071067811865476\n")
        report = self.retimed("keys.csv --max-rate 45deg/s")
        self.assertAlmostEqual(report["time_scale"], 2, delta=2e-4)
        self.assertGreaterEqual(report["time_scale"], 2)
        self.assertLessEqual(report["rate_bound_deg_s"], 45)

    def test_states_how_much_less_slowing_might_do(self):
        report = self.retimed("robot.csv --max-rate 90deg/s")
        self.assertGreaterEqual(report["slack"], 0)
        self.assertLess(report["slack"], 2e-4)
        self.write("rest.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n1e-9,-1,0,1e-16,0\n2e-9,1,1e-16,0,0\n3e-9,-1,0,0,0\n")
        done = self.run_command("retime rest.csv --max-acceleration 0.54rad/s2 -o slow.csv --json")
        report = json.loads(done.stdout)
        self.assertGreater(report["slack"], 2e-4)
        self.assertEqual(done.stderr, "orispline: warning: auto: the motion may be slower than the limits ask for, by a "
                         f"share of up to {report['slack']:.2g}; keys that are very close in time make that happen, so join them into "
                         "one\norispline: warning: auto: the limits are met only where rests are slowed as well, so they are "
                         "longer than they were; equal keys that differ in their last digits make that happen\n")

    def test_steps_that_differ_by_a_million_are_slowed_as_little_as_others(self):
        angles = [0, 60, 100, 30, 80]
        self.write("pair.csv", "t,qw,qx,qy,qz\n" + "".join(
            f"{t},{math.cos(math.radians(a) / 2)!r},{'0,0,' if k % 2 else '0,'}{math.sin(math.radians(a) / 2)!r}"
            f"{'' if k % 2 else ',0'}\n" for k, (t, a) in enumerate(zip((0, 1, 1.000001, 2, 3), angles))))
        for method in ("timed-c1", "timed-c2"):
            report = self.retimed(f"pair.csv --max-rate 90deg/s --method {method}")
            self.assertLess(report["slack"], 2e-4)
            self.assertGreater(report["rate_max_deg_s"], 90 * (1 - 3e-4))

    def test_limits_hold_everywhere_and_are_reached(self):
        for extra in ("", "--per-interval"):
            report = self.retimed(f"robot.csv --max-rate 90deg/s --max-acceleration 200deg/s2 {extra}")
            rate, acceleration = peaks(self.sampled())
            self.assertLessEqual(rate, report["rate_bound_deg_s"])
            self.assertLessEqual(acceleration, report["acceleration_bound_deg_s2"])
            self.assertLessEqual(report["rate_bound_deg_s"], 90)
            self.assertLessEqual(report["acceleration_bound_deg_s2"], 200)
            self.assertGreater(max(rate / 90, acceleration / 200), 1 - (5e-3 if extra else 1e-3))

    def test_intervals_by_themselves_need_less_time(self):
        limits = "robot.csv --max-rate 90deg/s --max-acceleration 200deg/s2"
        self.assertLess(self.retimed(limits + " --per-interval")["time_scale"],
                        0.85 * self.retimed(limits)["time_scale"])

    def test_the_written_keys_keep_the_limits_whatever_the_epoch(self):
        robot = [line.split(",") for line in self.read("robot.csv").splitlines()]
        late = [[f"17{100000000 + float(row[0]):.3f}000001", *row[1:]] for row in robot[1:]]
        self.write("late.csv", "".join(",".join(row) + "\n" for row in [robot[0], *late]))
        for extra in ("", "--per-interval"):
            self.retimed(f"robot.csv --max-rate 30deg/s --max-acceleration 50deg/s2 {extra}")
            soon = self.sampled()
            self.retimed(f"late.csv --max-rate 30deg/s --max-acceleration 50deg/s2 {extra}")
            self.assertTrue(table_of(self.read("slow.csv"))[1].startswith(late[0][0]))
            rows = self.sampled()
            self.assertEqual([row[1:] for row in rows], [row[1:] for row in soon])
            rate, acceleration = peaks(rows)
            self.assertLessEqual(rate, 30)
            self.assertLessEqual(acceleration, 50)

    def test_positions_go_along_with_their_keys(self):
        report = json.loads(self.output_of(f"retime {ROBOT} --max-rate 45deg/s -o slow.csv --json"))
        given = [line.split(",") for line in ROBOT.read_text("utf-8").splitlines() if line[0] not in "#t"]
        slow = rows_of(self.read("slow.csv"))
        self.assertEqual([row[5:8] for row in slow], [[float(cell) for cell in row[5:8]] for row in given])
        self.assertAlmostEqual(slow[-1][0], report["time_scale"] * float(given[-1][0]), places=9)

    def test_torque_of_a_ball_is_its_acceleration(self):
        by_torque = self.retimed("robot.csv --max-torque 6Nm --inertia=2,2,2 --method timed-c2")
        by_acceleration = self.retimed("robot.csv --max-acceleration 3rad/s2 --method timed-c2")
        self.assertAlmostEqual(by_torque["time_scale"], by_acceleration["time_scale"], delta=1e-3)

    def test_a_motion_within_the_limits_stays_as_it_is(self):
        report = self.retimed("keys.csv --max-rate 1000deg/s")
        self.assertEqual(report["time_scale"], 1)
        self.assertEqual([row[0] for row in rows_of(self.read("slow.csv"))], [0, 1, 3])

    @with_pages
    def test_the_report_shows_the_motion_before_and_after_with_the_limits(self):
        for extra in ("", "--per-interval"):
            report = self.retimed(f"robot.csv --max-rate 90deg/s --max-acceleration 200deg/s2 {extra} --report out.html")
            page = self.page("out.html")
            self.assertAlmostEqual(page["limits"]["w"], math.radians(90), delta=1e-6)
            self.assertAlmostEqual(page["limits"]["a"], math.radians(200), delta=1e-6)
            after, before = page["methods"]
            self.assertEqual((after["name"], before["name"]), ("after", "before"))
            self.assertEqual(before["keys"]["t"], [row[0] for row in rows_of(self.read("robot.csv"))])
            for t, row in zip(after["keys"]["t"], rows_of(self.read("slow.csv")), strict=True):
                self.assertAlmostEqual(t, row[0], delta=1e-5)
            self.assertAlmostEqual(before["measures"]["duration_s"], report["duration_before_s"], delta=1e-5)
            self.assertAlmostEqual(after["measures"]["duration_s"], report["duration_after_s"], delta=1e-5)
            for part in ("rate_{}_deg_s", "acceleration_{}_deg_s2"):
                for what in ("bound", "max"):
                    self.assertAlmostEqual(after["measures"][part.format(what)], report[part.format(what)], delta=1e-4)
                self.assertGreater(before["measures"][part.format("max")], report[part.format("limit")])
            for letter in "wa":
                values = after["samples"][letter]
                self.assertLessEqual(max(math.hypot(*values[k:k + 3]) for k in range(0, len(values), 3)),
                                     page["limits"][letter] * (1 + HALF_FLOAT))
            self.assertLessEqual(after["measures"]["peak_acceleration_rad_s2"], page["limits"]["a"] * (1 + 1e-6))
            self.assertEqual(after["samples"]["torque"], [])

    @with_pages
    def test_the_report_has_torques_where_the_inertia_is_known(self):
        report = self.retimed("robot.csv --max-torque 2Nm --inertia=1,2,2.5 --method timed-c2 --report out.html")
        page = self.page("out.html")
        self.assertEqual(page["limits"], {"torque": 2})
        for method in page["methods"]:
            w, a, torque = (method["samples"][name] for name in ("w", "a", "torque"))
            for k in range(0, len(w), 3):
                momentum = [w[k], 2 * w[k + 1], 2.5 * w[k + 2]]
                wanted = (a[k] + w[k + 1] * momentum[2] - w[k + 2] * momentum[1],
                          2 * a[k + 1] + w[k + 2] * momentum[0] - w[k] * momentum[2],
                          2.5 * a[k + 2] + w[k] * momentum[1] - w[k + 1] * momentum[0])
                self.assertLess(math.dist(torque[k:k + 3], wanted), 5 * HALF_FLOAT * (1 + math.hypot(*wanted)))
        self.assertAlmostEqual(page["methods"][0]["measures"]["torque_bound_nm"], report["torque_bound_nm"], delta=1e-6)
        self.assertLessEqual(page["methods"][0]["measures"]["peak_torque_n_m"], 2)

    @with_pages
    def test_reports_are_written_as_by_compare(self):
        self.write("one.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n")
        self.assert_writes_reports_as_compare("retime keys.csv --max-rate 1deg/s --quiet", "retime one.csv --max-rate 1deg/s")

    def even_keys(self, angles):
        self.write("even.csv", "t,qw,qx,qy,qz\n" + "".join(
            f"{t},{math.cos(math.radians(a) / 2)!r},0,0,{math.sin(math.radians(a) / 2)!r}\n"
            for t, a in enumerate(angles)))

    def test_methods_that_are_smooth_on_even_keys_slow_these(self):
        self.even_keys([0, 30, 90, 60, 100])
        for method in ("quintic", "sextic", "xing-quartic", "xing-quintic"):
            report = self.retimed(f"even.csv --max-acceleration 5deg/s2 --method {method}")
            self.assertLessEqual(peaks(self.sampled())[1], report["acceleration_bound_deg_s2"])
            self.assertLessEqual(report["acceleration_bound_deg_s2"], 5)
            self.assertGreater(peaks(self.sampled())[1], 5 * (1 - 1e-3))
        jumps = "quintic: its angular velocity jumps at keys whose times are uneven"
        remedy = ", which no slowing brings within a limit of acceleration or torque, wanted "
        self.assert_fails("retime even.csv --max-acceleration 5deg/s2 --method quintic --per-interval", BAD_USAGE,
                          f"{jumps}{remedy}all intervals slowed alike, or a method that is C1 on any, such as auto")
        self.assert_fails("retime keys.csv --max-acceleration 5deg/s2 --method quintic", BAD_USAGE,
                          f"{jumps}, as these are{remedy}even ones, or a method that is C1 on any, such as auto")

    def test_says_when_intervals_by_themselves_take_longer(self):
        self.even_keys([0, 90, 180, 270])  # a constant rate: nothing to gain
        report = self.retimed("even.csv --max-rate 45deg/s --per-interval")
        self.assertEqual((report["slowing"], report["slowing_asked_for"]), ("uniform", "per-interval"))
        text = self.run_command("retime even.csv --max-rate 45deg/s --per-interval -o slow.csv").stderr
        self.assertIn("slowed by 2", text)
        self.assertIn(", all intervals alike: each by itself saves no time\n", text)
        report = self.retimed("robot.csv --max-rate 90deg/s --max-acceleration 200deg/s2 --per-interval")
        self.assertEqual((report["slowing"], report["slowing_asked_for"]), ("per-interval", "per-interval"))

    def test_intervals_by_themselves_are_sought_where_uniform_slowing_is_hopeless(self):
        rows = ((0, 0), (1e-17, 90), (9e-4, 90))
        self.write("burst.csv", "t,qw,qx,qy,qz\n" + "".join(
            f"{t!r},{math.cos(math.radians(a) / 2)!r},0,0,{math.sin(math.radians(a) / 2)!r}\n" for t, a in rows))
        limit = "burst.csv --max-rate 45deg/s --method slerp"
        done = self.run_command(f"retime {limit}")
        self.assertEqual(done.returncode, BAD_USAGE)
        self.assertIn(", wanted limits that 1e+15 meets", done.stderr)
        report = self.retimed(f"{limit} --per-interval")
        self.assertEqual(report["slowing"], "per-interval")
        self.assertLess(report["time_scale"], 1e5)  # uniformly it would be 2e17
        self.assertLessEqual(report["rate_bound_deg_s"], 45)

    def test_columns_that_shape_the_curve_are_kept_and_others_told(self):
        self.write("shaped.csv", "t,qw,qx,qy,qz,tension,wx,wy,wz\n0,1,0,0,0,0.9,1,2,3\n1,0,1,0,0,0.9,1,2,3\n")
        done = self.run_command("retime shaped.csv --max-rate 1deg/s --method timed-c2 --quiet")
        self.assertEqual((done.returncode, done.stderr.splitlines()[0]),
                         (0, "orispline: warning: the output leaves out the columns wx, wy, wz"))
        self.assertRegex(done.stdout, r"^# orispline: method=timed-c2\nt,qw,qx,qy,qz,tension\n0,1,0,0,0,0\.9\n[\d.]+,0,1,0,0,0\.9\n$")
        done = self.run_command("retime shaped.csv --max-rate 1deg/s -o slow.csv --quiet")
        self.assertEqual((done.returncode, done.stderr.splitlines()[0]),
                         (0, "orispline: warning: the output leaves out the columns tension, wx, wy, wz"))

    def test_errors_of_the_keys_name_the_file(self):
        wild = random.Random(0)
        rows, t = [], 0
        for _ in range(12):
            t += wild.uniform(0.2, 2)
            quaternion = [wild.gauss(0, 1) for _ in range(4)]
            rows.append(",".join(map(repr, [t, *(c / math.hypot(*quaternion) for c in quaternion)])) + "\n")
        self.write("wild.csv", "t,qw,qx,qy,qz\n" + "".join(rows))
        done = self.run_command("retime wild.csv --max-rate 1deg/s --method bspline-through")
        self.assertEqual((done.returncode, done.stdout), (BAD_DATA, ""))
        self.assertRegex(done.stderr, r"^orispline: wild\.csv:\d+: key \d+: bspline-through does not converge")

    def test_warns_of_an_inertia_that_no_rigid_body_has(self):
        done = self.run_command("retime keys.csv --max-torque 1Nm --inertia=1,2,4 --quiet -o slow.csv")
        self.assertEqual(done.stderr, "orispline: warning: --inertia: one principal moment is greater than the sum of "
                         "the two others, which no rigid body has\n")

    def test_the_output_is_checked_before_the_keys(self):
        self.write("one.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n")
        self.assert_fails("retime one.csv --max-rate 1deg/s -o nowhere/out.csv", BAD_ACCESS,
                          "nowhere/out.csv: cannot write: No such file or directory")

    def test_refused(self):
        self.assert_fails("retime keys.csv", BAD_USAGE,
                          "found no limit, wanted --max-rate, --max-acceleration, --max-jerk, --max-torque, --max-speed, "
                          "--max-linear-acceleration, --duration, --constant-rate or --constant-speed")
        self.assert_fails("retime keys.csv --max-rate=-1deg/s", BAD_USAGE,
                          "--max-rate: found '-1deg/s', wanted a number greater than 0 with its unit, deg/s, rad/s, mrad/s or arcsec/s, such as "
                          "1deg/s, or three with commas between them, such as 1,2,3deg/s")
        self.assert_fails("retime keys.csv --max-rate 1deg/s --inertia=1,2,3", BAD_USAGE,
                          "--inertia: it is used for the torque alone, wanted --max-torque as well")
        self.assert_fails("retime keys.csv --max-torque 1Nm --inertia=1,-2,3", BAD_USAGE,
                          "--inertia: found the principal moments -2, 1, 3, wanted all of them greater than 0")
        self.assert_fails("retime keys.csv --max-rate 1e-100deg/s", BAD_USAGE,
                          "the limits ask for a slowing by 4.875e+101, wanted limits that 1e+15 meets")
        self.assert_fails("retime keys.csv --max-rate 1deg/s -o slow.npy", BAD_USAGE,
                          "-o: a NumPy file rounds times, and the limits may not hold with rounded times; wanted CSV or TUM")
        self.assert_fails("retime keys.csv --max-rate 1deg/s -o slow.csv --output-format euroc", BAD_USAGE,
                          "-o: an EuRoC file rounds times, and the limits may not hold with rounded times; wanted CSV "
                          "or TUM")
        self.assert_fails("retime keys.csv --max-torque 1Nm", BAD_USAGE,
                          "--max-torque: the torque depends on the body, wanted --inertia as well")
        self.assert_fails("retime keys.csv --max-acceleration 1deg/s2 --method slerp", BAD_USAGE,
                          "slerp: its angular velocity jumps at keys, which no slowing brings within a limit of "
                          "acceleration or torque, wanted a method that is C1, such as auto")
        self.assert_fails("retime keys.csv --max-rate 1deg/s --method global-c2", BAD_USAGE,
                          "global-c2: no bounds are known for the segments of this method, wanted one of polynomials, "
                          "such as auto or timed-c2")
        self.write("one.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n")
        self.assert_fails("retime one.csv --max-rate 1deg/s", BAD_DATA,
                          "one.csv: found 1 key, wanted 2 at least: one key does not move")


if __name__ == "__main__":
    main()
