import { createRequire } from 'node:module';
import { serve, threes } from './lines.mjs';
const require = createRequire(process.env.BUILDS + '/npm/x.js');
delete globalThis.fetch; // else it takes Node for a browser
const Triangle = require('triangle-wasm');
await Triangle.init(process.env.BUILDS + '/npm/node_modules/triangle-wasm/triangle.out.wasm');
serve(points => {
  const input = Triangle.makeIO({ pointlist: points.flat() }), output = Triangle.makeIO();
  Triangle.triangulate('zQ', input, output);
  const made = threes(Array.from(output.trianglelist));
  Triangle.freeIO(input, true);
  Triangle.freeIO(output);
  return made;
});
