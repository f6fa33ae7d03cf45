import { load, serve, threes } from './lines.mjs';
const Delaunator = (await load('delaunator')).default;
serve(points => threes(Delaunator.from(points).triangles));
