// SPDX-License-Identifier: Apache-2.0

type Given = number | ArrayLike<number>;

/** Whether numbers, or lists of them, have the same bits. */
export function areSame(a: Given, b: Given): boolean {
  if (typeof a === 'number' || typeof b === 'number') return Object.is(a, b);
  if (a.length !== b.length) return false;
  for (let k = 0; k < a.length; ++k) if (!Object.is(a[k], b[k])) return false;
  return true;
}

/** The same function, which gives its last result again while it is given the same. */
export function remembering<Values extends Given[], Made>(make: (...given: Values) => Made): (...given: Values) => Made {
  let last: { given: Values; made: Made } | null = null;
  return (...given) => {
    if (!last?.given.every((value, k) => areSame(value, given[k]))) last = { given, made: make(...given) };
    return last!.made;
  };
}
