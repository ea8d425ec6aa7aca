// SPDX-License-Identifier: Apache-2.0
// Sentences of the small package, whose compiled code says their text and their values: bindings/npm/lite/messages.cpp. A message is
// \1 text \2 value \2 value … \3, in which texts have braces where values go, as fmt has them.

/** The shortest digits that read back to the number, one before the point, and its power of ten. */
const shortest = (number: number): [digits: string, power: number] => {
  const [digits, power] = number.toExponential().split('e');
  return [digits, Number(power)];
};

const withPower = (digits: string, power: number): string =>
  `${digits}e${power < 0 ? '-' : '+'}${String(Math.abs(power)).padStart(2, '0')}`;

const withoutZeros = (digits: string): string => (digits.includes('.') ? digits.replace(/\.?0+$/, '') : digits);

/** As `{}`, `{:.6g}`, `{:.2f}` and `{:+.2f}` of fmt. */
const numberText = (number: number, format: string): string => {
  if (!Number.isFinite(number)) return String(number).replace('Infinity', 'inf').replace('NaN', 'nan');
  const [, sign, precision, kind] = /^(\+?)(?:\.(\d+))?([fge]?)$/.exec(format) ?? [];
  const text = ((): string => {
    if (!kind && precision === undefined) {
      const [digits, power] = shortest(number);
      return power < -4 || power >= 16 ? withPower(digits, power) : power < 0 ? number.toFixed(Math.max(digits.replace(/[-.]/g, '').length - 1 - power, 0)) : String(number);
    }
    const places = Number(precision ?? 6);
    if (kind === 'f') return number.toFixed(places);
    const wanted = Math.max(places, 1), [digits, power] = number.toExponential(wanted - 1).split('e');
    return Number(power) < -4 || Number(power) >= wanted ? withPower(withoutZeros(digits), Number(power)) : withoutZeros(number.toFixed(wanted - 1 - Number(power)));
  })();
  return sign && number >= 0 ? `+${text}` : text;
};

const bitsOf = (letters: string): bigint => [...letters].reduce((bits, letter) => (bits << 4n) | BigInt(letter.charCodeAt(0) - 97), 0n);

const valueText = (value: string, format: string): string => {
  const kind = value[0], rest = value.slice(1);
  if (kind === 's') return rest;
  const bits = bitsOf(rest);
  if (kind === 'd') return numberText(new Float64Array(BigUint64Array.of(bits).buffer)[0], format);
  return String(kind === 'i' ? BigInt.asIntN(64, bits) : bits);
};

const filled = (text: string, values: string[]): string => {
  let next = 0;
  return text.replace(/\{\{|\}\}|\{(\d*)(?::([^}]*))?\}/g, (brace, index: string, format = '') =>
    brace === '{{' ? '{' : brace === '}}' ? '}' : valueText(values[index ? Number(index) : next++] ?? 's', format));
};

const innermost = /\x01([^\x01\x03]*)\x03/g;

/** The sentence of a message; messages stand in each other. */
export const sentence = (message: string): string => {
  for (let before = ''; before !== message; ) {
    before = message;
    message = message.replace(innermost, (_, content: string) => {
      const [text, ...values] = content.split('\x02');
      return filled(text, values);
    });
  }
  return message;
};
