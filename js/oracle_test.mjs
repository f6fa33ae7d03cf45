// What the package answers, as its users ask it:   node --test js/oracle_test.mjs
// CIRCUMSPECT_PACKAGE is the folder of it.
import assert from 'node:assert/strict';
import { copyFileSync, mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
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
  const all = oracle.check([[0, 0], [1, 0], [0, 1], [0.9, 0.9]], [[0, 1, 2], [1, 3, 2]], { maxViolations: Infinity });
  assert.equal(all.violations.length, 1);
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
  fails([square, [[0, 1, NaN]]], RangeError, /expected indices of points as simplices, found NaN/);
  fails([square, [[0, 1, '2']]], RangeError, /expected indices of points as simplices, found "2"/);
  fails([square.flat(), [0, 1, 2], { dimension: 1.6 }], RangeError, /expected how long a row of points is, at least 1, found 1.6/);
  fails([square, halves, { limit: -1 }], RangeError, /expected a limit in seconds, above 0, found -1/);
  fails([square, halves, { domain: { points: square, segments: [[0, 2 ** 40]] } }], RangeError, /segments, found one beyond 32 bits/);
  fails([square, halves, { domain: { points: square, polygonHoles: { first: [[0, 0, 0]] } } }], RangeError, /keys of polygonHoles/);
  fails([square, halves, { clam: 'cdt' }], TypeError, /found clam/);
  fails([square, halves, 'cdt'], TypeError, /expected options as an object, found "cdt"/);
  fails([new Set(square), halves], TypeError, /expected points as an array, found \[object Set\]/);
  fails([square, halves, { maxViolations: 2 ** 32 + 1 }], RangeError, /expected maxViolations as a whole number .* found 4294967297/);
  fails([square, halves, { claim: 'nonsense' }], TypeError, /expected a claim about a mesh/);
  fails([square, halves, { weights: [1] }], RangeError, /a weight for each of 4 points, found 1/);
  fails([[[null, 0], [1, 0]], [[0, 1]]], TypeError, /found null/);
  const gone = Float64Array.from(square.flat());
  structuredClone(gone.buffer, { transfer: [gone.buffer] });
  fails([gone, [0, 1, 2], { dimension: 2 }], TypeError, /expected points, found an array whose buffer was detached or made smaller: pass a copy/);
  fails([square, gone, { vertices: 3 }], TypeError, /expected simplices, found an array whose buffer was detached/);
  const shrinking = new ArrayBuffer(64, { maxByteLength: 64 });
  const small = new Float64Array(shrinking, 0, 8);
  shrinking.resize?.(8);  // in Node 18 none can
  // What is not a list of segments is not a domain without segments.
  for (const segments of [new Set([[0, 2]]), 7, gone, ...(small.length === 0 ? [small] : [])]) {
    fails([square, halves, { domain: { points: square, segments, kind: 'hull' } }], TypeError, /expected segments/);
  }
  fails([square, halves, { domain: { points: square, polygons: [gone] } }], TypeError, /expected a polygon, found an array whose buffer was detached/);
  assert.throws(() => oracle.generate('uniform', { count: 2 ** 32 + 5 }), /^RangeError: expected count as a whole number .* found 4294967301$/);
});

test('an input at fault is an InputError; a fault of the mesh is a verdict', () => {
  assert.throws(() => oracle.check([...square, [0, 0]], [[0, 1, 2], [4, 2, 3]]), oracle.InputError);
  // Advice is in the words of this package.
  assert.throws(() => oracle.check([...square, [0, 0]], [[0, 1, 2], [4, 2, 3]]), /take equal points for one, give duplicates: 'merge'$/);
  assert.throws(() => oracle.check([], [], { dimension: 2, vertices: 3 }), /judge an empty mesh, give allowEmpty: true$/);
  assert.throws(() => oracle.check(square, halves, { exceptSharp: '60deg' }), /beside `exceptSharp`, found none$/);
  const merged = oracle.check([...square, [0, 0]], [[0, 1, 2], [4, 2, 3]], { duplicates: 'merge' });
  assert.equal(merged.holds, true);
  assert.equal(merged.notes.length, 1);
  assert.throws(() => oracle.check([[0, 0], [1, NaN], [0, 1]], [[0, 1, 2]]), oracle.InputError);
  assert.throws(() => oracle.check([], []), Error);
  // Whatever an index is that names no point: libraries write 4294967295 for none.
  for (const none of [9, -1, 2 ** 32 - 1, 2 ** 40, 12345678901234n]) {
    assert.deepEqual(oracle.check(square, [[0, 1, none]]).rules, { 'triangulation.unknown-vertex': 1, 'triangulation.unused-point': 2 });
  }
  assert.match(oracle.check(square, Uint32Array.of(0, 1, 2 ** 32 - 1), { vertices: 3 }).text, / vertex   4294967295$/m);
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

test('demands beside the claim, and an end after a time', () => {
  assert.deepEqual(oracle.check(square, halves, { require: 'min-angle:45deg' }).holds, true);
  assert.deepEqual(Object.keys(oracle.check(square, halves, { require: ['min-angle:46deg'] }).rules), ['quality.min-angle']);
  const apart = [[0, 0], [1, 0], [0, 1], [5, 5], [6, 5], [5, 6]];
  const parted = oracle.check(apart, [[0, 1, 2], [3, 4, 5]], { claim: 'complex', demands: 'connected' });
  assert.deepEqual(parted.rules, { 'complex.not-connected': 1 });
  const { points } = oracle.generate('uniform', { dimension: 3, count: 1000, seed: 1 });
  const { simplices } = oracle.delaunay(points, { dimension: 3 });
  assert.throws(() => oracle.check(points, simplices, { dimension: 3, byDefinition: true, limit: 1e-6 }), oracle.UndecidedError);
  assert.equal(oracle.check(points, simplices, { dimension: 3 }).holds, true);  // the limit was of one call
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

test('a worker answers as the module does, and says so when it is ended', async () => {
  const { startWorker } = await import(pathToFileURL(join(folder, 'worker.mjs')));
  const worker = await startWorker();
  const verdict = await worker.check(square, halves.slice(1));
  assert.equal(verdict.text, oracle.check(square, halves.slice(1)).text);
  assert.deepEqual(verdict.rules, { 'triangulation.unused-point': 1 });
  assert.ok(verdict instanceof oracle.Verdict);
  assert.equal(await worker.orient([0, 0], [1, 0], [0, 1]), 1);
  await assert.rejects(worker.check([...square, [0, 0]], halves), oracle.InputError);
  await assert.rejects(worker.check(square, halves, { clam: 'cdt' }), TypeError);
  const other = await startWorker();
  const answered = other.version();
  Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, 200);  // the answer lies there, and nobody has read it
  other.end();
  await assert.rejects(answered, /worker was ended: end\(\) was called$/);
  await new Promise((resolve) => { setTimeout(resolve, 50); });  // what it answered is heard now, and nobody waits for it
  const { points } = oracle.generate('uniform', { dimension: 3, count: 300, seed: 1 });
  const long = worker.check(points, oracle.delaunay(points, { dimension: 3 }).simplices, { dimension: 3, byDefinition: true });
  worker.end();
  await assert.rejects(long, /^Error: expected an answer, found that the worker was ended: end\(\) was called$/);
  await assert.rejects(worker.check(square, halves), /expected a worker, found that it was ended: .*; start another/);
});

test('a library that had to end says why, and the next call has another one', async () => {
  const from = (name) => import(pathToFileURL(join(folder, name)));
  const [{ instance }, { oracle: oracleOf }] = [await from('memory.mjs'), await from('oracle.mjs')];
  const code = new WebAssembly.Module(readFileSync(join(folder, 'circumspect.wasm')));
  const lastWords = ['GNU MP: Cannot allocate memory (size=8)\n', 'Assertion failed: holds\n'];
  const tried = oracleOf(() => {
    const { exports, said } = instance(code);
    const words = lastWords.shift();
    const version = () => { said.push(words); throw new WebAssembly.RuntimeError('unreachable'); };
    return { exports: words ? { ...exports, version } : exports, said };
  });
  assert.throws(() => tried.version(), /^RangeError: expected memory for this mesh and its exact numbers, found no more/);
  assert.throws(() => tried.version(), /^Error: internal error: Assertion failed: holds; please report it$/);
  assert.equal(tried.version(), oracle.version());
});

test('where a bundler left the compiled library behind, the error says where it belongs', async () => {
  const bare = mkdtempSync(join(tmpdir(), 'oracle-'));
  for (const name of readdirSync(folder).filter((one) => one.endsWith('.mjs'))) copyFileSync(join(folder, name), join(bare, name));
  await assert.rejects(import(pathToFileURL(join(bare, 'index.mjs'))), /^Error: expected the compiled library as file:.*circumspect\.wasm, found none: /);
  rmSync(bare, { recursive: true });
});

test('the registry shows links that can be followed, and whose package it is', () => {
  const [, ...links] = readFileSync(join(folder, 'README.md'), 'utf8').split('](');
  assert.ok(links.length > 0);
  assert.deepEqual(links.filter((link) => !/^(https:|#)/.test(link)).map((link) => link.split(')')[0]), []);
  const { homepage, repository, bugs, version } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  assert.ok([homepage, repository.url.replace('git+', ''), bugs].every((address) => address.startsWith('https://')));
  assert.ok(homepage.includes(`/v${version}/`));
});

test('where it was built is not in the compiled library', () => {
  const here = resolve(dirname(fileURLToPath(import.meta.url)), '..');
  assert.ok(!readFileSync(join(folder, 'circumspect.wasm')).includes(here), `expected no ${here}: remove the folder "build" of \`make web\``);
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
