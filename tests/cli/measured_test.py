#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The method measured: what it says of the keys, that this can be given back to it, and its band."""
import json
import math
import random

from command import BAD_USAGE, CommandTest, main


def noisy_keys(count, seed=1):
    """A slow turn about z with noise at its keys, ten a second."""
    dice = random.Random(seed)
    rows = ["t,qw,qx,qy,qz"]
    for i in range(count):
        half = 0.02 * i + dice.gauss(0, 0.02)
        rows.append(f"{i / 10},{math.cos(half)!r},0,0,{math.sin(half)!r}")
    return "\n".join(rows) + "\n"


def cells_of(text):
    return [line.split(",") for line in text.splitlines()]


class Measured(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("keys.csv", noisy_keys(60))

    def test_the_summary_of_many_keys_names_the_method_for_recordings(self):
        hint = "if the keys are a recording, --method measured"
        for count, method, told in ((19, "", False), (20, "", True), (20, "--method measured", False), (20, "--method slerp", False)):
            self.write("recorded.csv", noisy_keys(count))
            done = self.run_command(f"sample recorded.csv {method} --count 5 -o out.csv")
            self.assertEqual((done.returncode, hint in done.stderr), (0, told), done.stderr)

    def summary(self, arguments):
        return json.loads(self.output_of(f"sample keys.csv --rate 50 {arguments} --json -o out.csv"))

    def test_says_in_the_summary_what_the_keys_say(self):
        done = self.run_command("sample keys.csv --method measured --rate 50 --band 0.9 -o out.csv")
        self.assertRegex(done.stderr, r"\nthe keys say: key noise 0\.\d+: \d+ %, .*; polynomial believed [\d.]+, "
                                      r"of nine keys [\d.]+; trust 1\n")
        self.assertIn("\nthe band is meant to hold 90 % of the true motion\n", done.stderr)
        self.assertNotIn("the keys say", self.run_command("sample keys.csv --rate 50 -o out.csv").stderr)

    def test_says_the_same_in_json_and_takes_it_as_settings(self):
        found = self.summary("--method measured")["findings"]
        self.assertEqual((found["given"], len(found["settings"])), (False, 15))
        self.assertAlmostEqual(found["settings"]["interval"], 0.1, delta=1e-12)
        samples = self.read("out.csv")
        given = self.summary("--method measured " + " ".join(f"--set {k}={v!r}" for k, v in found["settings"].items()))
        self.assertEqual(self.read("out.csv"), samples)
        self.assertTrue(given["method_text"].startswith("measured:"), given["method_text"])
        self.assertIsNone(self.summary("--method auto")["findings"])

    def test_goes_in_pieces_where_all_is_given(self):
        found = self.summary("--method measured")["findings"]["settings"]
        samples = self.read("out.csv")
        settings = " ".join(f"--set {k}={v!r}" for k, v in found.items())
        done = self.run_command(f"sample keys.csv --method measured {settings} --rate 50 -o out.csv")
        self.assertNotIn("the keys say", done.stderr)  # they were not held
        self.assertEqual(self.read("out.csv"), samples)

    def test_inspect_says_it_and_how_it_is_given(self):
        text = self.output_of("inspect keys.csv --method measured,auto")
        self.assertEqual(text.count("The keys say to measured: "), 1)
        self.assertRegex(text, r"\nwhich as settings are 'measured:interval=")
        methods = {m["method"]: m for m in json.loads(self.output_of("inspect keys.csv --method measured,auto --json"))["methods"]}
        self.assertIsNone(methods["auto"]["findings"])
        self.assertEqual(methods["measured"]["findings"]["trust"], 1)

    def test_a_band_that_is_empty_is_said_so(self):
        reason = "the keys do not tell how far from the curve the motion was"
        self.write("keys.csv", noisy_keys(8))  # nine are the fewest that tell
        done = self.run_command("sample keys.csv --method measured --rate 50 --band 0.9 -o out.csv")
        self.assertIn(f"\nthe band is empty: {reason}\n", done.stderr)
        self.assertEqual({row[-1] for row in cells_of(self.read("out.csv"))[1:]}, {""})
        sessions = noisy_keys(60) + "".join(f"{100 + k},{math.cos(k)!r},{math.sin(k)!r},0,0\n" for k in range(4))
        self.write("keys.csv", sessions)
        done = self.run_command("sample keys.csv --method measured --gap 5 --rate 10 --band 0.9 -o out.csv")
        empty = sum(row[-1] == "" for row in cells_of(self.read("out.csv"))[1:])
        self.assertGreater(empty, 0)
        self.assertIn(f"\nthe band is meant to hold 90 % of the true motion; it is empty at {empty} samples, where {reason}\n", done.stderr)

    def test_the_band_is_the_last_column(self):
        report = self.summary("--method measured --band 0.9")
        self.assertEqual((report["columns"][-1], report["band"]), ("band", 0.9))
        head, *rows = cells_of(self.read("out.csv"))
        self.assertEqual(head[-1], "band")
        bands = [float(row[-1]) for row in rows]
        self.assertTrue(all(0 <= band < 1 for band in bands))
        self.assertGreater(max(bands), 0.01)
        self.summary("--method measured --band 0.5")
        half = [float(row[-1]) for row in cells_of(self.read("out.csv"))[1:]]
        self.assertTrue(all(a <= b for a, b in zip(half, bands)))

    def test_the_band_is_empty_where_the_keys_say_nothing(self):
        self.write("keys.csv", noisy_keys(5))
        self.summary("--method measured --band 0.9")
        self.assertEqual({row[-1] for row in cells_of(self.read("out.csv"))[1:]}, {""})

    def test_the_band_needs_a_share_the_method_and_a_format_that_holds_it(self):
        for share in ("0", "1", "90", "most"):
            self.assert_fails(f"sample keys.csv --method measured --band {share} --rate 9", BAD_USAGE,
                              f"--band: found '{share}', wanted a number between 0 and 1")
        self.assert_fails("sample keys.csv --band 0.9 --rate 9", BAD_USAGE,
                          "--band: method 'auto' has no band, wanted 'measured', or keys that smooth wrote with --sigma")
        self.assert_fails("sample keys.csv --method measured --band 0.9 --rate 9 -o out.tum", BAD_USAGE,
                          "--band: found '0.9', wanted none for a TUM file, which has no columns for rates")


if __name__ == "__main__":
    main()
