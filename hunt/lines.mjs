// What every adapter in JavaScript does: it answers the cases of `circumspect campaign --worker`
// (docs/workers.md).
import fs from 'node:fs';
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';

const require = createRequire(process.env.BUILDS + '/npm/x.js');
export const load = name => import(pathToFileURL(require.resolve(name)));
/** A module that a package lets nobody `require`, by its file. */
export const loadFile = file => import(pathToFileURL(process.env.BUILDS + '/npm/node_modules/' + file));

/** From a point that a library returns back to its index; it has to be the same two or three doubles. */
export const indices = points => {
  const known = new Map(points.map((p, i) => [p.join(), i]));
  return p => known.get(p.join()) ?? -1;
};
/** [a, b, c, d, e, f] → [[a, b, c], [d, e, f]] */
export const threes = flat => Array.from({ length: flat.length / 3 }, (_, i) => Array.from(flat.slice(3 * i, 3 * i + 3)));
/** [a, b, c] → [[a, b], [b, c], [c, a]]: the edges of a hull in the plane whose vertices a library returns. */
export const edges = cycle => cycle.map((v, i) => [v, cycle[(i + 1) % cycle.length]]);

/** `triangulate` is given points, and returns rows of indices. What it throws ends the process with exit code 1. */
export const serve = triangulate => answerAll(triangulate, (_, rows) => [rows.length, ...rows]);

/** The same of the plane with segments that have to be edges: a worker answers domains with an .off file. */
export const serveDomains = triangulate => answerAll(triangulate, (points, rows) =>
  ['nOFF 2', `${points.length} ${rows.length} 0`, ...points, ...rows.map(row => '3 ' + row)]);

async function answerAll(triangulate, answer) {
  let text = '', rows = [];
  const buffer = Buffer.alloc(1 << 20);
  for (;;) {
    // Points, their dimension, weights, segments, facets, holes: the last are read, as the hull is
    // filled.
    const [count, , , segments = 0, , holes = 0] = (rows[0] ?? '0').split(' ').map(Number);
    if (rows.length === 0 || rows.length <= count + segments + holes) {
      const size = fs.readSync(0, buffer);
      if (size === 0) return;
      text += buffer.toString('latin1', 0, size);
      const lines = text.split('\n');
      text = lines.pop();
      rows.push(...lines);
      continue;
    }
    const lines = rows.splice(0, count + segments + holes + 1).slice(1);
    const given = lines.map(line => line.split(' ').map(Number));
    try {
      const made = await triangulate(given.slice(0, count), given.slice(count, count + segments));
      const own = made.map(simplex => Array.from(simplex, v => (v >= 0 ? v : count)).join(' '));
      fs.writeSync(1, answer(lines.slice(0, count), own).join('\n') + '\n');
    } catch (error) {
      console.error(error);
      process.exit(1);
    }
  }
}
