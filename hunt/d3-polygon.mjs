import { edges, indices, load, serve } from './lines.mjs';
const { polygonHull } = await load('d3-polygon');
serve(points => edges((polygonHull(points) ?? []).map(indices(points))));
