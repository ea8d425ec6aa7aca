// SPDX-License-Identifier: Apache-2.0
// What the views are given.
import type { Store as ViewStore } from 'orispline-viewer/store/store';
import type { Original } from '../document/document';
import type { Engine, MethodInfo } from '../engine/protocol';
import type { StudioStore } from './store';

export interface Studio {
  readonly store: StudioStore; // the document, its history, the chosen key
  readonly view: ViewStore; // time, playing, axis, theme, window: how it is looked at; its report has both curves
  readonly engine: Engine;
  readonly methods: readonly MethodInfo[];
  readonly original: Original;
}
