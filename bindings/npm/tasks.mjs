// SPDX-License-Identifier: Apache-2.0
// tasks.mjs: what each task takes, as types of the package. The list of the tasks comes in, from `orispline tasks --json`.
import { readFileSync } from 'node:fs';

const kinds = { keys: 'KeyInput', rates: 'RateInput', skeleton: 'SceneInput' };

const typeOfInput = ({ kinds: taken, several }) => {
  const one = taken.map((kind) => kinds[kind]).join(' | ');
  return several ? `${one} | (${one})[]` : one;
};

const typeOfOption = ({ type, words }) =>
  type === 'flag' ? 'Flag' : words ? words.map(({ word }) => `'${word}'`).join(' | ') : 'Text';

const tasks = JSON.parse(readFileSync(0, 'utf8'));
const typed = ({ options, options_of_skeletons: ofSkeletons = [] }) =>
  [...options, ...ofSkeletons].filter(({ type }) => type !== 'recording').map((option) => [option.name, { sentence: option.sentence, type: typeOfOption(option) }]);
const known = new Map(tasks.flatMap(typed));

/** Options by their names, each once: of a task, of it on skeletons, and what it takes beside them, as far as another task says of what type. */
const optionsOf = (task) => new Map([...task.settings.map(({ name, sentence }) => [name, { sentence, type: known.get(name)?.type ?? 'Text | Flag' }]), ...typed(task)]);

const member = (indent, sentence, name, isRequired, type) => `${indent}/** ${sentence}. */\n${indent}${name}${isRequired ? '' : '?'}: ${type};\n`;

const typesOf = (task) => {
  const inputs = task.inputs.map((input) => member('      ', input.sentence, input.name, input.required, `${typeOfInput(input)}${input.required ? '' : ' | undefined'}`));
  const options = [...optionsOf(task)].map(([name, { sentence, type }]) => member('      ', sentence, name, false, `${type} | undefined`));
  return `  /** ${task.sentence}. */\n  ${task.task}: {\n    inputs: {\n${inputs.join('')}    };\n    options: {\n${options.join('')}    };\n  };\n`;
};

process.stdout.write(`// SPDX-License-Identifier: Apache-2.0
// Written by bindings/npm/tasks.mjs, from the list of the tasks.
import type { KeyInput, RateInput, SceneInput } from './task_values.js';

type Flag = boolean | 'true' | 'false';
/** As the command has it, with its unit where it has one: \`0.1deg\`. */
type Text = string | number;

/** What each task takes. */
export interface Tasks {
${tasks.map(typesOf).join('')}}
`);
