#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""orispline tune: what it prints and writes, that 'sample' reads it, and what it refuses."""
import json
import math
import random

from command import BAD_DATA, BAD_USAGE, SUCCESS, CommandTest, main, table_of

KEYS = """t,qw,qx,qy,qz,note
0,1,0,0,0,"take off, level"
1,0.9,0.3,0.2,0.2449489742783178,
2.5,0.6,0.5,0.4,0.4795831523312719,x
3,0.3,0.7,0.1,0.6403124237432849,x
4,0.1,0.8,-0.3,0.5099019513592785,x
"""


class Tune(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("keys.csv", KEYS)

    def tuned(self, arguments):
        return json.loads(self.output_of(f"tune keys.csv {arguments} --json -o tuned.csv"))

    def test_times_are_text_as_the_file_has_them(self):
        stamps = [f"1700000000.{digits}" for digits in ("023456789", "123456789", "323456789", "423456789")]
        self.write("stamps.csv", "t,qw,qx,qy,qz\n" + "".join(f"{t},{math.cos(k / 9)},0,0,{math.sin(k / 9)}\n" for k, t in enumerate(stamps)))
        found = json.loads(self.output_of("tune stamps.csv --method quintic --json -o tuned.csv"))
        self.assertEqual(found["t_s"], stamps)

    def test_writes_the_keys_as_they_are_with_their_tensions(self):
        summary = self.tuned("--method timed-c2 --objective acceleration")
        lines, keys = table_of(self.read("tuned.csv")), KEYS.splitlines()
        self.assertEqual(lines[0], keys[0] + ",tension,tension2")
        for line, key, first, second in zip(lines[1:], keys[1:], summary["tension"], summary["tension2"], strict=True):
            self.assertEqual(line, f"{key},{first!r},{second!r}".replace(".0,", ",").removesuffix(".0"))
        self.assertLess(summary["energy_after"], summary["energy_before"])
        self.assertEqual((summary["tension2"][0], summary["tension2"][-1]), (1, 1))

    def test_finds_nothing_more_to_tune_in_what_it_wrote(self):
        for method in ("quintic", "sextic", "timed-c2", "timed-c3", "timed-sextic", "tcb", "nu"):
            first = self.tuned(f"--method {method} --objective torque --inertia=2,2,3")
            again = json.loads(self.output_of(f"tune tuned.csv --method {method} --objective torque --inertia=2,2,3 "
                                              "--json -o again.csv"))
            self.assertAlmostEqual(again["energy_before"] / first["energy_after"], 1, delta=1e-12)
            self.assertAlmostEqual(again["energy_after"] / first["energy_after"], 1, delta=1e-12)
            self.assertEqual(self.read("again.csv").splitlines()[0], self.read("tuned.csv").splitlines()[0])

    def test_writes_what_sample_reads(self):
        self.tuned("--method quintic --objective linearised --inertia=1,2,4")
        plain = self.output_of("sample keys.csv --method quintic --count 9 --quiet")
        tuned = self.output_of("sample tuned.csv --method quintic --count 9 --quiet")
        self.assertNotEqual(plain, tuned)

    def test_fits_a_reference(self):
        self.output_of("sample keys.csv --method sextic --tension=0.1 --rate 20 --ends repeat -o reference.csv")
        summary = self.tuned("--method sextic --objective fit --reference reference.csv")
        self.assertLess(summary["energy_after"], 1e-20)
        for tension in summary["tension"]:
            self.assertAlmostEqual(tension, 0.1, delta=1e-8)

    def test_leaves_a_steady_turn_as_it_is(self):
        self.write("steady.csv", "t,qw,qx,qy,qz\n" + "".join(
            f"{t},{math.cos(0.25 * t)!r},0,0,{math.sin(0.25 * t)!r}\n" for t in range(8)))
        for method in ("timed-c2", "timed-c3", "timed-sextic"):
            for objective in ("acceleration", "jerk"):
                done = self.run_command(f"tune steady.csv --method {method} --objective {objective} --json -o tuned.csv")
                self.assertEqual((done.returncode, done.stderr), (SUCCESS, ""))
                summary = json.loads(done.stdout)
                self.assertEqual((summary["iterations"], summary["stationarity"]), (0, 0))
                self.assertEqual(summary["energy_after"], summary["energy_before"])
                self.assertEqual(len(set(summary["tension"])), 1)

    def test_says_where_there_may_be_better_tensions(self):
        wild, t, rows = random.Random(4), 0.0, []
        for _ in range(7):
            quaternion = [wild.gauss(0, 1) for _ in range(4)]
            rows.append(",".join(map(repr, [t, *(c / math.hypot(*quaternion) for c in quaternion)])) + "\n")
            t += math.exp(wild.uniform(math.log(4e-4), math.log(98)))
        self.write("uneven.csv", "t,qw,qx,qy,qz\n" + "".join(rows))
        done = self.run_command("tune uneven.csv --method timed-c3 --objective jerk --json -o tuned.csv")
        self.assertEqual(done.returncode, SUCCESS)
        summary = json.loads(done.stdout)
        self.assertLess(summary["energy_after"], summary["energy_before"])
        self.assertGreater(summary["stationarity"], 1e-8)
        self.assertRegex(done.stderr.splitlines()[0], r"^orispline: warning: timed-c3: after \d+ iterations another step would still "
                                      r"lower the energy by \S+ of itself, wanted 1e-08 at most; these tensions are "
                                      r"better than those before, and others may be better still$")

    def test_keeps_bounds(self):
        summary = self.tuned("--method quintic --bounds=0.48,0.52")
        self.assertEqual(max(summary["tension"]), 0.52)
        self.assertGreaterEqual(min(summary["tension"]), 0.48)

    def test_reads_a_header_and_rows_that_end_with_a_comma(self):
        self.write("comma.csv", "t,qw,qx,qy,qz,\n0,1,0,0,0,\n1,0.9,0.43588989435,0,0,\n2,0.8,0.6,0,0,\n"
                                "3.5,0.9,0.1,0.3,0.3,\n")
        lines = table_of(self.output_of("tune comma.csv --method timed-c2 --quiet"))
        self.assertEqual(lines[0], "t,qw,qx,qy,qz,tension,tension2")
        self.assertEqual([line.count(",") for line in lines], [6] * 5)

    def test_makes_a_csv_of_a_tum_file(self):
        self.output_of("convert keys.csv -o keys.tum --quiet")
        self.output_of("tune keys.tum --method quintic -o tuned.csv --quiet")
        self.assertEqual(table_of(self.read("tuned.csv"))[0], "t,px,py,pz,qx,qy,qz,qw,tension")
        self.output_of("sample tuned.csv --method quintic --count 3 --quiet")

    def test_refuses_methods_without_tensions_and_names_those_that_it_tunes(self):
        refusal = self.run_command("tune keys.csv --method slerp -o tuned.csv").stderr.splitlines()[0]
        words, _, names = refusal.partition(", wanted one of ")
        self.assertEqual(words, "orispline: --method: slerp has no tensions to tune")
        self.assertLessEqual({"tcb", "quintic", "sextic", "timed-c2", "timed-c3", "timed-sextic", "nu"}, set(names.split(", ")))
        for method in json.loads(self.output_of("methods --json")):
            done = self.run_command(f"tune keys.csv --method {method['name']} -o tuned.csv --quiet")
            self.assertEqual(done.returncode, SUCCESS if method["name"] in names.split(", ") else BAD_USAGE, done.stderr)

    def test_refuses_what_it_cannot_tune(self):
        self.write("two.csv", "\n".join(KEYS.splitlines()[:3]) + "\n")
        self.write("one.csv", "\n".join(KEYS.splitlines()[:2]) + "\n")
        self.write("late.csv", "t,qw,qx,qy,qz\n10,1,0,0,0\n11,1,0,0,0\n")
        refused = lambda arguments, code, message: self.assert_fails(f"tune {arguments} -o tuned.csv", code, message)
        refused("one.csv", BAD_DATA, "one.csv: found 1 key, wanted at least 3 to tune tensions")
        refused("two.csv", BAD_DATA, "two.csv: found 2 keys, wanted at least 3 to tune tensions")
        refused("keys.csv --objective fit --reference late.csv", BAD_DATA, "keys.csv: the reference has no time between "
                "the first and the last key, wanted some from 0 to 4 s")
        refused("keys.csv --objective torque --inertia=1,-2,4", BAD_USAGE,
                "--inertia: found the principal moments -2, 1, 4, wanted all of them greater than 0")
        refused("keys.csv --objective torque", BAD_USAGE, "--objective: found torque, wanted --inertia as well")
        refused("keys.csv --objective fit", BAD_USAGE, "--objective: found fit, wanted --reference as well")
        refused("keys.csv --reference late.csv", BAD_USAGE, "--reference: it is used by the objective fit alone, wanted "
                                                            "--objective fit as well")
        refused("keys.csv --free nu", BAD_USAGE, "--free: found 'nu' for timed-c2, wanted one of tension, tension2")
        refused("keys.csv --bounds=1,0", BAD_USAGE, "--bounds: found '1,0', wanted LOWEST,HIGHEST, the lower one first")
        self.assertFalse((self.folder / "tuned.csv").exists())

    def test_warns_of_an_inertia_that_no_rigid_body_has(self):
        done = self.run_command("tune keys.csv --objective torque --inertia=1,2,4 --quiet -o tuned.csv")
        self.assertEqual(done.stderr, "orispline: warning: --inertia: one principal moment is greater than the sum of "
                         "the two others, which no rigid body has\n")
        self.assertEqual(done.returncode, 0)


if __name__ == "__main__":
    main()
