// Points of the plane drawn by hand, their triangulation, and edges that are flipped: what makes
// the files drawn.node and drawn.ele. Coordinates are whole numbers, so that all that is computed
// here is exact.
import { element, svg } from '../../oracle/picture/page/elements.js';

const width = 600;
const height = 400;

const orientation = (a, b, c) => (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);

export class Plane {
  // `changed(flipped)` is called when points were changed, or an edge was flipped.
  constructor(changed) {
    this.changed = changed;
    this.points = [];
    this.triangles = [];
    this.picture = svg('svg', { viewBox: `0 0 ${width} ${height}`, class: 'plane', role: 'img',
      'aria-label': 'Points of the plane and their triangulation' });
    this.picture.addEventListener('pointerdown', (event) => this.press(event));
    this.picture.addEventListener('pointermove', (event) => this.drag(event));
    this.picture.addEventListener('pointerup', () => { this.held = undefined; });
    const number = (words, most) => element('input', { type: 'number', min: 0, max: most, value: 0, 'aria-label': words });
    const [x, y] = [number('x of a new point', width), number('y of a new point', height)];
    const add = element('button', { type: 'button' }, 'Add point');
    add.addEventListener('click', () => this.add(Math.round(Number(x.value)), Math.round(Number(y.value))));
    const undo = element('button', { type: 'button' }, 'Remove the last point');
    undo.addEventListener('click', () => this.replace(this.points.slice(0, -1)));
    this.node = element('div', {}, element('p', { class: 'note' },
      'Click for a point, and drag it. Click an edge to flip it. The mesh is built anew after each change of points.'),
    this.picture, element('div', { class: 'bar' }, x, y, add, undo));
    this.render();
  }

  replace(points) {
    this.points = points;
    this.triangles = [];
    this.render();
    this.changed(false);
  }

  add(x, y) {
    if (!this.points.some((p) => p.x === x && p.y === y)) this.replace([...this.points, { x, y }]);
  }

  // Where a pointer is: coordinates, with y upwards.
  place(event) {
    const box = this.picture.getBoundingClientRect();
    return { x: Math.round((event.clientX - box.left) / box.width * width),
      y: height - Math.round((event.clientY - box.top) / box.height * height) };
  }

  press(event) {
    const edge = event.target.dataset?.edge;
    const point = event.target.dataset?.point;
    if (edge) this.flip(edge.split(' ').map(Number));
    else if (point) this.held = Number(point);
    else {
      const { x, y } = this.place(event);
      this.add(x, y);
    }
  }

  drag(event) {
    if (this.held === undefined) return;
    const { x, y } = this.place(event);
    if (x < 0 || y < 0 || x > width || y > height || this.points.some((p) => p.x === x && p.y === y)) return;
    this.replace(this.points.map((p, i) => (i === this.held ? { x, y } : p)));
  }

  // The other diagonal, where the two triangles of an edge are a strictly convex quadrilateral.
  flip([a, b]) {
    const beside = this.triangles.filter((t) => t.includes(a) && t.includes(b));
    if (beside.length !== 2) return;
    const [c, d] = beside.map((t) => t.find((v) => v !== a && v !== b));
    const p = this.points;
    if (Math.sign(orientation(p[c], p[d], p[a])) * Math.sign(orientation(p[c], p[d], p[b])) >= 0) return;
    this.triangles = this.triangles.filter((t) => !beside.includes(t)).concat([[c, d, a], [d, c, b]]);
    this.render();
    this.changed(true);
  }

  // The files, in TetGen's form; indices from 1.
  nodeFile() { return `${this.points.length} 2 0 0\n${this.points.map((p, i) => `${i + 1} ${p.x} ${p.y}\n`).join('')}`; }
  eleFile() {
    return `${this.triangles.length} 3 0\n${this.triangles.map((t, i) => `${i + 1} ${t.map((v) => v + 1).join(' ')}\n`).join('')}`;
  }

  // Takes over what such files hold; anything else changes nothing.
  readNodes(text) {
    const rows = text.split('\n').slice(1).filter(Boolean).map((row) => row.trim().split(/\s+/).map(Number));
    if (rows.some((row) => row.length < 3 || !row.every(Number.isInteger))) return;
    this.points = rows.map(([, x, y]) => ({ x, y }));
    this.triangles = [];
    this.render();
  }

  readTriangles(text) {
    const rows = text.split('\n').slice(1).filter((row) => row && !row.startsWith('#'));
    this.triangles = rows.map((row) => row.trim().split(/\s+/).slice(1, 4).map((v) => Number(v) - 1));
    this.render();
  }

  render() {
    const edges = new Map();
    for (const t of this.triangles) {
      for (const [i, j] of [[0, 1], [1, 2], [0, 2]]) {
        const [a, b] = [t[i], t[j]].sort((one, other) => one - other);
        edges.set(`${a} ${b}`, [this.points[a], this.points[b]]);
      }
    }
    const line = (name, [a, b], rest) => svg('line', { class: name, x1: a.x, y1: height - a.y, x2: b.x, y2: height - b.y, ...rest });
    const lines = [...edges].filter(([, ends]) => ends[0] && ends[1]);
    this.picture.replaceChildren(
      ...lines.map(([, ends]) => line('first', ends, { 'stroke-width': 2 })),
      ...lines.map(([name, ends]) => line('grip', ends, { 'data-edge': name })),
      ...this.points.map((p, i) => svg('circle', { class: 'dot vertex', cx: p.x, cy: height - p.y, r: 6, 'data-point': i })),
      ...this.points.map((p, i) => svg('text', { class: 'corner', x: p.x + 8, y: height - p.y - 6 }, String(i + 1))));
  }
}
