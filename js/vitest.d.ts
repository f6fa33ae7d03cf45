import 'vitest';
import type { Matchers } from './matchers.js';

declare module 'vitest' {
  interface Assertion<T = any> extends Matchers<void> {}
  interface AsymmetricMatchersContaining extends Matchers {}
}
