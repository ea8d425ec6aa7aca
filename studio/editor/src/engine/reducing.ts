// SPDX-License-Identifier: Apache-2.0
// The keys that a recording needs.
import type { Library } from './library';
import { used } from './library';
import { trackOf, warningsFrom, type Opening } from './opening';
import { mostKeys, type Given, type Reduced } from './protocol';

/** What is read of the task's document: docs/reduce.md. */
interface Found {
  method: string;
  keys: number;
  error_max_deg: number;
  methods: { method: string; keys: number }[];
  position_error_max_m?: number;
  smoothing?: { noise_rad?: number; raw_error_rms_deg: number };
}

const unchecked = 'positions_unchecked'; // the page asks for a tolerance of its own

export class Reducing {
  private readonly library: Library;
  private readonly opening: Opening;

  constructor(library: Library, opening: Opening) {
    this.library = library;
    this.opening = opening;
  }

  reduce({ tolerance, positionTolerance, smooth, methods, ...source }: Given<'reduce'>, progress?: (share: number) => void): Reduced {
    const options = { tolerance, position_tolerance: positionTolerance, ...(smooth ? { smooth } : {}), methods };
    const outcome = used(trackOf(this.library, source), (recording) => this.library.run('reduce', { recording }, options, progress ? { progress } : {}));
    const found = outcome.document as unknown as Found, { smoothing } = found;
    return used(outcome.tracks[0], (track) => ({
      count: found.keys,
      method: found.method,
      others: found.methods.filter(({ method }) => method !== found.method).map(({ method, keys }) => ({ method, count: keys })),
      furthest: found.error_max_deg,
      furthestPosition: found.position_error_max_m ?? null,
      smoothed: smoothing ? { noise: ((smoothing.noise_rad ?? 0) * 180) / Math.PI, rms: smoothing.raw_error_rms_deg } : null,
      opened: track.info.count > mostKeys ? null : this.opening.made(track, source, warningsFrom(outcome.warnings.filter(({ code }) => code !== unchecked))),
    }));
  }
}
