import { edges, indices, load, serve } from './lines.mjs';
const hull = (await load('quick-hull-2d')).default;
serve(points => edges(hull(points.map(p => [...p])).map(indices(points))));
