// SPDX-License-Identifier: Apache-2.0
// The worker: it answers one question after another.
import { Answering } from './answers';
import type { Answered, Asked } from './messages';
import { moduleIn } from './module';
import { buffersIn } from './transfer';
import { troubleOf } from './trouble';

let answering: Promise<Answering>;

async function answer({ number, name, given }: Exclude<Asked, { library: string }>): Promise<Answered> {
  try {
    return { number, told: (await answering).answer(name, given, (share) => postMessage({ number, share } satisfies Answered)) };
  } catch (reason) {
    return { number, trouble: troubleOf(reason) };
  }
}

addEventListener('message', async ({ data }: MessageEvent<Asked>) => {
  if ('library' in data) {
    answering = moduleIn(data.library).then((module) => new Answering(module));
    answering.catch(() => {}); // who asks is told
    return;
  }
  const answered = await answer(data);
  postMessage(answered, { transfer: buffersIn(answered) });
});
