// ConvexHull of three's examples, which ConvexGeometry is made of.
import { indices, loadFile, serve } from './lines.mjs';
const { Vector3 } = await loadFile('three/build/three.module.js');
const { ConvexHull } = await loadFile('three/examples/jsm/math/ConvexHull.js');
serve(points => {
  const index = indices(points);
  const hull = new ConvexHull().setFromPoints(points.map(p => new Vector3(...p)));
  return hull.faces.map(face => {
    const corners = [];
    let edge = face.edge;
    do {
      corners.push(index(edge.head().point.toArray()));
      edge = edge.next;
    } while (edge !== face.edge);
    return corners;
  });
});
