// @turf/convex wraps concaveman, which is given no limit for concave edges, and takes a convex hull
// first.
import { edges, indices, load, serve } from './lines.mjs';
const { convex } = await load('@turf/convex');
const feature = coordinates => ({ type: 'Feature', properties: {}, geometry: { type: 'Point', coordinates } });
serve(points => {
  const hull = convex({ type: 'FeatureCollection', features: points.map(feature) });
  return hull ? edges(hull.geometry.coordinates[0].slice(0, -1).map(indices(points))) : [];
});
