// @turf/voronoi gives d3-voronoi the box, and closes each cell.
import { load, write } from './cells.mjs';
const { voronoi } = await load('@turf/voronoi');
const feature = coordinates => ({ type: 'Feature', properties: {}, geometry: { type: 'Point', coordinates } });
write((sites, box) => Array.from(voronoi({ type: 'FeatureCollection', features: sites.map(feature) }, { bbox: box }).features, cell =>
  cell?.geometry.coordinates[0].slice(0, -1)));
