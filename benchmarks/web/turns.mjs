// SPDX-License-Identifier: Apache-2.0
// Two contenders in turn, by processor time. A contender is a function of a number of calls, which gives the time that they took [s].
const rounds = 41, turn = 0.02, warm = 1.5; // [s]

export const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];

/** A contender of this process, its other threads included: V8 collects and compiles on them. */
export const here = (work) => (calls) => {
  const start = process.cpuUsage();
  for (let call = 0; call < calls; ++call) work();
  const { user, system } = process.cpuUsage(start);
  return (user + system) / 1e6;
};

/** How many calls fill a turn, once the compiler of V8 has had its time. */
const warmed = async (contender) => {
  let calls = 1, spent = 0;
  for (let taken; spent < warm; spent += taken) {
    taken = Math.max(await contender(calls), 1e-6);
    calls = Math.max(1, Math.round((calls * turn) / taken));
  }
  return calls;
};

/** The time of one call of `ours` over that of `theirs`: the median of the rounds, in each of which both have a turn. */
export const ratioOf = async (ours, theirs) => {
  const [ourCalls, theirCalls] = [await warmed(ours), await warmed(theirs)], ratios = [];
  for (let round = 0; round < rounds; ++round) ratios.push((await ours(ourCalls)) / ourCalls / ((await theirs(theirCalls)) / theirCalls));
  return median(ratios);
};
