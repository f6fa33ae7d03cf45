// The page: verdicts, a card for each violation, and what moves between them. All that is shown
// comes from the JSON that stands in the page.
import { relativeDepth } from './drawing.js';
import { button, element, svg, table } from './elements.js';
import { histogram } from './histogram.js';
import { Solid, colourOf } from './solid.js';
import { player } from './player.js';
import { View } from './view.js';

const data = JSON.parse(document.getElementById('data').textContent);
const views = [];

// The place of the one WebGL renderer.
const stage = {
  enter(view) {
    if (view === this.view || view.camera.isFlat) return;
    try {
      this.solid ??= new Solid();
    } catch {
      document.body.classList.add('no-webgl');
      return;
    }
    this.view?.become(null);
    this.view = view;
    view.become(this.solid);
  },
  colour(role) {
    const probe = document.querySelector(`#colours .${role}`) ?? document.body;
    return colourOf(getComputedStyle(probe).color);
  },
};

function redraw() {
  if (!stage.view) return;
  stage.view.isNew = true;
  stage.view.render();
}

const pair = (value) => (value.exact === value.decimal ? [value.exact, ''] : [value.exact, value.decimal]);
const rounded = (text) => {
  const [a, b = '1'] = text.split('/');
  const value = Number(a) / Number(b);
  return Number.isFinite(value) ? String(value) : '';
};
const point = (coordinates) => [coordinates.join(',\n'),
  coordinates.some((x) => x.includes('/') || x.length > 17) ? coordinates.map(rounded).join(',\n') : ''];

// Where the points are that a witness names. If a lattice repeats the mesh, each corner is a copy
// of a point, at a place of its own.
function placeRows(v) {
  if (!v.places) return Object.entries(v.coordinates).map(([index, at]) => [`point ${index}`, ...point(at)]);
  const rows = (what, named, places) => named.flatMap((index, i) => (places[i] ? [[`${what} ${index}`, ...point(places[i])]] : []));
  return [...v.simplices.flatMap((simplex, i) => rows('corner of the simplex:', simplex, v.places.simplices[i])),
    ...rows('corner of the face:', v.face ?? [], v.places.face), ...rows('vertex', v.vertices, v.places.vertices)];
}

// What the witness consists of, exactly and rounded.
function exactTable(v, title) {
  const rows = [];
  const groups = (v.groups ?? []).flatMap((group) => Array(group.count).fill(group));
  v.simplices.forEach((simplex, i) => rows.push([groups[i]?.words ?? 'simplex', simplex.join(' '), '']));
  if (v.face) rows.push(['face', v.face.length ? v.face.join(' ') : 'the empty one', '']);
  if (v.vertices.length) rows.push([v.vertices.length > 1 ? 'vertices' : 'vertex', v.vertices.join(' '), '']);
  rows.push(...placeRows(v));
  if (v.point) rows.push(['point of the witness', ...point(v.point)]);
  if (v.domain?.polygon) rows.push(['polygon of the domain', v.domain.polygon, '']);
  for (const cell of ['segment', 'vertex']) {
    for (const [index, at] of Object.entries(v.domain?.[cell] ?? {})) {
      rows.push([`vertex ${index} of the domain`, ...point(at)]);
    }
  }
  if (v.ball) {
    rows.push(['centre of the ball', ...point(v.ball.centre)]);
    rows.push(['its squared radius', ...pair(v.ball.squared_radius)]);
    if (v.ball.radius_decimal) rows.push(['its radius', '', v.ball.radius_decimal]);
  }
  for (const [name, value] of Object.entries(v.values)) rows.push([name, ...pair(value)]);
  if (v.nearest) rows.push([`squared distance to vertex ${v.nearest.vertex}`, ...pair(v.nearest.squared_distance)]);
  return table(title, 'The witness, exactly', ['what', 'exact', 'rounded'], rows);
}

// The surface of the ball near a vertex that is barely inside, so large that its depth can be seen.
function loupe(v) {
  const share = relativeDepth(v);
  if (share === undefined || !(share < 2e-3)) return undefined;
  const depth = (share / 2).toPrecision(3);
  const image = svg('svg', { viewBox: '0 0 360 120', role: 'img', class: 'loupe',
    'aria-label': `Section across the surface: the vertex is inside by ${depth} of the radius` },
  svg('rect', { class: 'ball', x: 0, y: 50, width: 360, height: 70, 'fill-opacity': 0.2, stroke: 'none' }),
  svg('line', { class: 'ball', x1: 0, y1: 50, x2: 360, y2: 50, 'stroke-width': 2 }),
  svg('line', { class: 'vertex', x1: 180, y1: 50, x2: 180, y2: 88, 'stroke-width': 1 }),
  svg('circle', { class: 'dot vertex', cx: 180, cy: 88, r: 6 }),
  svg('text', { class: 'vertex', x: 192, y: 96 }, v.vertices.join(' ')),
  svg('text', { class: 'corner', x: 8, y: 40 }, 'outside'), svg('text', { class: 'corner', x: 8, y: 70 }, 'inside'));
  return element('figure', {}, image, element('figcaption', {},
    `No eye can see this at scale: vertex ${v.vertices.join(' ')} is inside by ${depth} of the radius. This section ` +
    `through it stretches the direction of the radius ${(0.3 / Number(depth)).toPrecision(3)} times, an affine map.`));
}

function copyButton(words, text) {
  return button(words, async (node) => {
    try {
      await navigator.clipboard.writeText(text);
    } catch {
      // Pages from files may not use the clipboard; the selection still can be copied.
      const area = element('textarea', { 'aria-label': 'JSON' }, text);
      document.body.append(area);
      area.select();
      document.execCommand('copy');
      area.remove();
    }
    node.textContent = 'Copied';
    setTimeout(() => { node.textContent = words; }, 1500);
  });
}

function card(v, picture, id, title) {
  const name = v.rule ? `${title}, ${v.rule}` : title;
  const heading = v.rule
    ? element('h3', {}, `${title}: `, element('a', { href: `#rule-${v.rule}` }, v.rule)) : element('h3', {}, title);
  const parts = [element('p', { class: 'meaning' }, `${v.meaning[0].toUpperCase()}${v.meaning.slice(1)}.`)];
  if (picture?.why_none) {
    parts.push(element('p', { class: 'note' }, picture.why_none));
  } else if (picture) {
    const view = new View(v, picture, stage, name);
    views.push(view);
    parts.push(element('p', { class: 'caption' }, view.drawing.caption), view.node);
    if (picture.left_out) parts.push(element('p', { class: 'note' }, picture.left_out));
    parts.push(loupe(v));
  }
  parts.push(element('details', {}, element('summary', {}, 'Exact values'), exactTable(v, title)),
    copyButton('Copy as JSON', JSON.stringify(v, null, 2)));
  return element('article', { id, class: 'card', tabindex: '-1', 'aria-label': name }, heading,
    ...parts.filter(Boolean));
}

// Numbers of violations, with a dash for those that follow each other, and no more than have room:
// "3, 5–9, 12 …".
function runs(numbers) {
  const parts = [];
  for (const n of numbers) {
    const last = parts.at(-1);
    if (last?.[1] === n - 1) last[1] = n;
    else parts.push([n, n]);
  }
  return parts.slice(0, 3).map(([from, to]) => (from === to ? `${from}` : `${from}–${to}`)).join(', ') +
    (parts.length > 3 ? ' …' : '');
}

// The mesh as a whole, with a dot where violations are. `first`: the number of the first.
function whole(overview, first, mesh) {
  const names = overview.marks.map((violations) => runs(violations.map((i) => first + i)));
  const caption = `The whole mesh${overview.coarser ? ', its surface drawn with fewer triangles' : ''}.` +
    (names.length ? ' The dots are where violations are, by their numbers.' : '');
  const picture = { ...overview, names, near: [], simplices: [], vertices: [], boundary: [],
    walls: { segments: [], triangles: [] } };
  const view = new View({ simplices: [], vertices: [], caption }, picture, stage, `${mesh}: the whole mesh`);
  views.push(view);
  return element('article', { class: 'card whole' }, element('p', { class: 'caption' }, caption), view.node);
}

function facts(report) {
  const rows = [['claim', report.claim], ['judged by', report.by], ['points', report.points],
    ['simplices', report.simplices], ['dimension', report.dimension]];
  for (const key of ['domain', 'domain_kind', 'unique', 'canonical']) {
    if (report[key] !== undefined) rows.push([key.replace('_', ' '), String(report[key])]);
  }
  for (const rule of report.rules) {
    const margin = rule.worst_relative_margin;
    rows.push([rule.rule, `broken ${rule.count} ${rule.count === 1 ? 'time' : 'times'}` +
      (margin ? `; worst relative margin ${margin.decimal}` : '')]);
  }
  return table(report.mesh, 'Facts', ['what', 'value'], rows.map(([what, value]) => [what, String(value)]));
}

// The families of a campaign, and how often each outcome was met.
function campaign({ line, command, families }) {
  const outcomes = [...new Set(Object.values(families).flatMap((counts) => Object.keys(counts)))];
  const kind = line.split(':')[0];
  return element('section', { 'aria-label': 'Campaign' }, element('h2', {}, 'Campaign'),
    element('p', { class: `verdict ${kind}` }, line),
    element('p', { class: 'note' }, `The program: ${command.join(' ')}`),
    table('Campaign', 'How often each outcome was met', ['family', ...outcomes],
      Object.entries(families).map(([family, counts]) => [family, ...outcomes.map((one) => String(counts[one] ?? ''))])));
}

// What was found, and what shows it again.
function finding({ signature, count, text, minimal, reproduce }) {
  const parts = [element('h2', {}, `Finding: ${signature}`),
    element('p', { class: 'verdict fails' }, text),
    element('p', {}, `Met ${count} ${count === 1 ? 'time' : 'times'}. This repeats it: `, element('code', {}, reproduce), ' ',
      copyButton('Copy', reproduce))];
  if (minimal) {
    parts.push(element('details', { open: '' }, element('summary', {}, 'The small input'), element('pre', { tabindex: '0', 'aria-label': 'The small input' }, minimal),
      copyButton('Copy the input', minimal)));
  }
  return parts;
}

// The lines of a command, "what: words", as a table.
function told(text, title) {
  const rows = text.trimEnd().split('\n').map((line) => {
    const colon = line.indexOf(': ');
    return colon < 0 ? ['', line] : [line.slice(0, colon), line.slice(colon + 2)];
  });
  return table(title, 'What was found', ['what', 'value'], rows);
}

// The cards of a verdict are its violations; a page that shows no verdict brings its own.
const cardsOf = (result) => result.report?.violations ?? result.cards ?? [];

function section(result, first) {
  const { report } = result;
  const heading = report?.mesh ?? result.heading;
  if (!heading) return element('section', { 'aria-label': result.finding.signature }, ...finding(result.finding));
  const parts = [...(result.finding ? finding(result.finding) : []), element('h2', {}, heading),
    element('p', { class: `verdict ${report?.verdict ?? result.verdict}` }, result.line)];
  for (const cause of report?.causes ?? []) {
    parts.push(element('p', { class: 'cause' }, element('strong', {}, 'Cause: '),
      `${cause.text} (explains ${cause.explains} of ${cause.of}${cause.of_listed ? ' listed here' : ''})`));
  }
  for (const note of result.notes ?? []) parts.push(element('p', { class: 'note' }, note));
  if (result.steps?.left_out) parts.push(element('p', { class: 'note' }, result.steps.left_out));
  if (result.cards_note) parts.push(element('p', { class: 'note' }, result.cards_note));
  if (result.facts) parts.push(told(result.facts, heading));
  parts.push(...(result.histograms ?? []).map(histogram));
  if (result.steps) parts.push(player(result.steps, stage, views));
  if (result.overview) parts.push(whole(result.overview, first, heading));
  cardsOf(result).forEach((v, i) => parts.push(
    card(v, result.pictures[i], `violation-${first + i}`, `${result.noun ?? 'Violation'} ${first + i}`)));
  if (report) parts.push(element('details', {}, element('summary', {}, 'Facts'), facts(report)));
  return element('section', { 'aria-label': result.finding?.signature ?? heading }, ...parts);
}

function rules() {
  const broken = new Map();
  for (const v of data.results.flatMap(cardsOf)) if (v.rule) broken.set(v.rule, v.meaning);
  if (broken.size === 0) return undefined;
  return element('section', { 'aria-label': 'Rules' }, element('h2', {}, 'Rules'),
    ...[...broken].map(([rule, meaning]) => element('p', { id: `rule-${rule}` },
      element('code', {}, rule), `: ${meaning}. `,
      element('code', {}, `circumspect rule ${rule}`), ' says what causes it, and how to mend it.')));
}

function step(by) {
  const cards = [...document.querySelectorAll('.card[id]')];
  if (cards.length === 0) return;
  const at = cards.indexOf(document.activeElement?.closest('.card'));
  const next = cards[at < 0 ? (by > 0 ? 0 : cards.length - 1) : (at + by + cards.length) % cards.length];
  next.focus({ preventScroll: true });
  next.scrollIntoView({ block: 'start' });
}

function theme(node) {
  const root = document.documentElement;
  const dark = root.dataset.theme ? root.dataset.theme === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
  root.dataset.theme = dark ? 'light' : 'dark';
  node.textContent = dark ? 'Dark' : 'Light';
  redraw();
}

function compose() {
  const main = document.querySelector('main');
  let first = 1;
  const sections = data.results.map((result) => {
    const node = section(result, first);
    first += cardsOf(result).length;
    return node;
  });
  const dark = matchMedia('(prefers-color-scheme: dark)').matches;
  const bar = element('div', { class: 'bar' }, button(dark ? 'Light' : 'Dark', theme));
  if (first > 1) {
    const noun = data.results.find((result) => result.noun)?.noun.toLowerCase() ?? 'violation';
    bar.prepend(button(`Previous ${noun}`, () => step(-1)), button(`Next ${noun}`, () => step(1)));
    bar.append(element('span', { class: 'note' }, `Keys: n next, p previous ${noun}`));
  }
  main.replaceChildren(bar, ...[data.campaign && campaign(data.campaign), ...sections, rules()].filter(Boolean));
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || event.target.matches('input, textarea')) return;
    if (event.key === 'n') step(1);
    if (event.key === 'p') step(-1);
  });
  const solidView = views.find((view) => !view.camera.isFlat);
  if (solidView) stage.enter(solidView);
  addEventListener('resize', redraw);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', redraw);
  document.body.dataset.ready = 'yes';
}

compose();
