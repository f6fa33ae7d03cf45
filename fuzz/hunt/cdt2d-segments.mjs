import { load, serve } from './lines.mjs';
const cdt2d = (await load('cdt2d')).default;
serve((points, segments) => cdt2d(points, segments));
