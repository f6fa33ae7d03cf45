import 'circumspect-oracle/vitest';
import { Delaunay } from 'd3-delaunay';
import Delaunator from 'delaunator';
import { expect, test } from 'vitest';

const five = [[0, 0], [3, 0], [0, 2], [3, 4], [1, 1]];
test('Delaunator', () => expect(Delaunator.from(five)).toBeDelaunay());
test('d3-delaunay', () => expect(Delaunay.from(five)).toBeDelaunay());
