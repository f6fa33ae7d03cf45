import { indices, load, serve } from './lines.mjs';
const { voronoi } = (await load('d3-voronoi')).default;
serve(points => {
  const index = indices(points);
  return voronoi().triangles(points).map(triangle => triangle.map(index));
});
