// SPDX-License-Identifier: Apache-2.0
// The numbers of one key as fields: its time, orientation, position and values of its own. What they are told they write into the store.
import { keyWith, type Key, type Quaternion } from '../document/document';
import { valueAt, withOwn } from '../edits/parameters';
import { placed } from '../edits/position';
import { notATime, notAValue } from '../edits/reasons';
import { movedInTime } from '../edits/time';
import { turnedTo } from '../edits/turn';
import type { OwnParameter } from '../store/parameters';
import type { Studio } from '../store/studio';
import { NumberField } from './numberField';
import type { Orientations } from './orientation';

export class KeyFields {
  constructor(
    private readonly studio: Studio,
    private readonly orientations: Orientations,
    private readonly id: () => number | null, // the key that is meant
    private readonly nameOf: (what: string) => string, // what a field is called by who does not see it
  ) {}

  private get document() {
    return this.studio.store.current().document;
  }

  get key(): Key | undefined {
    return keyWith(this.document, this.id());
  }

  time(): NumberField {
    const taken = (t: number, gesture: object) => {
      const id = this.id();
      if (id === null) return null;
      const why = notATime(this.document, id, t);
      if (!why) this.studio.store.edit(movedInTime(this.document, id, t), gesture);
      return why;
    };
    return new NumberField({ label: 't', name: this.nameOf('time'), unit: 's', step: 0.01, decimals: 6, taken });
  }

  /** The fields of the form that is chosen now; all of them are one orientation. */
  orientation(): NumberField[] {
    const form = this.orientations.current;
    return form.names.map(
      (name, i) => new NumberField({ label: name.split(',')[0], name: this.nameOf(name), unit: form.unit, step: form.step, decimals: form.decimals, taken: (value, gesture) => this.turn(i, value, gesture) }),
    );
  }

  private turn(i: number, value: number, gesture: object): string | null {
    const { key } = this;
    if (!key) return null;
    const numbers = [...this.orientations.numbersOf(key)].with(i, value);
    const q = this.orientations.current.orientationOf(numbers);
    if (typeof q === 'string') return q;
    this.studio.store.edit(turnedTo(this.document, key.id, q as Quaternion), gesture);
    if (this.orientations.current.keepsTyped && this.key) {
      this.orientations.keep(this.key, numbers);
      this.shown?.();
    }
    return null;
  }

  /** Is called where what was typed is shown in another way than before. */
  shown?: () => void;

  position(): NumberField[] {
    return ['x', 'y', 'z'].map((axis, i) => {
      const taken = (value: number, gesture: object) => {
        if (this.key) this.studio.store.edit(placed(this.document, this.key.id, i as 0 | 1 | 2, value), gesture);
        return null;
      };
      return new NumberField({ label: axis, name: this.nameOf(`position ${axis}`), unit: 'm', step: 0.01, decimals: 3, taken });
    });
  }

  own({ which, info }: OwnParameter): NumberField {
    const taken = (value: number, gesture: object) => {
      const why = notAValue(info, value);
      if (!why && this.key) this.studio.store.edit(withOwn(this.document, this.key.id, which, info, value), gesture);
      return why;
    };
    return new NumberField({ label: info.name, name: this.nameOf(info.name), step: 0.05, taken });
  }

  valueOf({ which, info }: OwnParameter): number {
    return this.key ? valueAt(this.document, this.key, which, info) : NaN;
  }
}
