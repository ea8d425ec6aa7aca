#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Angular rates of the keys: which are read, which are not, and what `orispline sample` says about them."""
from command import BAD_DATA, CommandTest, main, rows_of


class Rates(CommandTest):
    def test_rates_of_the_keys_shape_the_hermite_curve(self):
        self.write("keys.csv", "t,qw,qx,qy,qz,wx,wy,wz\n0,1,0,0,0,0.3,0,0\n1,1,0,0,0,0,-0.4,0\n2,1,0,0,0,0,0,0.5\n")
        rows = rows_of(self.output_of("sample keys.csv --method hermite-cumulative --count 3 --derivatives 1"))
        for row, rate in zip(rows, ([0.3, 0, 0], [0, -0.4, 0], [0, 0, 0.5])):
            for found, wanted in zip(row[5:], rate):
                self.assertAlmostEqual(found, wanted, delta=1e-14)

    def test_accelerations_are_read_by_methods_that_take_them_and_by_no_others(self):
        self.write("keys.csv", "t,qw,qx,qy,qz,wx,wy,wz,ax,ay,az\n"
                   "0,1,0,0,0,0.3,0,0,1,2,3\n1,1,0,0,0,0,-0.4,0,-1,0,0\n2,1,0,0,0,0,0,0.5,0,9.81,0\n")
        rows = rows_of(self.output_of("sample keys.csv --method hermite-c2 --count 3"))
        for row, rates in zip(rows, ([0.3, 0, 0, 1, 2, 3], [0, -0.4, 0, -1, 0, 0], [0, 0, 0.5, 0, 9.81, 0])):
            for found, wanted in zip(row[5:], rates):
                self.assertAlmostEqual(found, wanted, delta=1e-13)
        done = self.run_command("sample keys.csv --method hermite-c2 --count 3 -o out.csv")
        self.assertIn("rates taken from the keys: angular velocities, accelerations\n", done.stderr)
        self.write("keys.csv", "t,qw,qx,qy,qz,wx,wy,wz,ax,ay\n0,1,0,0,0,0.3,0,0,nan,x\n1,1,0,0,0,0,-0.4,0,,\n")
        self.output_of("sample keys.csv --method hermite-c1 --count 3")
        self.assert_fails("sample keys.csv --method hermite-c2 --count 3", BAD_DATA,
                          "keys.csv:1: found ax, ay without az, wanted all three columns or none")

    def test_rates_of_the_world_are_turned_into_the_body(self):
        turned = "t,qw,qx,qy,qz,wx_world,wy_world,wz_world\n0,0,1,0,0,1,2,3\n1,0,1,0,0,1,2,3\n"
        self.write("keys.csv", turned)
        row = rows_of(self.output_of("sample keys.csv --method hermite-cumulative --count 2 --derivatives 1"))[0]
        for found, wanted in zip(row[5:], (1, -2, -3)):
            self.assertAlmostEqual(found, wanted, delta=1e-14)
        self.write("keys.csv", turned.replace(",0,1,0,0,", ",0,-1,0,0,"))
        other = rows_of(self.output_of("sample keys.csv --conjugate --method hermite-c3 --count 2 --derivatives 1"))[0]
        for found, wanted in zip(other[5:], row[5:]):
            self.assertAlmostEqual(found, wanted, delta=1e-14)

    def test_rates_of_the_body_are_kept_where_the_file_holds_world_to_body(self):
        self.write("keys.csv", "t,qw,qx,qy,qz,wx,wy,wz\n0,1,0,0,0,1,2,3\n1,1,0,0,0,1,2,3\n")
        command = "sample keys.csv --conjugate --method hermite-cumulative --count 2 --derivatives 1 -o out.csv"
        self.assertIn("rates taken from the keys: angular velocities\n", self.run_command(command).stderr)
        for found, wanted in zip(rows_of(self.read("out.csv"))[0][5:], (1, 2, 3)):
            self.assertAlmostEqual(found, wanted, delta=1e-14)

    def test_rates_may_be_left_free_at_some_keys(self):
        rows = ["t,qw,qx,qy,qz,wx,wy,wz", "0,1,0,0,0,0.3,0,0", "1,0.96,0.28,0,0,,,", "2,0.8,0.6,0,0,nan,nan,nan",
                "3,0.96,0.28,0,0,0,-0.4,0"]
        self.write("keys.csv", "\n".join(rows) + "\n")
        self.write("none.csv", "\n".join(row.split(",w")[0] if row[0] == "t" else ",".join(row.split(",")[:5])
                                         for row in rows) + "\n")
        for method in ("hermite-c1", "hermite-cumulative", "least"):
            done = self.run_command(f"sample keys.csv --method {method} --count 4 --derivatives 1 -o out.csv")
            self.assertIn("left rates of 2 keys free\n", done.stderr)
            found = rows_of(self.read("out.csv"))
            for row, wanted in ((0, [0.3, 0, 0]), (3, [0, -0.4, 0])):
                for value, rate in zip(found[row][5:], wanted):
                    self.assertAlmostEqual(value, rate, delta=1e-12)
            if method != "least":
                estimated = rows_of(self.output_of(f"sample none.csv --method {method} --count 4 --derivatives 1"))
                for row in (1, 2):
                    for value, rate in zip(found[row][5:], estimated[row][5:]):
                        self.assertAlmostEqual(value, rate, delta=1e-12)
        self.run_command("convert keys.csv -o again.csv")
        one, two = (self.output_of(f"sample {name} --method hermite-c1 --count 9") for name in ("keys.csv", "again.csv"))
        self.assertEqual(one, two)
        self.assert_fails("smooth keys.csv --gyro -o out.csv", BAD_DATA,
                          "keys.csv: found 2 rates of the gyro, wanted at least 3")  # a row without a rate is one without a gyro

    def test_the_optimum_is_a_file_of_keys_with_rates(self):
        self.write("keys.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n1,0.96,0.28,0,0\n2.5,0.8,0,0.6,0\n3,0.6,0,0,0.8\n")
        self.run_command("sample keys.csv --method least --times keys.csv -o optimum.csv")
        again = rows_of(self.output_of("sample optimum.csv --method least --count 21"))
        for row, wanted in zip(again, rows_of(self.output_of("sample keys.csv --method least --count 21"))):
            for value, number in zip(row, wanted):
                self.assertAlmostEqual(value, number, delta=1e-6)


if __name__ == "__main__":
    main()
