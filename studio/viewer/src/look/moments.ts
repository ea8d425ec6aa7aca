// SPDX-License-Identifier: Apache-2.0
// Moments of a motion, all of them in one notation: seconds, from ten minutes on as a clock shows them.

/** `3:05`, `1:02:03.5` */
function onClock(time: number, digits: number): string {
  const unit = 10 ** digits;
  const parts = Math.round(Math.abs(time) * unit); // so that 59.99 does not become 60
  const seconds = parts / unit;
  const whole = Math.floor(seconds / 60);
  const rest = (seconds - 60 * whole).toFixed(digits).padStart(digits > 0 ? digits + 3 : 2, '0');
  const [hours, minutes] = [Math.floor(whole / 60), whole % 60];
  const text = hours > 0 ? `${hours}:${String(minutes).padStart(2, '0')}:${rest}` : `${minutes}:${rest}`;
  return time < 0 && parts > 0 ? `−${text}` : text;
}

export class Moments {
  private readonly asClock: boolean;
  private readonly decimals: number; // so many that a thousandth of the motion is seen

  constructor([start, end]: [start: number, end: number]) {
    const span = end - start;
    this.asClock = Math.max(Math.abs(start), Math.abs(end)) >= 600;
    this.decimals = Math.min(Math.max(Math.ceil(-Math.log10(span > 0 ? span / 1000 : 1)), this.asClock ? 0 : 2), 9);
  }

  text = (time: number): string => (this.asClock ? onClock(time, this.decimals) : `${time.toFixed(this.decimals)} s`.replace('-', '−'));

  /** Beside an axis; as many decimals as all of its marks need. */
  ticks(times: number[]): string[] {
    if (!this.asClock) return times.map((t) => `${t} s`.replace('-', '−'));
    const digits = times.every((t) => Number.isInteger(t)) ? 0 : Math.max(this.decimals, 1);
    return times.map((t) => onClock(t, digits));
  }
}
