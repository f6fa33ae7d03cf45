import type { Matchers as Meshes } from './matchers.js';

declare module 'expect' {
  interface Matchers<R extends void | Promise<void>, T = unknown> extends Meshes<R> {}
}
