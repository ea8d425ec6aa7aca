// SPDX-License-Identifier: Apache-2.0
// What a user opens: bytes with a name, from wherever they come.
import { element } from 'orispline-viewer/look/element';
import type { Reading } from '../document/reading';
import type { Looks } from '../document/templates';
import type { Engine, Opened, TooMany } from '../engine/protocol';
import { Reducing } from './reducing';

/** As browsers have it that give access to files of the disk. */
export interface FileHandle {
  readonly name: string;
  getFile: () => Promise<Blob>;
  isSameEntry?: (other: FileHandle) => Promise<boolean>;
  createWritable: () => Promise<{ write: (text: string | Uint8Array) => Promise<void>; close: () => Promise<void> }>;
}

export interface Given {
  bytes: Uint8Array;
  name: string;
  method?: string; // its text
  beside?: string;
  reading?: Reading; // what the user has said of it
  hash?: string; // of the file on the disk, where the bytes are what was made of it here
  looks?: Looks; // else those of a body that nothing is known of
  handle?: FileHandle; // where it can be written again
}

type Picker = (options: object) => Promise<FileHandle[]>;
const picker = () => (window as unknown as { showOpenFilePicker?: Picker }).showOpenFilePicker?.bind(window);

export const bytesOf = async (blob: Blob): Promise<Uint8Array> => new Uint8Array(await blob.arrayBuffer());

async function fromHandle(handle: FileHandle): Promise<Given> {
  return { bytes: await bytesOf(await handle.getFile()), name: handle.name, handle };
}

/** With an input where the browser has no picker. */
function fromInput(): Promise<Given | null> {
  const input = element('input', { type: 'file' });
  return new Promise((resolve) => {
    input.addEventListener('cancel', () => resolve(null));
    input.addEventListener('change', async () => {
      const [file] = input.files ?? [];
      resolve(file ? { bytes: await bytesOf(file), name: file.name } : null);
    });
    input.click();
  });
}

/** What the user picks; null: nothing. */
export async function picked(): Promise<Given | null> {
  const pick = picker();
  if (!pick) return fromInput();
  try {
    const [handle] = await pick({});
    return await fromHandle(handle);
  } catch (reason) {
    if ((reason as Error).name === 'AbortError') return null;
    if ((reason as Error).name === 'SecurityError') return fromInput();
    throw reason;
  }
}

async function fromTransfer({ items, files }: DataTransfer): Promise<Given | null> {
  const item = [...items].find(({ kind }) => kind === 'file') as (DataTransferItem & { getAsFileSystemHandle?: () => Promise<FileHandle | null> }) | undefined;
  const file = files[0];
  const handle = await item?.getAsFileSystemHandle?.().catch(() => null);
  if (handle && 'getFile' in handle) return fromHandle(handle);
  return file ? { bytes: await bytesOf(file), name: file.name } : null;
}

const isTypedInto = 'input, textarea, select, [contenteditable]';

/** Ctrl+O, wherever the focus is, but while something is asked; what is typed there counts. */
export function hearOpen(place: HTMLElement, open: () => void): void {
  const hear = (event: KeyboardEvent) => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey || event.shiftKey || event.key.toLowerCase() !== 'o' || !place.isConnected) return;
    event.preventDefault();
    event.stopPropagation();
    if (place.querySelector('dialog[open]')) return;
    if ((event.target as Element).matches?.(isTypedInto)) event.target?.dispatchEvent(new Event('change', { bubbles: true }));
    open();
  };
  place.ownerDocument.addEventListener('keydown', hear, { capture: true });
}

/** Files dropped anywhere, and text that is pasted where nothing else takes it. `front`: what is marked while a file is above it. */
export function hearDrops(place: HTMLElement, front: () => HTMLElement, given: (given: Given) => void): void {
  const isAsking = () => !!place.querySelector('dialog[open]'); // what is asked comes first
  const mark = (is: boolean) => front().classList.toggle('is-dropped-on', is);
  place.addEventListener('dragover', (event) => {
    if (!event.dataTransfer?.types.includes('Files')) return;
    event.preventDefault();
    mark(!isAsking());
  });
  place.addEventListener('dragleave', (event) => !place.contains(event.relatedTarget as Node | null) && mark(false));
  place.addEventListener('drop', async (event) => {
    mark(false);
    if (!event.dataTransfer) return;
    event.preventDefault();
    if (isAsking()) return;
    const found = await fromTransfer(event.dataTransfer);
    if (found) given(found);
  });
  place.ownerDocument.addEventListener('paste', (event) => {
    if ((event.target as Element).closest?.(isTypedInto) || !place.isConnected || isAsking()) return;
    const text = event.clipboardData?.getData('text/plain');
    if (text) given({ bytes: new TextEncoder().encode(text), name: 'pasted.csv' });
  });
}

const isOpened = (told: Opened | TooMany): told is Opened => 'document' in told;

/** A document; null where the user did not want it. Throws `Trouble`, a sentence. */
export async function opened(engine: Engine, place: HTMLElement, given: Given): Promise<Opened | null> {
  const { bytes, name, method, beside, reading, hash } = given, source = { bytes, name, reading, hash };
  const told = await engine.ask('open', { ...source, method, beside });
  return isOpened(told) ? told : new Reducing(engine, place, source, told).opened();
}
