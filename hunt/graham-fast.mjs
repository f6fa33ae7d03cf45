import { edges, indices, load, serve } from './lines.mjs';
const hull = (await load('graham-fast')).default;
serve(points => edges(hull(points.map(p => [...p])).map(indices(points))));
