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


if __name__ == "__main__":
    main()
