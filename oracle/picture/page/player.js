// A construction, step by step: what each frame deletes, creates and looks at.
import { button, element } from './elements.js';
import { add, cross, dot, length, sub, times } from './vectors.js';
import { View } from './view.js';

const GROUPS = [['deleted', 'second', 'is deleted'], ['created', 'first', 'is created'], ['look', 'third', 'is looked at'],
  ['all', 'first', 'the triangulation']];
const key = (simplex) => [...simplex].sort((a, b) => a - b).join(' ');

// The ball through the corners, in doubles: nothing is decided by it. Undefined if it is too large
// to be seen.
function circumball(corners, dimension) {
  const [a, ...rest] = corners;
  const e = rest.map((p) => sub(p, a));
  let centre;
  if (dimension === 2) {
    const twice = 2 * (e[0][0] * e[1][1] - e[0][1] * e[1][0]);
    const n = e.map((v) => dot(v, v));
    centre = [(e[1][1] * n[0] - e[0][1] * n[1]) / twice, (e[0][0] * n[1] - e[1][0] * n[0]) / twice, 0];
  } else {
    const twice = 2 * dot(e[0], cross(e[1], e[2]));
    const part = (i, j, k) => times(cross(e[j], e[k]), dot(e[i], e[i]) / twice);
    centre = add(part(0, 1, 2), add(part(1, 2, 0), part(2, 0, 1)));
  }
  const radius = length(centre);
  return radius < 100 ? { centre: add(a, centre), radius } : undefined;
}

// The simplices that there are before each frame.
function states(frames) {
  const found = [];
  const alive = new Map();
  for (const frame of frames) {
    found.push([...alive.values()]);
    for (const simplex of frame.deleted ?? []) alive.delete(key(simplex));
    for (const simplex of frame.created ?? []) alive.set(key(simplex), simplex);
    if (frame.all) alive.clear();
  }
  return found;
}

// What Drawing takes of one frame.
function scene(base, frame, before, lower) {
  const drawn = new Set();
  const simplices = [];
  const groups = [];
  for (const [name, role, words] of GROUPS) {
    const some = (frame[name] ?? []).filter((simplex) => !drawn.has(key(simplex)));
    for (const simplex of some) drawn.add(key(simplex));
    if (some.length) groups.push({ role, words, count: some.length });
    simplices.push(...some);
  }
  const half = base.points.length / 2;
  const lifted = (face) => face.map((i) => i + half);
  const outlines = lower.map((face) => ({ corners: lifted(face), role: 'near', words: 'lower facets' }));
  if (frame.outline) {
    const role = frame.lower ? 'first' : 'second';
    outlines.push({ corners: lifted(frame.outline), role, words: frame.lower ? 'a lower facet' : 'an upper facet' });
    if (frame.lower) outlines.push({ corners: frame.outline, role: 'third', words: 'the cell below it' });
  }
  const ball = frame.ball && frame.ball.length === base.dimension + 1 && base.dimension > 1
    ? circumball(frame.ball.map((i) => base.points[i]), base.dimension) : undefined;
  const labels = (indices) => indices.map((i) => Number(base.names[i]));
  const picture = { ...base, simplices, outlines, ball,
    vertices: frame.vertex === undefined ? [] : [frame.vertex],
    face: frame.face,
    near: before.filter((simplex) => !drawn.has(key(simplex))),
    dots: base.points.map((_, i) => i).filter((i) => i !== frame.vertex) };
  const v = { rule: '', caption: frame.words, groups, simplices: simplices.map(labels), around: 'the triangulation so far',
    ball_words: 'circumball', face: labels(frame.face ?? []), vertices: labels(picture.vertices), values: {} };
  return [v, picture];
}

export function player({ picture, frames }, stage, views) {
  const base = { ...picture, ball: undefined, core: picture.points.length };
  const before = states(frames);
  const lower = (at) => frames.slice(0, at).filter((frame) => frame.lower).map((frame) => frame.outline);
  const sceneOf = (at) => scene(base, frames[at], before[at], lower(at));
  let now = 0;
  const view = new View(...sceneOf(0), stage, 'The construction', true);
  views.push(view);
  const words = element('p', { class: 'caption', 'aria-live': 'polite', id: 'step' });
  const input = element('input', { type: 'range', min: 1, max: frames.length, step: 1, value: 1, 'aria-label': 'Step' });
  const go = (to) => {
    now = Math.max(0, Math.min(frames.length - 1, to));
    const { step, words: said } = frames[now];
    words.replaceChildren(`Step ${now + 1} of ${frames.length}. `, element('b', {}, step), `. ${said}`);
    input.value = now + 1;
    view.show(...sceneOf(now));
  };
  input.addEventListener('input', () => go(Number(input.value) - 1));
  let timer;
  const play = button('Play', () => {
    clearInterval(timer);
    timer = timer === undefined ? setInterval(() => {
      if (now + 1 < frames.length) go(now + 1);
      else play.click();
    }, 900) : undefined;
    play.textContent = timer === undefined ? 'Play' : 'Pause';
    if (timer !== undefined && now + 1 === frames.length) go(0);
  });
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || event.target.matches('input, textarea')) return;
    if (event.key === '.') go(now + 1);
    if (event.key === ',') go(now - 1);
  });
  go(0);
  return element('section', { class: 'player', 'aria-label': 'Step by step' }, element('h3', {}, 'Step by step'), words,
    element('div', { class: 'bar' }, button('Previous step', () => go(now - 1)), button('Next step', () => go(now + 1)), play, input,
      element('span', { class: 'note' }, 'Keys: . next, , previous step')),
    view.node);
}
