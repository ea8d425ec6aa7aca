import type { MethodInfo } from './orispline.js';
export declare const methods: MethodInfo[];
