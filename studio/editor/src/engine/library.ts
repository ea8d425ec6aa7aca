// SPDX-License-Identifier: Apache-2.0
// The library as compiled code, by the sources of the npm package.
import { Engine } from 'orispline/engine';
import { FullOrispline } from 'orispline/full_orispline';
import { System } from 'orispline/system';

/** Gives what work makes of something that is freed behind it. */
export function used<Thing extends { dispose(): void }, Result>(thing: Thing, work: (thing: Thing) => Result): Result {
  try {
    return work(thing);
  } finally {
    thing.dispose();
  }
}

export class Library extends FullOrispline {
  constructor(module: WebAssembly.Module) {
    const system = new System();
    super(new Engine(module, 'orispline_task_run_with', String, system), system);
  }

  /** Whether no fault has ended it. */
  get isSound(): boolean {
    try {
      return this.methodText('auto') === 'auto';
    } catch {
      return false;
    }
  }

  /** The text of a method as it is written, with all defaults left out; what there is not is an error. */
  methodText(text: string): string {
    return this.engine.withText(text, (at) => this.engine.toldText('orispline_method_text', at));
  }
}
