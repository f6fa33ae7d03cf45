import { edges, indices, load, serve } from './lines.mjs';
const { Point3d, Point3dArray } = (await load('@itwin/core-geometry')).default;
serve(points => {
  const hull = [];
  Point3dArray.computeConvexHullXY(points.map(([x, y]) => Point3d.create(x, y, 0)), hull, [], false);
  return edges(hull.map(({ x, y }) => [x, y]).map(indices(points)));
});
