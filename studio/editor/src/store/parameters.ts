// SPDX-License-Identifier: Apache-2.0
// Which parameters keys may have values of their own for.
import type { StudioDocument, Which } from '../document/document';
import type { MethodInfo, ParameterInfo } from '../engine/protocol';

export interface OwnParameter {
  which: Which; // whose parameter it is
  info: ParameterInfo;
}

/** Those of the curve, then those that the other one has alone. */
export function ownParameters(document: StudioDocument, methods: readonly MethodInfo[]): OwnParameter[] {
  const of = (which: Which) => methods.find(({ name }) => name === document[which].method)?.parameters.filter(({ per_key }) => per_key) ?? [];
  const first = of('first');
  const others = of('second').filter(({ name }) => !first.some((parameter) => parameter.name === name));
  return [...first.map((info): OwnParameter => ({ which: 'first', info })), ...others.map((info): OwnParameter => ({ which: 'second', info }))];
}
