// SPDX-License-Identifier: Apache-2.0
// What tests look at of the engine.
export * from '../src/engine/answers';
export * from '../src/engine/client';
export * from '../src/engine/hash';
export * from '../src/engine/latest';
export * from '../src/engine/library';
export * from '../src/engine/module';
export { stopped } from '../src/engine/protocol';
export * from '../src/engine/times';
export * from '../src/engine/trouble';
