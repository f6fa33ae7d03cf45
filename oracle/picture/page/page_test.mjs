// Opens pages in Chromium as their readers do, and looks at what happens.
//   node page_test.mjs COMMAND FOLDER           six pages, and what can be done with them
//   node page_test.mjs COMMAND FOLDER --all     a page for every mesh of the corpus that breaks a
// rule COMMAND is circumspect; pages and screenshots are left in FOLDER. The modules are in the
// folder that NODE_PATH names.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { copyFileSync, mkdirSync, readFileSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const modules = resolve(process.env.NODE_PATH);
const require = createRequire(join(modules, 'none.js'));
const { chromium } = require('playwright-core');
const axe = readFileSync(join(modules, 'axe-core', 'axe.min.js'), 'utf8');

const [command, folder, mode] = process.argv.slice(2);
const root = resolve(dirname(fileURLToPath(import.meta.url)), '..', '..', '..');
const corpus = join(root, 'corpus');
mkdirSync(folder, { recursive: true });

// Writes a page; verdicts that fail are what is wanted, and inputs that are at fault.
function written(name, words, subcommand = 'check') {
  const file = join(folder, `${name}.html`);
  const found = execFileSync('bash', ['-c', '"$@" >/dev/null; echo $?', 'run', command, subcommand, ...words,
    '--html', file], { cwd: root, encoding: 'utf8' });
  assert.ok(['0', '1', '3'].includes(found.trim()), `circumspect ${subcommand} ${words.join(' ')} ended with ${found}`);
  return file;
}

// A page that was opened; whatever a console says or a network is asked for is a fault.
class Opened {
  static async at(browser, file, options = {}) {
    const opened = new Opened();
    opened.faults = [];
    opened.page = await browser.newPage({ viewport: { width: 1000, height: 900 }, ...options });
    opened.page.setDefaultTimeout(120_000); // pictures in space are drawn without a graphics card, and the machine may be busy
    opened.page.on('pageerror', (error) => opened.faults.push(String(error.stack)));
    opened.page.on('console', (message) => {
      // How fast a software renderer is asked for its pixels is a matter of screenshots.
      if (!message.text().includes('GPU stall due to ReadPixels')) opened.faults.push(message.text());
    });
    opened.page.on('dialog', (dialog) => {
      opened.faults.push(`a dialog: ${dialog.message()}`);
      dialog.dismiss();
    });
    const url = pathToFileURL(file).href;
    opened.page.on('request', (request) => {
      if (request.url().split('#')[0] !== url) opened.faults.push(`a request for ${request.url()}`);
    });
    await opened.page.goto(url);
    await opened.page.waitForSelector('body[data-ready]');
    return opened;
  }

  async accessible() {
    await this.page.evaluate(axe);
    const { violations } = await this.page.evaluate(() => window.axe.run());
    assert.deepEqual(violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.html).join(' | ').slice(0, 300)}`), []);
  }

  shot(name) { return this.page.screenshot({ path: join(folder, `${name}.png`) }); }

  async done() {
    assert.deepEqual(this.faults, []);
    await this.page.close();
  }
}

// The pixels of the first picture, to tell whether they change.
const pixels = async (page) => (await page.locator('.view').first().screenshot()).toString('base64');

async function changes(page, what, act) {
  const before = await pixels(page);
  await act();
  assert.notEqual(await pixels(page), before, `${what} changes nothing`);
}

async function inSpace(browser) {
  const opened = await Opened.at(browser, written('space', ['corpus/reject/delaunay.facet-not-local.ele']));
  const { page } = opened;
  assert.equal(await page.locator('.view canvas').count(), 1, 'there is no WebGL');
  await opened.shot('space');
  const view = page.locator('.view').first();
  await changes(page, 'dragging', async () => {
    const box = await view.boundingBox();
    await page.mouse.move(box.x + 300, box.y + 200);
    await page.mouse.down();
    await page.mouse.move(box.x + 400, box.y + 260);
    await page.mouse.up();
  });
  await changes(page, 'an arrow key', () => page.keyboard.press('ArrowLeft'));
  await changes(page, 'plus', () => page.keyboard.press('+'));
  const slide = (words, to) => page.getByLabel(words).first().evaluate((input, value) => {
    input.value = value;
    input.dispatchEvent(new Event('input'));
  }, to);
  await changes(page, 'exploding', () => slide('Explode', 1));
  await changes(page, 'cutting away', () => slide('Cut away', 0.5));
  await changes(page, 'leaving the labels out', () => page.getByRole('button', { name: 'Labels' }).first().click());
  await page.getByRole('button', { name: 'Reset' }).first().click();
  await opened.accessible();
  await changes(page, 'the dark theme', () => page.getByRole('button', { name: 'Dark' }).click());
  await opened.accessible();
  await opened.shot('space-dark');
  await page.setViewportSize({ width: 320, height: 640 });
  const width = await page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(width <= 320, `a screen of 320 pixels is scrolled sideways: ${width}`);
  await opened.shot('space-narrow');
  await opened.done();
}

// A mesh of the plane with a name that would do harm, and several violations.
async function inThePlane(browser) {
  const name = '<img src=x onerror=alert(1)><script>alert(2)<!--';
  const stem = join(corpus, 'accept', 'triangulation-anisotropic-2d');
  const hostile = resolve(folder, `${name}.ele`);
  copyFileSync(`${stem}.ele`, hostile);
  copyFileSync(`${stem}.node`, hostile.replace(/ele$/, 'node'));
  const opened = await Opened.at(browser, written('plane', [hostile]));
  const { page } = opened;
  assert.equal((await page.locator('h2').first().textContent()).endsWith(`${name}.ele`), true);
  assert.equal(await page.locator('main img, main script').count(), 0);
  assert.equal(await page.locator('.view canvas').count(), 0);
  await page.getByRole('button', { name: 'Next violation' }).click();
  await page.keyboard.press('n');
  assert.equal(await page.evaluate(() => document.activeElement.id), 'violation-2');
  await page.keyboard.press('Tab');
  await page.keyboard.press('Tab');
  assert.equal(await page.evaluate(() => document.activeElement.className), 'view');
  const before = await page.locator('#violation-2 .view svg').innerHTML();
  await page.keyboard.press('ArrowRight');
  assert.notEqual(await page.locator('#violation-2 .view svg').innerHTML(), before);
  await page.locator('#violation-2 h3 a').click();
  assert.match(page.url(), /#rule-delaunay\.facet-not-local$/);
  await page.getByRole('button', { name: 'Copy as JSON' }).first().click();
  await page.getByRole('button', { name: 'Copied' }).waitFor();
  await opened.accessible();
  await opened.shot('plane');
  await opened.done();
}

// Two meshes of one cube: cells that differ, in the colours of the meshes.
async function ofTwoMeshes(browser) {
  const opened = await Opened.at(browser, written('compare',
    ['corpus/peers/tetgen/cube-3d.1.ele', 'corpus/peers/cgal/cube-3d.ele'], 'compare'));
  const { page } = opened;
  assert.equal(await page.locator('.legend .key.first').count(), 1);
  assert.equal(await page.locator('.legend .key.second').count(), 1);
  assert.equal(await page.locator('.caption:empty').count(), 0);
  assert.match(await page.locator('.legend').first().textContent(), /only in A: .*only in B: /);
  await page.getByRole('button', { name: 'Next difference' }).click();
  assert.equal(await page.evaluate(() => document.activeElement.id), 'violation-1');
  await opened.accessible();
  await opened.shot('compare');
  await opened.done();
}

// A mesh of more simplices than the picture of a witness shows: first all of it, with a dot where
// the violations are.
async function ofTheWhole(browser) {
  const stem = join(folder, 'whole');
  const points = Array.from({ length: 121 }, (_, i) => `${i} ${i % 11} ${Math.floor(i / 11)}`);
  const triangles = Array.from({ length: 100 }, (_, i) => Math.floor(i / 10) * 11 + (i % 10))
    .flatMap((corner) => [[corner, corner + 1, corner + 12], [corner, corner + 12, corner + 11]]);
  triangles.splice(110, 1);
  writeFileSync(`${stem}.node`, `121 2\n${points.join('\n')}\n`);
  writeFileSync(`${stem}.ele`, `199 3\n${triangles.map((corners, i) => `${i} ${corners.join(' ')}`).join('\n')}\n`);
  const opened = await Opened.at(browser, written('whole', [`${stem}.ele`]));
  const { page } = opened;
  const card = page.locator('.card.whole');
  assert.equal(await card.locator('polygon.skin').count(), 199);
  // The three edges of the hole, which are in the upper half.
  const marks = await card.locator('text.place').allTextContents();
  assert.equal(marks.flatMap((numbers) => numbers.split(/, |–/)).sort()[0], '1');
  const [box, dot] = [await card.locator('.view').boundingBox(), await card.locator('circle.place').first().boundingBox()];
  assert.ok(dot.y < box.y + box.height / 2, 'the dot is where the hole is');
  await page.keyboard.press('n');
  assert.equal(await page.evaluate(() => document.activeElement.id), 'violation-1');
  await opened.accessible();
  await opened.shot('whole');
  await opened.done();
}

// A domain that is none: its polygons are filled, and lie in the place of the picture.
async function ofADomain(browser) {
  const opened = await Opened.at(browser, written('inspect', ['corpus/domains/invalid/plc.polygons-cross.poly'], 'inspect'));
  const { page } = opened;
  assert.match(await page.locator('.legend').first().textContent(), /polygon 1 \(line \d+\)polygon 2/);
  assert.match(await page.locator('.caption').first().textContent(), /^Polygon 1 \(line \d+\), polygon 2/);
  assert.match(await page.locator('table').first().textContent(), /plc\.polygons-cross/);
  await opened.accessible();
  await opened.shot('inspect');
  await opened.done();
}

// A mesh that a lattice repeats: three corners are copies of one point.
async function ofCopies(browser) {
  const words = ['corpus/periodic/flat.ele', '--claim', 'periodic-delaunay', '--box', '0,0,1,1'];
  const opened = await Opened.at(browser, written('copies', words));
  const { page } = opened;
  assert.match(await page.locator('.card h3').first().textContent(), /simplex\.degenerate/);
  const table = await page.locator('table').filter({ hasText: 'The witness, exactly' }).first().textContent();
  for (const at of ['0,\n0', '1,\n0', '2,\n0']) assert.ok(table.includes(`corner of the simplex: 0${at}`), table);
  await opened.done();
}

// A construction, step by step: by buttons, keys and the slider.
async function ofSteps(browser) {
  const points = join(folder, 'steps.node');
  writeFileSync(points, '5 2\n1 0 0\n2 1 0\n3 0 1\n4 1 1\n5 0.5 0.25\n');
  const opened = await Opened.at(browser, written('steps', ['delaunay', points, '--algorithm', 'flips'], 'build'));
  const { page } = opened;
  const at = async (pattern) => assert.match(await page.locator('#step').textContent(), pattern);
  await at(/^Step 1 of 8\. The first simplex/);
  await changes(page, 'the next step', () => page.getByRole('button', { name: 'Next step' }).click());
  await at(/^Step 2 of 8\. Insert a vertex\. Vertex 4 lies outside/);
  await changes(page, 'the key for the next step', () => page.keyboard.press('.'));
  await at(/^Step 3 of 8\. Flip algorithm\. The facet 2 3 is not locally Delaunay/);
  assert.equal(await page.locator('.view ellipse.ball').count(), 1, 'the ball of the facet is drawn');
  await page.keyboard.press(',');
  await at(/^Step 2 of/);
  await page.getByLabel('Step', { exact: true }).focus();
  await page.keyboard.press('End');
  await at(/^Step 8 of 8\. Done\. The triangulation has 4 triangles/);
  await page.getByRole('button', { name: 'Play' }).click();
  await page.locator('#step', { hasText: 'Step 2 of' }).waitFor();
  await page.getByRole('button', { name: 'Pause' }).click();
  await opened.accessible();
  await opened.shot('steps');
  await opened.done();
}

// What the corpus says that is wrong on purpose: the words of `check` for each of its meshes.
function rejected() {
  const rows = (file) => readFileSync(join(corpus, file), 'utf8').trim().split('\n').map((line) => line.split('\t'));
  const words = [];
  for (const [mesh, claim] of rows('expected.tsv')) {
    if (!mesh.startsWith('reject/')) continue;
    const [name, ...options] = claim.split(' ');
    words.push([`corpus/${mesh}`, '--claim', name, ...options]);
  }
  for (const [mesh, domain, claim] of rows('domains/expected.tsv')) {
    if (!mesh.startsWith('reject/')) continue;
    const [file, ...kinds] = domain.split(' ');
    const [name, ...options] = claim.split(' ');
    words.push([`corpus/domains/${mesh}`, '--domain', `corpus/domains/${file}`, '--claim', name, ...options,
      ...kinds.filter((kind) => ['hull', 'enclosed'].includes(kind)).flatMap((kind) => ['--domain-kind', kind])]);
  }
  const optionsOf = (text) => text.split(' ').filter(Boolean);
  for (const [mesh, sites, options, verdict] of rows('voronoi/expected.tsv')) {
    if (verdict === 'holds') continue;
    words.push([`corpus/voronoi/${mesh}`, '--points', `corpus/voronoi/${sites}`, '--claim', 'voronoi', ...optionsOf(options)]);
  }
  for (const [mesh, options, verdict] of rows('periodic/expected.tsv')) {
    if (verdict === 'holds') continue;
    words.push([`corpus/periodic/${mesh}`, '--claim', 'periodic-delaunay', ...optionsOf(options)]);
  }
  return words;
}

async function everything(browser) {
  const seen = new Set();
  for (const [i, words] of rejected().entries()) {
    const file = written(`reject-${i}`, words);
    assert.ok(statSync(file).size < 1e6, `${file} is large`);
    const opened = await Opened.at(browser, file);
    const rules = await opened.page.locator('.card h3 a').allTextContents();
    const isNew = rules.some((rule) => !seen.has(rule));
    for (const rule of rules) seen.add(rule);
    const blank = await opened.page.locator('.caption:empty').count();
    assert.equal(blank, 0, `${words.join(' ')}: a picture without words`);
    const numbers = await opened.page.evaluate(() => document.querySelector('main').innerHTML.match(/NaN|undefined|Infinity/));
    assert.equal(numbers, null, words.join(' '));
    if (isNew) {
      await opened.accessible();
      await opened.page.locator('section').first().screenshot({ path: join(folder, `${rules[0]}.png`) });
    }
    await opened.done();
  }
  const listed = JSON.parse(execFileSync(command, ['rule', '--format', 'json'], { encoding: 'utf8' })).results;
  const never = listed.map(({ rule }) => rule).filter((rule) => !rule.startsWith('plc.') && !seen.has(rule));
  assert.deepEqual(never, [], 'rules without a picture');
}

// Browsers that have no WebGL draw all the same.
async function withoutWebGl() {
  const browser = await chromium.launch({ executablePath: '/usr/bin/chromium', args: ['--no-sandbox', '--disable-3d-apis'] });
  const file = join(folder, 'space.html');
  const page = await browser.newPage();
  page.setDefaultTimeout(120_000);
  await page.goto(pathToFileURL(file).href);
  await page.waitForSelector('body.no-webgl[data-ready]');
  const image = page.locator('.view svg').first();
  const before = await image.innerHTML();
  await page.locator('.view').first().focus();
  await page.keyboard.press('ArrowUp');
  assert.notEqual(await image.innerHTML(), before);
  assert.ok(await page.locator('.no-webgl-note').isVisible());
  await browser.close();
}

// A script that got into the page all the same is refused: the policy names the page's own by its
// hash.
async function withAnIntruder(browser) {
  const opened = await Opened.at(browser, join(folder, 'space.html'));
  const ran = await opened.page.evaluate(() => {
    const script = document.createElement('script');
    script.textContent = 'window.intruder = true';
    document.body.append(script);
    return window.intruder === true;
  });
  assert.equal(ran, false);
  assert.match(opened.faults.join('\n'), /Content Security Policy/);
  await opened.page.close();
}

const browser = await chromium.launch({ executablePath: '/usr/bin/chromium', args: ['--no-sandbox'] });
try {
  await inSpace(browser);
  await withAnIntruder(browser);
  await inThePlane(browser);
  await ofTwoMeshes(browser);
  await ofTheWhole(browser);
  await ofADomain(browser);
  await ofCopies(browser);
  await ofSteps(browser);
  if (mode === '--all') {
    await everything(browser);
    await withoutWebGl();
  }
} finally {
  await browser.close();
}
