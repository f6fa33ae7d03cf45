// For browsers and their workers: the library is fetched while the module is loaded.
import { imports, instance } from './memory.mjs';
import { oracle } from './oracle.mjs';

const place = new URL('./circumspect.wasm', import.meta.url);
const answer = await fetch(place);
if (!answer.ok) throw new Error(`expected the compiled library at ${place}, found ${answer.status} ${answer.statusText}`);
const code = await WebAssembly.compile(await answer.arrayBuffer());

// The first instance is made without stopping the page, which a browser demands; one that takes the
// place of a broken one is made at once.
async function start() {
  const said = [];
  let exports;
  ({ exports } = await WebAssembly.instantiate(code, imports(() => exports.memory, said)));
  exports._initialize();
  return { exports, said };
}
let first = await start();
function instantiate() {
  const made = first ?? instance(code);
  first = undefined;
  return made;
}

export const { check, delaunay, constrainedDelaunay, compare, certify, generate, orient, inBall, version } = oracle(instantiate);
export { InputError, NoneError, UndecidedError, Verdict } from './oracle.mjs';
