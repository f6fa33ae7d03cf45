// Holds the command that was compiled for the web to what the command prints, and uses the page as
// people do.
//   node web_test.mjs FOLDER            a slice of the golden bytes of the corpus; the page in
// Chromium
//   node web_test.mjs FOLDER --all      all golden bytes
//   node web_test.mjs FOLDER --page     the page in Chromium alone
//   node web_test.mjs FOLDER --times [COMMAND]    how large the page is, how long some verdicts
// take in Node, and how many times
//                                                 as long as by COMMAND on one thread
// FOLDER has index.html, circumspect.js and circumspect.wasm. The modules are in the first folder
// that NODE_PATH names.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { gunzipSync, gzipSync } from 'node:zlib';
import { judge } from './judge.mjs';

const [folder, mode, native] = process.argv.slice(2);
const root = resolve(dirname(fileURLToPath(import.meta.url)), '..', '..');
const modules = resolve(process.env.NODE_PATH.split(':')[0]);
const require = createRequire(join(modules, 'none.js'));
const make = createRequire(import.meta.url)(resolve(folder, 'circumspect.js'));
const code = new WebAssembly.Module(readFileSync(join(folder, 'circumspect.wasm')));
const text = (bytes) => new TextDecoder().decode(bytes);

const corpus = join(root, 'corpus');
function filesOf(path) {
  return readdirSync(join(corpus, path), { withFileTypes: true }).flatMap((entry) => {
    const name = join(path, entry.name);
    return entry.isDirectory() ? filesOf(name) : entry.isFile() ? [{ name, bytes: readFileSync(join(corpus, name)) }] : [];
  });
}

async function golden(every) {
  const rows = readFileSync(join(corpus, 'golden.tsv'), 'utf8').trimEnd().split('\n').map((line) => line.split('\t'));
  const files = filesOf('.');
  const wrong = [];
  let tried = 0;
  for (const [i, [line, exit, digest, last]] of rows.entries()) {
    if (i % every !== 0 || line.startsWith('generate ')) continue;  // a page has no `generate`
    // A count beyond 32 bits is named as the largest of them: only the exit code is the same.
    const namesLargeCount = /-of-a-trillion\.|node-attributes-overflow/.test(line);
    ++tried;
    const words = line.split(' ');
    // Of the folders that the line names, all files, for many are read unnamed beside another.
    const folders = new Set(words.filter((word) => word.includes('/')).map((word) => dirname(word)));
    const answer = await judge(make, code, words, files.filter(({ name }) => folders.has(dirname(name))));
    const found = createHash('sha256').update(answer.out).update('\0').update(answer.err).digest('hex').slice(0, 16);
    if (String(answer.exit) !== exit || (found !== digest && !namesLargeCount)) {
      wrong.push(`${line}\n  expected exit code ${exit}, ${last || digest}\n  found    exit code ${answer.exit}, ` +
        `${(text(answer.out) + text(answer.err)).trimEnd().split('\n').at(-1).slice(0, 300)}`);
    }
  }
  console.log(`golden bytes: ${tried} command lines, ${wrong.length} differ`);
  assert.equal(wrong.length, 0, `\n${wrong.slice(0, 20).join('\n')}`);
}

const html = join(folder, 'index.html');

// What the command says that it is made of has its licence in the page.
const licenceOf = { GMP: 'libgmp-dev', MPFR: 'libmpfr-dev', CGAL: 'libcgal-dev', CaDiCaL: 'libcadical-dev', '{fmt}': 'libfmt-dev',
  CLI11: 'libcli11-dev', 'nlohmann/json': 'nlohmann-json3-dev', pugixml: 'libpugixml-dev', zlib: 'zlib1g-dev' };

// The same sources make the same bytes in any folder.
function tellsNotWhereItWasBuilt() {
  assert.ok(!readFileSync(join(folder, 'circumspect.wasm')).includes(root), `expected no ${root} in circumspect.wasm: remove ${join(folder, 'build')}`);
}

async function licences() {
  const packed = readFileSync(html, 'utf8').match(/<script type="text\/plain" id="licence-texts">([^<]*)</)[1];
  const texts = text(gunzipSync(Buffer.from(packed, 'base64')));
  const version = text((await judge(make, code, ['--version'], [])).out);
  const libraries = version.match(/\((.*)\), commit/)[1].split(', ').filter((name) => name !== 'plain threads');
  assert.ok(libraries.length >= 9, version);
  const names = ['Circumspect', 'three.js', 'emscripten', 'libexpected-dev', 'GPL-3', 'LGPL-3',
    ...libraries.map((library) => licenceOf[library.slice(0, library.lastIndexOf(' '))] ?? `an entry of licenceOf for ${library}`)];
  for (const name of names) assert.ok(texts.includes(`\n${name}\n=`), `the page lacks the licence of ${name}`);
  assert.match(texts, /Boost Software License/);
  console.log(`licences: those of ${libraries.length} libraries and ${names.length - libraries.length} others are in the page`);
}

const axe = () => readFileSync(join(modules, 'axe-core', 'axe.min.js'), 'utf8');

async function opened(browser, faults, link = '', options = {}) {
  const page = await browser.newPage({ viewport: { width: 1000, height: 900 }, ...options });
  page.on('pageerror', (error) => faults.push(String(error.stack)));
  page.on('console', (message) => {
    if (!message.text().includes('GPU stall due to ReadPixels')) faults.push(message.text());
  });
  page.on('request', (request) => {
    if (!/^(file|blob|data|about):/.test(request.url())) faults.push(`a request for ${request.url()}`);
  });
  await page.goto(pathToFileURL(html).href + link);
  await page.waitForSelector('body[data-ready]', { timeout: 60_000 });
  return page;
}

const verdict = async (page, pattern) => {
  await page.waitForFunction((source) => new RegExp(source).test(document.getElementById('verdict')?.textContent ?? ''),
    pattern.source, { timeout: 60_000 });
};

async function accessible(page) {
  await page.evaluate(axe());
  const { violations } = await page.evaluate(() => window.axe.run({ iframes: false }));
  assert.deepEqual(violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.html).join(' | ').slice(0, 300)}`), []);
}

// Neither a script nor a handler that gets into the page is run.
async function runsNothingElse(browser) {
  const refused = [];
  const page = await opened(browser, refused);
  await page.evaluate(() => {
    const script = document.createElement('script');
    script.textContent = 'window.ran = "a script"';
    document.body.append(script);
    document.body.insertAdjacentHTML('beforeend', '<button id="stranger" onclick="window.ran = \'a handler\'">a stranger</button>');
    document.getElementById('stranger').click();
  });
  assert.equal(await page.evaluate(() => window.ran), undefined);
  assert.equal(refused.filter((line) => line.includes('Content Security Policy')).length, 2, refused.join('\n'));
  await page.close();
}

async function inChromium() {
  const { chromium } = require('playwright-core');
  const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox'] });
  const shots = join(folder, 'screenshots');
  mkdirSync(shots, { recursive: true });
  try {
    await runsNothingElse(browser);
    const faults = [];
    const page = await opened(browser, faults);
    // An example, its verdict, its picture, its JSON.
    await page.selectOption('#examples', { index: 1 });
    await verdict(page, /^fails: delaunay wrong\.ele delaunay\.facet-not-local/);
    await page.frameLocator('#pictures').locator('.view').first().waitFor();
    await page.locator('#json summary').click();
    await page.waitForFunction(() => document.querySelector('#json pre').textContent.includes('"facet-not-local') ||
      document.querySelector('#json pre').textContent.includes('delaunay.facet-not-local'));
    assert.equal(JSON.parse(await page.locator('#json pre').textContent()).results[0].verdict, 'fails');
    await page.screenshot({ path: join(shots, 'example.png'), fullPage: true });
    await accessible(page);
    await page.locator('#licences summary').click();
    await page.locator('#licences pre', { hasText: 'GNU LESSER GENERAL PUBLIC LICENSE' }).waitFor();
    // The link has it all.
    await page.getByRole('button', { name: 'Link to all this' }).click();
    await page.waitForFunction(() => location.hash.length > 1);
    const other = await opened(browser, faults, await page.evaluate(() => location.hash));
    await verdict(other, /^fails: delaunay wrong\.ele/);
    assert.equal(await other.locator('#files li').count(), 2);
    await other.close();
    const broken = await opened(browser, faults, '#no-such-state');
    assert.match(await broken.locator('#status').textContent(), /no state that the page knows/);
    await broken.close();
    // Files that are dropped, one with a name that would do harm.
    const stem = join(corpus, 'accept', 'triangulation-anisotropic-2d');
    const bytes = (ending) => readFileSync(`${stem}.${ending}`);
    await page.setInputFiles('#choose', ['ele', 'node'].map((ending) => ({ name: `<img src=x onerror=alert(1)>.${ending}`,
      mimeType: 'text/plain', buffer: bytes(ending) })));
    await page.waitForFunction(() => document.querySelectorAll('#files li').length === 4);
    await page.getByRole('button', { name: 'Run' }).click();
    await verdict(page, /^fails: delaunay <img src=x onerror=alert\(1\)>\.ele/);
    assert.equal(await page.locator('img').count(), 0);
    await page.selectOption('#claim', 'triangulation');
    await page.getByRole('button', { name: 'Run' }).click();
    await verdict(page, /^holds: triangulation/);
    // A pasted mesh whose text is wrong: whose fault it is stands there.
    await page.getByRole('button', { name: 'Paste a file' }).click();
    await page.keyboard.type('2 2 0 0\n1 0 zero\n');
    await page.selectOption('#ask', 'inspect');
    await page.selectOption('#mesh', 'pasted-1.node');
    await page.getByRole('button', { name: 'Run' }).click();
    await verdict(page, /pasted-1\.node:2: expected .*found "?zero/);
    // Drawn points, their triangulation, and an edge that is flipped.
    await page.locator('#draw summary').click();
    const plane = page.locator('.plane');
    const box = await plane.boundingBox();
    for (const [x, y] of [[0.1, 0.5], [0.5, 0.2], [0.9, 0.5], [0.5, 0.75]]) {
      await page.mouse.click(box.x + x * box.width, box.y + y * box.height);
    }
    await page.waitForFunction(() => document.querySelectorAll('.plane .grip').length === 5);
    const shared = page.locator('.plane [data-edge="1 3"]');
    assert.equal(await shared.count(), 1, 'the short diagonal is the Delaunay edge');
    await shared.dispatchEvent('pointerdown');
    await verdict(page, /^fails: delaunay drawn\.ele/);
    await page.screenshot({ path: join(shots, 'drawn.png'), fullPage: true });
    // The steps of an algorithm, and the link to them.
    await page.selectOption('#ask', 'build delaunay');
    await page.selectOption('#mesh', 'drawn.node');
    for (const algorithm of ['bowyer-watson', 'flips', 'lifted-hull', 'gift-wrapping']) {
      await page.selectOption('#algorithm', algorithm);
      await page.getByRole('button', { name: 'Run' }).click();
      await page.waitForFunction((name) => document.getElementById('status').textContent.startsWith('Done: built') &&
        document.getElementById('command').textContent.includes(name), algorithm);
    }
    const steps = page.frameLocator('#pictures');
    await steps.locator('#step', { hasText: /^Step 1 of \d+\. Finish/ }).waitFor();
    await steps.getByRole('button', { name: 'Next step' }).click();
    await steps.locator('#step', { hasText: /^Step 2 of/ }).waitFor();
    await page.getByRole('button', { name: 'Link to all this' }).click();
    await page.waitForFunction(() => document.getElementById('status').textContent.startsWith('The link is in'));
    const linked = await opened(browser, faults, await page.evaluate(() => location.hash));
    await verdict(linked, /^built: delaunay drawn\.node/);
    assert.equal(await linked.locator('#algorithm').inputValue(), 'gift-wrapping');
    await linked.close();
    await page.selectOption('#examples', { label: 'Figure 4.14: a vertex behind a polygon, by FlipInsertPolygon' });
    await verdict(page, /^built: cdt occluded\.poly/);
    await steps.locator('#step', { hasText: 'Begin' }).waitFor();
    // A run that takes long is cancelled, and the page still answers.
    await page.setInputFiles('#choose', [{ name: 'many.node', mimeType: 'text/plain', buffer: Buffer.from(manyPoints(3000)) }]);
    await page.selectOption('#ask', 'build delaunay');
    await page.selectOption('#mesh', 'many.node');
    await page.getByRole('button', { name: 'Run' }).click();
    await page.getByRole('button', { name: 'Cancel' }).click();
    await page.waitForFunction(() => document.getElementById('status').textContent === 'Cancelled.');
    await page.selectOption('#examples', { index: 4 });
    await verdict(page, /dimension|points|generic/);
    // 320 pixels wide, and dark.
    await page.setViewportSize({ width: 320, height: 640 });
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(width <= 320, `a screen of 320 pixels is scrolled sideways: ${width}`);
    await page.emulateMedia({ colorScheme: 'dark' });
    await accessible(page);
    await page.screenshot({ path: join(shots, 'narrow.png'), fullPage: true });
    assert.deepEqual(faults, []);
    console.log('the page in Chromium: what it has to do, it does');
  } finally {
    await browser.close();
  }
}

// Points of a cube with whole coordinates, by a generator that is the same everywhere.
function manyPoints(count) {
  let state = 1;
  const next = () => (state = (state * 48271) % 2147483647) % 1000003;
  return `${count} 3 0 0\n${Array.from({ length: count }, (_, i) => `${i + 1} ${next()} ${next()} ${next()}\n`).join('')}`;
}

// Cells of a grid of n³ cubes, five each, in the pattern that fits from cube to cube; all corners
// of a cube are cospherical, so the mesh is Delaunay.
function gridMesh(n) {
  const at = (x, y, z) => 1 + x + (n + 1) * (y + (n + 1) * z);
  const nodes = [];
  for (let z = 0; z <= n; ++z) for (let y = 0; y <= n; ++y) for (let x = 0; x <= n; ++x) nodes.push(`${at(x, y, z)} ${x} ${y} ${z}`);
  const cells = [];
  for (let z = 0; z < n; ++z) {
    for (let y = 0; y < n; ++y) {
      for (let x = 0; x < n; ++x) {
        const odd = (x + y + z) % 2;
        const v = (i) => at(x + ((i & 1) ^ odd), y + ((i >> 1) & 1), z + ((i >> 2) & 1));
        for (const cell of [[0, 3, 5, 6], [1, 0, 3, 5], [2, 0, 3, 6], [4, 0, 5, 6], [7, 3, 5, 6]]) cells.push(cell.map(v).join(' '));
      }
    }
  }
  return { count: cells.length, node: `${nodes.length} 3 0 0\n${nodes.join('\n')}\n`,
    ele: `${cells.length} 4 0\n${cells.map((cell, i) => `${i + 1} ${cell}\n`).join('')}` };
}

async function times() {
  const size = (bytes) => `${(bytes.length / 1e6).toFixed(2)} MB`;
  const wasm = readFileSync(join(folder, 'circumspect.wasm'));
  const page = readFileSync(html);
  console.log(`circumspect.wasm ${size(wasm)}, packed ${size(gzipSync(wasm, { level: 9 }))}; index.html ${size(page)}, packed ${size(gzipSync(page, { level: 9 }))}`);
  for (const n of [14, 59]) {
    const mesh = gridMesh(n);
    const files = [{ name: 'grid.node', bytes: Buffer.from(mesh.node) }, { name: 'grid.ele', bytes: Buffer.from(mesh.ele) }];
    const start = performance.now();
    const answer = await judge(make, code, ['check', 'grid.ele'], files);
    const seconds = (performance.now() - start) / 1000;
    console.log(`${seconds.toFixed(2)} s  ${text(answer.out).trimEnd().split('\n').at(-1)}${text(answer.err)}`);
    assert.equal(answer.exit, 0);
    if (native) {
      const place = mkdtempSync(join(tmpdir(), 'grid-'));
      for (const file of files) writeFileSync(join(place, file.name), file.bytes);
      const begin = performance.now();
      execFileSync(resolve(native), ['check', '--threads', '1', '--quiet', join(place, 'grid.ele')]);
      console.log(`${(seconds * 1000 / (performance.now() - begin)).toFixed(1)} times as long as ${native} on one thread`);
      rmSync(place, { recursive: true });
    }
  }
}

if (mode === '--all') {
  await golden(1);
} else if (mode === '--times') {
  await times();
} else if (mode === '--page') {
  await inChromium();
} else {
  tellsNotWhereItWasBuilt();
  await licences();
  await golden(20);
  await inChromium();
}
