# SPDX-License-Identifier: Apache-2.0
"""A real browser without a screen, for tests of what notebooks show."""
import shutil

import pytest

QUIET = ["--disable-background-networking", "--disable-component-update", "--disable-sync", "--disable-quic", "--no-first-run"]
SOFTWARE = ["--disable-gpu", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]


@pytest.fixture(scope="module")
def browser():
    """Chromium, driven by playwright; without either the test is skipped."""
    driver = pytest.importorskip("playwright.sync_api", reason="no playwright, which drives a browser")
    path = next(filter(None, map(shutil.which, ("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome"))), None)
    if not path:
        pytest.skip("no Chromium here")
    with driver.sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=path, args=["--no-sandbox", *QUIET, *SOFTWARE])
        yield chromium
        chromium.close()


@pytest.fixture
def page(browser):
    """A page that has nothing to complain of in the end."""
    opened = browser.new_page(viewport={"width": 1000, "height": 900})
    opened.set_default_timeout(120_000)  # other work may be beside it
    complaints = []
    opened.on("console", lambda message: message.type == "error" and complaints.append(message.text))
    opened.on("pageerror", lambda error: complaints.append(str(error)))
    yield opened
    opened.close()
    assert complaints == []
