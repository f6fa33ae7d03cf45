import { indices, load, serve } from './lines.mjs';
const { DVMesh } = await load('@thi.ng/geom-voronoi');
serve(points => {
  const index = indices(points);
  const largest = Math.max(...points.flat().map(Math.abs));
  // Triangles with a corner of the first one, which is around all points, are left out.
  return new DVMesh(points, 4 * largest + 1).delaunay().map(triangle => triangle.map(p => index(Array.from(p))))
    .filter(triangle => !triangle.includes(-1));
});
