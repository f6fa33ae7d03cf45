import { load, serve, threes } from './lines.mjs';
const { triangulate } = (await load('delaunay-fast')).default;
serve(points => threes(triangulate(points)));
