// What the package answers, as its users ask it:   node --test js/oracle_test.mjs   CIRCUMSPECT_PACKAGE is the folder of it.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';

const folder = resolve(process.env.CIRCUMSPECT_PACKAGE);
const oracle = await import(pathToFileURL(join(folder, 'index.mjs')));
const { matchers } = await import(pathToFileURL(join(folder, 'matchers.mjs')));
const corpus = resolve(dirname(fileURLToPath(import.meta.url)), '..', 'corpus');

const square = [[0, 0], [1, 0], [1, 1], [0, 1]];
const halves = [[0, 1, 2], [0, 2, 3]];

test('a mesh that holds: what is known of it, and one line', () => {
  const verdict = oracle.check(square, halves);
  assert.equal(verdict.text, 'holds: delaunay mesh 4 points 2 triangles not-unique canonical');
  assert.deepEqual([verdict.holds, verdict.unique, verdict.canonical], [true, false, true]);
  assert.deepEqual(verdict.rules, {});
});

test('a mesh that fails: the rule, and exact values of the witness', () => {
  const verdict = oracle.check([[0, 0], [1, 0], [0, 1], [0.9, 0.9]], [[0, 1, 2], [1, 3, 2]], { name: 'mine' });
  assert.equal(verdict.holds, false);
  assert.deepEqual(verdict.rules, { 'delaunay.facet-not-local': 1 });
  const [violation] = verdict.violations;
  assert.deepEqual(violation.vertices, [3]);
  assert.deepEqual(violation.ball.centre, ['1/2', '1/2']);
  assert.equal(violation.ball.squared_radius.exact, '1/2');
  assert.match(verdict.text, /^fails: delaunay mine delaunay.facet-not-local 1 face 1 2 vertex 3$/m);
});

test('flat typed arrays, nested arrays and objects of libraries are one mesh', () => {
  const flat = Float64Array.from(square.flat());
  const line = 'holds: delaunay mesh 4 points 2 triangles not-unique canonical';
  const triangles = Uint32Array.from(halves.flat());
  assert.equal(oracle.check(flat, triangles, { dimension: 2 }).text, line);
  assert.equal(oracle.check({ coords: flat, triangles }).text, line);
  assert.equal(oracle.check({ points: square, cells: halves }).text, line);
});

test('numbers are taken exactly: doubles as they are, texts and BigInts as they say', () => {
  const third = [[0, 0], ['1/3', 0], [0, '1/3'], ['1/3', '1/3']];
  assert.equal(oracle.check(third, [[0, 1, 2], [1, 3, 2]]).unique, false);
  assert.equal(oracle.orient([0.1, 0.1], [0.2, 0.2], [0.3, 0.3]), 0);  // 3·0.1 is not 0.3, but y is x
  assert.equal(oracle.orient([0, 0], [0.1, 0.1], ['1/10', 0.1]), oracle.orient([0, 0], [1, 1], [0.99999999999999, 1]));
  assert.equal(oracle.orient([0n, 0n], [1n, 0n], [0n, 10n ** 400n]), 1);
  assert.equal(oracle.inBall([0, 0], [1, 0], [0, 1], [1, 1]), 0);
  assert.equal(oracle.inBall([0, 0], [1, 0], [0, 1], [0.9, 0.9]), 1);
  assert.equal(oracle.inBall([0, 0], [1, 0], [0, 1], [1, 1.0000000000000002]), -1);
});

test('a wrong call is a TypeError or a RangeError that says what was expected', () => {
  const fails = (words, fault, text) => assert.throws(() => oracle.check(...words), (found) => found instanceof fault && text.test(found.message));
  fails([7], TypeError, /expected points and simplices, or an object that has both, found 7/);
  fails([{ points: square }], TypeError, /found one with points/);
  fails([[0, 0, 1, 0], [[0, 1]]], TypeError, /found a flat array/);
  fails([[[0, 0], [1]], halves], RangeError, /rows of 2, found row 1 of 1/);
  fails([square, [[0, 1, 2.5]]], RangeError, /expected indices of points as simplices, found 2.5/);
  fails([square, [[0, 1, 2 ** 40]]], RangeError, /found 1099511627776/);
  fails([square, halves, { clam: 'cdt' }], TypeError, /found clam/);
  fails([square, halves, { claim: 'nonsense' }], TypeError, /expected a claim about a mesh/);
  fails([square, halves, { weights: [1] }], RangeError, /a weight for each of 4 points, found 1/);
  fails([[[null, 0], [1, 0]], [[0, 1]]], TypeError, /found null/);
  const gone = Float64Array.from(square.flat());
  structuredClone(gone.buffer, { transfer: [gone.buffer] });
  fails([gone, [0, 1, 2], { dimension: 2 }], Error, /detached|without points|expected/);
});

test('an input at fault is an InputError; a fault of the mesh is a verdict', () => {
  assert.throws(() => oracle.check([...square, [0, 0]], [[0, 1, 2], [4, 2, 3]]), oracle.InputError);
  const merged = oracle.check([...square, [0, 0]], [[0, 1, 2], [4, 2, 3]], { duplicates: 'merge' });
  assert.equal(merged.holds, true);
  assert.equal(merged.notes.length, 1);
  assert.throws(() => oracle.check([[0, 0], [1, NaN], [0, 1]], [[0, 1, 2]]), oracle.InputError);
  assert.throws(() => oracle.check([], []), Error);
  assert.deepEqual(oracle.check(square, [[0, 1, 9]]).rules, { 'triangulation.unknown-vertex': 1, 'triangulation.unused-point': 2 });
});

test('domains, with the claim that fits', () => {
  const outline = { points: square, segments: [[0, 1], [1, 2], [2, 3], [3, 0]] };
  assert.match(oracle.check(square, halves, { domain: outline, claim: 'cdt' }).text, /^holds: cdt mesh/m);
  assert.deepEqual(Array.from(oracle.constrainedDelaunay(outline).simplices), [0, 1, 2, 0, 2, 3]);
  const corners = [0, 1].flatMap((z) => [[0, 0, z], [1, 0, z], [1, 1, z], [0, 1, z]]);
  const cube = { points: corners, polygons: [[0, 1, 2, 3], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]] };
  const { simplices, vertices } = oracle.constrainedDelaunay(cube);
  assert.equal(oracle.check(corners, simplices, { domain: cube, claim: 'cdt', vertices }).holds, true);
  assert.equal(oracle.check(corners, simplices.slice(4), { domain: cube, claim: 'cdt', vertices }).holds, false);
  assert.throws(() => oracle.constrainedDelaunay({ points: square, segments: [[0, 2], [1, 3]], kind: 'hull' }), oracle.InputError);
});

test('references, comparisons, certificates and drawn points', () => {
  const { simplices } = oracle.delaunay(square);
  assert.equal(oracle.compare({ points: square, simplices }, { points: square, simplices: halves }).same, true);
  assert.equal(oracle.compare({ points: square, simplices: [[0, 1, 3], [1, 2, 3]] }, { points: square, simplices: halves }).same, false);
  assert.match(oracle.certify(square, halves).text, /certificate/);
  const drawn = oracle.generate('circle', { count: 12, seed: 3 });
  assert.deepEqual(drawn, oracle.generate('circle', { count: 12, seed: 3 }));
  assert.equal(oracle.check(drawn.points, oracle.delaunay(drawn.points, { dimension: 2 }).simplices, { dimension: 2 }).holds, true);
  assert.throws(() => oracle.generate('no-such-family'), TypeError);
});

test('matchers pass and fail as they say, with the witness in the message', () => {
  assert.equal(matchers.toBeDelaunay({ points: square, triangles: halves }).pass, true);
  const wrong = matchers.toBeTriangulation({ points: square, triangles: halves.slice(1) });
  assert.equal(wrong.pass, false);
  assert.match(wrong.message(), /triangulation\.unused-point/);
});

test('a page with pictures, where it is asked for', () => {
  const verdict = oracle.check([[0, 0], [1, 0], [0, 1], [0.9, 0.9]], [[0, 1, 2], [1, 3, 2]], { pictures: true });
  assert.match(verdict.page, /^<!DOCTYPE html>/);
  assert.equal(oracle.check(square, halves).page, undefined);
});

test('require() brings the same', () => {
  const required = createRequire(import.meta.url)(join(folder, 'index.cjs'));
  assert.equal(required.check(square, halves).text, oracle.check(square, halves).text);
});

// Meshes of the corpus whose points are doubles, and what is known of them.
test('the corpus is judged as its table says', () => {
  const rowsOf = (file) => readFileSync(join(corpus, file), 'utf8').split('\n').map((line) => line.replace(/#.*/, '').trim())
    .filter(Boolean).map((line) => line.split(/\s+/));
  let judged = 0;
  for (const line of readFileSync(join(corpus, 'expected.tsv'), 'utf8').trim().split('\n')) {
    const [name, claim, expected] = line.split('\t');
    if (!/^(accept|reject)\/[^ ]*\.ele$/.test(name) || !/^(delaunay|triangulation|complex)$/.test(claim)) continue;
    if (expected !== 'holds' && !expected.includes('.')) continue;  // the input is at fault
    const [[, dimension, attributes], ...nodes] = rowsOf(name.replace(/ele$/, 'node'));
    const [, ...cells] = rowsOf(name);
    if (attributes !== '0' || nodes.length === 0 || cells.length === 0) continue;
    const numbers = nodes.map((row) => row.slice(1, 1 + Number(dimension)));
    if (numbers.flat().some((text) => !/^[-+.\de]+$/i.test(text))) continue;
    const first = Number(nodes[0][0]);
    const verdict = oracle.check(numbers.map((row) => row.map(Number)), cells.map((row) => row.slice(1).map((v) => Number(v) - first)),
      { claim, maxViolations: 0, duplicates: claim === 'complex' ? undefined : 'merge' });
    assert.equal(verdict.holds ? 'holds' : Object.keys(verdict.rules).sort().join(' '), expected.split(',').sort().join(' '), `${name} ${claim}`);
    ++judged;
  }
  assert.ok(judged > 100, `${judged} meshes`);
});
