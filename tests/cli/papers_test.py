#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The papers' experiments: the numbers that the papers print come out, and those that we state of them."""
import math

from command import main
from reproduced import Reproduced


class Quintic(Reproduced):
    """Tan et al. 2018."""

    def test_the_blending_functions_sum_to_one_and_interpolate(self):
        for table in self.tables_of("000-figure1"):
            for row in table["rows"]:
                self.assertAlmostEqual(row["sum"], 1, delta=1e-14)
            ends = [[table["rows"][k][name] for name in ("C0", "C1", "C2", "C3")] for k in (0, -1)]
            self.assertEqual(ends, [[0, 1, 0, 0], [0, 0, 1, 0]])

    def test_a_blending_function_has_the_value_of_its_formula(self):
        # (3.2) at t = 1/4 with the tension 0.35: C0 = -0.07 B1 - 0.1225 B2, C3 = -0.1225 B3 - 0.07 B4.
        b1, b2, b3, b4 = 5 * 3**4 / 4**5, 10 * 3**3 / 4**5, 10 * 3**2 / 4**5, 5 * 3 / 4**5
        row = self.rows_of("000-figure1")[1]
        self.assertAlmostEqual(row["C0"], -0.07 * b1 - 0.1225 * b2, delta=1e-15)
        self.assertAlmostEqual(row["C3"], -0.1225 * b3 - 0.07 * b4, delta=1e-15)

    def test_one_tension_touches_two_segments(self):
        base, *changed, zero = self.rows_of("000-figure2")
        self.assertEqual(zero["tensions"], "0")
        self.assertGreater(min(zero[f"segment {i}"] for i in (1, 2, 3, 4)), 1)
        self.assertEqual([base[f"segment {i}"] for i in (1, 2, 3, 4)], [0] * 4)
        for row in changed:
            self.assertEqual([row["segment 1"], row["segment 4"]], [0, 0])
            self.assertGreater(min(row["segment 2"], row["segment 3"]), 1)
            tension = float(row["tensions"].split(",")[2])
            self.assertAlmostEqual(row["|ω| at key 3 [rad/s]"], abs(tension) / 0.35 * base["|ω| at key 3 [rad/s]"],
                                   delta=1e-12)

    def test_a_larger_tension_makes_the_curve_flatter_at_its_key(self):
        rows = {row["α"]: row for row in self.rows_of("000-figure2", 1)}
        for key in ("at key 2", "at key 3", "at key 4"):
            curvatures = [rows[tension][key] for tension in (0.1, 0.2, 0.35, 0.7, 1, 2)]
            self.assertEqual(curvatures, sorted(curvatures, reverse=True))
            for tension in (0.1, 0.35, 1, 2):
                self.assertAlmostEqual(rows[-tension][key], rows[tension][key], delta=1e-9)
        self.assertAlmostEqual(rows[0.1]["at key 4"], 3.719, delta=0.5e-3)
        self.assertAlmostEqual(rows[2]["at key 4"], 0.394, delta=0.5e-3)

    def test_a_tension_of_zero_makes_a_corner(self):
        one, first, second, third = self.rows_of("000-theorem1")[1:]
        for row, key, corner in ((one, 3, 148.8), (first, 2, 106.2), (second, 3, 134.0), (third, 4, 70.3)):
            self.assertEqual((row["key"], row["order before"], row["behind"]), (key, 3, 3))
            self.assertAlmostEqual(row["corner [degrees]"], corner, delta=0.05)
            self.assertAlmostEqual(row["of ω at ±1e-5 s"], corner, delta=0.05)
        self.assertLess(self.rows_of("000-theorem1")[0]["corner [degrees]"], 1e-6)

    def test_the_derivatives_at_a_key_are_as_stated_and_the_misprints_are_none(self):
        self.assertEqual([row["equation"] for row in self.rows_of("000-identities")],
                         ["(3.4)", "(3.11)", "(3.12)", "(3.13)", "(3.14)"])
        self.assert_identities("000-identities", misprints=3)

    def test_tension_zero_stops_at_every_key(self):
        rows = {row["curve"]: row for row in self.rows_of("000-figure3")}
        self.assertEqual(len(rows), 9)
        self.assertLess(rows["α = 0"]["|ω| at key 3 [rad/s]"], 1e-14)
        self.assertEqual(rows["α = 0.35"]["continuity"], "C2")

    def test_table_1_holds_every_scheme_with_both_numbers_of_frames(self):
        rows = self.rows_of("000-table1")
        self.assertEqual([(row["method"], row["frames"]) for row in rows],
                         [(name, frames) for name in ("bspline-through", "nu", "atbi", "quintic") for frames in (401, 17)])
        for row in rows:
            self.assertLess(row["error [rad]"], 1e-11)  # the paper's schemes stop at 1e-6


    def test_the_hermite_curve_has_half_the_rate_and_an_acceleration_that_jumps(self):
        quintic, hermite, double = self.rows_of("000-figure4")
        self.assertEqual([row["continuity"] for row in (quintic, hermite, double)], ["C2", "C1", "C1"])
        rate = "|ω| at key 2 [rad/s]"
        self.assertAlmostEqual(hermite[rate], quintic[rate] / 2, delta=1e-14)
        self.assertAlmostEqual(double[rate], quintic[rate], delta=1e-14)
        jump = "largest jump of α at a key"
        self.assertLess(quintic[jump], 1e-13)
        self.assertGreater(min(hermite[jump], double[jump]), 1)

    def test_the_published_iterations_take_as_many_sweeps_as_linear_theory_says(self):
        """Of a natural spline with three inner keys in space."""
        rows = self.rows_of("000-table1", 1)
        self.assertEqual([(row["scheme"].split()[0], row["ends"]) for row in rows],
                         [("Kim's", "natural"), ("Kim's", "natural"), ("Nielson's", "natural"), ("Nielson's", "rest")])
        near, still = "until within 1e-6 rad of the keys", "until no control moves by 1e-6 rad"
        half = math.sqrt(0.5)  # of the slowest mode of three inner keys, whose matrix has 1/6, 4/6 and 1/6 in a row
        for row, rate in zip(rows, ((1 + half) / 3, half / 2, half / 2)):
            sweeps = math.log(1e-6) / math.log(rate)
            self.assertLess(abs(row[near] - sweeps), 0.3 * sweeps)
        for row in rows:
            self.assertGreaterEqual(row[still], row[near])
            self.assertEqual(row["paper_iterations"], "13" if row["scheme"].startswith("Kim") else "27")

    def test_the_quintic_approximates_other_curves_only_weakly(self):
        rows = self.rows_of("000-claims")
        for row, before, after in zip(rows, (5.6, 5.8, 2.6), (3.2, 3.4, 1.6)):
            self.assertAlmostEqual(row["RMS with α = 0.5 [degrees]"], before, delta=0.05)
            self.assertAlmostEqual(row["RMS of the nearest"], after, delta=0.05)

    def test_the_tensions_of_least_energy_have_the_least_energy(self):
        rows = {row["which"]: row for row in self.rows_of("000-claims", 1)}
        for which, energy in (("least ∫|α|² dt", "∫|α|² dt [rad²/s³]"), ("least ∫|torque|² dt", "∫|torque|² dt [N² m² s]"),
                              ("least ∫|κ|² ds", "∫|κ|² ds [1/rad]")):
            self.assertEqual(min(self.rows_of("000-claims", 1), key=lambda row: row[energy])["which"], which)
        self.assertLess(rows["closed form"]["∫|α|² dt [rad²/s³]"], 1.01 * rows["least ∫|α|² dt"]["∫|α|² dt [rad²/s³]"])


class Beta(Reproduced):
    """He et al. 2022."""

    def test_the_seven_control_points_come_out_as_printed(self):
        rows = self.rows_of("001-example1")
        self.assertEqual(len(rows), 7)
        for row in rows:
            self.assertLess(row["largest difference"], 0.5e-4)
            self.assertEqual(row["printed"], "({:.4f}, {:.4f}, {:.4f}, {:.4f})".format(*(row[f"q{c}"] for c in "wxyz")))
        self.assertEqual(rows[0]["printed"], "(-0.3796, 0.4589, 0.1106, 0.7956)")
        self.assertEqual(rows[6]["printed"], "(-0.3509, -0.7065, -0.5548, -0.2642)")

    def test_the_curves_are_g1_and_not_g2(self):
        for experiment, table, residuals in (("001-example1", 1, (0.0664, 0.0469)), ("001-example2", 0, (1.28, 0.0031))):
            rows = self.rows_of(experiment, table)
            self.assertEqual([row["signs"] for row in rows], ["as given", "shortest"])
            for row, residual in zip(rows, residuals):
                self.assertLess(row["G1"], 1e-14)
                self.assertAlmostEqual(row["G2"], residual, delta=0.006 * residual)
                self.assertAlmostEqual(row["times 6/gamma"], row["G2"], delta=1e-12)
                self.assertGreater(row["G2 with it"], 1e-3)

    def test_example_1_violates_the_condition_it_is_said_to_fulfil(self):
        row = self.rows_of("001-example1", 1)[0]
        self.assertAlmostEqual(row["(10) printed"], 1.01, delta=0.005)
        self.assertAlmostEqual(row["(10) corrected"], 0.00983, delta=0.5e-5)
        self.assertAlmostEqual(row["best delta"], 0.4685, delta=0.5e-4)
        self.assertAlmostEqual(row["G2 with it"], 0.0536, delta=0.5e-4)

    def test_a_larger_beta2_draws_the_joint_to_its_point(self):
        rows = self.rows_of("001-example2", 1)
        self.assertEqual([row["beta2"] for row in rows], [0.5, 2, 4] * 2)
        for variant in (rows[:3], rows[3:]):
            distances = [row["first joint to point 1 [degrees]"] for row in variant]
            self.assertEqual(distances, sorted(distances, reverse=True))
            self.assertLess(max(row["at the last joint"] for row in variant), 1e-12)

    def test_a_parameter_of_a_point_moves_the_four_segments_that_know_it(self):
        rows = self.rows_of("001-local")
        beta = [row for row in rows if row["method"] == "beta"]
        self.assertEqual([row["changed"] for row in beta], ["β₁ = 2", "β₂ = 4"])
        for row in beta:
            moved = {name: cell for name, cell in row.items() if "–" in name}
            self.assertEqual([moved.pop("0–1"), moved.pop("8–9")], ["–", "–"])
            self.assertEqual([name for name, angle in moved.items() if angle > 0], ["3–4", "4–5", "5–6", "6–7"])
            self.assertGreater(min(moved[name] for name in ("3–4", "4–5", "5–6", "6–7")), 0.3)
        for row in (row for row in rows if row["method"] == "beta-through"):
            self.assertGreater(min(cell for name, cell in row.items() if "–" in name), 1e-3)  # a global curve

    def test_the_best_betas_have_less_energy_or_are_nearer_and_leave_the_continuity_as_it_is(self):
        rows = self.rows_of("001-shapes")
        energy, rms = "∫|α|² dt [rad²/s³]", "RMS [degrees]"
        for (plain, least, nearest), shape, less, nearer in ((rows[:3], "G1", 0.88, 0.33), (rows[3:], "G2", 0.81, 0.85)):
            self.assertAlmostEqual(least[energy] / plain[energy], less, delta=0.01)
            self.assertAlmostEqual(nearest[rms] / plain[rms], nearer, delta=0.01)
            self.assertEqual({row["shape"] for row in (plain, least, nearest)}, {shape})


class Eberly(Reproduced):
    def test_every_identity_holds_and_the_misprints_do_not(self):
        self.assertEqual(len(self.rows_of("002-identities")), 22)
        self.assert_identities("002-identities", misprints=3, rounding=1e-13)

    def test_the_angular_cubic_has_the_stated_ends(self):
        rows = {row["quantity"]: row for row in self.rows_of("002-example")}
        for quantity, value in (("phi(0)", 0.2), ("phi(1)", 1), ("phi'(0)", 0.65), ("phi'(1)", 0.25)):
            for column in ("its value", "phi", "squad"):
                self.assertAlmostEqual(rows[quantity][column], value, delta=1e-14)

    def test_squad_in_the_plane_is_the_cubic_of_catmull_and_rom(self):
        for row in self.rows_of("002-example", 1):
            self.assertLess(max(row["angle"], row["first derivative"], row["second derivative"]), 1e-12)


class Sextic(Reproduced):
    def test_the_continuity_is_that_of_theory(self):
        even, _, uneven = self.tables_of("003-table1")
        continuity = {row["method"]: row["in time"] for row in even["rows"]}
        self.assertEqual({name: continuity[name] for name in ("xing-quartic", "xing-quintic", "quintic", "sextic")},
                         {"xing-quartic": "C2", "xing-quintic": "C3", "quintic": "C2", "sextic": "C3"})
        continuity = {row["method"]: row["in time"] for row in uneven["rows"]}
        self.assertEqual((continuity["sextic"], continuity["timed-c3"]), ("C0", "C3"))
        for table in (even, uneven):
            shape = {row["method"]: row["in shape"] for row in table["rows"]}
            self.assertEqual([shape[name] for name in ("xing-quartic", "xing-quintic", "quintic", "sextic", "timed-c3")],
                             ["G2", "G3", "G2", "G3", "G3"])

    def test_xing_is_the_case_of_five_96ths(self):
        even, _, uneven = self.tables_of("003-table1")
        for table in (even, uneven):
            rows = {row["curve"]: row for row in table["rows"]}
            for column in ("angle: MSE [rad²]", "angle: maximum [rad]"):
                self.assertAlmostEqual(rows["Xing, quintic"][column], rows["6th degree, β = 5/96"][column], delta=1e-12)

    def test_the_figures_of_the_paper_stand_beside_ours(self):
        rows = {row["curve"]: row for row in self.rows_of("003-table1")}
        self.assertEqual([rows[name]["paper_mse"] for name in ("Xing, quartic", "Tan, α = 0.45", "6th degree, β = 0.025")],
                         ["0.012979", "0.011337", "0.001130"])
        row = rows["6th degree, β = 0.025"]
        self.assertEqual([row[name] for name in ("paper_maximum", "paper_time_s")], ["0.079421", "0.715989"])

    def test_both_readings_of_the_distance_stand_in_the_table(self):
        """Half the angle is what fits the paper's 6th degree, though the flights differ."""
        for table in self.tables_of("003-table1"):
            for row in table["rows"]:
                self.assertAlmostEqual(row["sphere: MSE [rad²]"], row["angle: MSE [rad²]"] / 4, delta=1e-15)
                self.assertAlmostEqual(row["sphere: maximum [rad]"], row["angle: maximum [rad]"] / 2, delta=1e-15)
        row = {row["curve"]: row for row in self.rows_of("003-table1")}["6th degree, β = 0.025"]
        for column, value in (("angle: MSE [rad²]", 0.006214), ("angle: maximum [rad]", 0.160028),
                              ("sphere: MSE [rad²]", 0.001554), ("sphere: maximum [rad]", 0.080014)):
            self.assertAlmostEqual(row[column], value, delta=0.5e-6)

    def test_the_lemmas_hold_as_corrected_and_not_as_printed(self):
        numbers = {row["equation"] for row in self.rows_of("003-identities")}
        self.assertLessEqual({"lemma 1 (i)", "lemma 1 (ii)", "lemma 1 (iii)", "lemma 1 (iv)", "(2), lemma 2", "lemma 3",
                              "lemma 4", "(9)"}, numbers)
        self.assert_identities("003-identities", misprints=8)

    def test_a_tension_of_zero_makes_a_cusp(self):
        moving, *rows = self.rows_of("003-theorem1")
        self.assertLess(moving["corner [degrees]"], 1e-6)
        self.assertEqual([row["key"] for row in rows], [3, 2, 3, 4])
        for row in rows:
            self.assertEqual((row["order before"], row["behind"]), (2, 2))
            self.assertAlmostEqual(row["corner [degrees]"], 180, delta=1e-9)
            self.assertAlmostEqual(row["of ω at ±1e-5 s"], 180, delta=0.1)

    def test_curves_at_rest_at_both_ends_are_nearer_than_those_of_the_paper(self):
        printed, better, _ = self.tables_of("003-table1")
        nearest = min(row["angle: maximum [rad]"] for row in printed["rows"])
        rows = {(row["curve"], row["ends"]): row for row in better["rows"]}
        for curve, mse, largest in (("global-c2", 0.00152, 0.0729), ("Tan, α = 0.45", 0.00204, 0.104)):
            row = rows[curve, "rest"]
            self.assertAlmostEqual(row["angle: MSE [rad²]"], mse, delta=0.5e-5)
            self.assertAlmostEqual(row["angle: maximum [rad]"], largest, delta=0.5e-3)
            self.assertLess(row["angle: maximum [rad]"], 0.75 * nearest)
        before = {row["curve"]: row["angle: MSE [rad²]"] for row in printed["rows"]}
        for name, plain in (("Tan", "Tan, α = 0.45"), ("6th degree", "6th degree, β = 1/12")):
            self.assertGreater(rows[f"{name}, by energy", "repeat"]["angle: MSE [rad²]"], 2 * before[plain])
            self.assertLess(rows[f"{name}, by energy", "rest"]["angle: MSE [rad²]"], before[plain])
            self.assertLess(rows[f"{name}, by fit", "repeat"]["angle: MSE [rad²]"], before[plain] / 5)

    def test_energy_leads_away_from_a_flight_of_five_keys_and_fit_leads_to_it(self):
        plain, energy, fit = self.rows_of("003-claims", 1)
        for row, rms in ((plain, 3.97), (energy, 5.61), (fit, 1.24)):
            self.assertAlmostEqual(row["RMS [degrees]"], rms, delta=0.005)
        self.assertLess(energy["∫|α|² dt [rad²/s³]"], plain["∫|α|² dt [rad²/s³]"])
        flight = self.rows_of("003-claims", 2)
        for method in (flight[:3], flight[3:]):
            self.assertEqual(sorted(method, key=lambda row: -row["RMS [degrees]"]), method)

    def test_what_is_claimed_in_words_is_judged_by_numbers(self):
        even, peaks, reach = (table["rows"] for table in self.tables_of("003-claims")[3:])
        deviations = {row["curve"]: row["deviation/mean"] for row in even}
        for curve, deviation in (("the chords alone", 0.54), ("6th degree, β = 0.025", 0.75), ("6th degree, β = 1/12", 0.61)):
            self.assertAlmostEqual(deviations[curve], deviation, delta=0.005)
        self.assertLess(deviations["the chords alone"], min(value for curve, value in deviations.items() if curve.startswith("6th")))
        rms = {row["curve"]: row["RMS of |ω| [rad/s]"] for row in peaks}
        self.assertEqual(max(rms, key=rms.get), "6th degree, β = 0.025")
        self.assertAlmostEqual(rms["6th degree, β = 0.025"], 0.116, delta=0.5e-3)
        for row in reach[1:]:
            self.assertEqual((row["segment 1"], row["segment 4"]), (0, 0))
            self.assertGreater(min(row["segment 2"], row["segment 3"]), 1)

    def test_the_times_of_the_claim_are_those_of_this_machine(self):
        rows = self.rows_of("003-claims")
        self.assertEqual([row["method"] for row in rows], ["xing-quartic", "quintic", "sextic"])
        self.assertGreater(min(row["time [ms]"] for row in rows), 0)

    def test_the_speed_jumps_by_the_ratio_of_the_steps_unless_the_method_is_timed(self):
        knots = {0.5: 2, 1.5: 0.75, 2.25: 7 / 3}
        for row in self.rows_of("003-figure7"):
            if row["curve"].startswith("6th"):
                self.assertAlmostEqual(row["before/after"], knots[row["knot [s]"]], delta=1e-12)
                self.assertEqual((row["in time"], row["in shape"]), ("C0", "G3"))
            else:
                self.assertLess(row["|jump of ω|"], 1e-13)
                self.assertEqual((row["in time"], row["in shape"]), ("C3", "G3"))


if __name__ == "__main__":
    main()
