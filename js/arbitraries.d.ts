import type { Arbitrary } from 'fast-check';

/** Families whose points are degenerate or nearly so. */
export const families: string[];
/** Rows of coordinates, which shrink by leaving points out. */
export function points(options?: { dimension?: number; minimum?: number; maximum?: number; families?: string[] }): Arbitrary<number[][]>;
