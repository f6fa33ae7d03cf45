// The same for a module that is required.
import oracle = require('circumspect-oracle');
import arbitraries = require('circumspect-oracle/arbitraries');
import { expect } from '@jest/globals';
import 'circumspect-oracle/jest';

const verdict: oracle.Verdict = oracle.check([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]]);
const families: string[] = arbitraries.families;
expect(verdict.holds || families).toBeTriangulation({ duplicates: 'merge' });
