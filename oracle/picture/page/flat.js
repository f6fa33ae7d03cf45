// Drawings as SVG: of meshes of the plane, where there is no WebGL, on paper, and as images for
// pages. Items are drawn from the farthest to the nearest.
import { add, cross, dot, frame, length, middle, sub, times } from './vectors.js';

export const WIDTH = 720;
export const HEIGHT = 480;
const LARGE = { 2: 300, 3: 12 };  // a ball with a larger radius is drawn as its surface near the picture

const round = (x) => (Math.abs(x) < 1e7 ? x.toFixed(1) : (Math.sign(x) * 1e7).toFixed(0));
const escape = (text) => String(text).replace(/[&<>"']/g, (c) => `&#${c.charCodeAt(0)};`);

// How thick lines and how large dots of a role are, and what is above all else.
export const STYLE = {
  first: { line: 2, fill: 0.24 },
  second: { line: 2, fill: 0.24 },
  third: { line: 2, fill: 0.24 },
  face: { line: 3, fill: 0.4 },
  vertex: { dot: 7, front: true },
  point: { dot: 5, front: true },
  corner: { dot: 3.5 },
  ball: { line: 1.5, fill: 0.12 },
  missing: { line: 1.5, fill: 0, dashed: true },
  hole: { line: 2, fill: 0.22 },
  common: { line: 2, fill: 0.3, front: true },
  domain: { line: 4, fill: 0.2, dot: 4 },
  nearest: { line: 2, dot: 6, front: true },
  wall: { line: 1, fill: 0.05 },
  other: { line: 1.5 },
  skin: { line: 0.5, fill: 0.3 },
  place: { dot: 8, front: true },
  near: { line: 0.7, fill: 0.06 },
  boundary: { line: 0.7, fill: 0.05 },
  cut: { line: 1.5, front: true },
  ray: { line: 1.5, front: true },
  blocked: { line: 1.5, front: true },
};

export const isLarge = (item, dimension) => item.radius > LARGE[dimension === 2 ? 2 : 3];

// Meridians and parallels of a ball about the origin.
export function rings(radius) {
  const circle = (centre, u, v) => Array.from({ length: 64 }, (_, i) => {
    const t = (2 * Math.PI * i) / 64;
    return centre.map((c, k) => c + Math.cos(t) * u[k] + Math.sin(t) * v[k]);
  });
  const found = [];
  for (let i = 0; i < 6; ++i) {
    const [along, across] = [radius * Math.cos((Math.PI * i) / 6), radius * Math.sin((Math.PI * i) / 6)];
    found.push(circle([0, 0, 0], [along, across, 0], [0, 0, radius]));
    if (i > 0) found.push(circle([0, 0, along], [across, 0, 0], [0, across, 0]));
  }
  return found;
}

// The surface of a large ball near the picture: rings of points about the point `near` of it.
export function patch(item, reach = 2.4, rings = 8, sectors = 48) {
  const n = item.normal;
  const [u, v] = frame(n);
  const point = (distance, angle) => {
    const theta = distance / item.radius;
    const along = add(times(u, Math.cos(angle)), times(v, Math.sin(angle)));
    const across = Math.min(theta, 1e-3) < 1e-3 ? Math.sin(theta) * item.radius : distance;
    const sunk = 2 * Math.sin(theta / 2) ** 2 * item.radius;
    return add(item.near, add(times(along, across), times(n, -sunk)));
  };
  const grid = [];
  for (let r = 0; r <= rings; ++r) {
    const ring = [];
    for (let s = 0; s < sectors; ++s) ring.push(point((reach * r) / rings, (2 * Math.PI * s) / sectors));
    grid.push(ring);
  }
  return grid;
}

// The inside of a large circle near the picture, as a polygon.
function segmentOfDisk(item) {
  const n = item.normal;
  const along = cross([0, 0, 1], n);
  const polygon = [];
  for (let i = -40; i <= 40; ++i) {
    const t = (i / 40) * 6;
    const theta = t / item.radius;
    polygon.push(add(item.near, add(times(along, Math.sin(theta) * item.radius),
      times(n, -2 * Math.sin(theta / 2) ** 2 * item.radius))));
  }
  return [...polygon, add(polygon[80], times(n, -12)), add(polygon[0], times(n, -12))];
}

// Where an item is once the picture is exploded.
export function moved(item, explode) {
  if (!item.cell || explode === 0) return item.at;
  return item.at.map((p) => add(p, times(item.cell.centre, explode)));
}

// The outline of a ball that an affine map has stretched: half axes and the angle of an ellipse.
function outline(item, camera, drawing) {
  const { stretch } = drawing;
  const [right, up] = camera.axes();
  const r = (item.radius * camera.zoom) / camera.size;
  if (stretch === 1 || !drawing.picture.thin) return [r, r, 0];
  const n = drawing.picture.thin.normal;
  const k = stretch * stretch - 1;
  const a = 1 + k * dot(n, right) ** 2;
  const b = k * dot(n, right) * dot(n, up);
  const c = 1 + k * dot(n, up) ** 2;
  const mean = (a + c) / 2;
  const root = Math.hypot((a - c) / 2, b);
  const angle = 0.5 * Math.atan2(2 * b, a - c);
  return [r * Math.sqrt(mean + root), r * Math.sqrt(Math.max(mean - root, 0)), angle];
}

// Labels beside their points, the later ones moved away from those that are there.
export function placedLabels(dots) {
  const placed = [];
  const seen = new Set();
  for (const { x, y, name, role } of dots) {
    if (!name || seen.has(name)) continue;
    seen.add(name);
    let best = [x + 9, y - 9];
    for (const [dx, dy] of [[9, -9], [9, 17], [-9 - 8 * name.length, -9], [-9 - 8 * name.length, 17], [9, 32], [9, -26]]) {
      if (placed.every((o) => Math.abs(o.x - x - dx) > 7 * Math.max(name.length, o.name.length) + 4 ||
                              Math.abs(o.y - y - dy) > 14)) {
        best = [x + dx, y + dy];
        break;
      }
    }
    placed.push({ x: best[0], y: best[1], name, role });
  }
  return placed;
}

const onPage = ([x, y, z]) => [WIDTH / 2 + (x * HEIGHT) / 2, HEIGHT / 2 - (y * HEIGHT) / 2, z];

// How dark a triangle of the skin is: the darker, the less it faces the light, which comes from
// above the eye.
function shade([a, b, c], camera) {
  const normal = cross(sub(b, a), sub(c, a));
  const [right, up, eye] = camera.axes();
  const light = add(eye, add(times(up, 0.8), times(right, -0.5)));
  const towards = Math.sign(dot(normal, eye)) * dot(normal, light) / (length(normal) * length(light) || 1);
  return (0.1 + 0.45 * (1 - Math.max(0, towards))).toFixed(2);
}

// The elements inside <svg viewBox="0 0 720 480">. `cut`: what is nearer to the eye than this is
// left out.
export function svgOf(drawing, camera, { explode = 0, cut = Infinity } = {}) {
  const see = (p) => onPage(camera.project(p));
  const pieces = [];
  const dots = [];
  for (const item of drawing.items) {
    const style = STYLE[item.role];
    const at = moved(item, explode);
    const depth = camera.project(middle(at))[2];
    if (depth > cut && item.role !== 'ball') continue;
    if (item.isDrawn && explode === 0) continue;
    const dash = item.dashed || style.dashed ? ' stroke-dasharray="6 4"' : '';
    let text = '';
    if (item.kind === 'polygon') {
      const corners = at.map((p) => see(p).slice(0, 2).map(round).join(',')).join(' ');
      const outlined = ['hole', 'common'].includes(item.role) ? '' : ' stroke="none"';
      const isSolid = item.role === 'skin' && !camera.isFlat;
      const fill = isSolid ? shade(at, camera) : style.fill;
      text = (isSolid ? `<polygon class="paper" points="${corners}"/>` : '') +
        `<polygon class="${item.role}" points="${corners}" fill-opacity="${fill}"` +
        `${item.role === 'skin' ? ` stroke-width="${style.line}"` : outlined}/>` +
        (item.hatch ? `<polygon points="${corners}" fill="url(#hatch-${item.role})" stroke="none"/>` : '');
    } else if (item.kind === 'line') {
      const [a, b] = at.map(see);
      const arrow = item.arrow ? ` marker-end="url(#arrow-${item.role})"` : '';
      text = `<line class="${item.role}" x1="${round(a[0])}" y1="${round(a[1])}" x2="${round(b[0])}" ` +
        `y2="${round(b[1])}" stroke-width="${style.line}"${dash}${arrow}/>`;
    } else if (item.kind === 'dot') {
      const [x, y] = see(at[0]);
      dots.push({ x, y, name: item.name, role: item.role });
      text = `<circle class="dot ${item.role}" cx="${round(x)}" cy="${round(y)}" r="${style.dot}"/>`;
    } else if (isLarge(item, drawing.picture.dimension)) {
      const polygon = drawing.picture.dimension === 2 ? segmentOfDisk(item) : patch(item).at(-1);
      const corners = polygon.map((p) => see(p).slice(0, 2).map(round).join(',')).join(' ');
      text = `<polygon class="${item.role}" points="${corners}" fill-opacity="${style.fill}" ` +
        `stroke-width="${style.line}"/>`;
    } else {
      const [x, y] = see(at[0]);
      const [rx, ry, angle] = outline(item, camera, drawing);
      const half = HEIGHT / 2;
      text = `<ellipse class="${item.role}" rx="${round(rx * half)}" ry="${round(ry * half)}" ` +
        `transform="translate(${round(x)} ${round(y)}) rotate(${round((-angle * 180) / Math.PI)})" ` +
        `fill-opacity="${style.fill}" stroke-width="${style.line}"${dash}/>`;
      if (drawing.picture.dimension === 3 && drawing.stretch === 1) {
        const lines = rings(item.radius).map((ring) => ring.map((p) => see(add(p, at[0])).slice(0, 2).map(round).join(',')));
        text += lines.map((line) => `<polygon class="${item.role}" points="${line.join(' ')}" fill="none" ` +
          'fill-opacity="0" stroke-width="0.5" stroke-opacity="0.5"/>').join('');
      }
    }
    const layer = style.front || item.kind === 'dot' ? 2 : item.kind === 'ball' ? 0 : 1;
    pieces.push({ layer, depth, text });
  }
  pieces.sort((a, b) => a.layer - b.layer || a.depth - b.depth);
  const labels = placedLabels(dots).map(({ x, y, name, role }) =>
    `<text class="${role}" x="${round(x)}" y="${round(y)}">${escape(name)}</text>`);
  return DEFINITIONS + pieces.map((piece) => piece.text).join('') + labels.join('');
}

const DEFINITIONS = '<defs>' +
  ['domain', 'hole'].map((role) =>
    `<pattern id="hatch-${role}" width="8" height="8" patternUnits="userSpaceOnUse" ` +
    `patternTransform="rotate(45)"><line class="${role}" y2="8" stroke-width="1.5"/></pattern>`).join('') +
  ['first', 'second', 'hole'].map((role) =>
    `<marker id="arrow-${role}" viewBox="0 0 8 8" refX="9" refY="4" markerWidth="5" markerHeight="5" ` +
    `orient="auto"><path class="${role} solid" d="M0 0 8 4 0 8z"/></marker>`).join('') + '</defs>';

// An image that stands alone.
export function imageOf(drawing, camera, title, style) {
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img">` +
    `<title>${escape(title)}</title><style>${style}</style>${svgOf(drawing, camera)}</svg>\n`;
}
