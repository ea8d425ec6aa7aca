// SPDX-License-Identifier: Apache-2.0
// Random edits in the page, by what is on its screen: keys of the keyboard, fields, sliders, menus and buttons.

/** Runs in the page: so many edits, of which some are refused or taken back; tells how many were tried of each kind. */
export async function walk({ seed, edits }) {
  const { store, methods } = globalThis.studio.current.studio;
  const root = document.querySelector('.orispline-studio');
  let state = seed;
  const random = () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
  const pick = (list) => list[Math.floor(random() * list.length)];
  const between = (low, high) => low + random() * (high - low);

  const seen = (selector, place = root) => [...place.querySelectorAll(selector)].filter((one) => !one.closest('[hidden]'));
  const press = (target, key, more) => target.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true, ...more }));
  const pressed = (selector, keys) => {
    const targets = seen(selector);
    if (targets.length > 0) press(pick(targets), pick(keys), pick([{}, {}, { shiftKey: true }, { ctrlKey: true }]));
  };
  const tell = (target, ...types) => types.forEach((type) => target.dispatchEvent(new Event(type, { bubbles: true })));
  const write = (target, text) => {
    target.value = text;
    tell(target, 'input', 'change');
  };
  const select = (target) => write(target, pick([...target.options]).value);
  const group = (name) => root.querySelector(`[role=group][aria-label="${name}"]`);
  const button = (name) => seen('button').find((one) => (one.getAttribute('aria-label') ?? one.textContent) === name);
  const typed = (place, low, high) => {
    const fields = seen('input.number', place);
    if (fields.length === 0) return;
    const digits = pick([1, 3, 17]);
    write(pick(fields), random() < 0.05 ? pick(['1/0', 'abc', '', '1e999', '−0']) : String(Number(between(low, high).toPrecision(digits))));
  };
  const settings = (letter) => root.querySelector(`[role=dialog][aria-label="Settings of ${letter}"]`);
  const arrows = ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown', 'PageUp', 'PageDown'];

  const acts = {
    choose: () => store.choose(pick(store.current().document.keys).id),
    retime: () => pressed('.dot.is-chosen', ['ArrowLeft', 'ArrowRight']),
    turn: () => pressed('.scene canvas', arrows),
    pull: () => pressed('.bar', ['ArrowUp', 'ArrowDown', 'PageUp']),
    pullAll: () => seen('.all-keys input').forEach((slider) => write(slider, String(between(Number(slider.min), Number(slider.max))))),
    turnAs: () => select(group('Key').querySelector('select')),
    typeTurn: () => typed(group('Key').querySelector('.fields'), -2, 2),
    typeAny: () => typed(group('Key'), 0, 6),
    insert: async () => {
      globalThis.studio.current.studio.view.moveTo(between(store.current().document.keys[0].t, store.current().document.keys.at(-1).t));
      const { document } = store.current();
      button('Insert key').click();
      for (let turns = 0; turns < 200 && store.current().document === document && !root.querySelector('.notice'); ++turns) await new Promise((resolve) => setTimeout(resolve));
    },
    duplicate: () => button('Duplicate key').click(),
    remove: () => button('Delete key').click(),
    removeByKey: () => press(document.body, 'Delete'),
    method: () => write(root.querySelector(`select[aria-label="${pick(['Curve', 'Compare with'])}"]`), pick(methods).name),
    typeSetting: () => typed(settings(pick(['Curve', 'Compare with'])), 0, 1.5),
    setting: () => {
      const menus = seen('select', settings(pick(['Curve', 'Compare with'])));
      if (menus.length > 0) select(pick(menus));
    },
    close: () => {
      const box = seen('[type=checkbox]', settings(pick(['Curve', 'Compare with'])))[0];
      if (!box) return;
      box.checked = random() < 0.3;
      tell(box, 'change');
    },
    undo: () => press(document.body, 'z', { ctrlKey: true }),
    redo: () => press(document.body, pick(['y', 'y', 'Z']), { ctrlKey: true }),
  };
  const often = { typeTurn: 4, typeAny: 4, retime: 4, turn: 3, pull: 3, method: 0.3, setting: 0.5, typeSetting: 1, close: 0.3, insert: 0.7, remove: 0.4, removeByKey: 0.4, duplicate: 0.7, turnAs: 0.5, undo: 1.5 };
  const names = Object.keys(acts).flatMap((name) => Array(Math.round(10 * (often[name] ?? 1))).fill(name));
  const tried = {};
  for (let edit = 0; edit < edits; ++edit) {
    const name = pick(names);
    tried[name] = (tried[name] ?? 0) + 1;
    await acts[name]();
    for (const notice of root.querySelectorAll('.notice')) notice.remove();
  }
  return tried;
}
