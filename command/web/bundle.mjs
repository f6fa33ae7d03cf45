// Makes of the compiled command, and of the sources beside this, one page that needs no server and
// no other file.
//   node bundle.mjs BUILD OUTPUT
// BUILD has circumspect.js, circumspect.wasm and licences/; esbuild is in NODE_PATH.
import { createHash } from 'node:crypto';
import { createRequire } from 'node:module';
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

const here = dirname(fileURLToPath(import.meta.url));
const page = join(here, '..', '..', 'oracle', 'picture', 'page');
const esbuild = createRequire(join(resolve(process.env.NODE_PATH.split(':')[0]), 'none.js'))('esbuild');
const [build, output] = process.argv.slice(2);
const read = (...path) => readFileSync(join(...path), 'utf8');

const bundled = (name) => esbuild.buildSync({ entryPoints: [join(here, name)], bundle: true, minify: true, write: false,
  charset: 'ascii', loader: { '.poly': 'text', '.node': 'text', '.ele': 'text' }, format: 'iife', target: 'es2022', legalComments: 'inline' }).outputFiles[0].text.trim();
const inScript = (text) => text.replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');
const style = esbuild.transformSync(['page.css', 'roles.css'].map((name) => read(page, name)).join('') + read(here, 'web.css'),
  { loader: 'css', minify: true });

// The claims are those that the command knows.
const rows = read(here, '..', '..', 'oracle', 'model', 'claim.cpp').matchAll(/\{Claim::\w+, "([a-z-]+)"/g);
const claims = Array.from(rows, ([, claim]) => claim);
if (claims.length === 0) throw new Error('expected a row for each claim in oracle/model/claim.cpp, found none');
// The licences of all that is compiled into the page, and the project's own: one text, which the
// page unpacks when it is asked for.
const packed = (bytes) => gzipSync(bytes, { level: 9 }).toString('base64');
const licences = [['Circumspect', read(here, '..', '..', 'LICENSE')],
  ...readdirSync(join(build, 'licences')).sort().map((name) => [name, read(build, 'licences', name)])]
  .map(([name, text]) => `${'='.repeat(78)}\n${name}\n${'='.repeat(78)}\n${text.trim()}\n`).join('\n');
const parts = {
  style: style.code.trim(),
  claims: claims.map((claim) => `<option>${claim}</option>`).join(''),
  worker: inScript(`${read(build, 'circumspect.js')}\n${bundled('worker.js')}`),
  wasm: packed(readFileSync(join(build, 'circumspect.wasm'))),
  licences: packed(licences),
  script: inScript(bundled('app.js')),
};
// The page runs its own script and, in a frame that inherits its policy, that of the pages of
// pictures: no other, whatever gets into it.
parts.hash = `sha256-${createHash('sha256').update(parts.script).digest('base64')}`;
[parts['hash of pictures']] = read(page, 'page.built.html').match(/sha256-[\w+/]+=/);
writeFileSync(output, read(here, 'web.html').replace(/\{\{(style|claims|worker|wasm|licences|script|hash|hash of pictures)\}\}/g, (_, name) => parts[name]));
