// Prints how large the package is and how long its verdicts take in Node:   node js/times.mjs
// build/web The goals are at most 2 MB, at least 5,000 verdicts a second, and at most 1.5 s.
import { readdirSync, statSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const folder = resolve(process.argv[2]);
const { check, delaunay, generate } = await import(pathToFileURL(join(folder, 'package', 'index.mjs')));
const packed = readdirSync(folder).find((name) => /^circumspect-oracle-.*\.tgz$/.test(name));
console.log(`packed            ${(statSync(join(folder, packed)).size / 1e6).toFixed(2)} MB`);

// Processor time.
const seconds = (act) => {
  const start = process.cpuUsage();
  act();
  const { user, system } = process.cpuUsage(start);
  return (user + system) / 1e6;
};

for (const dimension of [2, 3]) {
  const meshes = Array.from({ length: 1000 }, (_, seed) => {
    const { points } = generate('uniform', { dimension, count: 12, seed });
    return [points, delaunay(points, { dimension })];
  });
  const judge = () => meshes.forEach(([points, built]) => check(points, built, { dimension }));
  judge();
  const least = Math.min(...Array.from({ length: 5 }, () => seconds(judge)));
  console.log(`12 points, d = ${dimension}  ${Math.round(meshes.length / least)} verdicts a second`);
}

// Each cube of a grid as five tetrahedra, mirrored from cube to cube so that they fit: 59³·5 =
// 1,026,895 of them.
const n = 59;
const at = (x, y, z) => (x * (n + 1) + y) * (n + 1) + z;
const points = new Float64Array(3 * (n + 1) ** 3);
const simplices = new Int32Array(4 * 5 * n ** 3);
const corners = [[0, 0, 0], [0, 0, 1], [0, 1, 0], [0, 1, 1], [1, 0, 0], [1, 0, 1], [1, 1, 0], [1, 1, 1]];
const five = [[0, 1, 2, 4], [3, 1, 2, 7], [5, 1, 4, 7], [6, 2, 4, 7], [1, 2, 4, 7]];
let end = 0;
for (let x = 0; x <= n; ++x) {
  for (let y = 0; y <= n; ++y) {
    for (let z = 0; z <= n; ++z) {
      points.set([x, y, z], 3 * at(x, y, z));
      if (x === n || y === n || z === n) continue;
      const cube = corners.map(([i, j, k]) => at(x + ((x + i) % 2), y + ((y + j) % 2), z + ((z + k) % 2)));
      for (const tetrahedron of five) for (const corner of tetrahedron) simplices[end++] = cube[corner];
    }
  }
}
let verdict;
const times = Array.from({ length: 3 }, () => seconds(() => { verdict = check(points, simplices, { dimension: 3 }); }));
console.log(`10⁶ tetrahedra    ${Math.min(...times).toFixed(2)} s  ${verdict}`);
