import { load, serve } from './lines.mjs';
const { triangulate } = (await load('delaunay')).default;
serve(points => {
  const flat = triangulate(points), k = points[0].length + 1;
  return Array.from({ length: flat.length / k }, (_, i) => flat.slice(k * i, k * i + k));
});
