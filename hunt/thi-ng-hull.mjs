import { edges, indices, loadFile, serve } from './lines.mjs';
const { grahamScan2 } = await loadFile('@thi.ng/geom-hull/index.js');
serve(points => edges(grahamScan2(points.map(p => [...p])).map(indices(points))));
