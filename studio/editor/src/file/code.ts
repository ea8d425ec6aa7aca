// SPDX-License-Identifier: Apache-2.0
// What is copied: a command or a program that samples the same curve at the same times, to the last bit. All but JavaScript, which has the keys in
// it, read the file that the keys are saved in.
import { numberText } from '../document/decimal';
import type { Choice, Key } from '../document/document';
import { plainReading, type Reading } from '../document/reading';
import { methodText } from '../document/methodText';
import { countedFromFirst } from '../document/times';
import type { MethodInfo } from '../engine/protocol';

export interface Wanted {
  readonly name: string; // of the file
  readonly keys: readonly Key[];
  readonly choice: Choice;
  readonly method: MethodInfo; // of the choice
  readonly count: number; // of samples at even times, from the start to the end
  readonly reading?: Reading; // of the file
}

export type Language = 'command' | 'C++' | 'Python' | 'JavaScript';

/** Parameters of the method that keys have values of their own for. */
const ownOf = ({ keys, method }: Wanted): string[] => method.parameters.map(({ name }) => name).filter((name) => name in (keys[0]?.own ?? {}));

/** A name is no option, and a lone dash is standard input. */
const fileNamed = (name: string): string => (name.startsWith('-') ? `./${name}` : name);

/** Of a shell: nothing within single quotes means anything but itself. */
const word = (text: string): string => (/^[\w./:=,+@%-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`);

/** A literal of Python and of JavaScript. */
const literal = (text: string): string => JSON.stringify(text);

/** A literal of C++, which wants other escapes. */
function literalOfC(text: string): string {
  const escaped = [...text].map((c) => (c === '"' || c === '\\' ? `\\${c}` : c < ' ' ? `\\${c.charCodeAt(0).toString(8).padStart(3, '0')}` : c));
  return `"${escaped.join('')}"`;
}

const optionsOf = ({ reading }: Wanted): [name: string, value: string | boolean][] => Object.entries(reading?.options ?? {});

function command(wanted: Wanted): string {
  const { name, choice, count } = wanted, output = name === 'motion.csv' ? 'samples.csv' : 'motion.csv';
  const options = optionsOf(wanted).map(([option, value]) => ` --${option.replaceAll('_', '-')}${value === true ? '' : ` ${word(String(value))}`}`).join('');
  return `orispline sample ${word(fileNamed(name))}${options} --method ${word(methodText(choice))} --count ${count} -o ${output}\n`;
}

function cpp(wanted: Wanted): string {
  const { name, choice, count, method } = wanted;
  const own = ownOf(wanted);
  const parameters = own.length > 0 ? `, .parameters = {${own.map(literalOfC).join(', ')}}` : '';
  const reading = `{.rate_orders = ${Number(method.rate_orders ?? 0)}${parameters}}`;
  return `// Links to orispline::orispline. Times count from the first key on.
#include <cstddef>
#include <cstdio>
#include <orispline/files.hpp>
#include <orispline/orispline.hpp>
#include <orispline/sampling.hpp>
#include <orispline/streams.hpp>
#include <vector>

int main() {
  const auto failed = [](const orispline::Error& error) { return std::fprintf(stderr, "%s\\n", describe(error).c_str()), 1; };
  const auto file = orispline::io::read_track(${literalOfC(fileNamed(name))}, ${reading});
  if (!file) return failed(file.error());
  const auto method = orispline::method_from_text(${literalOfC(methodText(choice))});
  if (!method) return failed(method.error());
  const auto family = orispline::find_family(method->name);
  if (!family) return failed(family.error());
  const auto curve = orispline::make_curve(orispline::completed(*method, **family, file->track), file->track.keys);
  if (!curve) return failed(file->track.located(curve.error()));

  constexpr std::size_t count = ${count};
  const auto [start, end] = curve->domain();
  const auto grid = orispline::SampleGrid::make({.spacing = orispline::SampleGrid::Count{count}}, start, end);
  if (!grid) return failed(grid.error());
  std::vector<double> times(count), q(4 * count), w(3 * count);  // [s]; x, y, z, w; [rad/s], body
  grid->fill(0, times);
  const auto sampled = orispline::sample_at<double>(*curve, times, {.orientations = q, .angular_velocities = w});
  if (!sampled) return failed(sampled.error());
  std::printf("t,qx,qy,qz,qw,wx,wy,wz\\n");
  for (std::size_t k = 0; k < count; ++k) {
    std::printf("%.17g", times[k]);
    for (std::size_t i = 4 * k; i < 4 * k + 4; ++i) std::printf(",%.17g", q[i]);
    for (std::size_t i = 3 * k; i < 3 * k + 3; ++i) std::printf(",%.17g", w[i]);
    std::printf("\\n");
  }
}
`;
}

/** Of columns a mapping; of numbers, such as 30000/1001, their text. */
function ofPython(option: string, value: string | boolean): string {
  if (value === true) return 'True';
  if (option === 'columns') return `{${String(value).split(',').map((pair) => pair.split('=').map(literal).join(': ')).join(', ')}}`;
  return option === 'session' ? String(value) : literal(String(value));
}

const python = (wanted: Wanted): string => `import orispline as ori

keys = ori.read(${literal(fileNamed(wanted.name))}, ${optionsOf(wanted).map(([option, value]) => `${option}=${ofPython(option, value)}, `).join('')}scalar_first=True)
curve = keys.curve(${literal(methodText(wanted.choice))})
samples = curve.sample(count=${wanted.count}, derivatives=3)  # times, orientations (w, x, y, z), angular velocities, accelerations, jerks
`;

/** Rows of a list, one a line. */
const rows = (lists: readonly (readonly number[])[]): string => `[\n${lists.map((list) => `    ${list.map((number) => (Number.isNaN(number) ? 'NaN' : numberText(number))).join(', ')},\n`).join('')}  ]`;

function javaScript(wanted: Wanted): string {
  const { choice, count } = wanted;
  const keys = countedFromFirst(wanted.keys);
  const rates = ['angularVelocities', 'angularAccelerations', 'angularJerks'].slice(0, keys[0].rates.length);
  const columns = [
    `  times: ${rows([keys.map(({ t }) => t)])}, // [s]`,
    `  orientations: ${rows(keys.map(({ q }) => q))},`,
    `  order: 'wxyz',`,
    ...(keys[0].p ? [`  positions: ${rows(keys.map(({ p }) => p!))}, // [m]`] : []),
    ...rates.map((rate, order) => `  ${rate}: ${rows(keys.map((key) => key.rates[order]))},`),
  ];
  const own = ownOf(wanted).map((name) => `${name}: [${keys.map((key) => numberText(key.own[name])).join(', ')}]`);
  return `import { load } from 'orispline';

const ori = await load();
const keys = {
${columns.join('\n')}
};
const curve = ori.curve(${literal(methodText(choice))}, keys${own.length > 0 ? `, { ${own.join(', ')} }` : ''});
const { start, end } = curve;
const count = ${count};
const times = Array.from({ length: count }, (_, k) => (k < count - 1 ? start + ((end - start) * k) / (count - 1) : end));
const samples = curve.sample({ times, rates: 3 }); // orientations, angularVelocities, …
`;
}

const writers: Record<Language, (wanted: Wanted) => string> = { command, 'C++': cpp, Python: python, JavaScript: javaScript };

/** Those in which a file is read as it is here: no other reads decimal commas, and C++ states options otherwise. */
export const languagesFor = ({ options, comma }: Reading = plainReading): Language[] =>
  comma ? ['JavaScript'] : (Object.keys(writers) as Language[]).filter((language) => language !== 'C++' || Object.keys(options).length === 0);

export const copiedCode = (language: Language, wanted: Wanted): string => writers[language](wanted);
