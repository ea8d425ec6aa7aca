# SPDX-License-Identifier: Apache-2.0
"""Pages in notebooks: what a frame holds, and the notebook of the examples."""
import copy
import html.parser
import pickle
import re

import numpy as np
import orispline as ori
import pytest
from conftest import ROOT
from scipy.spatial.transform import Rotation

CURVE = ori.Curve([0.0, 1.0, 3.0], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]])
TIMES = np.linspace(0, 4, 81)
RECORDING = ori.Keys(TIMES, Rotation.from_rotvec(np.outer(np.sin(TIMES), [0, 0, 1]) + np.random.default_rng(1).normal(0, 0.01, (81, 3))))
BVH = """HIERARCHY
ROOT head
{
OFFSET 0 1.5 0
CHANNELS 3 Zrotation Xrotation Yrotation
End Site
{
OFFSET 0 0.2 0
}
}
MOTION
Frames: 5
Frame Time: 0.25
0 0 0
0 10 0
0 20 0
0 10 0
0 0 0
"""


class Frame(html.parser.HTMLParser):
    """The only element of a text, a frame."""

    def __init__(self, text):
        super().__init__()
        self.elements = []
        self.feed(text)
        (self.name, attributes), = self.elements
        self.attributes = dict(attributes)

    def handle_starttag(self, tag, attrs):
        self.elements.append((tag, attrs))


def undated(page):
    return re.sub(r"\d{4}-\d\d-\d\d \d\d:\d\d", "", page)


def scene(tmp_path):
    (tmp_path / "nod.bvh").write_text(BVH, "utf-8")
    return ori.read_scene(tmp_path / "nod.bvh")


def reduced_scene(tmp_path):
    return ori.reduce_scene(scene(tmp_path), "1deg")[1]


def smoothed_scene(tmp_path):
    return ori.smooth_scene(scene(tmp_path))[1]


RESULTS = {"curve": lambda _: CURVE, "comparison": lambda _: ori.compare(RECORDING, ["slerp", "auto"]),
           "smoothing": lambda _: ori.smooth(RECORDING), "reduction": lambda _: ori.reduce(RECORDING, "2deg"),
           "retiming": lambda _: ori.retime(CURVE.keys, max_rate=1), "skeleton": reduced_scene, "scene": scene, "clip": lambda folder: scene(folder).clips[0], "smoothed scene": smoothed_scene}


@pytest.mark.parametrize("name", RESULTS)
def test_a_view_is_the_report_in_a_frame(name, tmp_path):
    result = RESULTS[name](tmp_path)
    result.report(tmp_path / "report.html")
    view = result.view(height=480)
    page = (tmp_path / "report.html").read_text("utf-8")
    assert page.startswith("<!doctype html>") and undated(view.html) == undated(page)
    frame = Frame(view._repr_html_())
    assert frame.name == "iframe" and frame.attributes["srcdoc"] == view.html and frame.attributes["sandbox"] == "allow-scripts"
    assert frame.attributes["title"] and "height: 480px" in frame.attributes["style"]
    view.write(tmp_path / "view.html")
    assert (tmp_path / "view.html").read_text("utf-8") == view.html
    assert re.fullmatch(r"View\(\d\.\d MB, 480 px high\)", repr(view))


def test_a_view_takes_what_the_report_of_a_curve_takes():
    title = "A \"title\" with 'markup' & <b>more</b>"
    page = Frame(CURVE.view(title=title, inertia=[1, 2, 2.5])._repr_html_()).attributes["srcdoc"]
    assert "\"title\":" in page.replace(" ", "") and "peak_torque_n_m" in page and "<b>more" not in page.partition("report-data")[2]


def test_a_curve_still_shows_its_small_drawing():
    assert not hasattr(CURVE, "_repr_html_") and CURVE._repr_svg_().startswith("<svg")


@pytest.mark.parametrize("look", [lambda height: CURVE.view(height=height), lambda height: ori.smooth(RECORDING).view(height=height)])
@pytest.mark.parametrize(("height", "error", "told"), [
    (99, ori.ArgumentError, "height: found 99, wanted a whole number from 100 to 10000"),
    (10**6, ori.ArgumentError, "height: found 1000000, wanted"), ("tall", TypeError, "height: found 'tall' of type str, wanted a whole number"),
    (480.5, TypeError, "height: found 480.5"), (None, TypeError, "height: found None"), (True, TypeError, "height: found True")])
def test_heights_that_are_none(look, height, error, told):
    with pytest.raises(error) as found:
        look(height)
    assert told in str(found.value)


def test_a_view_is_not_made_by_hand_and_says_where_it_cannot_be_written(tmp_path):
    with pytest.raises(TypeError, match="found a call of View, wanted one of view"):
        ori.View()
    with pytest.raises(ori.AccessError, match="none"):
        CURVE.view().write(tmp_path / "none" / "page.html")


def test_what_was_done_to_a_scene_and_was_copied_has_all_but_its_page(tmp_path):
    for of, what, task in [(reduced_scene, "reduction", "reduce_scene"), (smoothed_scene, "smoothing", "smooth_scene")]:
        found = of(tmp_path)
        for again in (pickle.loads(pickle.dumps(found)), copy.deepcopy(found)):
            assert again == found and again.as_dict() == found.as_dict()
            with pytest.raises(ori.ArgumentError, match=f"found a {what} that was copied or pickled, wanted the one that {task} gave"):
                again.view()


def test_the_notebook_of_the_examples_shows_the_viewer():
    """It is kept without outputs, which are megabytes."""
    nbclient, nbformat = (pytest.importorskip(name, reason=f"no {name}, which runs notebooks") for name in ("nbclient", "nbformat"))
    pytest.importorskip("ipykernel", reason="no ipykernel, which notebooks run in")
    path = ROOT / "examples/notebook.ipynb"
    notebook = nbformat.read(path, as_version=4)
    nbformat.validate(notebook)
    cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert all(not cell.outputs and cell.execution_count is None for cell in cells) and path.stat().st_size < 10_000
    nbclient.NotebookClient(notebook, timeout=600, resources={"metadata": {"path": str(path.parent)}}).execute()
    shown = {cell.source.splitlines()[-1]: output.data for cell in cells for output in cell.outputs if output.output_type == "execute_result"}
    assert "image/svg+xml" in shown["curve"]
    for view in ("curve.view()", "comparison.view(height=800)"):
        page = Frame(shown[view]["text/html"]).attributes["srcdoc"]
        assert "report-data" in page and page.rstrip().endswith("</html>")
