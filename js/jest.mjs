// For Jest: import 'circumspect-oracle/jest', or require() it, gives expect() the matchers.
import { expect } from '@jest/globals';
import { matchers } from './matchers.mjs';

expect.extend(matchers);
