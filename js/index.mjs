// For Node: the library is read from the disk, and nothing is waited for.
import { readFileSync } from 'node:fs';
import { imports } from './memory.mjs';
import { oracle } from './oracle.mjs';

const code = new WebAssembly.Module(readFileSync(new URL('./circumspect.wasm', import.meta.url)));

function instantiate() {
  let exports;
  ({ exports } = new WebAssembly.Instance(code, imports(() => exports.memory)));
  exports._initialize();
  return exports;
}

export const { check, delaunay, constrainedDelaunay, compare, certify, generate, orient, inBall, version } = oracle(instantiate);
export { InputError, NoneError, UndecidedError, Verdict } from './oracle.mjs';
