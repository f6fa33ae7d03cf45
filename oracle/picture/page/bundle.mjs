// Makes page.built.html of the sources beside it: what the command puts its data into. Three.js
// comes from the folder that NODE_PATH names.
//   node bundle.mjs OUTPUT
import { createHash } from 'node:crypto';
import { createRequire } from 'node:module';
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const modules = resolve(process.env.NODE_PATH);
const esbuild = createRequire(join(modules, 'none.js'))('esbuild');
const read = (name) => readFileSync(join(here, name), 'utf8');

const licence = readFileSync(join(modules, 'three', 'LICENSE'), 'utf8').trim();
const options = { bundle: true, minify: true, write: false, charset: 'ascii', nodePaths: [modules], legalComments: 'none' };
const script = esbuild.buildSync({ ...options, entryPoints: [join(here, 'page.js')], format: 'iife', target: 'es2021' });
const style = esbuild.transformSync(read('page.css') + read('roles.css'), { loader: 'css', minify: true });
const roles = [...new Set(read('roles.css').match(/\.[a-z]+(?=[ ,])/g))].map((name) => `<i class="${name.slice(1)}"></i>`);

const parts = {
  style: style.code.trim(),
  colours: roles.join(''),
  script: `/*! With three.js, https://threejs.org:\n${licence}\n*/\n` +
    script.outputFiles[0].text.trim().replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--'),
};
// The page runs this script alone, whatever gets into its data: its policy names the script by its
// hash.
parts.hash = `sha256-${createHash('sha256').update(parts.script).digest('base64')}`;
writeFileSync(process.argv[2], read('page.html').replace(/\{\{(style|colours|script|hash)\}\}/g, (_, name) => parts[name]));
