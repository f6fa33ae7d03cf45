import { loadFile, serve } from './lines.mjs';
const quickhull = (await loadFile('quickhull3d/dist/quickhull3d.js')).default;
serve(points => quickhull(points));
