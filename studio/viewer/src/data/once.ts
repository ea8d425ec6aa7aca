// SPDX-License-Identifier: Apache-2.0

/** Computes once what belongs to a part of the data, as long as there is that part. */
export function once<Of extends object, Result>(compute: (of: Of) => Result): (of: Of) => Result {
  const results = new WeakMap<Of, Result>();
  return (of) => {
    if (!results.has(of)) results.set(of, compute(of));
    return results.get(of)!;
  };
}

/** Computes once what is asked for late, or never. */
export function lazily<Result>(compute: () => Result): () => Result {
  let result: Result | undefined;
  return () => (result ??= compute());
}
