// One picture that can be turned, magnified, exploded, cut and stretched, by mouse, touch or keys.
import { Camera } from './camera.js';
import { Drawing, largestStretch } from './drawing.js';
import { svgOf } from './flat.js';
import { button, element, slider, svg } from './elements.js';

const KEYS = {
  ArrowLeft: (camera, shift) => (shift ? camera.move(-0.1, 0) : camera.turn(-0.12, 0)),
  ArrowRight: (camera, shift) => (shift ? camera.move(0.1, 0) : camera.turn(0.12, 0)),
  ArrowUp: (camera, shift) => (shift ? camera.move(0, 0.1) : camera.turn(0, 0.12)),
  ArrowDown: (camera, shift) => (shift ? camera.move(0, -0.1) : camera.turn(0, -0.12)),
  '+': (camera) => camera.magnify(1.25),
  '=': (camera) => camera.magnify(1.25),
  '-': (camera) => camera.magnify(0.8),
  0: (camera) => camera.reset(),
};

export class View {
  // `stage` lends the one WebGL renderer: stage.enter(view) calls view.become(solid) if there is
  // one. `changes`: whether it will show other drawings of the same points.
  constructor(violation, picture, stage, name, changes = false) {
    Object.assign(this, { violation, picture, stage, changes, explode: 0, cut: 1, stretch: 1, showsLabels: true });
    this.most = largestStretch(picture);
    this.drawing = new Drawing(violation, picture);
    this.camera = new Camera(this.drawing);
    this.image = svg('svg', { viewBox: '0 0 720 480', 'aria-hidden': 'true' });
    this.overlay = svg('svg', { viewBox: '0 0 720 480', class: 'overlay', 'aria-hidden': 'true' });
    this.stand = element('div', {
      class: 'view', tabindex: '0', role: 'application', 'aria-roledescription': 'picture',
      'aria-label': `${name}. ${this.drawing.caption} Arrow keys turn it, with Shift they move it, plus and minus ` +
        'magnify, 0 resets.' }, this.image);
    this.listen();
    this.legend = element('ul', { class: 'legend' });
    this.node = element('div', { class: 'picture' }, this.stand, this.controls(), this.legend);
    this.explain();
    this.render();
  }

  // Shows another drawing in the place of this one, seen as before.
  show(violation, picture) {
    Object.assign(this, { violation, picture });
    this.drawing = new Drawing(violation, picture, this.stretch);
    this.isNew = true;
    this.explain();
    this.render();
  }

  listen() {
    const { stand, camera } = this;
    stand.addEventListener('keydown', (event) => {
      const act = KEYS[event.key];
      if (!act || event.ctrlKey || event.altKey || event.metaKey) return;
      event.preventDefault();
      act(camera, event.shiftKey);
      this.render();
    });
    stand.addEventListener('focus', () => this.stage.enter(this));
    const pointers = new Map();
    stand.addEventListener('pointerdown', (event) => {
      stand.focus({ preventScroll: true });
      stand.setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, [event.clientX, event.clientY]);
    });
    stand.addEventListener('pointermove', (event) => {
      const before = pointers.get(event.pointerId);
      if (!before) return;
      const height = stand.clientHeight / 2;
      const x = (event.clientX - before[0]) / height;
      const y = (event.clientY - before[1]) / height;
      if (pointers.size > 1) {
        const other = [...pointers].find(([id]) => id !== event.pointerId)[1];
        const apart = (at) => Math.hypot(at[0] - other[0], at[1] - other[1]);
        camera.magnify(apart([event.clientX, event.clientY]) / Math.max(apart(before), 1));
      } else if (event.shiftKey || event.buttons === 4) {
        camera.move(x, -y);
      } else if (camera.isFlat) {
        camera.move(x, -y);
      } else {
        camera.turn(-x * 1.5, y * 1.5);
      }
      pointers.set(event.pointerId, [event.clientX, event.clientY]);
      this.render();
    });
    for (const end of ['pointerup', 'pointercancel']) {
      stand.addEventListener(end, (event) => pointers.delete(event.pointerId));
    }
    // Only a picture that was chosen takes the wheel, so that the page scrolls past the others.
    stand.addEventListener('wheel', (event) => {
      if (document.activeElement !== stand) return;
      event.preventDefault();
      camera.magnify(Math.exp(-event.deltaY / 400));
      this.render();
    }, { passive: false });
  }

  controls() {
    const change = (key, value) => {
      this[key] = value;
      if (key === 'stretch') this.drawing = new Drawing(this.violation, this.picture, value);
      if (key === 'stretch' || key === 'explode') this.isNew = true;
      this.render();
    };
    const rows = [];
    if (this.changes || this.picture.near.length + this.picture.simplices.length > 1) {
      rows.push(slider('Explode', 0, 1.5, 0, (x) => change('explode', x)));
    }
    if (this.picture.dimension === 3) rows.push(slider('Cut away', 0, 1, 0, (x) => change('cut', 1 - x)));
    if (this.most > 1) {
      const words = element('span', { class: 'note' }, '');
      rows.push(slider('Exaggerate', 0, 1, 0, (x) => {
        const factor = this.most ** x;
        words.textContent = factor === 1 ? '' : `stretched ${factor.toPrecision(3)} times across the thin ` +
          'direction: an affine map, under which balls are ellipsoids. Flatness and overlaps stay what they are.';
        change('stretch', factor);
      }), words);
    }
    rows.push(button('Labels', () => {
      this.showsLabels = !this.showsLabels;
      this.stand.classList.toggle('unlabelled', !this.showsLabels);
      return this.showsLabels;
    }, true), button('Reset', () => {
      this.camera.reset();
      for (const input of this.node.querySelectorAll('input')) {
        input.value = 0;
        input.dispatchEvent(new Event('input'));
      }
      this.render();
    }));
    return element('div', { class: 'controls' }, ...rows);
  }

  explain() {
    this.legend.replaceChildren(...[...this.drawing.legend].map(([role, words]) =>
      element('li', {}, element('span', { class: `key ${role}`, 'aria-hidden': 'true' }), words)));
  }

  become(solid) {
    this.solid = solid;
    this.isNew = true;
    if (solid) this.stand.append(solid.canvas, this.overlay);
    this.stand.classList.toggle('solid', Boolean(solid));
    this.render();
  }

  // How near to the eye things may be before they are cut away.
  nearest() { return this.cut === 1 ? Infinity : (2 * this.cut - 1) * this.camera.size; }

  render() {
    const options = { explode: this.explode, cut: this.nearest() };
    if (!this.solid) {
      this.image.innerHTML = svgOf(this.drawing, this.camera, options);
      return;
    }
    if (this.isNew) this.solid.show(this.drawing, options, this.stage.colour);
    this.isNew = false;
    const labels = this.solid.draw(this.camera, options.cut);
    this.overlay.replaceChildren(...labels.map(({ x, y, name, role }) => svg('text', { x, y, class: role }, name)));
  }
}
