// SPDX-License-Identifier: Apache-2.0
// What is answered to each question. It needs no worker.
import type { WholeCurve } from 'orispline/whole_curve';
import type { Choice, Key } from '../document/document';
import { plainReading, textFor } from '../document/reading';
import { settingsOf } from './choices';
import { countedOf, type Counted } from './counted';
import { Drawings, type Redrawn } from './drawings';
import { Forms } from './forms';
import { dataOf } from './keys';
import { Library, used } from './library';
import { Opening } from './opening';
import type { Given, MethodInfo, Name, Told } from './protocol';
import { Reducing } from './reducing';
import { Remedies } from './remedies';
import { evenSamples } from './samples';
import { tableOf } from './table';

type Progress = (share: number) => void;
type Questioned = { [N in Name]: (given: Given<N>, progress?: Progress) => N extends 'curves' ? Redrawn : Told<N> };

/** Answers one question after another, by a new library where a fault has ended the last one. */
export class Answering {
  private readonly module: WebAssembly.Module;
  private library!: Library;
  private answers!: Questioned;

  constructor(module: WebAssembly.Module) {
    this.module = module;
    this.begin();
  }

  answer<N extends Name>(name: N, given: Given<N>, progress?: Progress): unknown {
    try {
      return this.answers[name](given, progress);
    } finally {
      if (!this.library.isSound) this.begin();
    }
  }

  private begin(): void {
    this.library = new Library(this.module);
    this.answers = answersOf(this.library);
  }
}

/** An answer to each question of the protocol. */
export function answersOf(library: Library): Questioned {
  const methods = library.methods() as MethodInfo[], opening = new Opening(library, methods), drawings = new Drawings(library, methods);
  const reducing = new Reducing(library, opening), forms = new Forms(library), remedies = new Remedies(library, methods);
  const withCurve = <Result>(edited: readonly Key[], choice: Choice, work: (curve: WholeCurve, counted: Counted) => Result): Result => {
    const counted = countedOf(edited), { keys } = counted;
    return used(library.curve(choice.method, dataOf(keys), settingsOf(choice, keys, methods)), (curve) => work(curve, counted));
  };
  return {
    methods: () => methods,
    open: (given) => opening.open(given),
    reduce: (given, progress) => reducing.reduce(given, progress),
    curves: (given) => drawings.redrawn(given),
    calmest: ({ keys, choice, need }) => remedies.calmest(countedOf(keys).keys, choice, need),
    ofAnyTimes: ({ keys, choice }) => remedies.ofAnyTimes(keys, choice),
    at: ({ keys, choice, time }) => withCurve(keys, choice, (curve, { counted }) => {
      const t = counted(time), [w, x, y, z] = curve.at(t), p = curve.hasPositions ? curve.positionAt(t) : null;
      return { q: [w, x, y, z], p: p && [p[0], p[1], p[2]] };
    }),
    write: ({ keys, epoch, name, choice }) =>
      used(library.read(tableOf(keys, epoch, choice), 'keys.csv'), (track) => new TextDecoder().decode(library.write(track, name).bytes)),
    read: ({ text, name, reading = plainReading }) => used(library.read(textFor(text, reading), name, reading.options), (track) => opening.keysIn(track, true)),
    reopens: (given) => opening.reopens(given),
    stated: (given) => forms.stated(given),
    sample: ({ keys, choice, count, rates }) => withCurve(keys, choice, (curve, { given }) => {
      const samples = evenSamples(curve, count, rates);
      return { ...samples, t: given(samples.t) };
    }),
    bake: ({ keys, choice, tolerance }) => withCurve(keys, choice, (curve) => JSON.stringify(curve.bake({ tolerance }))),
  };
}
