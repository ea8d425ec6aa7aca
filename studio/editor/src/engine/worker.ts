// SPDX-License-Identifier: Apache-2.0
// The worker: it answers one question after another.
import { answersOf } from './answers';
import { Library } from './library';
import type { Answered, Asked } from './messages';
import { moduleIn } from './module';
import { buffersIn } from './transfer';
import { troubleOf } from './trouble';

type Answers = Record<string, (given: unknown) => unknown>;

let answers: Promise<Answers>;

async function answer({ number, name, given }: Exclude<Asked, { library: string }>): Promise<Answered> {
  try {
    return { number, told: (await answers)[name](given) };
  } catch (reason) {
    return { number, trouble: troubleOf(reason) };
  }
}

addEventListener('message', async ({ data }: MessageEvent<Asked>) => {
  if ('library' in data) {
    answers = moduleIn(data.library).then((module) => answersOf(new Library(module)) as unknown as Answers);
    answers.catch(() => {}); // who asks is told
    return;
  }
  const answered = await answer(data);
  postMessage(answered, { transfer: buffersIn(answered) });
});
