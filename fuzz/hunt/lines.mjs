// What every adapter in JavaScript does: reads points from the standard input, writes triangles to the standard output.
import fs from 'node:fs';
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';

const require = createRequire(process.env.BUILDS + '/npm/x.js');
export const load = name => import(pathToFileURL(require.resolve(name)));

/** From a point that a library returns back to its index; it has to be the same two or three doubles. */
export const indices = points => {
  const known = new Map(points.map((p, i) => [p.join(), i]));
  return p => known.get(p.join()) ?? -1;
};
/** [a, b, c, d, e, f] → [[a, b, c], [d, e, f]] */
export const threes = flat => Array.from({ length: flat.length / 3 }, (_, i) => Array.from(flat.slice(3 * i, 3 * i + 3)));

export async function serve(triangulate) {
  let text = '', rows = [];
  const buffer = Buffer.alloc(1 << 20);
  for (;;) {
    const [count, , constraints = 0] = (rows[0] ?? '0').split(' ').map(Number); // points, their dimension, segments
    if (rows.length === 0 || rows.length <= count + constraints) {
      const size = fs.readSync(0, buffer);
      if (size === 0) return;
      text += buffer.toString('latin1', 0, size);
      const lines = text.split('\n');
      text = lines.pop();
      rows.push(...lines);
      continue;
    }
    const given = rows.splice(0, count + constraints + 1).slice(1).map(line => line.split(' ').map(Number));
    const points = given.slice(0, count);
    let answer;
    try {
      const simplices = await triangulate(points, given.slice(count));
      answer = [`${simplices.length} ${points[0].length + 1}`, ...simplices.map(s => Array.from(s).join(' '))].join('\n');
    } catch (error) {
      answer = `raised ${String(error).split('\n')[0]}`;
    }
    fs.writeSync(1, answer + '\n');
  }
}
