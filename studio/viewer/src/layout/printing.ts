// SPDX-License-Identifier: Apache-2.0
// Paper is light.
import type { Store } from '../store/store';

export function printLight(store: Store): void {
  const { choose, current } = store;
  let before = current().theme;
  store.listen(window, 'beforeprint', () => {
    before = current().theme;
    choose({ theme: 'light' });
  });
  store.listen(window, 'afterprint', () => choose({ theme: before }));
}
