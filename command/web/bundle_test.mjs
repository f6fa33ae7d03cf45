// Does the page that bundle.mjs makes allow its own scripts and no others, and offer the claims
// that the command knows? What is compiled takes minutes and is not looked at: something else is in
// its place.
//   node bundle_test.mjs COMMAND        The modules are in the first folder that NODE_PATH names.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const command = resolve(process.argv[2]);
const folder = mkdtempSync(join(tmpdir(), 'web-bundle-'));
try {
  mkdirSync(join(folder, 'licences'));
  for (const [name, text] of [['circumspect.js', 'const circumspect = "</script>";'], ['circumspect.wasm', '\0asm\x01\0\0\0'],
    ['licences/some', 'A licence']]) writeFileSync(join(folder, name), text);
  execFileSync(process.execPath, [join(here, 'bundle.mjs'), folder, join(folder, 'index.html')]);
  const page = readFileSync(join(folder, 'index.html'), 'utf8');
  const hashes = (html) => [...html.matchAll(/<script>([^]*?)<\/script>/g)]
    .map(([, script]) => `'sha256-${createHash('sha256').update(script).digest('base64')}'`);
  const own = hashes(page);
  const ofPictures = hashes(readFileSync(join(here, '..', '..', 'oracle', 'picture', 'page', 'page.built.html'), 'utf8'));
  assert.deepEqual([own.length, ofPictures.length], [1, 1]);
  assert.equal(page.match(/script-src ([^;]*);/)[1], `${own[0]} ${ofPictures[0]} 'wasm-unsafe-eval'`);

  const said = spawnSync(command, ['check', 'x.ele', '--claim', 'none-of-them'], { encoding: 'utf8' }).stderr;
  const known = said.match(/--claim: expected ([a-z|-]+), found/)[1].split('|');
  const offered = [...page.matchAll(/<option>([a-z-]+)<\/option>/g)].map(([, claim]) => claim);
  assert.deepEqual(offered.sort(), known.sort());
} finally {
  rmSync(folder, { recursive: true });
}
