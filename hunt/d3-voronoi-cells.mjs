import { load, write } from './cells.mjs';
const { voronoi } = (await load('d3-voronoi')).default;
write((sites, [x0, y0, x1, y1]) => {
  const cells = voronoi().extent([[x0, y0], [x1, y1]])(sites).polygons();
  return sites.map((_, i) => cells[i] && [...cells[i]]);
});
