// What the package has besides its sources: where it comes from, its page, its licences, and the
// modules for require().
//   node pack.mjs ROOT PACKAGE VERSION LICENCES     esbuild is in NODE_PATH
import { createRequire } from 'node:module';
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';

const esbuild = createRequire(join(resolve(process.env.NODE_PATH.split(':')[0]), 'none.js'))('esbuild');
const [root, folder, version, licences] = process.argv.slice(2);
const sources = join(root, 'js');
const read = (...path) => readFileSync(join(...path), 'utf8');

const [, home] = read(root, 'pyproject.toml').match(/^Source = "(\S+)"$/m);
const described = { ...JSON.parse(read(sources, 'package.json')), version, homepage: `${home}/blob/v${version}/docs/javascript.md`,
  repository: { type: 'git', url: `git+${home}.git`, directory: 'js' }, bugs: `${home}/issues` };
writeFileSync(join(folder, 'package.json'), `${JSON.stringify(described, null, 2)}\n`);
// As the registry shows it: links lead to the sources of this version, and what says which file an
// example is goes.
writeFileSync(join(folder, 'README.md'), read(root, 'docs', 'javascript.md').replaceAll(/^<!-- file: .*\n/gm, '')
  .replaceAll(/\]\((?!https?:|#)/g, `](${home}/blob/v${version}/docs/`));
const texts = [['Circumspect', read(root, 'LICENSE')], ...readdirSync(licences).sort().map((name) => [name, read(licences, name)])];
writeFileSync(join(folder, 'LICENSES.txt'), texts.map(([name, text]) =>
  `${'='.repeat(78)}\n${name}\n${'='.repeat(78)}\n${text.trim()}\n`).join('\n'));
// One copy of the library for all of them: they ask #index, which is index.cjs for require().
for (const name of ['index', 'matchers', 'jest', 'arbitraries']) {
  esbuild.buildSync({ bundle: true, platform: 'node', format: 'cjs', target: 'node18', charset: 'ascii',
    define: { 'import.meta.url': 'url' }, banner: { js: "const url = require('node:url').pathToFileURL(__filename).href;" },
    external: ['#index', '@jest/globals', 'fast-check'], entryPoints: [join(sources, `${name}.mjs`)], outfile: join(folder, `${name}.cjs`) });
  writeFileSync(join(folder, `${name}.d.cts`), read(sources, `${name}.d.ts`).replaceAll(/'(\.\/\w+)\.js'/g, "'$1.cjs'"));
}
