# SPDX-License-Identifier: Apache-2.0
"""The widget's module in a real browser, with Python behind it as anywidget has it: a state that both change."""
import base64

import numpy as np
import orispline as ori
import pytest
from browser import browser, page  # noqa: F401, which are fixtures

pytest.importorskip("anywidget", reason="no anywidget, which the widget is made with")
from orispline.notebook import Widget  # noqa: E402

T, Q = [0.0, 1.0, 3.0], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]]
# What anywidget gives a module: get, set, save_changes and events; bytes are DataViews.
MODEL = """async ({ module, css, state }) => {
  const value = (x) => x?.base64 === undefined ? x : new DataView(Uint8Array.from(atob(x.base64), (c) => c.charCodeAt(0)).buffer);
  const values = {}, listeners = [];
  let changed = {};
  const take = (state) => {
    const names = Object.keys(state);
    for (const name of names) values[name] = value(state[name]);
    for (const name of names) for (const [event, listener] of [...listeners]) if (event === `change:${name}`) listener();
  };
  take(state);
  const model = {
    get: (name) => values[name],
    set: (name, value) => { values[name] = changed[name] = value; },
    save_changes: async () => { const sent = changed; changed = {}; take(await window.python(sent)); },
    on: (event, listener) => listeners.push([event, listener]),
    off: (event, listener) => listeners.splice(listeners.findIndex(([e, l]) => e === event && l === listener), 1),
  };
  document.head.append(Object.assign(document.createElement('style'), { textContent: css }));
  const url = URL.createObjectURL(new Blob([module], { type: 'text/javascript' }));
  const { default: { render } } = await import(url);
  const end = await render({ model, el: document.body.appendChild(document.createElement('div')) });
  Object.assign(window, { take, end, listeners });
}"""
NAMES = ("document", "rows", "width", "version", "seconds", "edit", "answered", "refusal", "height")


def sent(value):
    return {"base64": base64.b64encode(value).decode()} if isinstance(value, bytes) else value


class Notebook:
    """A widget in a page."""

    def __init__(self, page, widget):
        self.page, self.widget, self.changed = page, widget, {}
        widget.page.observe(lambda change: self.changed.update({change.name: sent(change.new)}), names=NAMES)
        page.set_content("<!doctype html><title>A notebook</title>")
        page.expose_function("python", self.hear)
        state = {name: sent(getattr(widget.page, name)) for name in NAMES}
        page.evaluate(MODEL, {"module": str(widget.page._esm), "css": str(widget.page._css), "state": state})

    def hear(self, state):
        """What the page has changed; answers what Python changes then."""
        self.changed = {}
        for name, value in state.items():
            setattr(self.widget.page, name, value)
        return {name: value for name, value in self.changed.items() if state.get(name) != value}

    def push(self):
        """What Python has changed."""
        changed, self.changed = self.changed, {}
        self.page.evaluate("(state) => take(state)", changed)

    def cell(self, name, key):
        return self.page.get_by_label(f"{name} of key {key}", exact=True)

    def cells(self, name):
        return [float(cell.input_value()) for cell in self.page.get_by_label(f"{name} of key").all()]

    def wait_for(self, state):
        self.page.wait_for_function(state)


@pytest.fixture
def notebook(page):  # noqa: F811
    return Notebook(page, Widget(ori.Keys(T, Q), title="In a page"))


def test_an_edited_key_arrives_in_python_and_its_curve_in_the_page(notebook):
    heard = []
    notebook.widget.observe(lambda change: heard.append(change.new), names="keys")
    assert notebook.page.locator("h1").text_content() == "In a page" and notebook.cells("t") == T
    for name, text in zip(("t", "qw", "qx", "qy", "qz"), ("1.5", "2", "0", "0", "2")):
        notebook.cell(name, 1).fill(text)
        assert not heard, "the numbers of a row go together"
    notebook.cell("qz", 1).press("Enter")
    notebook.wait_for("document.querySelector('[aria-label=\"qw of key 1\"]').value === '0.707107'")
    keys, = heard
    assert keys is notebook.widget.keys and keys.times.tolist() == [0, 1.5, 3] and np.allclose(keys.rotations[1], [0, 0, 0.5**0.5, 0.5**0.5])
    assert np.array_equal(keys.rotations[2], Q[2]), "what was not touched has all its digits"
    assert notebook.page.locator(".orispline-viewer").count() == 1
    notebook.wait_for("document.querySelectorAll('.plots canvas').length > 2")


def test_keys_are_added_at_the_time_shown_and_deleted(notebook):
    notebook.widget.time = 2.0
    notebook.push()
    where = notebook.widget.curve(2.0)
    notebook.page.get_by_role("button", name="Add a key at 2 s").click()
    notebook.cell("t", 3).wait_for()
    assert notebook.widget.keys.times.tolist() == [0, 1, 2, 3] == notebook.cells("t") and np.allclose(notebook.widget.keys.rotations[2], where)
    notebook.page.get_by_role("button", name="Delete key 0").click()
    notebook.cell("t", 3).wait_for(state="detached")
    assert notebook.widget.keys.times.tolist() == [1, 2, 3] == notebook.cells("t")


def test_the_last_key_stays_and_others_come_behind_it(notebook):
    notebook.widget.keys = ori.Keys(T[:1], Q[:1])
    notebook.push()
    assert notebook.cells("t") == [0]
    notebook.page.get_by_role("button", name="Delete key 0").click()
    notebook.page.get_by_role("alert").filter(has_text="found the only key").wait_for()
    notebook.page.get_by_role("button", name="Add a key at 1 s").click()
    notebook.cell("t", 1).wait_for()
    assert notebook.widget.keys.times.tolist() == [0, 1] == notebook.cells("t")


@pytest.mark.parametrize(("name", "text", "told"), [("t", "nan", "key 2"), ("t", "3", "duplicate time 3"), ("qz", "0", "key 1"),
                                                    ("qx", "round", "qx: found 'round', wanted a number")])
def test_a_bad_edit_shows_the_sentence_and_the_last_good_curve(notebook, name, text, told):
    before = notebook.widget.keys
    if name == "qz":
        notebook.cell("qw", 1).fill("0")
    notebook.cell(name, 1).fill(text)
    notebook.cell(name, 0).focus()
    alert = notebook.page.get_by_role("alert")
    alert.filter(has_text=told).wait_for()
    assert notebook.widget.keys is before and notebook.cell(name, 1).input_value() == text
    notebook.cell("qw", 1).fill("1")
    notebook.cell("t", 1).fill("0.5")
    notebook.cell("qx", 1).fill("0")
    notebook.cell("qx", 1).press("Enter")
    notebook.wait_for("document.querySelector('[role=alert]').textContent === ''")
    assert notebook.widget.keys.times.tolist() == [0, 0.5, 3]


def test_the_time_goes_both_ways(notebook):
    slider = notebook.page.locator("input[type=range]")
    slider.evaluate("(input) => { input.value = '1.5'; input.dispatchEvent(new Event('input')); }")
    notebook.page.wait_for_timeout(300)  # longer than the pause between two times
    assert notebook.widget.time == pytest.approx(1.5, abs=0.02)
    notebook.widget.time = 2.5
    notebook.push()
    assert float(slider.input_value()) == pytest.approx(2.5, abs=0.01)


def test_what_python_sets_is_shown_and_the_choices_stay(notebook):
    notebook.page.locator("select").first.select_option(index=1)
    notebook.widget.time = 2.0
    notebook.push()
    notebook.widget.keys = ori.Keys([0, 1, 2, 4], [*Q, Q[0]], positions=np.eye(4)[:, :3])
    notebook.push()
    assert notebook.cells("px") == [1, 0, 0, 0] and float(notebook.page.locator("input[type=range]").input_value()) == pytest.approx(2, abs=0.01)
    assert notebook.page.locator(".orispline-viewer").count() == 1


def test_it_is_light_or_dark_as_the_notebook_is(notebook):
    for is_light, theme in (("false", "dark"), ("true", "light")):
        notebook.page.evaluate("(value) => { document.body.dataset.jpThemeLight = value; }", is_light)
        notebook.wait_for(f"document.querySelector('.orispline-widget').dataset.theme === '{theme}'")
        assert notebook.page.locator(".orispline-viewer").get_attribute("data-theme") == theme


def test_many_edits_leave_nothing_behind(notebook):
    told = []
    notebook.page.on("console", lambda message: told.append(message.text))
    for i in range(25):
        notebook.widget.keys = ori.Keys([0, 1 + i / 100, 3], Q)
        notebook.push()
    assert notebook.page.locator(".orispline-viewer").count() == 1 and notebook.page.locator("canvas").count() < 20
    assert not [text for text in told if "context" in text.lower()]
    notebook.page.evaluate("end()")
    assert notebook.page.evaluate("listeners.length") == 0 and notebook.page.locator(".orispline-viewer").count() == 0


def test_of_very_many_keys_those_near_the_time_are_in_the_table(page):  # noqa: F811
    count = 1000
    angles = np.linspace(0, 30, count)
    keys = ori.Keys(np.arange(count), np.stack([0 * angles, 0 * angles, np.sin(angles / 2), np.cos(angles / 2)], axis=1))
    notebook = Notebook(page, Widget(keys))
    assert page.get_by_text("Of 1000 keys 200 near the time are shown.").count() == 1 and notebook.cells("t")[:2] == [0, 1]
    notebook.widget.time = 500.0
    notebook.push()
    assert 500.0 in notebook.cells("t") and len(notebook.cells("t")) == 200
