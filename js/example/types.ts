// What TypeScript knows of the package.
import { check, delaunay, type Verdict } from 'circumspect-oracle';
import { points } from 'circumspect-oracle/arbitraries';
import { matchers } from 'circumspect-oracle/matchers';
import 'circumspect-oracle/vitest';
import { startWorker } from 'circumspect-oracle/worker';
import Delaunator from 'delaunator';
import { expect } from 'vitest';

const square = [[0, 0], [1, 0], [1, 1], [0, 1]];
const verdict: Verdict = check(square, delaunay(square), { claim: 'delaunay', require: 'min-angle:20deg' });
const simplices: Int32Array = delaunay(new Float64Array(6), { dimension: 2 }).simplices;
const rules: string[] = Object.keys(verdict.rules);
const later: Promise<Verdict> = startWorker().then((worker) => worker.check(square, simplices));
expect(Delaunator.from(square)).toBeDelaunay();
expect(square).not.toHold({ claim: 'complex' });
matchers.toBeDelaunay(points({ dimension: 3, maximum: 5 }));
check({ points: [[1n, '1/3']], simplices: [] }, { duplicates: 'merge' });
// @ts-expect-error: there is no such claim
check([[0, 0]], [[0]], { claim: 'delauney' });
// @ts-expect-error: nor such a family of options
expect(square).toBeDelaunay({ clam: 1 });
