// What the package has besides its sources: its version, its licences, and the modules for require().
//   node pack.mjs SOURCES PACKAGE VERSION LICENCES LICENCE     esbuild is in NODE_PATH
import { createRequire } from 'node:module';
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';

const esbuild = createRequire(join(resolve(process.env.NODE_PATH.split(':')[0]), 'none.js'))('esbuild');
const [sources, folder, version, licences, licence] = process.argv.slice(2);
const read = (...path) => readFileSync(join(...path), 'utf8');

const described = JSON.parse(read(sources, 'package.json'));
writeFileSync(join(folder, 'package.json'), `${JSON.stringify({ ...described, version }, null, 2)}\n`);
const texts = [['Circumspect', read(licence)], ...readdirSync(licences).sort().map((name) => [name, read(licences, name)])];
writeFileSync(join(folder, 'LICENSES.txt'), texts.map(([name, text]) =>
  `${'='.repeat(78)}\n${name}\n${'='.repeat(78)}\n${text.trim()}\n`).join('\n'));
// One copy of the library for all of them: they ask #index, which is index.cjs for require().
for (const name of ['index', 'matchers', 'jest', 'arbitraries']) {
  esbuild.buildSync({ bundle: true, platform: 'node', format: 'cjs', target: 'node18', charset: 'ascii',
    define: { 'import.meta.url': 'url' }, banner: { js: "const url = require('node:url').pathToFileURL(__filename).href;" },
    external: ['#index', '@jest/globals', 'fast-check'], entryPoints: [join(sources, `${name}.mjs`)], outfile: join(folder, `${name}.cjs`) });
  writeFileSync(join(folder, `${name}.d.cts`), read(sources, `${name}.d.ts`).replaceAll(/'(\.\/\w+)\.js'/g, "'$1.cjs'"));
}
