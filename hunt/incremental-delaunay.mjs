import { load, serve } from './lines.mjs';
const create = (await load('incremental-delaunay')).default;
// Its first d+1 points are those of the simplex at 1e30 in which it starts.
serve(points => {
  const d = points[0].length;
  return create(d, points).cells.filter(cell => cell.every(v => v > d)).map(cell => cell.map(v => v - d - 1));
});
