// The package in Chromium: in a page, and in a worker of it.
//   node browser_test.mjs PACKAGE      playwright-core is in NODE_PATH
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { extname, join, resolve } from 'node:path';

const { chromium } = createRequire(join(resolve(process.env.NODE_PATH.split(':')[0]), 'none.js'))('playwright-core');
const folder = process.argv[2];
const kinds = { '.mjs': 'text/javascript', '.wasm': 'application/wasm', '.html': 'text/html' };
const mesh = '[[0, 0], [1, 0], [0, 1], [0.9, 0.9]], [[0, 1, 2], [1, 3, 2]]';
const asked = `import { check } from './browser.mjs';
const { text } = check(${mesh});`;
const made = {
  '/': '<!DOCTYPE html><title>t</title><script type="module" src="/page.mjs"></script>',
  '/page.mjs': `${asked} document.body.dataset.text = text;
    const worker = new Worker('/asking.mjs', { type: 'module' });
    worker.onmessage = ({ data }) => { document.body.dataset.worker = data; };
    const { startWorker } = await import('./worker.mjs');
    const oracle = await startWorker();
    document.body.dataset.asked = await oracle.check(${mesh});
    oracle.end();
    document.body.dataset.ended = await oracle.check(${mesh}).catch(String);`,
  '/asking.mjs': `${asked} postMessage(text);`,
};
const server = createServer(({ url }, answer) => {
  const isThere = url in made || existsSync(join(folder, url));
  answer.writeHead(isThere ? 200 : 404, { 'content-type': kinds[extname(url)] ?? 'text/html' });
  answer.end(isThere ? made[url] ?? readFileSync(join(folder, url)) : '');
}).listen(0, '127.0.0.1');
await new Promise((done) => { server.once('listening', done); });
const browser = await chromium.launch({ executablePath: '/usr/bin/chromium', args: ['--no-sandbox'] });
try {
  const page = await browser.newPage();
  const faults = [];
  page.on('pageerror', (error) => faults.push(String(error)));
  await page.goto(`http://127.0.0.1:${server.address().port}/`);
  await page.waitForSelector('body[data-worker][data-ended]', { state: 'attached', timeout: 120_000 });
  const found = await page.evaluate(() => ({ ...document.body.dataset }));
  assert.match(found.text, /^fails: delaunay mesh delaunay\.facet-not-local 1 face 1 2 vertex 3$/m);
  assert.equal(found.worker, found.text);
  assert.equal(found.asked, found.text);
  assert.equal(found.ended, 'Error: expected a worker, found that it was ended: end() was called; start another');
  assert.deepEqual(faults, []);
  console.log('browser: a page and its worker judge alike');
} finally {
  await browser.close();
  server.close();
}
