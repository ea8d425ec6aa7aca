// SPDX-License-Identifier: Apache-2.0
// Keys go back into the file that was opened, where the browser gives access to it; else into a file to download.
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

const written = 'All rows were written anew, since the library could not keep those of the original; its comments and further columns are not in them.';

interface Place {
  notices: Notices;
  element: HTMLElement;
}

export class Saving {
  private hash: string; // of the file on the disk, as far as we know
  private isBusy = false;

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
      const saved = await savedText(original, document, engine, this.opened);
      if (await this.put(saved)) this.told(document, saved);
    } catch (reason) {
      const { message } = reason as Trouble;
      this.place().notices.tell(`The keys were not saved: ${sentence(message)}`, { isTrouble: true });
    } finally {
      this.isBusy = false;
    }
  }

  /** What was edited meanwhile is not in the file. */
  private told(document: StudioDocument, { isWhole }: Saved): void {
    const { store, original } = this.studio;
    if (store.current().document === document) store.tellSaved();
    const name = this.handle?.name ?? original.name;
    this.place().notices.tell([`${name} is saved.`, ...(isWhole && original.text !== '' ? [written] : [])].join(' '));
  }

  private async put(saved: Saved): Promise<boolean> {
    if (this.handle) return this.putIntoHandle(this.handle, saved);
    download(this.studio.original.name, saved.text);
    return true;
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

  private async putElsewhere(saved: Saved): Promise<boolean> {
    const { name } = this.studio.original;
    const pick = picker();
    if (!pick) {
      download(name, saved.text);
      return true;
    }
    try {
      const handle = await pick({ suggestedName: name });
      await this.write(handle, saved);
      this.handle = handle;
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
