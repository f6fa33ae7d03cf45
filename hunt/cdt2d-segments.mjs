import { load, serveDomains } from './lines.mjs';
const cdt2d = (await load('cdt2d')).default;
serveDomains((points, segments) => cdt2d(points, segments));
