// Each cell has the half-edges around it, in counterclockwise order; the library closes them at the
// box.
import { load, write } from './cells.mjs';
const Voronoi = (await load('voronoi')).default;
write((sites, [xl, yt, xr, yb]) => {
  const given = sites.map(([x, y]) => ({ x, y }));
  const diagram = new Voronoi().compute(given, { xl, xr, yt, yb });
  return given.map(site => diagram.cells[site.voronoiId]?.halfedges.map(half => half.getStartpoint()).map(({ x, y }) => [x, y]));
});
