// SPDX-License-Identifier: Apache-2.0

/** The memory of all typed arrays in plain data, which need not be copied on the way to a page. */
export function buffersIn(data: unknown): ArrayBuffer[] {
  if (ArrayBuffer.isView(data)) return [data.buffer as ArrayBuffer];
  return data && typeof data === 'object' ? Object.values(data).flatMap(buffersIn) : [];
}
