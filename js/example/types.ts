// What TypeScript knows of the package.
import { check, delaunay, type Verdict } from 'circumspect-oracle';
import { points } from 'circumspect-oracle/arbitraries';
import { matchers } from 'circumspect-oracle/matchers';

const verdict: Verdict = check([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]], { claim: 'delaunay' });
const simplices: Int32Array = delaunay(new Float64Array(6), { dimension: 2 }).simplices;
const rules: string[] = Object.keys(verdict.rules);
// @ts-expect-error: there is no such claim
check([[0, 0]], [[0]], { claim: 'delauney' });
export { matchers, points, rules, simplices };
