# SPDX-License-Identifier: Apache-2.0
"""The papers' experiments, for their tests."""
import json

from command import CommandTest

PARTS = ["000-figure1", "000-figure2", "000-figure3", "000-figure4", "000-table1", "000-identities", "000-theorem1",
         "000-claims", "001-example1", "001-example2", "001-local", "001-shapes", "002-identities", "002-example",
         "003-table1", "003-figure7", "003-identities", "003-theorem1", "003-claims"]
TAKING_REFERENCE = ["001-shapes", "003-table1", "003-claims"]
TAKING_KEYS = ["000-figure2", "000-figure3", "000-figure4", "000-table1", "000-theorem1", "000-claims", "001-example1",
               "001-example2", "001-local", "001-shapes", "003-table1", "003-figure7", "003-theorem1", "003-claims"]
AUTHORS = {"000": "tan", "001": "he", "002": "eberly", "003": "sextic"}


class Reproduced(CommandTest):
    def tables_of(self, experiment):
        """The tables of one experiment; a row is a dictionary by column."""
        [report] = json.loads(self.output_of(f"reproduce {experiment} --json"))
        for table in report["tables"]:
            table["rows"] = [dict(zip(table["columns"], row)) for row in table["rows"]]
        return report["tables"]

    def assert_identities(self, experiment, misprints, rounding=1e-12):
        """All hold but the misprints, each of which is wrong and has a right form."""
        identities, wrong = self.tables_of(experiment)
        for row in identities["rows"]:
            self.assertLess(row["largest error"], rounding, row["statement"])
        self.assertEqual(len(wrong["rows"]), misprints)
        for row in wrong["rows"]:
            self.assertGreater(row["error"], 0.01, row["printed"])
            self.assertLess(row["its error"], rounding, row["right"])

    def rows_of(self, experiment, table=0):
        return self.tables_of(experiment)[table]["rows"]
