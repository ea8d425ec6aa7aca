/** The sentence of a message; messages stand in each other. */
export declare const sentence: (message: string) => string;
