#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`orispline bake`: the two files that it writes, how near they are to the curve, and what it refuses."""
import json
import math
import pathlib
import re
import struct

from command import BAD_ACCESS, BAD_DATA, BAD_USAGE, SUCCESS, CommandTest, main, table_of

FLIGHT = pathlib.Path(__file__).resolve().parents[2] / "examples/data/flight_keys.csv"
NEAR = "t,qw,qx,qy,qz\n0,1,0,0,0\n1,0.6,0.8,0,0\n1.000000001,0.6,0,0.8,0\n2,0,0,0,1\n3,1,0,0,0\n"


def unpacked(data):
    """The document that a binary file stands for."""
    magic, version, count, epoch, largest = struct.unpack_from("<8sIIdd", data)
    at = 32

    def take(kind, number):
        nonlocal at
        at += struct.calcsize(kind) * number
        return struct.unpack_from(f"<{number}{kind}", data, at - struct.calcsize(kind) * number)

    ends, numbers = take("d", count + 1), take("f", 24 * count)
    curve = {"orispline": "baked", "version": version, "order": "xyzw", "epoch": epoch, "largest_difference": largest,
             "ends": list(ends), "pieces": [list(numbers[24 * i:24 * i + 24]) for i in range(count)]}
    if version == 2:
        count, _ = take("I", 2)
        (largest,), ends, firsts, others = take("d", 1), take("d", count + 1), take("d", 3 * count), take("f", 15 * count)
        rows = [[first, *others[5 * k:5 * k + 5]] for k, first in enumerate(firsts)]
        curve |= {"largest_position_difference": largest, "position_ends": list(ends),
                  "position_pieces": [sum(rows[3 * i:3 * i + 3], []) for i in range(count)]}
    assert at == len(data) and magic == b"ORIBAKED"
    return curve


def single(number):
    return struct.unpack("<f", struct.pack("<f", number))[0]


def values_at(ends, pieces, t):
    """The polynomials of all components at a time that counts as the ends do."""
    t = min(max(t, ends[0]), ends[-1])
    i = max(k for k in range(len(ends) - 1) if ends[k] <= t)
    s = (2 * t - ends[i] - ends[i + 1]) / ((ends[i + 1] - ends[i]) or 1)
    rows = [pieces[i][k:k + 6] for k in range(0, len(pieces[i]), 6)]
    return [sum(a * s**k for k, a in enumerate(row)) for row in rows]


def played(curve, t):
    """qx, qy, qz, qw at t [s]."""
    return values_at(curve["ends"], curve["pieces"], t - curve["epoch"])


def position(curve, t):
    """px, py, pz at t [s]."""
    return values_at(curve["position_ends"], curve["position_pieces"], t - curve["epoch"])


class Bake(CommandTest):
    def baked(self, arguments):
        return json.loads(self.output_of(f"bake {arguments} --quiet"))

    def assert_near(self, curve, arguments, tolerance):
        lines = table_of(self.output_of(f"sample {arguments} --quiet"))
        for line in lines[1:]:
            t, w, x, y, z = map(float, line.split(",")[:5])
            self.assertLessEqual(2 * math.dist(played(curve, t), (x, y, z, w)), tolerance, line)

    def test_the_flight_is_within_the_tolerance(self):
        done = self.run_command(f"bake {FLIGHT} --tolerance 1e-4deg -o flight.bin --json")
        self.assertEqual(done.returncode, SUCCESS, done.stderr)
        found, tolerance = json.loads(done.stdout), math.radians(1e-4)
        data = (self.folder / "flight.bin").read_bytes()
        curve = unpacked(data)
        self.assertEqual((found["method"], found["keys"], found["pieces"]), ("auto", 38, len(curve["pieces"])))
        self.assertLessEqual(found["largest_difference_rad"], tolerance)
        self.assertEqual((found["position_pieces"], found["warnings"]), (len(curve["position_pieces"]), []))
        self.assert_near(curve, f"{FLIGHT} --rate 97", tolerance)

    def test_positions_keep_to_their_tolerance(self):
        for typed, tolerance in (("", 1e-3), ("--position-tolerance 1cm", 1e-2), ("--position-tolerance 0.01mm", 1e-5)):
            curve = self.baked(f"{FLIGHT} --tolerance 1deg {typed}")
            table = table_of(self.output_of(f"sample {FLIGHT} --rate 97 --quiet"))
            at = table[0].split(",").index("px")
            for line in table[1:]:
                numbers = list(map(float, line.split(",")))
                self.assertLessEqual(math.dist(position(curve, numbers[0]), numbers[at:at + 3]), tolerance, line)
        self.assert_fails(f"bake {FLIGHT} --tolerance 1deg --position-tolerance 0m -o curve.json", BAD_USAGE,
                          "--position-tolerance: found '0m', wanted a number greater than 0 with its unit, mm, cm or m, such as 1mm")

    def test_both_files_have_the_same_numbers(self):
        text = self.baked("keys.csv --tolerance 1e-3deg")
        self.output_of("bake keys.csv --tolerance 1e-3deg --quiet -o curve.json")
        self.output_of("bake keys.csv --tolerance 1e-3deg --quiet -o curve.bin")
        self.assertEqual(text, json.loads(self.read("curve.json")))
        text["pieces"] = [[single(number) for number in piece] for piece in text["pieces"]]
        self.assertEqual(text, unpacked((self.folder / "curve.bin").read_bytes()))
        flight = self.baked(f"{FLIGHT} --tolerance 1deg")
        self.output_of(f"bake {FLIGHT} --tolerance 1deg --quiet -o flight.bin")
        flight["pieces"] = [[single(number) for number in piece] for piece in flight["pieces"]]
        flight["position_pieces"] = [[single(number) if k % 6 else number for k, number in enumerate(piece)]
                                     for piece in flight["position_pieces"]]
        self.assertEqual(flight, unpacked((self.folder / "flight.bin").read_bytes()))

    def test_takes_the_method_and_its_settings(self):
        for method in ("slerp", "squad", "timed-c2:tension=0.4:ends=natural", "global-c2"):
            curve = self.baked(f"keys.csv --method {method} --tolerance 2e-6rad")
            self.assert_near(curve, f"keys.csv --method {method} --rate 50", 2e-6)

    def test_counts_times_as_the_file_does(self):
        self.write("late.csv", self.read("keys.csv").replace("\n0,", "\n1700000000.25,").replace("\n1,", "\n1700000001,")
                   .replace("\n3,", "\n1700000002.5,"))
        curve = self.baked("late.csv --tolerance 1e-4deg")
        self.assertEqual((curve["epoch"], curve["ends"][0], curve["ends"][-1]), (1700000000.25, 0, 2.25))
        self.assert_near(curve, "late.csv --rate 10", math.radians(1e-4))

    def test_holds_the_end_orientations(self):
        curve = self.baked("keys.csv --tolerance 1e-4deg")
        for t, key in ((-5, [0, 0, 0, 1]), (0, [0, 0, 0, 1]), (3, [0, 0, math.sqrt(0.5), math.sqrt(0.5)]),
                       (9, [0, 0, math.sqrt(0.5), math.sqrt(0.5)])):
            self.assertLess(math.dist(played(curve, t), key), 1e-6, t)

    def test_a_single_key_is_a_piece_without_length(self):
        self.write("one.csv", "t,qw,qx,qy,qz\n2,0,0,1,0\n")
        curve = self.baked("one.csv --tolerance 1e-4deg")
        self.assertEqual((curve["epoch"], curve["ends"], len(curve["pieces"])), (2, [0, 0], 1))
        self.assertEqual(played(curve, 7), [0, 1, 0, 0])

    def test_refuses_tolerances_that_float_cannot_hold(self):
        wanted = "wanted a number greater than 0 with its unit, deg, rad, mrad or arcsec, such as 1deg"
        for typed, message in (("0deg", f"found '0deg', {wanted}"), ("1e-4", f"found '1e-4', {wanted}"),
                               ("1e-7rad", "found 1e-07 rad, wanted 1e-06 rad or more")):
            self.assert_fails(f"bake keys.csv --tolerance {typed} -o curve.json", BAD_USAGE, f"--tolerance: {message}")
        self.assertFalse((self.folder / "curve.json").exists())

    def test_says_what_is_reached_where_the_tolerance_is_not(self):
        missed = r"orispline: {}\.csv:\d: key \d: --tolerance: at \S+ s even the shortest piece reaches \S+ rad, wanted 1e-06: ask for {}\n"
        self.write("near.csv", NEAR.replace("1.000000001", "1.0000001"))
        done = self.run_command("bake near.csv --method rational --tolerance 1e-6rad -o curve.bin")
        said = re.fullmatch(missed.format("near", r"(\S+) rad or more, which all of the curve keeps to"), done.stderr)
        self.assertTrue(said, done.stderr)
        self.assertEqual(list(self.folder.glob("curve*")), [])
        self.output_of(f"bake near.csv --method rational --tolerance {said[1]}rad -o curve.bin")

    def test_offers_no_tolerance_where_it_knows_none(self):
        self.write("near.csv", NEAR)
        done = self.run_command("bake near.csv --method timed-c2 --tolerance 1e-6rad -o curve.bin")
        self.assertEqual((done.returncode, done.stdout), (BAD_USAGE, ""))
        self.assertRegex(done.stderr, r"^orispline: near\.csv:\d: key \d: --tolerance: at \S+ s even the shortest piece reaches \S+ rad, "
                                      r"wanted 1e-06: ask for a much larger tolerance, or a curve that turns less there\n$")
        self.assertEqual(list(self.folder.glob("curve*")), [])

    def test_refuses_other_files(self):
        self.assert_fails("bake keys.csv --tolerance 1deg -o curve.svg", BAD_USAGE,
                          "-o: found 'curve.svg', wanted a name that ends in .json or .bin")
        self.assert_fails("bake keys.csv --tolerance 1deg --json", BAD_USAGE,
                          "--json: the summary goes to standard output, wanted -o FILE for the curve")
        self.assert_fails("bake keys.csv --tolerance 1deg -o no/curve.bin", BAD_ACCESS,
                          "no/curve.bin: cannot write: No such file or directory")
        self.write("bad.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n1,0,0,0,0\n")
        done = self.run_command("bake bad.csv --tolerance 1deg -o curve.bin")
        self.assertEqual((done.returncode, done.stdout), (BAD_DATA, ""))
        self.assertTrue(done.stderr.startswith("orispline: bad.csv:3: "), done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1)


if __name__ == "__main__":
    main()
