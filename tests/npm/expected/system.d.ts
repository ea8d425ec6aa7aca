type Call = (...values: number[]) => number;
/** Is told the share of a task that is done, from 0 to 1. Where it returns true, the task ends. */
export type Progress = (share: number) => boolean | void;
export declare class System {
    memory: WebAssembly.Memory;
    /** What was printed. */
    said: string;
    /** What is told of a task; any other number than 0 ends it. */
    private shown;
    /** For the imports of a module; what is not here has no such file. */
    importsOf(module: WebAssembly.Module): Record<string, Record<string, Call>>;
    /** Does some work that is told of. What `progress` throws ends it too and comes out here, not through compiled code, whose stack would be lost. */
    showing<Result>(progress: Progress | null | undefined, work: () => Result): Result;
    private nothingAt;
    private readonly written;
    /** [ns], in 64 bits, of a clock that never goes back: `compare` says how long its methods take. */
    private readonly timed;
    private readonly ended;
}
export {};
