import { indices, load, serve, threes } from './lines.mjs';
const Delaunay = (await load('faster-delaunay')).default;
serve(points => {
  const index = indices(points);
  return threes(new Delaunay(points).triangulate()).map(triangle => triangle.map(index));
});
