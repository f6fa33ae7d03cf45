import { load, serve, threes } from './lines.mjs';
const { Delaunay } = await load('d3-delaunay');
serve(points => threes(Delaunay.from(points).triangles));
