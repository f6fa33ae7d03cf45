// For Node: the library is read from the disk, and nothing is waited for.
import { readFileSync } from 'node:fs';
import { instance } from './memory.mjs';
import { oracle } from './oracle.mjs';

const code = new WebAssembly.Module(readFileSync(new URL('./circumspect.wasm', import.meta.url)));

export const { check, delaunay, constrainedDelaunay, compare, certify, generate, orient, inBall, version } = oracle(() => instance(code));
export { InputError, NoneError, UndecidedError, Verdict } from './oracle.mjs';
