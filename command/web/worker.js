// What the page has in a worker, so that it never freezes: one run of the command after another.
// The first message brings the compiled module; each other one a run. `make` is circumspect.js,
// which stands before this.
/* global circumspect */
import { judge } from './judge.mjs';

let code;
addEventListener('message', async ({ data }) => {
  if (data.code) {
    code = data.code;
    return;
  }
  const answer = await judge(circumspect, code, data.words, data.files, data.wanted);
  postMessage({ id: data.id, ...answer });
});
