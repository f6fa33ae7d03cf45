import { edges, indices, load, serve } from './lines.mjs';
const Scan = (await load('graham_scan/graham_scan.min.js')).default;
serve(points => {
  const scan = new Scan();
  for (const [x, y] of points) scan.addPoint(x, y);
  return edges(scan.getHull().map(({ x, y }) => [x, y]).map(indices(points)));
});
