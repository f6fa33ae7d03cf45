// A worker for `circumspect campaign --worker --dimension 2 -- node mine.mjs`: it answers each case
// with simplices.
import { createInterface } from 'node:readline';
import Delaunator from 'delaunator';

// Put your own library here: an array of points, and back come rows of indices, from 0.
function triangulate(points) {
  const { triangles } = Delaunator.from(points);
  return Array.from({ length: triangles.length / 3 }, (_, i) => triangles.slice(3 * i, 3 * i + 3));
}

let wanted = -1; // points of this case that are still to come; -1: its header is
let points = [];
createInterface({ input: process.stdin }).on('line', (line) => {
  const numbers = line.split(' ').map(Number);
  if (wanted >= 0) points.push(numbers);
  wanted = wanted < 0 ? numbers[0] : wanted - 1;
  if (wanted > 0) return;
  const simplices = triangulate(points); // where its documents let it refuse: console.log('error TEXT')
  console.log([simplices.length, ...simplices.map((row) => row.join(' '))].join('\n'));
  wanted = -1;
  points = [];
});
