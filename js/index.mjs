// For Node: the library is read from the disk, and nothing is waited for.
import { readFileSync } from 'node:fs';
import { instance } from './memory.mjs';
import { oracle } from './oracle.mjs';

const file = new URL('./circumspect.wasm', import.meta.url);

// A bundler takes what stands here, and leaves the file behind.
function contents() {
  try {
    return readFileSync(file);
  } catch (cause) {
    throw new Error(`expected the compiled library as ${file}, found none: let bundlers leave circumspect-oracle external, or copy ` +
      'circumspect.wasm to there', { cause });
  }
}

const code = new WebAssembly.Module(contents());

export const { check, delaunay, constrainedDelaunay, compare, certify, generate, orient, inBall, version } = oracle(() => instance(code));
export { InputError, NoneError, UndecidedError, Verdict } from './oracle.mjs';
