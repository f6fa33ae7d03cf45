import type * as oracle from './index.js';

type Asked = Pick<typeof oracle, 'check' | 'delaunay' | 'constrainedDelaunay' | 'compare' | 'certify' | 'generate' | 'orient' | 'inBall' |
  'version'>;
type Later<F> = F extends { (...words: infer A): infer R; (...words: infer B): infer S } ?
  { (...words: A): Promise<R>; (...words: B): Promise<S> } : never;

/** The functions of the module, each of which gives a promise. */
export type Oracle = { [Name in keyof Asked]: Later<Asked[Name]> } & {
  /** Ends the thread; what was asked is rejected. */
  end(): void;
};
/** The oracle in a thread of its own: a page goes on meanwhile, and what takes too long can be ended. */
export function startWorker(): Promise<Oracle>;
