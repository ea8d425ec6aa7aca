#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Frames, fractions, dates of ISO 8601, units of angles, and orientations that turn world to body."""
import fractions
import math

from command import BAD_DATA, HALF, KEYS, CommandTest, main, rows_of, table_of

HEAD = "t,qw,qx,qy,qz"
TURN = [f"{math.cos(math.pi / 8)},0,0,{math.sin(math.pi / 8)}", f"{HALF},0,0,{HALF}"]


def keys(times, name="t"):
    rows = ["1,0,0,0", *TURN]
    return f"{name},qw,qx,qy,qz\n" + "".join(f"{time},{row}\n" for time, row in zip(times, rows))


class Frames(CommandTest):
    def times_of(self, arguments):
        return [line.split(",")[0] for line in table_of(self.output_of(f"{arguments} --derivatives 0 --quiet"))[1:]]

    def test_a_rate_in_frames_is_a_rate(self):
        self.assertEqual(self.output_of("sample keys.csv --fps 24"), self.output_of("sample keys.csv --rate 24"))
        self.assertEqual(self.output_of("sample keys.csv --fps 30000/1001"), self.output_of("sample keys.csv --rate 30000/1001"))
        self.assertEqual(self.output_of("sample keys.csv --fps 24 --rate 5"), self.output_of("sample keys.csv --rate 5"))

    def test_a_fraction_is_not_rounded(self):
        self.write("long.csv", keys((0, 1, 2002)))
        times = self.times_of("sample long.csv --rate 30000/1001")
        self.assertEqual(len(times), 60001)
        self.assertEqual((times[30000], times[60000]), ("1001", "2002"))
        for k in range(0, 60000, 501):
            self.assertEqual(float(times[k]), float(fractions.Fraction(1001 * k, 30000)))

    def test_a_column_of_frames_is_times(self):
        self.write("frames.csv", keys((0, 24, 72), "frame"))
        self.assertEqual(self.output_of("sample frames.csv --fps 24"), self.output_of("sample keys.csv --rate 24"))
        self.assertEqual(self.output_of("sample frames.csv --time-scale 1/24 --rate 24"),
                         self.output_of("sample keys.csv --rate 24"))
        self.assert_fails("sample frames.csv --rate 24", BAD_DATA,
                          "frames.csv:1: the column 'frame' counts frames, wanted how many there are in a second (--fps N)")
        self.write("both.csv", KEYS.replace("t,", "frame,t,", 1).replace("\n0", "\n7,0").replace("\n1", "\n8,1").replace("\n3", "\n9,3"))
        self.assertEqual(self.output_of("sample both.csv --rate 24"), self.output_of("sample keys.csv --rate 24"))

    def test_frames_that_no_decimal_is_are_written_short(self):
        self.write("frames.csv", keys((1, 2, 24), "frame"))
        self.assertEqual([row.split(",")[0] for row in table_of(self.output_of("convert frames.csv --fps 24"))[1:]],
                         ["0.041666666666666667", "0.083333333333333333", "1"])

    def test_ends_may_be_frames_and_fractions(self):
        self.assertEqual(self.output_of("sample keys.csv --fps 24 --from 12f --to 36f"),
                         self.output_of("sample keys.csv --rate 24 --from 0.5 --to 1.5"))
        self.assertEqual(self.output_of("sample keys.csv --rate 24 --from 1/2 --to +3/2"),
                         self.output_of("sample keys.csv --rate 24 --from 0.5 --to 1.5"))
        self.write("frames.txt", "frame\n12\n36\n")
        self.assertEqual(self.times_of("sample keys.csv --fps 24 --times frames.txt"), ["0.5", "1.5"])

    def test_rates_and_intervals_of_tasks_may_be_fractions(self):
        self.write("many.csv", "t,qw,qx,qy,qz\n" + "".join(
            f"{k / 50},{math.cos(k / 40)},{math.sin(k / 40)},{0},0\n" for k in range(100)))
        for one, other in (("--cutoff 5/2", "--cutoff 2.5"), ("--smoothing-time 1/8", "--smoothing-time 0.125"),
                           ("--noise 1/4deg", "--noise 0.25deg"), ("--rate 100/1", "--rate 100")):
            self.assertEqual(self.output_of(f"smooth many.csv {one}"), self.output_of(f"smooth many.csv {other}"))
        self.assertEqual(self.output_of("sample keys.csv --rate 5 --method timed-c2 --period 7/2"),
                         self.output_of("sample keys.csv --rate 5 --method timed-c2 --period 3.5"))

    def test_the_end_is_a_sample_on_request(self):
        for method in ("auto", "global-c2"):  # in pieces, and held
            plain = self.times_of(f"sample keys.csv --rate 0.7 --method {method}")
            self.assertEqual(self.times_of(f"sample keys.csv --rate 0.7 --method {method} --include-end"), [*plain, "3"])
            self.assertEqual(self.times_of(f"sample keys.csv --rate 1 --method {method} --include-end"), ["0", "1", "2", "3"])
        self.assertEqual(self.times_of("sample keys.csv --rate 1 --to 2.5 --include-end"), ["0", "1", "2", "2.5"])
        last = rows_of(self.output_of("sample keys.csv --rate 0.7 --include-end --derivatives 0"))[-1]
        for value, wanted in zip(last, (3, HALF, 0, 0, HALF)):
            self.assertAlmostEqual(value, wanted, delta=1e-15)
        self.output_of("sample keys.csv --rate 0.7 --include-end -o with.npy --quiet")
        self.output_of("sample keys.csv --rate 0.7 -o without.npy --quiet")
        self.assertEqual((self.folder / "with.npy").stat().st_size - (self.folder / "without.npy").stat().st_size, 8 * 11)


class Dates(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("dates.csv", keys(("2024-02-29T12:00:00.000000001Z", "2024-02-29T12:00:01.000000001Z",
                                      "2024-060T14:00:03.000000001+02:00")))

    def test_dates_are_unix_time_with_all_their_decimals(self):
        rows = table_of(self.output_of("convert dates.csv"))
        self.assertEqual([row.split(",")[0] for row in rows[1:]],
                         ["1709208000.000000001", "1709208001.000000001", "1709208003.000000001"])

    def test_an_epoch_counts_as_zero(self):
        epoch = "--epoch 2024-02-29T12:00:00.000000001"
        self.assertEqual(self.output_of(f"sample dates.csv --rate 4 {epoch}"), self.output_of("sample keys.csv --rate 4"))
        self.assertEqual(self.output_of(f"convert dates.csv {epoch}"), self.output_of("convert keys.csv"))

    def test_ends_may_be_dates_on_files_with_dates_and_without(self):
        epoch, ends = "--epoch 2024-02-29T12:00:00Z", "--from 2024-02-29T12:00:01Z --to 2024-02-29T12:00:02.5"
        wanted = self.output_of("sample keys.csv --rate 4 --from 1 --to 2.5")
        self.assertEqual(self.output_of(f"sample keys.csv --rate 4 {epoch} {ends}"), wanted)
        unix = self.output_of(f"sample dates.csv --rate 4 {ends} --derivatives 0")
        self.assertEqual([row.split(",")[0] for row in table_of(unix)[1:3]], ["1709208001", "1709208001.25"])

    def test_a_file_of_times_may_hold_dates(self):
        self.write("times.txt", "2024-02-29T12:00:02.5Z\n2024-02-29T12:00:00.5\n")
        rows = rows_of(self.output_of("sample keys.csv --times times.txt --epoch 2024-02-29T12:00:00Z --derivatives 0"))
        self.assertEqual([row[0] for row in rows], [2.5, 0.5])

    def test_dates_and_numbers_do_not_mix(self):
        self.write("mixed.csv", keys(("2024-02-29T12:00:00Z", "5", "6")))
        self.assert_fails("convert mixed.csv", BAD_DATA,
                          "mixed.csv:3:1: key 1: found '5', wanted a time of ISO 8601 as in the rows before")
        self.write("wrong.csv", keys(("2024-02-30T12:00:00Z", "5", "6")))
        self.assert_fails("convert wrong.csv", BAD_DATA, "wrong.csv:2:1: key 0: found '2024-02-30T12:00:00Z', wanted a time "
                                                         "of ISO 8601 such as 2024-02-29T12:30:00.25Z")


class Units(CommandTest):
    def test_angles_in_milliradians_and_arcseconds(self):
        degrees = [(0, 0), (1, 45), (3, 90)]
        turn = {"deg": 1, "rad": math.pi / 180, "mrad": 1000 * math.pi / 180, "arcsec": 3600}
        wanted = rows_of(self.output_of("convert keys.csv"))
        for unit, factor in turn.items():
            named = f"t,roll_{unit},pitch_{unit},yaw_{unit}\n" + "".join(f"{t},0,0,{a * factor!r}\n" for t, a in degrees)
            plain = named.replace(f"_{unit}", "")
            vector = f"t,rx_{unit},ry_{unit},rz_{unit}\n" + "".join(f"{t},0,0,{a * factor!r}\n" for t, a in degrees)
            for text, options in ((named, ""), (plain, f"--angle-unit {unit}"), (vector, "")):
                self.write("angles.csv", text)
                for row, want in zip(rows_of(self.output_of(f"convert angles.csv {options}")), wanted):
                    for value, other in zip(row, want):
                        self.assertAlmostEqual(value, other, delta=1e-15)
            self.output_of(f"convert keys.csv --output-angle-unit {unit} -o written.csv --quiet")
            self.assertTrue(self.read("written.csv").startswith(f"t,roll_{unit},pitch_{unit},yaw_{unit}\n"))
            self.assertAlmostEqual(rows_of(self.read("written.csv"))[-1][3], 90 * factor, delta=1e-9)

    def test_rates_in_milliradians_and_arcseconds(self):
        for unit, size in (("mrad_s", 1e-3), ("arcsec_s", math.pi / 648000), ("rad_s", 1)):
            self.write("rates.csv", f"t,qw,qx,qy,qz,wx_{unit},wy_{unit},wz_{unit}\n0,1,0,0,0,0,0,{0.5 / size!r}\n"
                                    f"1,{TURN[0]},0,0,{0.5 / size!r}\n")
            row = rows_of(self.output_of("sample rates.csv --method hermite-c1 --count 2 --derivatives 1"))[0]
            self.assertAlmostEqual(row[7], 0.5, delta=1e-15)

    def test_tolerances_and_limits(self):
        self.write("many.csv", "t,qw,qx,qy,qz\n" + "".join(
            f"{k / 50},{math.cos((k / 100) ** 2)},{math.sin((k / 100) ** 2)},0,0\n" for k in range(100)))
        wanted = self.output_of("reduce many.csv --tolerance 0.01rad")
        self.assertEqual(self.output_of("reduce many.csv --tolerance 10mrad"), wanted)
        arcseconds = 0.01 * 648000 / math.pi
        rows = rows_of(self.output_of(f"reduce many.csv --tolerance {arcseconds!r}arcsec"))
        self.assertEqual([row[0] for row in rows], [row[0] for row in rows_of(wanted)])


class WorldToBody(CommandTest):
    def test_orientations_are_conjugated_and_read_again(self):
        plain, turned = (rows_of(self.output_of(f"convert keys.csv {option}")) for option in ("", "--output-conjugate"))
        for row, other in zip(plain, turned):
            self.assertEqual(other, [row[0], row[1], *(-x for x in row[2:])])
        for form in ("quaternion", "euler", "matrix", "rotvec"):
            self.output_of(f"convert keys.csv --output-conjugate --output-orientation {form} -o turned.csv --quiet")
            for row, want in zip(rows_of(self.output_of("convert turned.csv --conjugate")), plain):
                for value, other in zip(row, want):
                    self.assertAlmostEqual(value, other, delta=1e-15)

    def test_every_format_has_them(self):
        for name, place in (("keys.tum", 6), ("keys_euroc.csv", 7)):
            self.output_of(f"convert keys.csv --output-conjugate -o {name} --quiet" +
                           (" --output-format euroc" if "euroc" in name else ""))
            last = self.read(name).split()[-1] if place == 7 else self.read(name).splitlines()[-1].replace(" ", ",")
            self.assertAlmostEqual(float(last.split(",")[place]), -HALF, delta=1e-15)

    def test_rates_keep_their_frame_and_name_it(self):
        plain = self.output_of("sample keys.csv --rate 2")
        turned = self.output_of("sample keys.csv --rate 2 --output-conjugate")
        self.assertEqual(table_of(turned)[0], f"{HEAD},wx_body,wy_body,wz_body,ax_body,ay_body,az_body")
        for row, other in zip(rows_of(plain), rows_of(turned)):
            self.assertEqual(other[5:], row[5:])
        world = table_of(self.output_of("sample keys.csv --rate 2 --output-conjugate --frame world"))[0]
        self.assertEqual(world, f"{HEAD},wx_world,wy_world,wz_world,ax_world,ay_world,az_world")
        self.write("turned.csv", turned)
        self.write("times.txt", "0.5\n1.5\n")
        again = self.output_of("sample turned.csv --conjugate --method hermite-c2 --times times.txt --quiet")
        for row, want in zip(rows_of(again), (rows_of(plain)[1], rows_of(plain)[3])):
            for value, other in zip(row, want):
                self.assertAlmostEqual(value, other, delta=1e-12)


if __name__ == "__main__":
    main()
