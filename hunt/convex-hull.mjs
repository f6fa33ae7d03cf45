import { load, serve } from './lines.mjs';
const hull = (await load('convex-hull')).default;
serve(points => hull(points));
