import { indices, load, serve } from './lines.mjs';
const { tin } = await load('@turf/tin');
const feature = coordinates => ({ type: 'Feature', properties: {}, geometry: { type: 'Point', coordinates } });
serve(points => {
  const index = indices(points);
  return tin({ type: 'FeatureCollection', features: points.map(feature) })
    .features.map(triangle => triangle.geometry.coordinates[0].slice(0, 3).map(index));
});
