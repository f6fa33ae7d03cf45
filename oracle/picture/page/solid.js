// Drawings in WebGL, by three.js. One renderer serves the whole page, since browsers allow few: it
// stands in the picture that is being turned, and the others are SVG.
import {
  AmbientLight, BufferGeometry, Color, DirectionalLight, DoubleSide, Float32BufferAttribute, Group,
  LineBasicMaterial, LineSegments, Matrix4, Mesh, MeshPhongMaterial, OrthographicCamera,
  Plane, Scene, SphereGeometry, Vector3, WebGLRenderer,
} from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { HEIGHT, STYLE, WIDTH, isLarge, moved, patch, placedLabels, rings } from './flat.js';
import { hatching, sub } from './vectors.js';

const vector = (p) => new Vector3(...p);

// The rings of a ball about the origin, or of the patch of a large one, as pairs of ends.
const gridLines = (item, large) => (large ? patch(item).filter((_, i) => i % 2 === 0) : rings(item.radius))
  .flatMap((ring) => ring.flatMap((p, i) => [p, ring[(i + 1) % ring.length]]));

export class Solid {
  // Throws where there is no WebGL.
  constructor() {
    this.renderer = new WebGLRenderer({ antialias: true, alpha: true });
    this.renderer.localClippingEnabled = true;
    this.canvas = this.renderer.domElement;
    this.canvas.setAttribute('aria-hidden', 'true');
    this.camera = new OrthographicCamera();
    this.cut = new Plane(new Vector3(), 0);
  }

  // Makes the scene of a drawing; `colour` gives the colour of a role.
  show(drawing, { explode }, colour) {
    this.dispose();
    this.scene = new Scene();
    this.drawing = drawing;
    this.explode = explode;
    const faces = new Map();
    const lines = new Map();
    const group = new Group();
    for (const item of drawing.items) {
      const at = moved(item, explode);
      if (item.isDrawn && explode === 0) continue;
      if (item.kind === 'polygon' && item.hatch) this.gather(lines, `${item.role} hatch`, hatching(at).flat());
      if (item.kind === 'polygon') this.gather(faces, item.role, at.slice(2).flatMap((p, i) => [at[0], at[i + 1], p]));
      else if (item.kind === 'line') this.gather(lines, `${item.role} ${item.dashed ? 'dashed' : ''}`, at);
      else if (item.kind === 'dot') group.add(this.dot(item, at[0], colour));
      else this.ball(item, group, colour);
      if (item.kind === 'line' && item.arrow) group.add(this.arrow(at, item.role, colour));
    }
    for (const [role, at] of faces) group.add(this.faces(role, at, colour));
    for (const [key, at] of lines) group.add(this.lines(key, at, colour));
    this.light = new DirectionalLight(0xffffff, 1.8);
    this.scene.add(group, new AmbientLight(0xffffff, 1.7), this.light);
  }

  gather(map, key, at) { map.set(key, [...(map.get(key) ?? []), ...at]); }

  geometry(at) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new Float32BufferAttribute(at.flat(), 3));
    return geometry;
  }

  faces(role, at, colour) {
    const geometry = this.geometry(at);
    geometry.computeVertexNormals();
    const isSolid = role === 'skin';
    const faces = new Mesh(geometry, new MeshPhongMaterial({
      color: colour(role), side: DoubleSide, transparent: !isSolid, opacity: isSolid ? 1 : STYLE[role].fill * 1.4,
      flatShading: isSolid, depthWrite: isSolid, depthTest: !STYLE[role].front, clippingPlanes: [this.cut] }));
    faces.renderOrder = STYLE[role].front ? 2 : 1;
    return faces;
  }

  lines(key, at, colour) {
    const [role, kind] = key.split(' ');
    const dashed = kind === 'dashed';
    const material = new LineMaterial({
      color: colour(role), linewidth: kind === 'hatch' ? 1.5 : STYLE[role].line, clippingPlanes: [this.cut],
      transparent: true, opacity: { near: 0.3, boundary: 0.3, wall: 0.5 }[role] ?? 1, depthTest: !STYLE[role].front,
      dashed, dashSize: 0.05, gapSize: 0.035 });
    const lines = new LineSegments2(new LineSegmentsGeometry().setPositions(at.flat()), material);
    if (dashed) lines.computeLineDistances();
    lines.renderOrder = 3;
    return lines;
  }

  dot(item, at, colour) {
    const dot = new Mesh(new SphereGeometry(1, 20, 14),
      new MeshPhongMaterial({ color: colour(item.role), clippingPlanes: [this.cut], depthTest: item.role !== 'place' }));
    if (item.role === 'place') dot.renderOrder = 4;
    dot.position.copy(vector(at));
    dot.userData.size = STYLE[item.role].dot;
    return dot;
  }

  // A cone would need no code but would look like part of the mesh: two short strokes.
  arrow([a, b], role, colour) {
    const back = sub(a, b).map((x) => x * 0.12);
    const [x, y, z] = back;
    const side = Math.abs(z) < Math.hypot(x, y) ? [-y * 0.6, x * 0.6, 0] : [z * 0.6, 0, -x * 0.6];
    const strokes = [1, -1].flatMap((s) => [b, b.map((c, i) => c + back[i] + s * side[i])]);
    return this.lines(role, strokes, colour);
  }

  ball(item, group, colour) {
    const large = isLarge(item, 3);
    const { stretch, picture } = this.drawing;
    if (large && stretch !== 1) return;  // the page says so
    const geometry = large ? this.patchGeometry(item) : new SphereGeometry(item.radius, 64, 40);
    const style = STYLE[item.role];
    const parts = [new LineSegments(this.geometry(gridLines(item, large)), new LineBasicMaterial({
      color: colour(item.role), transparent: true, opacity: 0.35, clippingPlanes: [this.cut] }))];
    if (style.fill > 0) {
      parts.push(new Mesh(geometry, new MeshPhongMaterial({
        color: colour(item.role), transparent: true, opacity: 0.16, depthWrite: false, side: DoubleSide,
        clippingPlanes: [this.cut] })));
    }
    for (const part of parts) {
      part.matrixAutoUpdate = false;
      if (!large) part.matrix.copy(this.stretched(stretch, picture.thin)).setPosition(vector(item.at[0]));
      group.add(part);
    }
  }

  stretched(stretch, thin) {
    const m = new Matrix4();
    if (stretch === 1 || !thin) return m;
    const n = thin.normal;
    const k = stretch - 1;
    const e = (i, j) => (i === j ? 1 : 0) + k * n[i] * n[j];
    return m.set(e(0, 0), e(0, 1), e(0, 2), 0, e(1, 0), e(1, 1), e(1, 2), 0, e(2, 0), e(2, 1), e(2, 2), 0, 0, 0, 0, 1);
  }

  patchGeometry(item) {
    const grid = patch(item);
    const at = [];
    for (let r = 0; r + 1 < grid.length; ++r) {
      for (let s = 0; s < grid[r].length; ++s) {
        const t = (s + 1) % grid[r].length;
        at.push(grid[r][s], grid[r + 1][s], grid[r + 1][t], grid[r][s], grid[r + 1][t], grid[r][t]);
      }
    }
    const geometry = this.geometry(at);
    geometry.computeVertexNormals();
    return geometry;
  }

  // Draws what the camera sees, at the size in which the canvas stands, and returns the labels in
  // the units of the SVG.
  draw(camera, cut) {
    const width = this.canvas.clientWidth || WIDTH;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.renderer.setSize(width, (width * HEIGHT) / WIDTH, false);
    const [right, up, eye] = camera.axes();
    const half = camera.size / camera.zoom;
    const far = 60 * camera.size;
    Object.assign(this.camera, {
      left: -half * (WIDTH / HEIGHT), right: half * (WIDTH / HEIGHT), top: half, bottom: -half, near: 0, far: 2 * far });
    this.camera.matrixAutoUpdate = false;
    this.camera.matrix.makeBasis(vector(right), vector(up), vector(eye))
      .setPosition(vector(camera.target).addScaledVector(vector(eye), far));
    this.camera.updateMatrixWorld(true);
    this.camera.updateProjectionMatrix();
    this.light.position.copy(vector(eye)).addScaledVector(vector(up), 0.8).addScaledVector(vector(right), -0.5);
    this.cut.normal.copy(vector(eye)).negate();
    this.cut.constant = Math.min(cut, 1e6) + vector(eye).dot(vector(camera.target));
    const pixel = (2 * half) / HEIGHT;
    this.scene.traverse((part) => {
      if (part.userData.size) part.scale.setScalar(part.userData.size * pixel);
      part.material?.resolution?.set(width, (width * HEIGHT) / WIDTH);
    });
    this.renderer.render(this.scene, this.camera);
    const dots = this.drawing.items.filter((item) => item.kind === 'dot').map((item) => {
      const [x, y] = camera.project(moved(item, this.explode)[0]);
      return { x: WIDTH / 2 + (x * HEIGHT) / 2, y: HEIGHT / 2 - (y * HEIGHT) / 2, name: item.name, role: item.role };
    });
    return placedLabels(dots);
  }

  dispose() {
    this.scene?.traverse((part) => {
      part.geometry?.dispose();
      part.material?.dispose();
    });
  }
}

// A colour of CSS as WebGL takes it.
export const colourOf = (text) => new Color(text.trim());
