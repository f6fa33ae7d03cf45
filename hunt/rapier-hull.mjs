// The hull of which Rapier makes a collider; parry computes it, in single precision.
import { indices, load, serve, threes } from './lines.mjs';
const rapier = (await load('@dimforge/rapier3d-compat')).default;
await rapier.init();
serve(points => {
  const index = indices(points);
  const world = new rapier.World({ x: 0, y: 0, z: 0 });
  const description = rapier.ColliderDesc.convexHull(new Float32Array(points.flat()));
  const collider = description && world.createCollider(description);
  const corners = collider ? threes(collider.vertices()) : [];
  const rows = collider ? threes(collider.indices()).map(row => row.map(v => index(corners[v]))) : [];
  world.free();
  return rows;
});
