// Points of space as arrays of three numbers, and what drawings need of them. A drawing decides
// nothing: verdicts and the values beside it are exact, and come from the command.
export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const times = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const length = (a) => Math.hypot(a[0], a[1], a[2]);
export const between = (a, b, t) => add(times(a, 1 - t), times(b, t));
export const middle = (points) =>
  times(points.reduce(add, [0, 0, 0]), 1 / Math.max(points.length, 1));

export function unit(a) {
  const l = length(a);
  return l > 0 ? times(a, 1 / l) : [0, 0, 1];
}

// Two unit vectors that are orthogonal to a unit vector and to each other.
export function frame(n) {
  const u = unit(cross(Math.abs(n[0]) < 0.7 ? [1, 0, 0] : [0, 1, 0], n));
  return [u, cross(n, u)];
}

// The facets of a simplex by its vertices: triangles of a tetrahedron, a triangle itself.
export function triangles(simplex) {
  if (simplex.length < 3) return [];
  if (simplex.length === 3) return [simplex];
  if (simplex.length > 4) return [];
  return [0, 1, 2, 3].map((left) => simplex.filter((_, i) => i !== left));
}

export function edges(simplex) {
  const pairs = [];
  for (let i = 0; i < simplex.length; ++i) {
    for (let j = i + 1; j < simplex.length; ++j) pairs.push([simplex[i], simplex[j]]);
  }
  return pairs;
}

// The triangles of a nearly flat polygon, whose ears are cut off one by one. Of one that crosses
// itself there may be fewer.
export function ears(polygon) {
  const normal = polygon.reduce((sum, p, i) => add(sum, cross(p, polygon[(i + 1) % polygon.length])), [0, 0, 0]);
  const side = (a, b, p) => dot(normal, cross(sub(b, a), sub(p, a)));
  const rest = [...polygon];
  const found = [];
  while (rest.length > 2) {
    const at = rest.findIndex((b, i) => {
      const [a, c] = [rest.at(i - 1), rest[(i + 1) % rest.length]];
      return side(a, b, c) > 0 && rest.every((p) => [a, b, c].includes(p) ||
        side(a, b, p) < 0 || side(b, c, p) < 0 || side(c, a, p) < 0);
    });
    if (at < 0) break;
    found.push([rest.at(at - 1), rest[at], rest[(at + 1) % rest.length]]);
    rest.splice(at, 1);
  }
  return found;
}

// The part of a flat polygon where n·x <= d.
export function clipped(polygon, n, d) {
  const kept = [];
  for (let i = 0; i < polygon.length; ++i) {
    const a = polygon[i];
    const b = polygon[(i + 1) % polygon.length];
    const ha = dot(n, a) - d;
    const hb = dot(n, b) - d;
    if (ha <= 0) kept.push(a);
    if ((ha < 0 && hb > 0) || (ha > 0 && hb < 0)) kept.push(between(a, b, ha / (ha - hb)));
  }
  return kept;
}

// The half-spaces (in the plane: half-planes) whose intersection is a simplex, as [n, d] with n·x
// <= d.
export function halfspaces(corners) {
  return corners.map((corner, i) => {
    const rest = corners.filter((_, j) => j !== i);
    const n = rest.length === 3
      ? unit(cross(sub(rest[1], rest[0]), sub(rest[2], rest[0])))
      : unit([rest[1][1] - rest[0][1], rest[0][0] - rest[1][0], 0]);
    const d = dot(n, rest[0]);
    return dot(n, corner) > d ? [times(n, -1), -d] : [n, d];
  });
}

// What two tetrahedra, or two triangles of the plane, have in common, as the polygons that bound
// it.
export function commonPart(a, b) {
  const parts = [];
  for (const [one, other] of [[a, b], [b, a]]) {
    const bounds = halfspaces(other);
    for (const face of triangles(one)) {
      const polygon = bounds.reduce((left, [n, d]) => clipped(left, n, d + 1e-12), face);
      if (polygon.length >= 3) parts.push(polygon);
    }
  }
  return parts;
}

// Where a plane cuts a tetrahedron: the corners of the section, in order.
export function section(corners, n, d) {
  const height = corners.map((corner) => dot(n, corner) - d);
  const isIn = height.map((h) => Math.abs(h) < 1e-6);
  const cuts = corners.filter((_, i) => isIn[i]);
  for (const [i, j] of edges(corners.map((_, k) => k))) {
    if (!isIn[i] && !isIn[j] && height[i] * height[j] < 0) {
      cuts.push(between(corners[i], corners[j], height[i] / (height[i] - height[j])));
    }
  }
  if (cuts.length < 3) return [];
  const m = middle(cuts);
  const [u, v] = frame(n);
  const angle = (p) => Math.atan2(dot(sub(p, m), v), dot(sub(p, m), u));
  return cuts.sort((p, q) => angle(p) - angle(q));
}

// Strokes across a convex polygon, as pairs of ends: all polygons of one plane have theirs in the
// same lines.
export function hatching(polygon, apart = 0.06) {
  const n = unit(cross(sub(polygon[1], polygon[0]), sub(polygon[2], polygon[0])));
  const [u, v] = frame(n.find((x) => Math.abs(x) > 1e-9) < 0 ? times(n, -1) : n);
  const across = unit(add(u, v));
  const heights = polygon.map((p) => dot(across, p));
  const strokes = [];
  for (let i = Math.ceil(Math.min(...heights) / apart); i * apart < Math.max(...heights) && strokes.length < 200; ++i) {
    const ends = polygon.flatMap((p, k) => {
      const [q, a, b] = [polygon[(k + 1) % polygon.length], heights[k] - i * apart, heights[(k + 1) % polygon.length] - i * apart];
      return a * b < 0 ? [between(p, q, a / (a - b))] : [];
    });
    if (ends.length === 2) strokes.push(ends);
  }
  return strokes;
}

// Does a segment pass through a triangle, properly?
export function pierces(a, b, triangle) {
  const n = cross(sub(triangle[1], triangle[0]), sub(triangle[2], triangle[0]));
  const ha = dot(n, sub(a, triangle[0]));
  const hb = dot(n, sub(b, triangle[0]));
  if (ha * hb >= 0) return false;
  const p = between(a, b, ha / (ha - hb));
  return triangle.every((corner, i) =>
    dot(n, cross(sub(triangle[(i + 1) % 3], corner), sub(p, corner))) > 0);
}

// Do two segments of the plane cross, properly?
export function crosses(a, b, c, d) {
  const side = (p, q, r) => (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}
