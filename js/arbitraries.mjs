// For fast-check: points of the families that `circumspect generate --list` names, which shrink to
// few points.
import { subarray, tuple, constantFrom, maxSafeNat, integer } from 'fast-check';
import { generate } from '#index';

// Families whose points are degenerate or nearly so, where triangulation programs go wrong.
export const families = ['uniform', 'integers', 'grid', 'circle', 'collinear', 'lower-dimensional', 'clusters', 'grid+ulp',
  'circle+ulp', 'lower-dimensional+ulp', 'circle+moved'];

// Rows of coordinates: [[x, y], …]. A failing case is made smaller by leaving points out.
export function points({ dimension = 2, minimum = dimension + 1, maximum = 40, families: from = families } = {}) {
  if (!(minimum >= 1 && maximum >= minimum)) {
    throw new RangeError(`expected 1 <= minimum <= maximum, found ${minimum} and ${maximum}`);
  }
  return tuple(constantFrom(...from), maxSafeNat(), integer({ min: minimum, max: maximum }))
    .map(([family, seed, count]) => drawn(family, { dimension, count, seed }))
    .chain((rows) => subarray(rows, { minLength: Math.min(minimum, rows.length) }));
}

function drawn(family, options) {
  const { points: flat, dimension } = generate(family, options);
  return Array.from({ length: flat.length / dimension }, (_, i) => Array.from(flat.subarray(i * dimension, (i + 1) * dimension)));
}
