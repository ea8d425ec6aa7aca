#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The blocks of JavaScript in the pages run in Node, on the npm package as who installs it has it.

scripts_test.py PACKED, the packed file of the package. ORISPLINE_NPM_TOOLS is a folder of packages with esbuild and three.js.
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from lines import run, shell_of
from pages import ROOT, all_blocks, blocks

sys.path.insert(0, str(ROOT / "tests/cli"))
from command import COMMAND  # noqa: E402

NPM = ROOT / "tests/npm"
TOOLS = pathlib.Path(os.environ["ORISPLINE_NPM_TOOLS"])

OBJECT = "import { Object3D } from 'three';\nconst object = new Object3D();\n"
KEYS = "const times = [0, 1, 2.5], orientations = [0, 0, 0, 1, 0, 0, 0.6, 0.8, 0.6, 0, 0, 0.8];\n"
CURVE = "import { load as loadOf } from 'orispline/lite';\n" + KEYS + "const curve = (await loadOf()).curve('auto', { times, orientations, order: 'xyzw' });\n"
READ = ("import { readFile } from 'node:fs/promises';\nimport { load } from 'orispline/full';\nconst ori = await load();\n"
        "const recording = ori.read(await readFile('keys.csv'), 'keys.csv');\n")
TURNING = ("import { readFile } from 'node:fs/promises';\nimport { load } from 'orispline/full';\nconst ori = await load();\n"
           "const at = Array.from({ length: 100 }, (_, k) => 0.05 * k), half = at.map((t, k) => 0.5 - 0.5 * Math.cos(t) + 0.002 * Math.sin(k * k));\n"
           "const recording = { times: at, orientations: half.flatMap((a) => [0, 0, Math.sin(a), Math.cos(a)]), order: 'xyzw' };\n")
CLIP = ("import { AnimationClip, Object3D, VectorKeyframeTrack } from 'three';\n" + KEYS +
        "const object = new Object3D(), clip = new AnimationClip('', -1, [new QuaternionKeyframeTrack('.quaternion', times, orientations)]);\n")
# What each block takes as the reader's own; of engines that are not here, what it calls of them.
GIVEN = {
    "README.md": [OBJECT],
    "bindings/npm/README.md": ["", "", ""],
    "docs/web.md": [
        "",
        OBJECT + "const scene = 0, camera = 0, renderer = { setAnimationLoop: (draw) => draw(20), render: () => 0 };\n",
        "",
        "import { openAsBlob } from 'node:fs';\nconst file = new File([await openAsBlob('keys.csv')], 'keys.csv');\n",
        TURNING + "const walkFile = new File([await readFile('walk.bvh')], 'walk.bvh');\n",
        READ + "const shared = new SharedArrayBuffer(4), postMessage = () => 0;\n",
        "",
        CLIP,
        CURVE + "const mesh = {}, engine = { getDeltaTime: () => 20 }, scene = { onBeforeRenderObservable: { add: (draw) => draw() } };\n"
                "const BABYLON = { Quaternion: { Identity: () => ({ set: (x, y, z, w) => 0 }) } };\n",
        CURVE + "const entity = { setLocalRotation: (x, y, z, w) => 0 }, app = { on: (event, update) => update(0.02) };\n",
        CURVE + "const viewer = { clock: { startTime: 0 } }, entity = {}, Cesium = { JulianDate: { secondsDifference: (a, b) => a - b },\n"
                "  Quaternion: { unpack: (array, start, result) => Object.assign(result, array) }, CallbackProperty: class { constructor(at) { at(1, {}); } } };\n",
        OBJECT + CURVE + "const sheet = { sequence: { pointer: { position: 1 } } };\n"],
}
BUNDLED = {"docs/web.md": [7]}  # by number, whose comment says how esbuild takes them


class Scripts(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        subprocess.run(["npm", "install", "--offline", "--no-audit", "--no-fund", "--silent", pathlib.Path(sys.argv[1]).resolve()], cwd=cls.folder, check=True)
        (cls.folder / "node_modules/three").symlink_to(TOOLS / "three")
        theatre = cls.folder / "node_modules/@theatre/core"
        theatre.mkdir(parents=True)
        (theatre / "package.json").write_text('{ "type": "module", "exports": "./index.js" }', "utf-8")
        (theatre / "index.js").write_text("export const onChange = (position, hear) => hear(position);\n", "utf-8")
        (cls.folder / "keys.csv").write_bytes((ROOT / "examples/data/five_keys.csv").read_bytes())
        (cls.folder / "walk.bvh").write_bytes((ROOT / "examples/data/walking.bvh").read_bytes())
        (cls.folder / "bin").mkdir()
        (cls.folder / "bin/orispline").symlink_to(COMMAND)
        baked = [line for line in shell_of("bindings/npm/README.md") if line.text.startswith("orispline ")]
        run([*baked, baked[0]._replace(text=baked[0].text.replace(".json", ".bin"))], cls.folder, cls.folder / "bin")

    def assert_runs(self, words, folder):
        done = subprocess.run(words, cwd=folder, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_every_block_runs(self):
        self.assertEqual({block.page for block in all_blocks() if block.kind == "js"}, set(GIVEN))
        for page, given in GIVEN.items():
            found = [block for block in blocks(page) if block.kind == "js"]
            self.assertEqual(len(found), len(given), page)
            for number, (block, own) in enumerate(zip(found, given), 1):
                with self.subTest(block.place):
                    (self.folder / "block.mjs").write_text(own + block.text, "utf-8")
                    program = self.bundled() if number in BUNDLED.get(page, []) else self.folder / "block.mjs"
                    self.assert_runs(["node", "--import", NPM / "fetch_files.mjs", program], program.parent)

    def bundled(self):
        self.assert_runs([TOOLS / "esbuild/bin/esbuild", "block.mjs", "--bundle", "--format=esm", "--platform=neutral", "--loader:.wasm=file",
                          "--external:node:*", "--out-extension:.js=.mjs", "--outdir=out", "--log-level=warning"], self.folder)
        return self.folder / "out/block.mjs"

    def test_the_package_has_the_readme_that_is_tested(self):
        installed = (self.folder / "node_modules/orispline/README.md").read_text("utf-8")
        self.assertEqual(installed, (ROOT / "bindings/npm/README.md").read_text("utf-8"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
