// SPDX-License-Identifier: Apache-2.0
// What the browser remembers of whoever uses the page; nothing where it keeps nothing for it.

const prefix = 'orispline-studio-';

export type Habit = 'more' | 'toured';

/** null: the browser does not tell. */
export function has(habit: Habit): boolean | null {
  try {
    return localStorage.getItem(prefix + habit) !== null;
  } catch {
    return null;
  }
}

export function keep(habit: Habit, is: boolean): void {
  try {
    if (is) localStorage.setItem(prefix + habit, '1');
    else localStorage.removeItem(prefix + habit);
  } catch {
    // It is so for as long as the page is open.
  }
}
