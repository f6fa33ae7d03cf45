import { load, serveDomains, threes } from './lines.mjs';
const Delaunator = (await load('delaunator')).default;
const Constrainautor = (await load('@kninnug/constrainautor')).default;
serveDomains((points, segments) => {
  const delaunay = Delaunator.from(points);
  new Constrainautor(delaunay).constrainAll(segments);
  return threes(delaunay.triangles);
});
