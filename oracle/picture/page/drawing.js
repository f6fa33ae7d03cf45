// What is drawn for a broken rule: polygons, lines, dots and balls, each with a role that has a
// colour and a line in the legend, and a sentence that says what is to be seen.
import {
  add, between, commonPart, cross, crosses, dot, ears, edges, length, middle, pierces, section, sub, times,
  triangles, unit,
} from './vectors.js';

const NOUNS = { 1: 'vertex', 2: 'edge', 3: 'triangle', 4: 'tetrahedron' };

const list = (indices) => indices.join(' ');
const noun = (simplex) => NOUNS[simplex?.length] ?? 'simplex';

// The items of one violation: `v` as the report has it, `picture` with positions, `stretch` the
// factor of the affine map x → x + (stretch − 1)·h(x)·n, h being the height along the unit vector
// n.
export class Drawing {
  constructor(v, picture, stretch = 1) {
    this.v = v;
    this.picture = picture;
    this.stretch = stretch;
    this.items = [];
    this.legend = new Map();
    this.outlined = new Set();
    this.caption = '';
    this.points = picture.points.map((p, i) =>
      stretch === 1 ? p : add(p, times(picture.thin.normal, (stretch - 1) * picture.thin.heights[i])));
    this.compose();
  }

  at(i) { return this.points[i]; }
  all(indices) { return indices.map((i) => this.at(i)); }
  say(role, words) { if (words && !this.legend.has(role)) this.legend.set(role, words); }

  polygon(positions, role, words, extra = {}) {
    if (positions.length < 3) return;
    this.items.push({ kind: 'polygon', at: positions, role, ...extra });
    this.say(role, words);
  }

  line(a, b, role, words, extra = {}) {
    this.items.push({ kind: 'line', at: [a, b], role, ...extra });
    this.say(role, words);
  }

  dot(i, role, words) {
    this.items.push({ kind: 'dot', at: [this.at(i)], role, name: this.picture.names[i] ?? '' });
    this.say(role, words);
  }

  // Faces and edges of a simplex, which moves as one when the picture is exploded.
  simplex(indices, role, words, faces = true) {
    const corners = this.all(indices);
    const cell = { centre: middle(corners) };
    if (faces) for (const face of triangles(corners)) this.polygon(face, role, words, { cell });
    for (const [a, b] of edges(corners)) this.line(a, b, role, words, { cell });
    for (const i of indices) this.dot(i, 'corner');
  }

  ball(role, words) {
    const { ball } = this.picture;
    if (!ball) return;
    this.items.push({
      kind: 'ball', at: [ball.centre ?? this.at(0)], radius: ball.radius, near: this.at(0), normal: ball.normal, role });
    this.say(role, words);
  }

  compose() {
    const { v, picture } = this;
    const bad = picture.simplices;
    const groups = (v.groups ?? []).flatMap((group) => Array(group.count).fill(group));
    bad.forEach((simplex, i) => {
      const drawn = simplex.every((one) => one !== null);
      const indices = simplex.filter((one) => one !== null);
      this.simplex(indices, groups[i]?.role ?? ['first', 'second', 'third'][Math.min(i, 2)], groups[i]?.words ??
        `${noun(v.simplices[i])} ${list(v.simplices[i])}${i === 2 && bad.length > 3 ? ' and others' : ''}`,
        drawn && picture.mark !== 'edges');
    });
    this.outlines(v.groups ?? []);
    if (v.ball_words) this.ball('ball', v.ball_words);
    for (const outline of picture.outlines ?? []) this.face(outline);
    if (picture.face) {
      const face = this.all(picture.face);
      this.polygon(face, 'face', `${noun(v.face)} ${list(v.face)}`);
      for (const [a, b] of edges(face)) this.line(a, b, 'face', `${noun(v.face)} ${list(v.face)}`);
      for (const i of picture.face) this.dot(i, 'corner');
    }
    for (const i of picture.vertices) {
      if (i !== null) this.dot(i, 'vertex', `vertex ${list(v.vertices)}`);
    }
    if (picture.point !== undefined) this.dot(picture.point, 'point', 'the point of the witness');
    for (const i of picture.dots ?? []) this.dot(i, 'corner');
    if (picture.gap) this.gap(picture.gap);
    this.domainCell();
    this.caption = v.caption ?? picture.caption ?? '';
    MARKS[picture.mark]?.(this, v);
    for (const simplex of picture.near) this.simplexOutline(simplex, 'near', v.around ?? 'simplices around it');
    for (const facet of picture.boundary) this.facet(facet, 'boundary', 'boundary of the mesh');
    for (const segment of picture.walls.segments) {
      this.line(...this.all(segment), 'wall', 'segments and polygons of the domain');
    }
    for (const triangle of picture.walls.triangles) this.polygon(this.all(triangle), 'wall');
  }

  // A convex polygon by its corners, in whatever order.
  face({ corners, role, words }) {
    const at = this.all(corners);
    const m = middle(at);
    const u = unit(sub(at[0], m));
    // Whichever of the others is not in line with the first spans the plane with it.
    const across = at.map((p) => sub(sub(p, m), times(u, dot(u, sub(p, m))))).sort((a, b) => length(b) - length(a))[0];
    const angle = (p) => Math.atan2(dot(unit(across), sub(p, m)), dot(u, sub(p, m)));
    at.sort((a, b) => angle(a) - angle(b));
    this.polygon(at, role, words);
    at.forEach((p, i) => this.line(p, at[(i + 1) % at.length], role, words));
  }

  // Where a hull ends: what is within its edges in space, a line in the plane.
  gap(indices) {
    const at = this.all(indices);
    const words = 'the gap in the hull';
    if (this.picture.dimension === 3) {
      for (const triangle of ears(at)) this.polygon(triangle, 'hole', words, { hatch: true });
    } else {
      at.slice(1).forEach((p, i) => this.line(at[i], p, 'hole', words, { dashed: true }));
    }
    for (const i of indices) this.dot(i, 'corner');
  }

  // What lies within the edges of a polygon, which are a group of simplices.
  outlines(groups) {
    let first = 0;
    for (const { role, words, count, closed } of groups) {
      const corners = this.picture.simplices.slice(first, first + count).map(([corner]) => corner);
      first += count;
      if (!closed || corners.includes(null)) continue;
      const at = this.all(corners);
      for (const triangle of ears(at)) this.polygon(triangle, role, words);
    }
  }

  // Its edges are drawn once, unless the picture is exploded, however many neighbours have them in
  // common.
  simplexOutline(simplex, role, words) {
    const corners = this.all(simplex);
    const cell = { centre: middle(corners) };
    if (this.picture.dimension === 2) this.polygon(corners, role, words, { cell });
    for (const [a, b] of edges(simplex)) {
      const key = a < b ? `${a} ${b}` : `${b} ${a}`;
      this.line(this.at(a), this.at(b), role, words, { cell, isDrawn: this.outlined.has(key) });
      this.outlined.add(key);
    }
  }

  facet(facet, role, words) {
    const corners = this.all(facet);
    if (corners.length >= 3) this.polygon(corners, role, words);
    else if (corners.length === 2) this.line(...corners, role, words);
  }

  domainCell() {
    const { picture } = this;
    const { cell } = picture;
    if (!cell) return;
    if (cell.vertex !== undefined) this.dot(cell.vertex, 'domain', 'vertex of the domain');
    if (cell.segment) {
      this.line(...this.all(cell.segment), 'domain', 'segment of the domain');
      for (const i of cell.segment) this.dot(i, 'domain');
    }
    if (cell.polygon) {
      for (const triangle of cell.polygon.triangles) {
        this.polygon(this.all(triangle), 'domain', 'polygon of the domain', { hatch: true });
      }
      for (const line of cell.polygon.segments) this.line(...this.all(line), 'domain');
    }
    if (picture.nearest !== undefined) this.dot(picture.nearest, 'nearest', 'nearest vertex of the mesh');
  }

  // Lines of sight from a vertex to a simplex: dashed where a wall of the domain is in between.
  rays(q, simplex) {
    const from = this.at(q);
    const corners = this.all(simplex);
    const targets = [middle(corners), ...corners.map((c) => between(c, middle(corners), 0.12))];
    const walls = this.picture.walls;
    for (const target of targets) {
      const blocked = this.picture.dimension === 2
        ? walls.segments.some((s) => crosses(from, target, ...this.all(s)))
        : walls.triangles.some((t) => pierces(from, target, this.all(t)));
      this.line(from, target, blocked ? 'blocked' : 'ray',
        blocked ? 'line of sight that the domain blocks' : 'line of sight', { dashed: blocked });
    }
  }
}

// Where two simplices that ought to have a face in common overlap.
function overlap(drawing) {
  const [a, b] = drawing.picture.simplices;
  if (!a || !b || a.length !== b.length || a.length < 3) return;
  for (const part of commonPart(drawing.all(a), drawing.all(b))) {
    drawing.polygon(part, 'common', 'what the two have in common');
    part.forEach((p, i) => drawing.line(p, part[(i + 1) % part.length], 'common'));
  }
}

// Where the mesh lies on both sides of a polygon, the lines along which the polygon cuts its
// simplices.
function cuts(drawing) {
  const { picture } = drawing;
  const polygon = picture.cell?.polygon;
  if (!polygon?.triangles.length || picture.dimension !== 3) return;
  const [a, b, c] = drawing.all(polygon.triangles[0]);
  const n = unit(cross(sub(b, a), sub(c, a)));
  for (const simplex of picture.near) {
    const corners = section(drawing.all(simplex), n, dot(n, a));
    // A face of the simplex in the polygon is not a cut.
    if (simplex.length !== 4 || corners.every((p) => drawing.all(simplex).includes(p))) continue;
    corners.forEach((p, i) => drawing.line(p, corners[(i + 1) % corners.length], 'cut',
      'where simplices of the mesh pass through the polygon'));
  }
}

function noBall(drawing) {
  const corners = drawing.picture.simplices[0].filter((i) => i !== null).map((i) => drawing.at(i));
  const m = middle(corners);
  const radius = 1.15 * Math.max(...corners.map((p) => length(sub(p, m))), 1e-3);
  drawing.items.push({ kind: 'ball', at: [m], radius, role: 'missing' });
  drawing.say('missing', 'there is no such ball');
}

// An arrow from the middle of a facet to the side that is bare.
function bareSide(drawing, v) {
  const { face, dimension } = drawing.picture;
  const value = v.values['orientation of the bare side'];
  if (!face || face.length < dimension) return;
  const corners = drawing.all(face);
  const normal = dimension === 2
    ? unit([corners[0][1] - corners[1][1], corners[1][0] - corners[0][0], 0])
    : unit(cross(sub(corners[1], corners[0]), sub(corners[2], corners[0])));
  const m = middle(corners);
  const reach = 0.8 * length(sub(corners[0], m));
  const own = drawing.picture.simplices[0];
  // The book's orientation of a tetrahedron is positive if its last corner is where the others turn
  // clockwise.
  let side = value ? Number(value.exact) * (dimension === 3 ? -1 : 1) : 0;
  if (!value && own?.every((i) => i !== null)) side = dot(normal, sub(middle(drawing.all(own)), m)) > 0 ? -1 : 1;
  if (side === 0) return;
  drawing.line(m, add(m, times(normal, reach * side)), 'hole',
    'this side of it is covered by nothing', { arrow: true });
}

// Where no eye sees the points of a witness apart along its thin direction, the factor that makes
// them seen apart; else 1.
export function largestStretch(picture) {
  if (!picture.thin) return 1;
  const high = Math.max(...picture.thin.heights.slice(0, picture.core).map(Math.abs));
  return high > 0 && high < 0.1 ? Math.min(0.6 / high, 1e300) : 1;
}

// How far inside a ball a vertex is: a share of the squared radius.
export function relativeDepth(v) {
  const squared = v.values['squared radius'];
  const depth = v.values['squared radius less squared distance'];
  return squared && depth ? Number(depth.decimal) / Number(squared.decimal) : undefined;
}

function inBall(drawing, v) {
  drawing.ball('ball', `open ${drawing.picture.dimension === 2 ? 'circle' : 'ball'} through the corners of ${list(v.simplices[0])}`);
  if (!v.face || drawing.picture.vertices[0] === null) return;
  const apex = drawing.at(drawing.picture.vertices[0]);
  for (const corner of drawing.all(drawing.picture.face)) {
    drawing.line(apex, corner, 'other', `simplex on the other side of ${list(v.face)}`, { dashed: true });
  }
}

function visible(drawing, v) {
  inBall(drawing, v);
  const q = drawing.picture.vertices[0];
  if (q !== undefined && q !== null) drawing.rays(q, drawing.picture.simplices[0]);
}

// Along the vertices of two simplices, in the order in which they are listed.
function arrows(drawing) {
  drawing.picture.simplices.forEach((simplex, s) => simplex.slice(1).forEach((i, k) =>
    drawing.line(drawing.at(simplex[k]), drawing.at(i), s === 0 ? 'first' : 'second', undefined, { arrow: true })));
}

// Between the face at which the mesh ends and a point beyond.
function hole(drawing) {
  const { face, vertices: [q] } = drawing.picture;
  if (!face || q === undefined) return;
  const corners = [...drawing.all(face), drawing.at(q)];
  for (const side of triangles(corners)) drawing.polygon(side, 'hole', 'part of the hole', { hatch: true });
  for (const corner of drawing.all(face)) drawing.line(corner, drawing.at(q), 'hole', 'part of the hole', { dashed: true });
}

function nearest(drawing) {
  const { cell, nearest: vertex } = drawing.picture;
  if (vertex === undefined || cell?.vertex === undefined) return;
  drawing.line(drawing.at(cell.vertex), drawing.at(vertex), 'nearest', undefined, { dashed: true });
}

// The whole mesh from outside, and where on it violations are.
function whole(drawing) {
  const { picture } = drawing;
  for (const triangle of picture.skin) drawing.polygon(drawing.all(triangle), 'skin', 'the mesh');
  for (let i = 0; i < picture.core; ++i) drawing.dot(i, 'place', 'where violations are, by their numbers');
}

// What is drawn beside the cells of a witness, by the mark of the rule (Mark in
// oracle/model/rule.hpp).
const MARKS = {
  whole,
  'no-ball': noBall,
  order: arrows,
  'common-part': overlap,
  hole,
  nearest,
  cuts,
  'bare-side': bareSide,
  ball: inBall,
  'ball-and-sight': visible,
  'orthogonal-ball': (d, v) => d.ball('ball', `ball that is orthogonal to the corners of ${list(v.simplices[0] ?? [])}`),
  'smallest-ball': (d) => d.ball('ball', 'smallest ball through its corners'),
};
