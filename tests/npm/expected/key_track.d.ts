import type { Address, Engine } from './engine.js';
import { type Forgotten, Held } from './held.js';
import { type KeyData, type Order } from './keys.js';
/** What keys are, and what reading them found: docs/c.md has all members. */
export interface KeyInfo {
    count: number;
    columns: {
        name: string;
        width: number;
    }[];
    name: string;
    /** What the times count from [s]. */
    epoch: string;
    /** The method that they are for. */
    method: string | null;
    [member: string]: unknown;
}
/** Keys with all that a file or a task has said of them. They are freed where they are disposed of, or some time after they were forgotten. */
export declare class KeyTrack extends Held {
    /** Of an `Orispline`, by its `read` or its `run`. */
    constructor(engine: Engine, forgotten: Forgotten, address: Address);
    get info(): KeyInfo;
    /** A column by its name: `times`, `positions`, a setting such as `tension`. */
    column(name: string, order?: Order): Float64Array;
    /** As plain arrays, for `curve`. */
    data(order: Order): KeyData;
}
