#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`orispline plot`: the picture that it writes, and what it refuses."""
import re
import xml.etree.ElementTree

from command import BAD_ACCESS, BAD_DATA, BAD_USAGE, SUCCESS, CommandTest, main

SVG = "{http://www.w3.org/2000/svg}"


class Plot(CommandTest):
    def picture(self, arguments, **options):
        return xml.etree.ElementTree.fromstring(self.output_of(f"plot {arguments}", **options))

    @staticmethod
    def words(picture):
        return [text.text for text in picture.iter(f"{SVG}text")]

    @staticmethod
    def lines(picture, color):
        """The points of all lines of a colour."""
        return [[tuple(map(float, point.split(","))) for point in line.get("points").split()]
                for line in picture.iter(f"{SVG}polyline") if line.get("stroke") == color]

    def test_the_file_is_what_goes_to_standard_output(self):
        done = self.run_command("plot keys.csv -o motion.svg")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (SUCCESS, "", ""))
        self.assertEqual(self.read("motion.svg"), self.output_of("plot keys.csv"))
        self.assertEqual([path.name for path in self.folder.glob("*.part")], [])

    def test_names_the_input_the_method_and_the_quantities(self):
        words = self.words(self.picture("keys.csv"))
        for word in ("keys.csv: 3 keys", "auto", "angle from the start [deg]", "angular velocity |ω| [rad/s]",
                     "body axis x on the unit sphere"):
            self.assertIn(word, words)
        self.write("late.csv", self.read("keys.csv").replace("\n0,", "\n0.5,"))
        self.assertIn("late.csv: 3 keys, t = 0 at 0.5 s", self.words(self.picture("late.csv --axis y")))
        self.assertIn("body axis y on the unit sphere", self.words(self.picture("late.csv --axis y")))

    def test_slerp_steps_down_to_half_its_rate_at_the_key(self):
        """45° in 1 s, then 45° in 2 s, over 660 px for 3 s: a step at 220 px from the left end at 70 px."""
        rates = self.lines(self.picture("keys.csv --method slerp"), "#0072b2")[2]  # after the legend and the angle
        bottom = 270 + 130
        before = [bottom - y for x, y in rates[:2]]
        after = [bottom - y for x, y in rates[-2:]]
        self.assertAlmostEqual(before[0] / after[0], 2.0, delta=0.01)
        at_the_key = [bottom - y for x, y in rates if x == 290.0]
        self.assertEqual(at_the_key, [before[0], after[0]])

    def test_draws_several_methods(self):
        picture = self.picture("keys.csv --method slerp,auto --method quintic")
        for method in ("slerp", "auto", "quintic"):
            self.assertIn(method, self.words(picture))
        for color in ("#0072b2", "#d55e00", "#009e73"):
            self.assertGreaterEqual(len(self.lines(picture, color)), 5)

    def test_the_legend_tells_vectors_of_tensions_apart(self):
        vectors = ["quintic:tension=0.3,0.7,0.2", "quintic:tension=0.5,0.7,0.2"]
        words = self.words(self.picture(f"keys.csv --method {vectors[0]} --method {vectors[1]} --method slerp"))
        self.assertEqual([word for word in words if word in [*vectors, "slerp"]], [*vectors, "slerp"])
        self.write("tuned.csv", f"# orispline: method={vectors[0]}\n" + self.read("keys.csv"))
        self.assertIn("quintic", self.words(self.picture("tuned.csv")))

    def test_ghosts_are_bodies_in_a_row_for_each_method(self):
        self.assertEqual(len(list(self.picture("keys.csv").iter(f"{SVG}polygon"))), 0)
        picture = self.picture("keys.csv --method slerp,auto --ghosts 7")
        faces = [face.get("fill") for face in picture.iter(f"{SVG}polygon")]
        self.assertEqual([faces.count(color) for color in ("#0072b2", "#d55e00")], [3 * 7] * 2)
        self.assertIn("the body at 7 even times", self.words(picture))
        self.assertEqual(len(list(self.picture("- --ghosts 2", input="t,qw,qx,qy,qz\n5,1,0,0,0\n").iter(f"{SVG}polygon"))), 6)

    def test_one_key_is_a_picture_too(self):
        picture = self.picture("-", input="t,qw,qx,qy,qz\n5,1,0,0,0\n")
        self.assertIn("standard input: 1 key, t = 0 at 5 s", self.words(picture))

    def test_numbers_are_finite(self):
        self.assertIsNone(re.search(r"nan|inf\b", self.output_of("plot keys.csv --method auto,nu,circular")))

    def test_refuses_what_it_cannot_draw(self):
        seven = "auto,slerp,squad,quintic,sextic,tcb,nu"
        self.assert_fails(f"plot keys.csv --method {seven}", BAD_USAGE, "--method: found 7 methods, wanted at most 6")
        self.assert_fails("plot keys.csv --method slerp,auto --method slerp", BAD_USAGE,
                          "--method: found 'slerp' twice, wanted each method once")
        self.assert_fails("plot keys.csv --axis w", BAD_USAGE, "--axis: found 'w', wanted x|y|z")
        self.assert_fails("plot keys.csv --ghosts 1", BAD_USAGE, "--ghosts: found '1', wanted a whole number from 2 on")
        self.assert_fails("plot keys.csv --ghosts 61", BAD_USAGE, "--ghosts: found '61', wanted at most 60")
        self.assert_fails("plot none.csv", BAD_ACCESS, "none.csv: cannot open: No such file or directory")
        self.write("empty.csv", "t,qw,qx,qy,qz\n")
        done = self.run_command("plot empty.csv -o motion.svg")
        self.assertEqual((done.returncode, done.stderr.count("\n")), (BAD_DATA, 1))
        self.assertFalse((self.folder / "motion.svg").exists())
        done = self.run_command("plot keys.csv -o nowhere/motion.svg")
        self.assertEqual((done.returncode, done.stderr.count("\n")), (BAD_ACCESS, 1))


if __name__ == "__main__":
    main()
