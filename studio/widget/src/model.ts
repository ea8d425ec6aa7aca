// SPDX-License-Identifier: Apache-2.0
// What the page shares with Python: the traits of the class Page in bindings/python/orispline/notebook.

/** An edit of the keys, with what was typed. Python answers to its number. */
export type Edit = { kind: 'set'; key: number; t: string; q: string[]; p: string[] } | { kind: 'add'; t: number } | { kind: 'delete'; key: number };

export interface Shared {
  document: DataView;
  rows: DataView; // float64: of each key t, qw, qx, qy, qz, and px, py, pz where they have positions
  width: number; // numbers in a row
  seconds: number;
  version: number; // of these rows
  edit: Partial<{ number: number }>;
  answered: number;
  refusal: string; // of that edit; empty: it was taken
  height: number; // [px]
}

/** As anywidget gives it. */
export interface Model {
  get: <Name extends keyof Shared>(name: Name) => Shared[Name];
  set: <Name extends keyof Shared>(name: Name, value: Shared[Name]) => void;
  save_changes: () => void;
  on: (event: `change:${keyof Shared}`, listener: () => void) => void;
  off: (event: `change:${keyof Shared}`, listener: () => void) => void;
}

/** The keys, row by row. */
export function keyRows(model: Model): number[][] {
  const { buffer, byteOffset, byteLength } = model.get('rows');
  const numbers = new Float64Array(buffer.slice(byteOffset, byteOffset + byteLength));
  const width = model.get('width');
  return Array.from({ length: numbers.length / width }, (_, i) => [...numbers.subarray(i * width, (i + 1) * width)]);
}

/** With its number, and what it is an edit of. */
export function send(model: Model, edit: Edit): void {
  const numbers = { number: (model.get('edit').number ?? 0) + 1, version: model.get('version') };
  model.set('edit', { ...edit, ...numbers });
  model.save_changes();
}
