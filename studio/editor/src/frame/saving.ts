// SPDX-License-Identifier: Apache-2.0
// Keys go back into the file that was opened, where the browser gives access to it; else into a file to download.
import { element } from 'orispline-viewer/look/element';
import type { StudioDocument } from '../document/document';
import { sentence } from '../document/sentence';
import { sha256 } from '../engine/hash';
import type { Trouble } from '../engine/protocol';
import { savedText, type Saved } from '../file/save';
import type { Studio } from '../store/studio';
import { ask, sentences } from './dialog';
import { download } from './download';
import type { Notices } from './notices';
import { bytesOf, type FileHandle } from './opening';

type Picker = (options: { suggestedName: string }) => Promise<FileHandle>;
const picker = () => (window as unknown as { showSaveFilePicker?: Picker }).showSaveFilePicker?.bind(window);

/** Of a file whose rows cannot stay. */
const anew = (name: string): string => name.replace(/(\.[^.]*)?$/, '_quaternions.csv');
const why = (name: string): string[] => [
  `The rows of ${name} cannot stay as they are with these changes. All of them can be written anew into another file: times in seconds, quaternions, positions, rates and values of parameters, below the method of A.`,
  `Comments and further columns of ${name} are not in that file. ${name} itself stays as it is.`,
];

interface Place {
  notices: Notices;
  element: HTMLElement;
}

export class Saving {
  private hash: string; // of the file on the disk, as far as we know
  private isBusy = false;
  private wholeName: string | null = null; // of the file that all rows go into, where the user has agreed to one

  constructor(
    private readonly studio: Studio,
    private readonly opened: StudioDocument,
    private handle: FileHandle | undefined,
    private readonly place: () => Place,
  ) {
    this.hash = studio.original.hash;
  }

  async save(): Promise<void> {
    if (this.isBusy) return;
    this.isBusy = true;
    try {
      const { store, original, engine } = this.studio;
      const { document } = store.current();
      const isMade = this.opened.keys.every(({ row }) => row === null); // of a recording, so that it has a file of its own
      const name = isMade ? original.name : (this.wholeName ?? anew(original.name));
      const saved = await savedText(original, document, engine, this.opened, name);
      const put = saved.isWhole && !isMade ? await this.putApart(saved, name) : await this.put(saved);
      if (put) this.told(document, put);
    } catch (reason) {
      const { message } = reason as Trouble;
      this.place().notices.tell(`The keys were not saved: ${sentence(message)}`, { isTrouble: true });
    } finally {
      this.isBusy = false;
    }
  }

  /** What was edited meanwhile is not in the file. */
  private told(document: StudioDocument, name: string): void {
    const { store } = this.studio;
    if (store.current().document === document) store.tellSaved();
    this.place().notices.tell(`${name} is saved.`);
  }

  /** Under which name it was put; null: the user did not want it. */
  private async put(saved: Saved): Promise<string | null> {
    const { name } = this.studio.original;
    if (this.handle) return (await this.putIntoHandle(this.handle, saved)) ? this.handle.name : null;
    download(name, saved.text);
    return name;
  }

  /** Never over the file that was opened. */
  private async putApart(saved: Saved, proposed: string): Promise<string | null> {
    if (this.wholeName !== null) return this.put(saved);
    const input = element('input', { value: proposed, spellcheck: false, attributes: { 'aria-label': 'Name of the new file' } });
    const { name } = this.studio.original, content = [...sentences(...why(name)), element('label', { className: 'choice' }, element('span', {}, 'Name of the new file'), input)];
    for (;;) {
      const answer = await ask(this.place().element, `${name} cannot keep its rows`, content, [{ label: 'Save as another file', isFirst: true }, { label: 'Cancel' }]);
      if (answer !== 'Save as another file') return null;
      const stem = input.value.trim(), other = /\.csv$/i.test(stem) ? stem : `${stem}.csv`;
      if (stem === '' || other === name) continue;
      if (this.handle) return (await this.putElsewhere(saved, other, true)) ? this.handle.name : null;
      download(other, saved.text);
      return other;
    }
  }

  private async putIntoHandle(handle: FileHandle, saved: Saved): Promise<boolean> {
    if (await this.isChanged(handle)) {
      const content = sentences(`${handle.name} has another content on the disk than when it was opened here. To overwrite it loses what was changed there.`);
      const answer = await ask(this.place().element, 'The file was changed', content, [{ label: 'Save as another file', isFirst: true }, { label: 'Overwrite' }, { label: 'Cancel' }]);
      if (answer === 'Save as another file') return this.putElsewhere(saved);
      if (answer !== 'Overwrite') return false;
    }
    await this.write(handle, saved);
    return true;
  }

  /** A file that is no more was changed too. */
  private async isChanged(handle: FileHandle): Promise<boolean> {
    try {
      return sha256(await bytesOf(await handle.getFile())) !== this.hash;
    } catch {
      return true;
    }
  }

  private async putElsewhere(saved: Saved, name = this.studio.original.name, isWhole = false): Promise<boolean> {
    const pick = picker();
    if (!pick) {
      download(name, saved.text);
      return true;
    }
    try {
      const handle = await pick({ suggestedName: name });
      if (isWhole && (await this.handle?.isSameEntry?.(handle))) throw new Error(`found ${handle.name} itself, wanted another file`);
      await this.write(handle, saved);
      this.handle = handle;
      if (isWhole) this.wholeName = handle.name;
      return true;
    } catch (reason) {
      if ((reason as Error).name === 'AbortError') return false;
      throw reason;
    }
  }

  private async write(handle: FileHandle, { text }: Saved): Promise<void> {
    const bytes = new TextEncoder().encode(text);
    const file = await handle.createWritable();
    await file.write(bytes);
    await file.close();
    this.hash = sha256(bytes);
  }
}
