import { load, serve } from './lines.mjs';
const cdt2d = (await load('cdt2d')).default;
serve(points => cdt2d(points));
