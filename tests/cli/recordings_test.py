#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`orispline compare` on recordings, against ratios to SciPy's spline that another implementation found on them.

The recordings are not part of the project, for their licences differ: they are read where they lie beside it.
"""
import json
import math
import pathlib
import unittest

from command import CommandTest, main

DATA = pathlib.Path(__file__).resolve().parents[3] / "shared" / "data"
METHODS = {  # column of the tables -> method as it was used there
    "slerp": "slerp", "squad": "squad", "quintic": "quintic:ends=natural",
    "sextic .025": "sextic:tension=0.025:ends=natural", "sextic 1/12": "sextic:ends=natural", "timed-c2": "timed-c2",
    "timed-sextic": "timed-sextic", "auto5": "auto5", "auto": "auto"}
BROAD = "imu/broad_06_undisturbed_fast_rotation_A_40s.csv"
FILES = {
    "px4": ["flight/px4_quad_sample_attitude.csv"],
    "broad": [BROAD, "--drop-invalid", "--columns",
              "qw=opt_qw,qx=opt_qx,qy=opt_qy,qz=opt_qz,wx=gyr_x_rad_s,wy=gyr_y_rad_s,wz=gyr_z_rad_s"],
    "mro": ["spacecraft/mro_ck_sliced_-74000.csv", "--conjugate", "--time-scale", "0.00390625", "--columns",
            "t=sclk_ticks,qw=q0_w,qx=q1,qy=q2,qz=q3,wx_world=wx_ref_rad_s,wy_world=wy_ref_rad_s,wz_world=wz_ref_rad_s"],
    "fr2": ["trajectory/tum_fr2_desk_groundtruth.txt", "--drop-duplicates"]}

# Ratios of RMS figures to those of rotation-spline, over the decimations: geometric mean and largest, as printed. The last
# of mro is with the guard of auto, which that implementation has too (1.0164; without it 1.0142).
DISTANCES = {
    "px4": ([8, 16, 32, 64], "1.445/2.14 1.064/1.20 1.074/1.20 1.624/2.52 1.215/1.48 1.083/1.22 1.218/1.50 1.016/1.09 1.002/1.02"),
    "broad": ([8, 16, 32, 64, 100],
              "1.703/3.92 1.155/1.79 1.161/1.81 2.443/9.38 1.359/2.67 1.159/1.77 1.354/2.63 1.035/1.18 1.000/1.00"),
    "mro": ([4, 8, 16, 32, 64], "1.882/4.76 1.613/1.90 1.809/2.13 25/39 1.654/2.76 1.060/1.31 1.392/2.62 1.025/1.14 1.003/1.02"),
    "fr2": ([4, 8, 16, 32, 64], "0.765/0.97 0.780/1.00 0.789/1.02 0.781/1.02 0.767/0.97 0.927/1.02 0.839/0.97 0.775/0.99 0.780/1.00")}
RATES = {
    "px4": ([8, 16, 32], "1.44/1.61 1.12/1.18 1.17/1.22 2.15/2.97 1.27/1.32 1.17/1.22 1.27/1.32 1.02/1.08 1.004/1.02"),
    "broad": ([4, 8, 16, 32], "1.30/1.69 1.09/1.22 1.12/1.27 4.18/7.15 1.20/1.49 1.09/1.25 1.19/1.48 1.02/1.04 1.000/1.00"),
    "mro": ([4, 8, 16, 32, 64], "1.17/1.70 1.17/1.26 1.30/1.39 19.6/19.9 1.20/1.42 1.01/1.05 1.07/1.29 1.00/1.01 1.000/1.00")}


def step_of(printed):
    """The unit of the last printed digit."""
    return 10.0 ** -len(printed.partition(".")[2])


@unittest.skipUnless(DATA.is_dir(), f"no {DATA}")
class Recordings(CommandTest):
    def ratios(self, name):
        """Method -> decimation -> figure -> ratio to rotation-spline."""
        file, *reading = FILES[name]
        steps = sorted({step for tables in (DISTANCES, RATES) for step in tables.get(name, ([], ""))[0]})
        rows = json.loads(self.output_of(
            ["compare", str(DATA / file), *reading, "--keep-every", ",".join(map(str, steps)), "--methods",
             ",".join(["rotation-spline", *METHODS.values()]), "--json"]))
        by_name = {(row["method"], row["keep_every"]): row for row in rows}
        return lambda method, step, figure: by_name[method, step][figure] / by_name["rotation-spline", step][figure]

    def assert_table(self, ratio, figure, steps, printed):
        for (column, method), cell in zip(METHODS.items(), printed.split(), strict=True):
            found = [ratio(method, step, figure) for step in steps]
            mean = math.exp(sum(map(math.log, found)) / len(found))
            for value, text in zip((mean, max(found)), cell.split("/"), strict=True):
                self.assertAlmostEqual(value, float(text), delta=0.6 * step_of(text), msg=f"{figure} {column}: {found}")

    def check(self, name):
        ratio = self.ratios(name)
        self.assert_table(ratio, "rms_deg", *DISTANCES[name])
        if name in RATES:
            self.assert_table(ratio, "rate_rms_rad_s", *RATES[name])

    def test_flight_log(self):
        self.check("px4")

    def test_fast_rotation_with_optical_truth(self):
        self.check("broad")

    def test_spacecraft_in_conjugate_quaternions(self):
        self.check("mro")

    def test_hand_held_camera_with_gaps(self):
        self.check("fr2")


if __name__ == "__main__":
    main()
