// From where a drawing is seen: an orthographic camera that turns about the middle of the picture.
// Of a mesh of the plane it looks straight down and only moves and magnifies.
import { add, cross, dot, length, sub, times } from './vectors.js';

export class Camera {
  // At first it shows the witness, and a ball that is not much larger.
  constructor({ points, picture }) {
    const isWhole = picture.mark === 'whole';
    const core = isWhole ? points : points.slice(0, picture.core);
    const { ball } = picture;
    const isSmall = ball?.centre && ball.radius < 2.5;
    this.isFlat = picture.dimension < 3;
    this.middle = isSmall ? ball.centre : [0, 0, 0];
    const reach = (some) => Math.max(0, ...some.map((p) => length(sub(p, this.middle))));
    // Half the height of what is seen when nothing is magnified. A point alone is seen among all
    // the others.
    this.size = 1.15 * Math.max(0.2, isSmall ? ball.radius : 0, reach(core) || reach(points));
    this.reset();
    if (isWhole) this.size *= 1.1 * Math.max(...points.map((p) => this.project(p)).map(([x, y]) => Math.max(Math.abs(y), Math.abs(x) / 1.5)));
    else this.lookAt(core, picture.face ? points.filter((_, i) => picture.face.includes(i)) : []);
  }

  reset() {
    this.yaw = this.isFlat ? 0 : this.best?.[0] ?? 0.6;
    this.pitch = this.isFlat ? 0 : this.best?.[1] ?? 0.35;
    this.zoom = 1;
    this.target = this.middle;
  }

  // Right, up, and towards the eye.
  axes() {
    if (this.isFlat) return [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    const { yaw, pitch } = this;
    const right = [Math.cos(yaw), Math.sin(yaw), 0];
    const eye = [Math.sin(yaw) * Math.cos(pitch), -Math.cos(yaw) * Math.cos(pitch), Math.sin(pitch)];
    return [right, cross(eye, right), eye];
  }

  // Coordinates on the picture, of which the height is 2, and how near to the eye.
  project(p) {
    const [right, up, eye] = this.axes();
    const q = sub(p, this.target);
    const s = this.zoom / this.size;
    return [dot(q, right) * s, dot(q, up) * s, dot(q, eye)];
  }

  turn(yaw, pitch) {
    if (this.isFlat) return this.move(yaw, -pitch);
    this.yaw += yaw;
    this.pitch = Math.max(-1.5707, Math.min(1.5707, this.pitch + pitch));
  }

  // By shares of the picture's half height.
  move(x, y) {
    const [right, up] = this.axes();
    const s = this.size / this.zoom;
    this.target = add(this.target, add(times(right, -x * s), times(up, -y * s)));
  }

  magnify(factor) {
    this.zoom = Math.max(0.05, Math.min(1e6, this.zoom * factor));
  }

  // Looks from where the given points lie furthest apart in the picture, and a triangle is not seen
  // from its edge.
  lookAt(points, face) {
    if (this.isFlat) return;
    let best = -1;
    // Never nearly along an axis, where boxes look like squares, and what is flat is not seen to be
    // so.
    for (let i = 0; i < 12; ++i) {
      for (const pitch of [0.3, 0.5, 0.75, -0.35]) {
        this.yaw = Math.floor(i / 3) * (Math.PI / 2) + [0.45, 0.8, 1.1][i % 3];
        this.pitch = pitch;
        const seen = points.map((p) => this.project(p));
        let nearest = Infinity;
        for (let a = 0; a < seen.length; ++a) {
          for (let b = 0; b < a; ++b) {
            if (length(sub(points[a], points[b])) < 1e-9) continue;
            const apart = Math.hypot(seen[a][0] - seen[b][0], seen[a][1] - seen[b][1]);
            nearest = Math.min(nearest, apart);
          }
        }
        if (face.length === 3) {
          const [a, b, c] = face.map((p) => this.project(p));
          nearest = Math.min(nearest, Math.sqrt(Math.abs((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]))));
        }
        // Of views as good as each other the usual one, from somewhat above.
        const score = nearest - 0.02 * Math.abs(pitch - 0.4);
        if (score > best) {
          best = score;
          this.best = [this.yaw, this.pitch];
        }
      }
    }
    this.reset();
  }
}
