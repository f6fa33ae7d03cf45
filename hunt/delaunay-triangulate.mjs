import { load, serve } from './lines.mjs';
const triangulate = (await load('delaunay-triangulate')).default;
serve(points => triangulate(points));
