// What is read of scripts' arrays, and what the package says that it has: node --test
// arrays_test.mjs, without the library.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { countOf, indicesOf, listOf, numbersOf, partsOf, placesOf, simplicesOf } from './arrays.mjs';
import { oracle } from './oracle.mjs';

test('doubles stay doubles, and beside texts they are texts of the same value', () => {
  assert.deepEqual(numbersOf([[1, 0.5], [3, -0]], 'points').doubles, Float64Array.of(1, 0.5, 3, -0));
  assert.equal(numbersOf(Float32Array.of(0.1, 1), 'points', 2).doubles[0], Math.fround(0.1));
  const mixed = numbersOf([[0.1, '1/3'], [5e-324, 10n ** 20n], [-2.5, 1e22]], 'points').texts;
  assert.deepEqual(mixed, ['3602879701896397/36028797018963968', '1/3', `1/${1n << 1074n}`, '100000000000000000000', '-5/2',
    '10000000000000000000000']);
  assert.deepEqual(numbersOf([['1', NaN], [Infinity, 2]], 'points').texts, ['1', 'NaN', 'Infinity', '2']);
});

test('indices are 32 bits wide unless one needs 64', () => {
  assert.ok(indicesOf([[0, 1], [2, -1]], 'edges').indices instanceof Int32Array);
  assert.deepEqual(indicesOf(Uint32Array.of(0, 2 ** 32 - 1), 'edges', 2).indices, BigInt64Array.of(0n, 4294967295n));
  assert.deepEqual(indicesOf([[0n, 2 ** 31]], 'edges').indices, BigInt64Array.of(0n, 2147483648n));
  assert.deepEqual(indicesOf(Uint32Array.of(0, 2 ** 31 - 1), 'edges', 2).indices, Int32Array.of(0, 2147483647));
  for (const none of [0.5, NaN, '1', null, undefined, 2 ** 53]) {
    assert.throws(() => indicesOf([[0, none]], 'edges'), /^RangeError: expected indices of points as edges, found /);
  }
  assert.throws(() => placesOf([0, 2 ** 40], 'segments', 2), /^RangeError: .* found one beyond 32 bits$/);
});

test('a count beyond 32 bits does not become another number', () => {
  assert.deepEqual([0, 5, 2 ** 31 - 1].map((value) => countOf(value, 'count')), [0, 5, 2 ** 31 - 1]);
  for (const none of [2 ** 31, 2 ** 32 + 5, -1, 1.5, NaN, Infinity, '5', 5n, null]) {
    assert.throws(() => countOf(none, 'count'), /^RangeError: expected count as a whole number from 0 to 2147483647, found /);
  }
});

test('rows that differ, rows of nothing and arrays that are none are refused', () => {
  assert.throws(() => numbersOf([[1, 2], [3]], 'points'), /^RangeError: expected points in rows of 2, found row 1 of 1$/);
  assert.throws(() => numbersOf([[1, 2], 3], 'points'), /^TypeError: expected points in rows of 2, found 3 as row 1$/);
  assert.throws(() => numbersOf([[], []], 'points'), /^RangeError: expected points in rows of at least 1/);
  assert.throws(() => numbersOf([1, 2, 3], 'points', 2), /^RangeError: expected points in rows of 2, found 3 numbers$/);
  for (const columns of [0, -1, 1.5, '2', NaN]) assert.throws(() => numbersOf([1, 2, 3], 'points', columns), RangeError);
  for (const none of [undefined, null, 7, 'text', new DataView(new ArrayBuffer(8))]) {
    assert.throws(() => numbersOf(none, 'points', 2), /^TypeError: expected points as an array/);
  }
  const gone = new Float64Array(4);
  structuredClone(gone.buffer, { transfer: [gone.buffer] });
  assert.throws(() => numbersOf(gone, 'points', 2), /^TypeError: expected points, found an array whose buffer was detached/);
  for (const rows of [[gone, [0, 1]], [[0, 1], gone]]) assert.throws(() => numbersOf(rows, 'points'), /^TypeError: .* buffer was detached/);
  assert.equal(numbersOf(new Float64Array(0), 'points', 2).rows, 0);
  assert.throws(() => listOf(gone, 'segments'), /^TypeError: expected segments, found an array whose buffer was detached/);
  for (const none of [new Set([[0, 1]]), 7, { 0: [0, 1] }]) assert.throws(() => listOf(none, 'segments'), /^TypeError: expected segments as an array/);
  assert.deepEqual([undefined, null, [], [[0, 1]]].map((value) => listOf(value, 'segments')), [[], [], [], [[0, 1]]]);
});

test('an index is the same number whatever stores it', () => {
  const all = [-(2 ** 53) + 1, -(2 ** 31) - 1, -(2 ** 31), -1, 0, 1, 2 ** 31 - 1, 2 ** 31, 2 ** 53 - 1];
  const read = (values, columns) => Array.from(indicesOf(values, 'edges', columns).indices, BigInt);
  const kinds = [Int8Array, Uint8Array, Int16Array, Uint16Array, Int32Array, Uint32Array, Float64Array];
  for (const first of all) {
    for (const second of all) {
      const expected = [BigInt(first), BigInt(second)];
      for (const values of [[[first, second]], [expected], [[first], [BigInt(second)]]]) assert.deepEqual(read(values), expected);
      assert.deepEqual(read(BigInt64Array.from(expected), 2), expected);
      for (const Kind of kinds) {
        const stored = Kind.of(first, second);
        if (stored[0] === first && stored[1] === second) assert.deepEqual(read(stored, 2), expected, Kind.name);
      }
    }
  }
});

test('of a mesh of any library all parts are known, whatever it calls them', () => {
  const rows = { 2: [[0, 0], [1, 0], [0, 1]], 3: [[0, 0, 0], [1, 0, 0], [0, 1, 0]] };
  const simplices = [[0, 1, 2]];
  for (const pointsName of ['points', 'coords', 'vertices', 'positions']) {
    for (const simplicesName of ['simplices', 'triangles', 'tetrahedra', 'cells']) {
      for (const dimension of [2, 3]) {
        const points = rows[dimension];
        for (const more of [{}, { weights: [1, 2, 3] }, { dimension }, { dimension, weights: [1, 2, 3] }]) {
          const parts = partsOf({ [pointsName]: points, [simplicesName]: simplices, ...more });
          assert.deepEqual({ ...parts }, { points, simplices, vertices: undefined, dimension: undefined, weights: undefined, ...more });
        }
      }
    }
  }
  const flat = Float64Array.of(0, 0, 1, 0, 0, 1);
  const triangles = Uint32Array.of(0, 1, 2);
  assert.equal(partsOf({ coords: flat, triangles, hull: [] }).dimension, 2);
  assert.equal(partsOf({ points: flat, triangles, dimension: 3 }).dimension, 3);
  assert.deepEqual(simplicesOf({ simplices: triangles, vertices: 3 }), { simplices: triangles, vertices: 3 });
  assert.throws(() => partsOf({ points: flat }), /^TypeError: .* found one with points$/);
});

test('no points are not rows of the plane', () => {
  const { rows, columns } = numbersOf([], 'points');
  assert.deepEqual({ rows, columns }, { rows: 0, columns: 2 });
});

test('what the package names is there, and index.d.ts declares what there is', () => {
  const here = (name) => new URL(name, import.meta.url);
  const { exports } = JSON.parse(readFileSync(here('./package.json'), 'utf8'));
  const made = /\.(cjs|d\.cts|wasm)$/;  // by build.sh
  const names = (value) => (typeof value === 'string' ? [value] : Object.values(value).flatMap(names));
  for (const name of names(exports)) assert.ok(made.test(name) || existsSync(here(name)), name);
  const declared = [...readFileSync(here('./index.d.ts'), 'utf8').matchAll(/^export function (\w+)/gm)].map(([, name]) => name);
  assert.deepEqual([...new Set(declared)].sort(), Object.keys(oracle(() => undefined)).sort());
  for (const file of ['./index.mjs', './browser.mjs']) {
    for (const name of declared) assert.match(readFileSync(here(file), 'utf8'), new RegExp(`\\b${name}\\b`), `${file} ${name}`);
  }
});
