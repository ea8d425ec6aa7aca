export declare const moduleText: string;
