type Call = (...values: number[]) => number;
export declare class System {
    memory: WebAssembly.Memory;
    /** What was printed. */
    said: string;
    /** For the imports of a module; what is not here has no such file. */
    importsOf(module: WebAssembly.Module): Record<string, Record<string, Call>>;
    private nothingAt;
    private readonly written;
    private readonly ended;
}
export {};
