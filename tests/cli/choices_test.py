#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Methods that are shaped by words: choices with `--set`, end rules with `--ends`."""
import math

from command import BAD_USAGE, CommandTest, main

WINDING_KEYS = "t,qw,qx,qy,qz\n" + "".join(  # a turn about x, then one about the body's y, at uneven times
    f"{t},{math.cos(a) * math.cos(b)},{math.sin(a) * math.cos(b)},{math.cos(a) * math.sin(b)},"
    f"{math.sin(a) * math.sin(b)}\n"
    for t, a, b in ((0, 0, 0), (1, 0.3, 0.1), (1.5, 0.2, 0.5), (3, 0.6, 0.4), (3.7, 0.1, 0.9), (5, 0.4, 0.2)))


REFUSED = (
    ("sample keys.csv --rate 1 --method squad-timed --set variant=eberly",
     "squad-timed: variant is 'eberly', wanted one of geier, boyle"),
    ("sample none.csv --rate 1 --method squad-timed --set variant=geier,boyle",
     "squad-timed: variant is 'geier,boyle', wanted one of geier, boyle"),
    ("sample keys.csv --rate 1 --method squad-timed --set variant=boyle --set variant=geier",
     "--set variant: 'variant' is given twice, wanted it once"),
    ("sample keys.csv --rate 1 --method hermite-c2 --set stencil=4",
     "hermite-c2: stencil is '4', wanted one of 5, 3"),
    ("sample keys.csv --rate 1 --method tcb --set tension=handle",
     "--set tension: found 'handle', wanted numbers with commas between them"),
)


class Choices(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("keys.csv", WINDING_KEYS)

    def test_a_choice_takes_its_words_and_the_first_is_the_default(self):
        for method, name, default, other in (("squad-timed", "variant", "geier", "boyle"),
                                             ("hermite-c2", "stencil", "5", "3"),
                                             ("hermite-c2", "form", "chart", "cumulative"),
                                             ("bspline-through", "phantom", "reflect", "equal"),
                                             ("shoemake", "timing", "time", "published")):
            with self.subTest(f"{method} {name}"):
                plain = self.output_of(f"sample keys.csv --rate 10 --method {method}")
                first, second = (self.output_of(f"sample keys.csv --rate 10 --method {method} --set {name}={word}")
                                 for word in (default, other))
                self.assertEqual(first, plain)
                self.assertNotEqual(second, plain)

    def test_words_and_numbers_may_stand_together(self):
        both = self.output_of("sample keys.csv --rate 10 --method beta-g2 --set form=global --set beta2=1")
        for part in ("--set form=global", "--set beta2=1"):
            self.assertNotEqual(both, self.output_of(f"sample keys.csv --rate 10 --method beta-g2 {part}"))

    def test_ends_take_every_rule_by_its_name(self):
        for method, rule in (("tcb", "handle"), ("rotation-spline", "secant"), ("rotation-spline", "natural")):
            with self.subTest(f"{method} {rule}"):
                curves = {ends: self.output_of(f"sample keys.csv --rate 10 --method {method} --ends {ends}")
                          for ends in (rule, f"{rule},{rule}")}
                self.assertEqual(*curves.values())
        self.assertNotEqual(self.output_of("sample keys.csv --rate 10 --method tcb --ends handle"),
                            self.output_of("sample keys.csv --rate 10 --method tcb"))
        self.assertEqual(self.output_of("sample keys.csv --rate 10 --method rotation-spline --ends secant"),
                         self.output_of("sample keys.csv --rate 10 --method rotation-spline"))

    def test_a_word_that_is_no_choice_of_the_method_is_refused(self):
        for arguments, message in REFUSED:
            with self.subTest(arguments):
                self.assert_fails(arguments, BAD_USAGE, message)


if __name__ == "__main__":
    main()
