// What is drawn for a broken rule: polygons, lines, dots and balls, each with a role that has a colour and a
// line in the legend, and a sentence that says what is to be seen.
import {
  add, between, commonPart, cross, crosses, dot, ears, edges, length, middle, pierces, section, sub, times,
  triangles, unit,
} from './vectors.js';

const NO_FACES = ['simplex.wrong-dimension', 'simplex.repeated-vertex'];
const NOUNS = { 1: 'vertex', 2: 'edge', 3: 'triangle', 4: 'tetrahedron' };

const list = (indices) => indices.join(' ');
const noun = (simplex) => NOUNS[simplex?.length] ?? 'simplex';

// The items of one violation: `v` as the report has it, `picture` with positions, `stretch` the factor of the
// affine map x → x + (stretch − 1)·h(x)·n, h being the height along the unit vector n.
export class Drawing {
  constructor(v, picture, stretch = 1) {
    this.v = v;
    this.picture = picture;
    this.stretch = stretch;
    this.items = [];
    this.legend = new Map();
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
        drawn && !NO_FACES.includes(v.rule));
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
    this.domainCell();
    this.caption = v.caption ?? RULES[v.rule]?.(this, v, picture) ?? '';
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

  simplexOutline(simplex, role, words) {
    const corners = this.all(simplex);
    const cell = { centre: middle(corners) };
    if (this.picture.dimension === 2) this.polygon(corners, role, words, { cell });
    for (const [a, b] of edges(corners)) this.line(a, b, role, words, { cell });
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

// Where the mesh lies on both sides of a polygon, the lines along which the polygon cuts its simplices.
function cuts(drawing) {
  const { picture } = drawing;
  const polygon = picture.cell?.polygon;
  if (!polygon?.triangles.length || picture.dimension !== 3) return;
  const [a, b, c] = drawing.all(polygon.triangles[0]);
  const n = unit(cross(sub(b, a), sub(c, a)));
  for (const simplex of picture.near) {
    const corners = section(drawing.all(simplex), n, dot(n, a));
    // A face of the simplex in the polygon is no cut.
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
  // The book's orientation of a tetrahedron is positive if its last corner is where the others turn clockwise.
  let side = value ? Number(value.exact) * (dimension === 3 ? -1 : 1) : 0;
  if (!value && own?.every((i) => i !== null)) side = dot(normal, sub(middle(drawing.all(own)), m)) > 0 ? -1 : 1;
  if (side === 0) return;
  drawing.line(m, add(m, times(normal, reach * side)), 'hole',
    'this side of it is covered by nothing', { arrow: true });
}

// Where no eye sees the points of a witness apart along its thin direction, the factor that makes them
// seen apart; else 1.
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
  const q = list(v.vertices);
  const flat = drawing.picture.dimension === 2;
  const round = flat ? 'circle' : 'ball';
  drawing.ball('ball', `open ${round} through the corners of ${list(v.simplices[0])}`);
  if (v.face && drawing.picture.vertices[0] !== null) {
    const apex = drawing.at(drawing.picture.vertices[0]);
    for (const corner of drawing.all(drawing.picture.face)) {
      drawing.line(apex, corner, 'other', `simplex on the other side of ${list(v.face)}`, { dashed: true });
    }
  }
  const other = v.face ? ` It is the corner on the other side of ${noun(v.face)} ${list(v.face)}.` : '';
  return `Vertex ${q} lies inside the ${round} through the corners of ${noun(v.simplices[0])} ` +
    `${list(v.simplices[0])}.${other} A Delaunay mesh has no vertex inside such a ${round}.`;
}

function visible(drawing, v) {
  const q = drawing.picture.vertices[0];
  const words = inBall(drawing, v).replace('A Delaunay mesh', 'A constrained Delaunay mesh')
    .replace(/inside such a (\w+)\.$/, 'that is seen from it inside such a $1.');
  if (q !== undefined && q !== null) drawing.rays(q, drawing.picture.simplices[0]);
  return `${words} Lines of sight lead from the vertex to five points of ${noun(v.simplices[0])} ` +
    `${list(v.simplices[0])}; that it is seen from some point is exact, whatever these five show.`;
}

function weighted(drawing, v) {
  drawing.ball('ball', `ball that is orthogonal to the corners of ${list(v.simplices[0] ?? [])}`);
}

// One sentence for each rule, and what is drawn for it alone.
const RULES = {
  'triangulation.unknown-vertex': (d, v) =>
    `${v.simplices[0].length} vertices are listed, and ${list(v.vertices)} is the index of no point. ` +
    'Only the corners that exist are drawn.',
  'simplex.wrong-dimension': (d, v) =>
    `The simplex ${list(v.simplices[0])} has ${v.simplices[0].length} vertices` +
    (v.values['vertices expected'] ? `, and each simplex of these points is to have ${v.values['vertices expected'].exact}.` :
      ', which is not what its place needs.'),
  'simplex.repeated-vertex': (d, v) =>
    `Vertex ${list(v.vertices)} is listed twice in ${list(v.simplices[0])}, so nothing is left but a face.`,
  'simplex.degenerate': (d, v) => {
    noBall(d);
    const flat = d.picture.dimension === 2 ? 'on one line' : 'in one plane';
    return `All corners of ${list(v.simplices[0])} lie ${flat}, exactly. It encloses nothing, and no ball ` +
      'has just these corners on its sphere.';
  },
  'simplex.orientation': (d, v) => {
    d.picture.simplices.forEach((simplex, s) => simplex.slice(1).forEach((i, k) =>
      d.line(d.at(simplex[k]), d.at(i), s === 0 ? 'first' : 'second', undefined, { arrow: true })));
    return `The arrows follow the order in which ${list(v.simplices[0])} and ${list(v.simplices[1])} list ` +
      'their corners. One turns like a right hand, the other like a left hand.';
  },
  'complex.duplicate-simplex': (d, v) =>
    `${list(v.simplices[0])} and ${list(v.simplices[1])} are the same ${noun(v.simplices[0])}, listed twice.`,
  'complex.facet-overused': (d, v) =>
    `${v.simplices.length} simplices have ${noun(v.face)} ${list(v.face)}. It has two sides, so at least two ` +
    'of them lie on the same one and overlap. "Explode" moves them apart.',
  'complex.overlap': (d, v) => {
    overlap(d);
    return `The ${noun(v.simplices[0])} ${list(v.simplices[0])} and the ${noun(v.simplices[1])} ` +
      `${list(v.simplices[1])} meet in more than a common face.`;
  },
  'complex.wrong-neighbor': (d, v) =>
    `Across ${noun(v.face)} ${list(v.face)} another simplex lies than the one that is listed as neighbour.`,
  'triangulation.unused-point': (d, v) =>
    `Point ${list(v.vertices)} is a corner of no simplex.`,
  'triangulation.hull-not-closed': (d, v) =>
    `The boundary is torn or pinched: ${v.simplices.length} of its facets meet in ` +
    `${v.face.length ? `${noun(v.face)} ${list(v.face)}` : 'the empty face'}, where two are to.`,
  'triangulation.hull-not-convex': (d, v) => {
    const q = d.picture.vertices[0];
    const face = d.picture.face;
    if (face && q !== undefined) {
      const hole = [...d.all(face), d.at(q)];
      for (const side of triangles(hole)) d.polygon(side, 'hole', 'part of the hole', { hatch: true });
      for (const corner of d.all(face)) d.line(corner, d.at(q), 'hole', 'part of the hole', { dashed: true });
    }
    return `The mesh ends at ${noun(v.face)} ${list(v.face)}, and point ${list(v.vertices)} lies beyond. What ` +
      'is between them belongs to the convex hull and is covered by nothing, or is beside what covers it.';
  },
  'triangulation.covered-twice': (d, v) => {
    overlap(d);
    return `The ${noun(v.simplices[0])} ${list(v.simplices[0])} and ${list(v.simplices[1])} both cover the ` +
      'point that is marked: the mesh folds over itself or winds around twice.';
  },
  'domain.vertex-missing': (d, v) => {
    if (d.picture.nearest !== undefined && d.picture.cell?.vertex !== undefined) {
      d.line(d.at(d.picture.cell.vertex), d.at(d.picture.nearest), 'nearest', undefined, { dashed: true });
    }
    const far = v.nearest ? ` The nearest vertex of the mesh, ${v.nearest.vertex}, is about ` +
      `${v.nearest.distance_decimal} away.` : '';
    return `The domain has a vertex where the mesh has none.${far}`;
  },
  'domain.steiner-forbidden': (d, v) =>
    `Vertex ${list(v.vertices)} is no vertex of the domain, and the claim allows no further ones.`,
  'domain.vertex-in-edge': (d, v) =>
    `Vertex ${list(v.vertices)} lies inside edge ${list(v.face ?? [])}: the two belong to one segment, and the ` +
    'mesh is not cut there.',
  'domain.segment-missing': () =>
    'The segment of the domain is to consist of edges of the mesh, and at least part of it does not. ' +
    'Simplices of the mesh pass across it.',
  'domain.polygon-not-tiled': (d, v) => {
    cuts(d);
    const at = v.face ? ` Where the mesh is to have a triangle beside ${noun(v.face)} ${list(v.face)}, it has none.` : '';
    return `The green polygon of the domain is to consist of triangles of the mesh, and does not.${at}`;
  },
  'domain.images-meet': () => 'Cells of the domain that are apart have faces of the mesh in common.',
  'domain.uncovered': (d, v) => {
    bareSide(d, v);
    return `Part of the domain is covered by nothing${v.face ? `: it begins at ${noun(v.face)} ${list(v.face)}` : ''}.`;
  },
  'domain.outside': (d, v) =>
    `The ${noun(v.simplices[0])} ${list(v.simplices[0])} lies outside the domain, at least in part.`,
  'delaunay.facet-not-local': inBall,
  'delaunay.vertex-in-ball': inBall,
  'weighted.vertex-submerged': (d, v) => {
    weighted(d, v);
    return `Vertex ${list(v.vertices)} is so light that it lies above the lower hull of the lifted points. It ` +
      'is not to be a vertex.';
  },
  'weighted.point-below-plane': (d, v) => {
    weighted(d, v);
    return `Lifted by its weight, point ${list(v.vertices)} lies below the witness plane of ` +
      `${list(v.simplices[0])}.`;
  },
  'delaunay.no-empty-ball': (d, v) => {
    d.ball('ball', 'smallest ball through its corners');
    return `Every ball through the corners of ${list(v.simplices[0])} has one of the vertices ` +
      `${list(v.vertices)} inside. The smallest one is drawn.`;
  },
  'cdt.facet-not-local': visible,
  'cdt.visible-vertex-in-ball': visible,
  'cdt.dangling-not-delaunay': visible,
};

export const drawnRules = Object.keys(RULES);
