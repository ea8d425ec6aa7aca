#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Recordings as they come: several in a file, gaps, stray stamps, cells of zeros and of other tracks, angles that run on.

The recordings are not part of the project: they are read where they lie beside it.
"""
import json
import math
import os
import pathlib
import shutil
import unittest

from command import BAD_DATA, BAD_USAGE, SUCCESS, CommandTest, main, rows_of, table_of, with_pages

CASES = pathlib.Path(os.environ["ORISPLINE_SHARED_DATA"]).resolve().parent / "cases"


class Recordings(CommandTest):
    cases = CASES / "recordings"

    def setUp(self):
        super().setUp()
        if not self.cases.is_dir():
            self.skipTest(f"no {self.cases}")

    def use(self, name):
        shutil.copy(self.cases / name, self.folder / name)
        return name

    def summary(self, arguments):
        return json.loads(self.output_of(f"{arguments} --json"))

    def said(self, arguments):
        done = self.run_command(arguments)
        self.assertEqual(done.returncode, SUCCESS, done.stderr)
        return done.stderr


class Sessions(Recordings):
    def setUp(self):
        super().setUp()
        self.use("02_sessions.tum")
        self.second = "02_sessions.tum:24: time 100.35 comes after 101.9, and the rows go on from there: a second " \
                      "recording begins, wanted one, or --unwrap if the clock came round (--session N|all reads one of them)"

    def test_a_block_that_goes_back_is_a_second_recording(self):
        for command in ("sample 02_sessions.tum --rate 10 --drop-duplicates", "smooth 02_sessions.tum --drop-duplicates",
                        "convert 02_sessions.tum --drop-duplicates"):
            self.assert_fails(command, BAD_DATA, self.second.replace(":24: ", ":24: key 20: "))

    def test_sorting_refuses_to_mix_them(self):
        self.assert_fails("convert 02_sessions.tum --sort --drop-duplicates", BAD_DATA,
                          "02_sessions.tum:24: found 2 recordings one behind the other, the second from here on, which "
                          "sorting would mix; wanted one of them, or --unwrap if the clock came round (--session N|all reads one of "
                          "them)")

    def test_each_can_be_read(self):
        first = rows_of(self.output_of("convert 02_sessions.tum --session 1 --drop-duplicates --output-format csv"))
        second = rows_of(self.output_of("convert 02_sessions.tum --session 2 --output-format csv"))
        self.assertEqual((len(first), first[0][0], first[-1][0]), (20, 100.0, 101.9))
        self.assertEqual((len(second), second[0][0], second[-1][0]), (15, 100.35, 101.75))
        self.assert_fails("convert 02_sessions.tum --session 3", BAD_USAGE,
                          "--session: found 3, wanted 1 to 2, which the file has")
        for bad in ("0", "-1", "one", "1.5"):
            self.assert_fails(f"convert 02_sessions.tum --session {bad}", BAD_USAGE,
                              f"--session: found '{bad}', wanted the number of a recording, from 1, or all")

    def test_files_beside_that_hold_one_recording_are_read_whole(self):
        self.output_of("convert 02_sessions.tum --session 2 -o second.tum")
        for command in ("sample 02_sessions.tum --session 2 --times second.tum --truth second.tum",
                        "compare 02_sessions.tum --session 2 --reference second.tum --methods slerp"):
            self.output_of(f"{command}{' -o out.csv' if 'sample' in command else ''}")
        report = self.summary("sample 02_sessions.tum --session 2 --times second.tum --truth second.tum -o out.csv")
        self.assertLess(report["truth"]["distance_max_deg"], 1e-6)
        found = self.summary("mean 02_sessions.tum --session 2 -o mean.csv")
        self.assertEqual(found["count"], 15)

    def test_all_of_them_go_into_a_folder_one_file_each(self):
        self.output_of("sample 02_sessions.tum --session all --drop-duplicates --rate 10 --output-folder out")
        self.assertEqual(sorted(path.name for path in (self.folder / "out").iterdir()),
                         ["02_sessions-1.tum", "02_sessions-2.tum"])
        self.assertEqual(len(self.read("out/02_sessions-1.tum").splitlines()), 20)
        self.assertEqual(len(self.read("out/02_sessions-2.tum").splitlines()), 15)
        self.assert_fails("sample 02_sessions.tum --session all --rate 10", BAD_USAGE,
                          "--session: found all without --output-folder, wanted that too, or the number of a recording")

    def test_duplicates_that_differ_are_said_with_the_largest_difference(self):
        said = self.said("convert 02_sessions.tum --session 1 --drop-duplicates -o first.csv")
        self.assertIn("3 rows of duplicate time differ from the row that is kept, by up to 3° and 0.01 m", said)
        report = self.summary("convert 02_sessions.tum --session 1 --drop-duplicates -o first.csv")
        self.assertAlmostEqual(report["largest_duplicate_deg"], 3, delta=1e-6)
        self.assertAlmostEqual(report["largest_duplicate_m"], 0.01, delta=1e-12)

    def test_inspect_shows_the_first_and_says_what_a_task_would(self):
        report = self.summary("inspect 02_sessions.tum")
        self.assertEqual(report["keys"], 20)
        self.assertIn("defect        02_sessions.tum:24: found 2 recordings one behind the other",
                      self.output_of("inspect 02_sessions.tum"))

    def test_blocks_that_do_not_overlap_are_not_sorted_either(self):
        lines = self.read("02_sessions.tum").splitlines()
        late = [line.replace("10", "20", 1) for line in lines[23:]]
        self.write("parts.tum", "\n".join(late + lines[:6]) + "\n")
        self.assertIn("found 2 recordings one behind the other", self.run_command("convert parts.tum --sort").stderr)


class Reports(Recordings):
    cases = CASES / "reports"

    def test_a_clock_that_comes_round_is_one_recording(self):
        for name, options, keys in (("r12_tow.csv", "--columns t=gps_tow_s --unwrap week", 40),
                                    ("r12_week.csv", "--columns t=week+tow", 40), ("r05_wrap24.csv", "--unwrap 24bit*1us", 1201)):
            with self.subTest(name):
                times = [row[0] for row in rows_of(self.output_of(f"convert {self.use(name)} {options}"))]
                self.assertEqual(len(times), keys)
                for one, other in zip(times, times[1:]):
                    self.assertAlmostEqual(other - one, 0.1, delta=1e-6)

    def test_sorting_refuses_it_and_unwrapping_what_never_does_so(self):
        self.use("r12_tow.csv"), self.use("r22_jump.csv")
        done = self.run_command("convert r12_tow.csv --columns t=gps_tow_s --sort -o sorted.csv")
        self.assertEqual(done.returncode, BAD_DATA)
        self.assertIn("--unwrap if the clock came round (--session N|all", done.stderr)
        done = self.run_command("convert r22_jump.csv --unwrap week -o none.csv")
        self.assertEqual((done.returncode, done.stderr.count("\n")), (BAD_USAGE, 1))
        self.assertIn("--unwrap: found times from 0 to 30, which never come round at 604800", done.stderr)
        self.assertFalse((self.folder / "sorted.csv").exists() or (self.folder / "none.csv").exists())

    def test_a_jump_makes_two_recordings(self):
        self.use("r22_jump.csv")
        done = self.run_command("convert r22_jump.csv")
        self.assertNotIn("--drop-duplicates", done.stderr)
        self.assertIn("the orientation jumps there by 90.1° (--jumps cuts the motion there)", done.stderr)
        first, second = (rows_of(self.output_of(f"convert r22_jump.csv --session {k}")) for k in (1, 2))
        self.assertEqual((first[0][0], first[-1][0], second[0][0], second[-1][0]), (0, 10, 10, 30))

    def test_jumps_make_two_stretches(self):
        self.use("r22_jump.csv")
        keys = rows_of(self.read("r22_jump.csv"))
        rows = rows_of(self.output_of("sample r22_jump.csv --jumps --rate 1 --derivatives 0"))
        self.assertEqual([row[0] for row in rows], list(range(31)))
        for found, key in ((rows[0], keys[0]), (rows[10], keys[2]), (rows[20], keys[3]), (rows[30], keys[4])):
            for one, other in zip(found, key, strict=True):
                self.assertAlmostEqual(one, other, delta=1e-8)
        alone = rows_of(self.output_of("sample r22_jump.csv --session 1 --rate 1 --derivatives 0"))
        self.assertEqual(rows[:10], alone[:10])
        report = self.summary("inspect r22_jump.csv --jumps --method slerp")
        self.assertEqual((report["jumps"], report["stretches"], report["duplicate_times"], report["defect"]), (True, 2, 0, None))
        self.assertEqual(report["methods"][0]["orientation_jump_max_deg"], 0)
        self.assertIn("stretches     2 by jumps, begun at key 2 (line 4, 10 s)", self.output_of("inspect r22_jump.csv --jumps"))

    def test_written_keys_say_that_they_jump(self):
        self.use("r22_jump.csv")
        self.output_of("convert r22_jump.csv --jumps -o stated.csv")
        self.assertEqual(self.read("stated.csv").splitlines()[0], "# orispline: jumps")
        self.assertEqual(self.output_of("sample stated.csv --rate 3"), self.output_of("sample r22_jump.csv --jumps --rate 3"))
        for task in ("tune", "retime --max-rate 10deg/s"):
            self.assert_fails(f"{task} r22_jump.csv --jumps -o out.csv", BAD_USAGE,
                              "--jumps: found two orientations at one time, wanted one curve through all keys")
        self.assert_fails("convert stated.csv -o out.glb", BAD_USAGE,
                          "--jumps: found two orientations at one time, as line 1 of the keys says, wanted one curve through all keys")
        self.assert_fails("sample r22_jump.csv --jumps --rate 1 --closed --method timed-c2", BAD_USAGE,
                          "--jumps: found jumps in the keys of a closed curve, wanted one of the two")

    @with_pages
    def test_tasks_keep_to_both_sides_of_a_jump(self):
        def angle(t):
            return 0.5 * math.sin(t) + (1.5 if t > 3 else 0)
        times = [k / 100 for k in range(301)] + [3 + k / 100 for k in range(301)]
        angles = [angle(min(t, 3)) for t in times[:301]] + [angle(t + 1e-12) for t in times[301:]]
        self.write("kick.csv", "t,qw,qx,qy,qz\n" + "".join(f"{t},{math.cos(a / 2)!r},0,0,{math.sin(a / 2)!r}\n" for t, a in zip(times, angles)))
        for task in ("reduce kick.csv --jumps --tolerance 0.05deg -o keys.csv", "smooth kick.csv --jumps -o keys.csv"):
            self.output_of(f"{task} --report page.html --quiet")
            self.assertIn(" jumps", self.read("keys.csv").splitlines()[0], task)
            sampled = rows_of(self.output_of("sample keys.csv --rate 100 --derivatives 0"))
            for t, w, *_, z in sampled:
                self.assertLess(abs(2 * math.atan2(z, w) - angle(t if t < 3 else t + 1e-12)), math.radians(0.06), (task, t))
            self.assertIn(None, self.page("page.html")["methods"][0]["samples"]["q"], task)
        compared = json.loads(self.output_of("compare kick.csv --jumps --keep-every 7 --methods timed-c2 --json --report page.html"))[0]
        self.assertLess(compared["max_deg"], 0.05)
        self.output_of("plot kick.csv --jumps -o out.svg")
        self.assertNotIn("nan", self.read("out.svg").lower())

    def test_names_in_a_comment_are_read_and_said(self):
        for name, options in (("r04_ns.csv", ""), ("r04_savetxt.csv", ""), ("r09_helios.trj", " --angle-unit deg")):
            with self.subTest(name):
                self.assertIn("the columns are named by a comment", self.said(f"convert {self.use(name)}{options} -o out.csv"))
        self.assertIn("--angle-unit", self.run_command("convert r09_helios.trj").stderr)


class Stamps(Recordings):
    def test_a_stray_zero_is_dropped_and_not_sorted_to_the_front(self):
        self.use("31_stamps.csv")
        self.assert_fails("convert 31_stamps.csv", BAD_DATA,
                          "31_stamps.csv:14: key 12: time 0 comes after 1044000, wanted increasing times: 0 is an invalid "
                          "time stamp there (--drop-invalid drops such rows)")
        self.assert_fails("convert 31_stamps.csv --sort", BAD_DATA,
                          "31_stamps.csv:14: time 0 comes after 1044000, wanted increasing times: 0 is an invalid time stamp there "
                          "(--drop-invalid drops such rows)")
        self.assert_fails("convert 31_stamps.csv --drop-invalid", BAD_DATA,
                          "31_stamps.csv:22: key 19: time 1075000 comes after 1076000, wanted increasing times (--sort "
                          "orders the rows)")
        rows = rows_of(self.output_of("convert 31_stamps.csv --drop-invalid --sort"))
        self.assertEqual((len(rows), rows[0][0], rows[-1][0]), (29, 1, 1.116))

    def test_a_stray_zero_is_told_where_the_clock_began_at_0_too(self):
        times = [k / 100 for k in range(60)]
        times[30] = 0
        self.write("from_zero.csv", "t,qw,qx,qy,qz\n" + "".join(f"{t:g},1,0,0,0\n" for t in times))
        self.assert_fails("convert from_zero.csv", BAD_DATA,
                          "from_zero.csv:32: key 30: time 0 comes after 0.29, wanted increasing times: 0 is an invalid time stamp there "
                          "(--drop-invalid drops such rows)")
        for more in ("", " --sort", " --session 1"):
            self.assertEqual(len(rows_of(self.output_of(f"convert from_zero.csv --drop-invalid{more}"))), 59)
        self.write("two.csv", "t,qw,qx,qy,qz\n" + "".join(f"{t:g},1,0,0,0\n" for t in 2 * [k / 100 for k in range(20)]))
        self.assertIn("a second recording begins", self.run_command("convert two.csv").stderr)

    def test_two_columns_of_times(self):
        self.use("24_ros.csv")
        done = self.output_of("convert 24_ros.csv --columns t=header.stamp.sec+header.stamp.nanosec")
        self.assertEqual([line.split(",")[0] for line in table_of(done)[1:]],
                         ["1650000000.95", "1650000000.97", "1650000000.99", "1650000001.01", "1650000001.03",
                          "1650000001.05"])
        self.assertEqual(rows_of(done)[1][1:], [0.9996875162757026, 0, 0, 0.024997395914712332])
        self.assert_fails("convert 24_ros.csv --columns t=header.stamp.sec", BAD_DATA,
                          "24_ros.csv:3: key 1: duplicate time 1650000000, as in line 2, wanted increasing times: the "
                          "stamps repeat in runs, since they are coarser than the rows; if another column has the rest "
                          "of the time, name both, such as t=sec+nanosec (--columns NAME=COLUMN,... says which is which)")
        self.assert_fails("convert 24_ros.csv --columns t=header.stamp.sec+orientation.x", BAD_USAGE,
                          "24_ros.csv:1: --columns: found t=header.stamp.sec+orientation.x, wanted a second column whose "
                          "name ends in a unit, such as t=sec+nanosec")

    def test_steps_that_no_seconds_are_are_warned_of(self):
        self.use("17_px4.csv")
        for command in ("convert 17_px4.csv -o out.csv", "sample 17_px4.csv --count 5 -o out.csv",
                        "sample 17_px4.csv --method slerp --rate 1/250000 -o out.csv"):
            self.assertIn("the times are taken as seconds, by which the keys are 250000 s apart; if they are microseconds, "
                          "set --time-scale to 1e-6", self.said(command))
        self.assertNotIn("apart", self.said("convert 17_px4.csv --time-scale 1e-6 -o out.csv"))
        self.assertEqual(rows_of(self.read("out.csv"))[0][1:],
                         [0.9952465414778341, 0.0870727897926938, 0.0434534024273578, -0.0038016801040236755])

    def test_names_are_compared_without_case_blanks_and_brackets(self):
        self.write("names.csv", "Timestamp (us),Orientation.X,Orientation.Y,Orientation.Z,Orientation.W, PX [mm],PY [mm],PZ [mm]\n"
                                "1000000,0,0,0,1,1000,0,0\n2000000,0,0,0.6,0.8,2000,0,0\n")
        self.assertEqual(rows_of(self.output_of("convert names.csv")), [[1, 1, 0, 0, 0, 1, 0, 0], [2, 0.8, 0, 0, 0.6, 2, 0, 0]])
        self.write("Time.csv", "Time,QW,QX,QY,QZ\n1,1,0,0,0\n2,0.8,0,0,0.6\n")
        self.assertEqual(len(rows_of(self.output_of("convert Time.csv"))), 2)


class Cells(Recordings):
    def test_zero_quaternions_are_dropped(self):
        self.use("35_zero.csv")
        self.assert_fails("convert 35_zero.csv", BAD_DATA,
                          "35_zero.csv:2: key 0: the quaternion is zero, wanted a rotation (--drop-invalid drops such rows)")
        self.assertEqual([row[0] for row in rows_of(self.output_of("convert 35_zero.csv --drop-invalid"))],
                         [0.1, 0.2, 0.30000000000000004, 0.4, 0.5, 0.7000000000000001, 0.8, 0.9])

    def test_rows_with_empty_orientations_are_dropped(self):
        self.write("empty.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n1,,,,\n2,0.8,0,0,0.6\n")
        self.assertEqual(len(rows_of(self.output_of("convert empty.csv --drop-invalid"))), 2)

    def test_matrices_near_a_rotation_become_the_nearest(self):
        self.use("21_mats.csv")
        refused = self.run_command("convert 21_mats.csv")
        self.assertEqual(refused.returncode, BAD_DATA)
        self.assertIn("--normalise takes the nearest rotation", refused.stderr)
        said = self.said("convert 21_mats.csv --normalise --output-orientation matrix -o out.csv")
        self.assertRegex(said, r"made 4 matrices each the nearest rotation: up to 0\.0\d+ away by Frobenius' norm")
        for row in rows_of(self.read("out.csv")):
            m = [row[1 + 3 * i:4 + 3 * i] for i in range(3)]
            for i in range(3):
                for j in range(3):
                    self.assertAlmostEqual(sum(m[k][i] * m[k][j] for k in range(3)), i == j, delta=1e-14)
        self.write("far.csv", "t,r11,r12,r13,r21,r22,r23,r31,r32,r33\n0,2,0,0,0,1,0,0,0,1\n")
        self.assertIn("far from any rotation", self.run_command("convert far.csv --normalise").stderr)

    def test_positions_can_be_left_unread(self):
        self.use("02_sessions.tum")
        out = self.output_of("convert 02_sessions.tum --session 2 --no-positions --output-format csv")
        self.assertEqual(table_of(out)[0], "t,qw,qx,qy,qz")

    def test_orientations_and_positions_on_different_rows_are_two_tracks_on_one_clock(self):
        self.use("23_mixed.csv")
        said = self.said("sample 23_mixed.csv --method slerp --rate 10 -o out.csv --derivatives 0")
        self.assertIn("orientations and positions stand in different rows: they are taken for two tracks on one clock, 5 "
                      "orientations and 35 positions; the keys are those with an orientation", said)
        rows = rows_of(self.read("out.csv"))
        self.assertEqual(len(rows), 17)
        for t, *_, x, y, z in rows[1:]:
            for found, wanted in ((x, 2 * t), (y, 4 * t), (z, 0)):
                self.assertAlmostEqual(found, wanted, delta=1e-12)
        self.output_of("convert 23_mixed.csv --no-positions --drop-invalid -o turns.csv")
        self.assertEqual(len(rows_of(self.read("turns.csv"))), 5)


class Gaps(Recordings):
    def setUp(self):
        super().setUp()
        self.write("gaps.csv", "t,qw,qx,qy,qz\n" + "".join(
            f"{t},{math.cos(t / 2)!r},0,0,{math.sin(t / 2)!r}\n" for t in (0, 0.5, 1, 1.5, 4, 4.5, 5, 9, 12, 12.5, 13)))

    def test_sample_bridges_no_gap(self):
        whole = rows_of(self.output_of("sample gaps.csv --rate 2"))
        self.assertEqual(len(whole), 27)
        rows = rows_of(self.output_of("sample gaps.csv --rate 2 --gap 1"))
        self.assertEqual([row[0] for row in rows], [0, 0.5, 1, 1.5, 4, 4.5, 5, 9, 12, 12.5, 13])
        report = self.summary("sample gaps.csv --rate 2 --gap 1 -o out.csv")
        self.assertEqual((report["samples"], report["gap_samples"]), (11, 16))
        marked = table_of(self.output_of("sample gaps.csv --rate 2 --gap 1 --mark-gaps"))
        self.assertEqual(len(marked), 28)
        self.assertEqual(marked[5], "2,,,,,,,,,,")
        self.assert_fails("sample gaps.csv --rate 2 --gap 0.5", BAD_USAGE,
                          "--gap: found 0.5 s, wanted more than the median interval of 0.5 s")
        self.assert_fails("sample gaps.csv --rate 2 --gap 1 --mark-gaps -o out.tum", BAD_USAGE,
                          "--mark-gaps: found a TUM file, which has no empty rows, wanted a CSV or NumPy file")

    def test_a_stretch_knows_nothing_of_the_others(self):
        self.write("first.csv", "\n".join(self.read("gaps.csv").splitlines()[:5]) + "\n")
        for method in ("auto", "timed-c2", "global-c2", "hermite-c2", "squad"):
            of_all = rows_of(self.output_of(f"sample gaps.csv --rate 8 --gap 1 --method {method}"))
            alone = rows_of(self.output_of(f"sample first.csv --rate 8 --method {method}"))
            for row, wanted in zip(of_all, alone):
                for found, number in zip(row, wanted, strict=True):
                    self.assertAlmostEqual(found, number, delta=1e-12, msg=method)

    def test_smoothed_keys_carry_their_gaps(self):
        self.use("12_gaps.csv")
        self.output_of("smooth 12_gaps.csv --gap 0.5 -o keys.csv")
        self.assertIn(" gap=0.5", self.read("keys.csv").splitlines()[0])
        keys = [row[0] for row in rows_of(self.read("keys.csv"))]
        gaps = [(a, b) for a, b in zip(keys, keys[1:]) if b - a > 0.5]
        self.assertTrue(gaps)
        times = [row[0] for row in rows_of(self.output_of("sample keys.csv --rate 50"))]
        for first, last in gaps:
            self.assertFalse([t for t in times if first + 1e-9 < t < last - 1e-9])
        bridged = rows_of(self.output_of("sample keys.csv --rate 50 --ignore-recipe --method hermite-c2"))
        self.assertGreater(len(bridged), len(times))
        self.output_of("smooth keys.csv -o again.csv")
        self.assertIn(" gap=0.5", self.read("again.csv").splitlines()[0])

    def test_reduce_and_compare_keep_to_the_stretches(self):
        times = [k / 100 for k in range(900) if not 300 < k < 500 and not 700 < k < 750]
        self.write("turns.csv", "t,qw,qx,qy,qz\n" + "".join(
            f"{t},{math.cos(0.5 * math.sin(t) + 0.1 * t)!r},0,0,{math.sin(0.5 * math.sin(t) + 0.1 * t)!r}\n" for t in times))
        for method in ("auto", "timed-c2", "slerp"):
            self.output_of(f"reduce turns.csv --gap 0.1 --method {method} --tolerance 0.05deg -o keys_of.csv")
            self.assertIn(" gap=", self.read("keys_of.csv").splitlines()[0], method)
            report = self.summary("sample keys_of.csv --times turns.csv --truth turns.csv -o out.csv")
            self.assertLessEqual(report["truth"]["distance_max_deg"], 0.05)
            self.assertEqual((report["samples"], report["gap_samples"]), (len(times), 0))
            sampled = [row[0] for row in rows_of(self.output_of("sample keys_of.csv --rate 100 --derivatives 0"))]
            self.assertFalse([t for t in sampled if 3.001 < t < 4.999 or 7.001 < t < 7.499], method)
        apart = json.loads(self.output_of("compare turns.csv --gap 0.1 --keep-every 10 --methods timed-c2 --json"))[0]
        bridged = json.loads(self.output_of("compare turns.csv --keep-every 10 --methods slerp --json"))[0]
        self.assertLess(apart["max_deg"], 0.1)
        self.assertGreater(bridged["max_deg"], 1)
        for task in ("tune turns.csv", "retime turns.csv --max-rate 10deg/s", "compare turns.csv --keep-every 10 --tune"):
            self.assert_fails(f"{task} --gap 0.1{'' if 'compare' in task else ' -o out.csv'}", BAD_USAGE,
                              "--gap: found gaps longer than 0.1 s, wanted one curve through all keys")

    def test_a_gap_that_reduced_keys_cannot_state_is_not_written(self):
        def rows(times):
            return "".join(f"{t},{math.cos(0.15 * t)!r},0,0,{math.sin(0.15 * t)!r}\n" for t in times)
        header, times = "t,qw,qx,qy,qz\n", [k / 10 for k in range(101)]
        self.write("even.csv", header + rows(times))
        self.write("kick.csv", header + rows(times[:51]) + f"5.0,{math.cos(1.25)!r},0,0,{math.sin(1.25)!r}\n" + rows(times[51:]))
        self.write("lonely.csv", header + rows(times[:30]) + rows(range(5, 20, 2)))
        for name, options, stated in (("even", "--gap 0.5", []), ("even", "--gap 0.5 --jumps", []), ("kick", "--gap 0.5 --jumps", ["jumps"]),
                                      ("even", "--gap 20", ["gap=20"]), ("lonely", "--gap 0.5", [])):
            said = self.said(f"reduce {name}.csv {options} --tolerance 0.1deg --method slerp -o out.csv")
            self.assertEqual(self.read("out.csv").splitlines()[0].split()[3:], stated)
            self.assertEqual("their file cannot say where the gaps are" in said, name == "lonely", said)
            self.output_of("sample out.csv --rate 1")

    def test_files_of_skeletons_which_know_no_gaps_are_refused_keys_with_some(self):
        self.output_of("convert gaps.csv --gap 1 -o stated.csv")
        for task in ("convert gaps.csv --gap 1", "reduce gaps.csv --gap 1 --tolerance 1deg", "sample gaps.csv --gap 1 --rate 10"):
            self.assert_fails(f"{task} -o out.glb", BAD_USAGE,
                              "--gap: found gaps longer than 1 s, wanted one curve through all keys")
            self.assertFalse((self.folder / "out.glb").exists())
        self.assert_fails("convert stated.csv -o out.glb", BAD_USAGE,
                          "--gap: found gaps longer than 1 s, as line 1 of the keys says, wanted one curve through all keys "
                          "(--ignore-recipe reads the keys without it)")
        self.output_of("convert stated.csv --ignore-recipe -o out.glb")

    @with_pages
    def test_pages_draw_nothing_in_gaps(self):
        times = [k / 20 for k in range(400) if not 120 < k < 200]
        self.write("long.csv", "t,qw,qx,qy,qz\n" + "".join(
            f"{t},{math.cos(0.5 * math.sin(t))!r},0,0,{math.sin(0.5 * math.sin(t))!r}\n" for t in times))
        for task in ("reduce long.csv --gap 0.5 --tolerance 0.1deg -o out.csv",
                     "compare long.csv --gap 0.5 --keep-every 5 --methods measured,auto"):
            self.output_of(f"{task} --report page.html --quiet" if "reduce" in task else f"{task} --report page.html")
            page = self.page("page.html")
            self.assertEqual([q for t, q in zip(page["reference"]["t"], page["reference"]["q"][::4]) if 6 + 1e-6 < t < 10 - 1e-6], [None])
            for method in page["methods"]:  # times are whole steps, so that a knot may be off by half of one
                inside = [q for t, q in zip(method["samples"]["t"], method["samples"]["q"][::4]) if 6 + 1e-6 < t < 10 - 1e-6]
                self.assertTrue(inside and not any(inside), method["name"])
                for band in method["bands"].values():
                    self.assertFalse([low for t, low in zip(band["t"], band["low"]) if 6 + 1e-6 < t < 10 - 1e-6 and low is not None])
                    self.assertTrue([low for t, low in zip(band["t"], band["low"]) if t < 6 and low is not None])

    def test_the_band_of_a_stretch_is_that_of_its_own_keys(self):
        rows = [f"{k / 20},{math.cos(0.5 * math.sin(k / 20))!r},0,0,{math.sin(0.5 * math.sin(k / 20))!r}\n" for k in range(400)]
        self.write("long.csv", "t,qw,qx,qy,qz\n" + "".join(rows[:120] + rows[200:]))
        self.write("alone.csv", "t,qw,qx,qy,qz\n" + "".join(rows[:120]))
        found = self.summary("sample long.csv --gap 0.5 --method measured --rate 40 -o out.csv")["findings"]["method_text"]
        settings = " ".join(f"--set {setting}" for setting in found.split(":")[1:])
        command = f"--method measured {settings} --band 0.9 --rate 40 --derivatives 0"
        apart = rows_of(self.output_of(f"sample long.csv --gap 0.5 {command}"))
        alone = rows_of(self.output_of(f"sample alone.csv {command}"))
        self.assertEqual([row[-1] for row in apart[:len(alone)]], [row[-1] for row in alone])
        self.assertFalse([row for row in apart if math.isnan(row[-1])])

    def test_plot_and_inspect_keep_to_the_stretches(self):
        self.output_of("plot gaps.csv --gap 1 -o out.svg")
        self.assertNotIn("nan", self.read("out.svg").lower())
        report = self.summary("inspect gaps.csv --gap 1 --method slerp")
        self.assertEqual(report["gap_s"], 1)
        self.assertEqual(report["stretches"], 4)

    def test_times_outside_are_left_out_where_that_is_asked_for(self):
        self.write("times.csv", "-1\n0.5\n20\n1\n")
        self.assertEqual([row[0] for row in rows_of(self.output_of("sample keys.csv --times times.csv --outside leave-out"))],
                         [0.5, 1])
        self.assertEqual(len(rows_of(self.output_of("sample keys.csv --times times.csv --outside hold"))), 4)
        self.assertEqual(self.run_command("sample keys.csv --times times.csv --outside error").returncode, BAD_DATA)
        self.assertIn("nan", self.output_of("sample keys.csv --times times.csv --outside nan"))
        self.assertEqual(len(rows_of(self.output_of("sample keys.csv --rate 2 --from -1 --to 5 --outside leave-out"))), 7)
        self.assert_fails("sample keys.csv --rate 1 --outside hold --extrapolate nan", BAD_USAGE,
                          "--outside: found --extrapolate too, which says the same, wanted one of them")


class Turns(Recordings):
    def test_angles_run_on(self):
        self.use("10_circle.csv")
        self.use("10_loop.csv")
        for command in ("convert 10_circle.csv", "sample 10_circle.csv --rate 20"):
            yaw = [row[3] for row in rows_of(self.output_of(f"{command} --output-orientation euler --continuous --threads 3"
                                                            if "sample" in command else
                                                            f"{command} --output-orientation euler --continuous"))]
            self.assertAlmostEqual(yaw[0], 0, delta=1e-6)
            self.assertAlmostEqual(yaw[-1], 1080, delta=1e-6)
            self.assertLess(max(abs(b - a) for a, b in zip(yaw, yaw[1:])), 40)
        for command in ("convert 10_loop.csv", "sample 10_loop.csv --rate 20"):
            rows = rows_of(self.output_of(f"{command} --output-orientation euler --continuous"))
            pitch = [row[2] for row in rows]
            self.assertAlmostEqual(pitch[0], 0, delta=1e-6)
            self.assertAlmostEqual(pitch[-1], 360, delta=1e-6)
            self.assertLess(max(abs(b - a) for a, b in zip(pitch, pitch[1:])), 40)
            for row in rows if "convert" in command else []:
                self.assertAlmostEqual(row[3], 20, delta=1e-3)

    def test_continuous_wants_euler_angles(self):
        self.assert_fails("convert keys.csv --continuous --output-orientation matrix", BAD_USAGE,
                          "--output-orientation: found 'matrix', wanted euler with --continuous")

    def test_typed_turns_are_counted(self):
        self.use("09_spin.csv")
        rows = rows_of(self.output_of("sample 09_spin.csv --signs as-typed --rate 1 --output-orientation euler --continuous"))
        self.assertEqual(len(rows), 41)
        for t, roll, pitch, yaw, *_ in rows:
            self.assertAlmostEqual(yaw, -18 * t, delta=1e-6)
            self.assertAlmostEqual(abs(roll) + abs(pitch), 0, delta=1e-6)
        said = self.said("reduce 09_spin.csv --signs as-typed --tolerance 1deg -o out.csv")
        self.assertIn("put 5 rows in between for turns that no quaternion holds", said)
        self.output_of("convert 09_spin.csv --signs as-typed -o keys_of_turns.csv")
        self.assertEqual(self.read("keys_of_turns.csv").splitlines()[0], "# orispline: signs=as-given")
        turned = rows_of(self.output_of("sample keys_of_turns.csv --rate 1 --output-orientation euler --continuous"))
        self.assertAlmostEqual(turned[-1][3], -720, delta=1e-6)
        self.output_of("retime 09_spin.csv --signs as-typed --max-rate 36deg/s -o out.csv")
        self.assertIn("signs=as-given", self.read("out.csv").splitlines()[0])
        self.assert_fails("convert keys.csv --signs as-typed", BAD_USAGE,
                          "--signs: found as-typed for a CSV file without Euler angles, wanted as-given or shortest")


if __name__ == "__main__":
    main()
