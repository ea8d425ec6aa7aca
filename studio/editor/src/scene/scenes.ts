// SPDX-License-Identifier: Apache-2.0
// The body and the sphere, drawn by one graphics context; or a sentence instead of each.
import { painterOf } from 'orispline-viewer/scene/painter';
import type { Studio } from '../store/studio';
import { Body } from './body';
import { withoutGraphics } from './figure';
import { Sphere } from './sphere';

/** Both figures. They are freed when the view ends. */
export function scenesOf(studio: Studio): { body: HTMLElement; sphere: HTMLElement } {
  const painter = painterOf(studio.view);
  if (!painter) return { body: withoutGraphics('Body'), sphere: withoutGraphics('Sphere') };
  return { body: new Body(studio, painter).figure, sphere: new Sphere(studio, painter).figure };
}
