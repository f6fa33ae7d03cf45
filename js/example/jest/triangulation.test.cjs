// The same for Jest, whose tests require() what they need:   npx jest
require('circumspect-oracle/jest');
const fc = require('fast-check');
const { points } = require('circumspect-oracle/arbitraries');
const { delaunay } = require('circumspect-oracle');

const square = [[0, 0], [1, 0], [1, 1], [0, 1]];

test('two triangles', () => expect({ points: square, triangles: [[0, 1, 2], [0, 2, 3]] }).toBeDelaunay());
test('one triangle', () => expect({ points: square, triangles: [[0, 1, 2]] }).not.toBeTriangulation());
test('any points', () => fc.assert(fc.property(points({ maximum: 12 }), (rows) => {
  expect({ points: rows, simplices: delaunay(rows) }).toBeDelaunay();
}), { seed: 1, numRuns: 20 }));
