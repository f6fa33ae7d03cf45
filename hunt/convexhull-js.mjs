import { edges, indices, load, serve } from './lines.mjs';
const hull = (await load('convexhull-js/convexhull.js')).default;
serve(points => edges(hull(points.map(([x, y]) => ({ x, y }))).map(({ x, y }) => [x, y]).map(indices(points))));
