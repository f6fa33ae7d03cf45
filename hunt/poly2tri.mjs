import { load, serve } from './lines.mjs';
const poly2tri = (await load('poly2tri')).default;
const { orient2d } = await load('robust-predicates');
// It triangulates polygons with points inside: the polygon is the hull, with every point on it.
const half = (points, order) => {
  const made = [];
  for (const i of order) {
    while (made.length > 1 && orient2d(...points[made.at(-2)], ...points[made.at(-1)], ...points[i]) > 0) made.pop();
    made.push(i);
  }
  return made.slice(0, -1);
};
serve(points => {
  const order = points.map((_, i) => i).sort((a, b) => points[a][0] - points[b][0] || points[a][1] - points[b][1]);
  const hull = [...half(points, order), ...half(points, order.reverse())];
  const own = points.map(([x, y], i) => Object.assign(new poly2tri.Point(x, y), { index: i }));
  const context = new poly2tri.SweepContext(hull.map(i => own[i]));
  const outer = new Set(hull);
  context.addPoints(own.filter(p => !outer.has(p.index)));
  return context.triangulate().getTriangles().map(t => t.getPoints().map(p => p.index));
});
