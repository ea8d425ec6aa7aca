#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""check_studio.py finds each kind of breach in a small studio that is sound otherwise."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "tools" / "check_studio.py"
SPDX = "// SPDX-License-Identifier: Apache-2.0\n"
SOUND = {
    "viewer/src/data/report.ts": SPDX,
    "viewer/src/motion/orientation.ts": SPDX + "import type { Path } from '../data/report';\n",
    "viewer/src/store/store.ts": SPDX + "import {\n  a,\n  b,\n} from '../motion/orientation';\n",
    "viewer/src/scene/stage.ts": SPDX + "import { Scene } from 'three';\nimport { C } from 'three/addons/c.js';\nimport { Store } from '../store/store';\n",
    "viewer/src/scene/skeleton/bones.ts": SPDX + "import { Stage } from '../stage';\n",
    "viewer/src/plots/plot.ts": SPDX + "import uPlot from 'uplot';\nimport 'uplot/dist/uPlot.min.css';\n",
    "viewer/src/style/ground.css": SPDX.replace("// ", "/* ").replace("\n", " */\n"),
    "viewer/src/viewer.ts": SPDX + "import './style/ground.css';\nimport { Stage } from './scene/stage';\nexport { type Path } from './data/report';\n",
    "report/src/main.ts": SPDX + "import { createViewer } from 'orispline-viewer';\nimport './page.css';\n",
    "report/src/page.css": SPDX.replace("// ", "/* ").replace("\n", " */\n"),
    "report/tests/page.test.mjs": SPDX + "import { chromium } from 'playwright-core';\n",
    "report/dist/assets/main.js": "built",
    "node_modules/three/three.js": "import 'elsewhere';\n",
}


def report(**changes):
    """What the script says about the sound studio with some files replaced or added; exit code 0 gives None."""
    with tempfile.TemporaryDirectory() as tree:
        for path, text in (SOUND | changes).items():
            file = pathlib.Path(tree, "studio", path)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, "utf-8")
        run = subprocess.run([sys.executable, SCRIPT, tree], capture_output=True, text=True, check=False)
        return run.stderr if run.returncode else None


class CheckStudio(unittest.TestCase):
    def assert_breach(self, path, text, message):
        self.assertIn(message, report(**{path: text}) or "no breach")

    def test_accepts_a_sound_studio(self):
        self.assertIsNone(report())

    def test_finds_an_import_upwards(self):
        for kind in ("import { S } from", "import type { S } from", "import", "export { S } from", "export * from"):
            self.assert_breach("viewer/src/data/report.ts", SPDX + f"{kind} '../store/store';\n", "data/report.ts: layer data must not import ../store/store")
        self.assert_breach("viewer/src/data/report.ts", SPDX + "const later = import('../store/store');\n", "layer data must not import")

    def test_accepts_the_text_of_an_example_and_nothing_else_from_outside(self):
        self.assertIsNone(report(**{"viewer/src/data/report.ts": SPDX + "import keys from '../../../../examples/data/keys.csv?raw';\n"}))
        for outside in ("../../../../examples/data/keys.csv", "../../../../tools/keys.csv?raw"):
            self.assert_breach("viewer/src/data/report.ts", SPDX + f"import keys from '{outside}';\n", "wanted a package by its name")

    def test_finds_an_import_of_a_neighbour(self):
        self.assert_breach("viewer/src/plots/plot.ts", SPDX + "import { Stage } from '../scene/stage';\n", "layer plots must not import ../scene/stage")

    def test_finds_an_import_of_a_file_beside_the_layers(self):
        self.assert_breach("viewer/src/plots/plot.ts", SPDX + "import { createViewer } from '../viewer';\n", "layer plots must not import ../viewer")

    def test_finds_a_folder_that_is_no_layer(self):
        self.assert_breach("viewer/src/unknown/box.ts", SPDX + "import { Path } from '../data/report';\n", "layer unknown must not import")

    def test_finds_third_party_code_in_the_wrong_place(self):
        self.assert_breach("viewer/src/plots/plot.ts", SPDX + "import { Scene } from 'three';\n", "plots/plot.ts: three is for viewer/src/scene/ and editor/src/scene/ only")
        self.assert_breach("viewer/src/scene/stage.ts", SPDX + "import uPlot from 'uplot';\n", "scene/stage.ts: uplot is for viewer/src/plots/ only")
        self.assert_breach("report/src/main.ts", SPDX + "import { Scene } from 'three/addons/c.js';\n", "three is for viewer/src/scene/ and editor/src/scene/ only")

    def test_finds_third_party_code_that_a_package_must_not_have(self):
        self.assert_breach("viewer/src/plots/plot.ts", SPDX + "import * as d3 from 'd3';\n", "plots/plot.ts: viewer must not import d3")

    def test_finds_a_viewer_that_knows_its_page(self):
        self.assert_breach("viewer/src/viewer.ts", SPDX + "import { data } from 'orispline-report';\n", "viewer must not import orispline-report")

    def test_finds_a_way_around_the_name_of_a_package(self):
        self.assert_breach("report/src/main.ts", SPDX + "import { Store } from '../../viewer/src/store/store';\n", "wanted a package by its name")

    def test_finds_a_circle_in_one_layer(self):
        circle = {"viewer/src/data/a.ts": SPDX + "import { b } from './b';\n", "viewer/src/data/b.ts": SPDX + "import { a } from './a';\n"}
        self.assertIn("import circle: viewer/src/data/", report(**circle) or "no breach")

    def test_finds_a_file_of_601_lines(self):
        self.assertIsNone(report(**{"report/tests/page.test.mjs": SPDX + "a;\n" * 599}))
        self.assert_breach("report/tests/page.test.mjs", SPDX + "a;\n" * 600, "page.test.mjs: 601 lines, at most 600")

    def test_finds_a_missing_licence_line(self):
        self.assert_breach("report/src/page.css", "body {}\n", "page.css: the first line is not the SPDX line")


if __name__ == "__main__":
    unittest.main()
