import type { CheckOptions } from './index.js';

export interface Matchers<R = unknown> {
  /** That the mesh is a Delaunay triangulation of its points. */
  toBeDelaunay(options?: CheckOptions): R;
  toBeTriangulation(options?: CheckOptions): R;
  /** That the simplices fit together, whatever they fill. */
  toBeComplex(options?: CheckOptions): R;
  /** That a claim holds: { claim, domain, within, … }. */
  toHold(options?: CheckOptions): R;
}

export const matchers: Record<keyof Matchers, (received: unknown, options?: CheckOptions) => { pass: boolean; message(): string }>;
export default matchers;
