// For browsers and their workers: the library is fetched while the module is loaded.
import { imports } from './memory.mjs';
import { oracle } from './oracle.mjs';

const code = await WebAssembly.compile(await (await fetch(new URL('./circumspect.wasm', import.meta.url))).arrayBuffer());
const start = async () => {
  let exports;
  ({ exports } = await WebAssembly.instantiate(code, imports(() => exports.memory)).then((instance) => instance));
  exports._initialize();
  return exports;
};
// The first instance is made without stopping the page; one that takes the place of a broken one is made at once.
let ready = await start();
function instantiate() {
  if (ready) {
    const first = ready;
    ready = undefined;
    return first;
  }
  let exports;
  ({ exports } = new WebAssembly.Instance(code, imports(() => exports.memory)));
  exports._initialize();
  return exports;
}

export const { check, delaunay, constrainedDelaunay, compare, certify, generate, orient, inBall, version } = oracle(instantiate);
export { InputError, NoneError, UndecidedError, Verdict } from './oracle.mjs';
