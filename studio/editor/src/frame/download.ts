// SPDX-License-Identifier: Apache-2.0
// A file for the folder of downloads.
import { element } from 'orispline-viewer/look/element';

export function download(name: string, text: string): void {
  const url = URL.createObjectURL(new Blob([text], { type: 'text/plain;charset=utf-8' }));
  element('a', { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}
