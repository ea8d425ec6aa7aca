# SPDX-License-Identifier: Apache-2.0
"""Views as a notebook shows them, in a real browser."""
import numpy as np
import orispline as ori
from browser import browser, page  # noqa: F401, which are fixtures
from scipy.spatial.transform import Rotation

TIMES = np.linspace(0, 4, 81)
RECORDING = ori.Keys(TIMES, Rotation.from_rotvec(np.outer(np.sin(TIMES), [0, 0, 1])))


def test_a_page_in_a_frame_has_its_table_plots_and_scenes(page):  # noqa: F811
    requests = []
    page.on("request", lambda request: requests.append(request.url))
    comparison = ori.compare(RECORDING, ["auto", "slerp"], keep_every=10)
    page.set_content(f"<!doctype html><title>A notebook</title>{comparison.view(height=700)._repr_html_()}")
    frame = page.frame_locator("iframe")
    frame.locator(".plots canvas").nth(2).wait_for()  # they are drawn when there is time
    assert frame.locator("tbody th").all_text_contents() == [row["method"] for row in comparison.table()]
    assert page.locator("iframe").bounding_box()["height"] == 700
    assert frame.locator("canvas").count() >= 6
    assert page.frames[1].evaluate("try { parent.document.title } catch (error) { error.name }") == "SecurityError"
    assert [url for url in requests if not url.startswith("about:")] == []


def test_two_views_stand_beside_each_other(page):  # noqa: F811
    curves = [RECORDING.curve(method) for method in ("auto", "slerp")]
    page.set_content("<!doctype html>" + "".join(curve.view(title=curve.method)._repr_html_() for curve in curves))
    for number, curve in enumerate(curves):
        frame = page.frame_locator("iframe").nth(number)
        frame.locator(".plots canvas").first.wait_for()
        assert frame.locator("h1").text_content() == curve.method
