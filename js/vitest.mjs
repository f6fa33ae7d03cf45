// For Vitest: import 'circumspect-oracle/vitest' gives expect() the matchers.
import { expect } from 'vitest';
import { matchers } from './matchers.mjs';

expect.extend(matchers);
