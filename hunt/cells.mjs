// What adapters of Voronoi diagrams in JavaScript share: `node LIBRARY.mjs x.node` writes cells as
// qvoronoi does, polygons that the library clipped at the box in which `circumspect check --claim
// voronoi` compares them: that of the sites, enlarged on each side by half its longest edge.
import fs from 'node:fs';
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';

const require = createRequire(process.env.BUILDS + '/npm/x.js');
export const load = name => import(pathToFileURL(require.resolve(name)));

/** `diagram` is given the sites and the box, and returns for each site the corners of its cell, or nothing. */
export function write(diagram) {
  const rows = fs.readFileSync(process.argv[2], 'latin1').split('\n').map(line => line.trim().split(/\s+/).map(Number));
  const sites = rows.slice(1, 1 + rows[0][0]).map(([, x, y]) => [x, y]);
  const low = [0, 1].map(axis => Math.min(...sites.map(p => p[axis]))), high = [0, 1].map(axis => Math.max(...sites.map(p => p[axis])));
  const margin = Math.max(high[0] - low[0], high[1] - low[1]) / 2 || 1;
  const cells = diagram(sites, [low[0] - margin, low[1] - margin, high[0] + margin, high[1] + margin]);
  const corners = cells.flatMap(cell => cell ?? []);
  let next = 1;
  console.log(['2', `${corners.length + 1} ${cells.length} 1`, '-10.101 -10.101', ...corners.map(([x, y]) => `${x} ${y}`),
    ...cells.map(cell => [cell?.length ?? 0, ...(cell ?? []).map(() => next++)].join(' '))].join('\n'));
}
