import { load, write } from './cells.mjs';
const { Delaunay } = await load('d3-delaunay');
write((sites, box) => {
  const cells = Delaunay.from(sites).voronoi(box);
  return sites.map((_, i) => cells.cellPolygon(i)?.slice(0, -1));
});
