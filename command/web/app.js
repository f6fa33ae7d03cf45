// The page: files, a question, and the answer. The command itself runs in a worker, which is ended
// to cancel.
import { button, element } from '../../oracle/picture/page/elements.js';
import { Plane } from './draw.js';
import { figures } from './figures.js';
import { bytesOf, packState, unpackState, unpacked } from './link.js';

const byId = (id) => document.getElementById(id);
const text = (bytes) => new TextDecoder().decode(bytes);
const shownBytes = 200_000;  // of a text, as much is shown in a field
const page = 'picture.html';

const endings = {
  mesh: /\.(ele|msh|vtk|vtu|mesh|json|off|obj|ply|tet|npz|qhull-i|npy)$/i,
  domain: /\.(poly|smesh|off|stl|ply|obj|mesh|msh|vtk|vtu|vtp)$/i,
  points: /\.(node|npy|csv|xyz|json|off)$/i,
};
const commands = { check: ['check'], inspect: ['inspect'], 'build delaunay': ['build', 'delaunay'], 'build cdt': ['build', 'cdt'] };

const examples = {
  'A vertex in a ball': { ask: 'check', mesh: 'wrong.ele', files: [
    { name: 'wrong.node', text: '5 3 0 0\n1 0 0 0\n2 6 0 0\n3 0 6 0\n4 2 2 2\n5 2 2 -2\n' },
    { name: 'wrong.ele', text: '2 4 0\n1 1 2 3 4\n2 1 3 2 5\n' }] },
  'A domain, and a mesh without its segment': { ask: 'check', mesh: 'square.ele', domain: 'square.poly', files: [
    { name: 'square.poly', text: '4 2 0 0\n1 0 0\n2 4 0\n3 5 5\n4 0 4\n5 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 1 3\n0\n' },
    { name: 'square.node', text: '4 2 0 0\n1 0 0\n2 4 0\n3 5 5\n4 0 4\n' },
    { name: 'square.ele', text: '2 3 0\n1 1 2 4\n2 2 3 4\n' }] },
  'Schönhardt’s polyhedron, which has no tetrahedralization': { ask: 'inspect', mesh: 'schoenhardt.poly', files: [
    { name: 'schoenhardt.poly', text: '6 3 0 0\n1 10 0 0\n2 -5 9 0\n3 -5 -9 0\n4 8 5 10\n5 -9 5 10\n6 1 -10 10\n8 0\n1\n3 1 2 3\n1\n3 4 5 6\n'
      + '1\n3 1 2 5\n1\n3 1 5 4\n1\n3 2 3 6\n1\n3 2 6 5\n1\n3 3 1 4\n1\n3 3 4 6\n0\n' }] },
  'Points, and what is known of them': { ask: 'inspect', mesh: 'grid.node', files: [
    { name: 'grid.node', text: '5 2 0 0\n1 0 0\n2 1 0\n3 0 1\n4 1 1\n5 0.5 0.25\n' }] },
  ...figures,
};

// Whose steps the page of pictures shows.
const algorithms = {
  'build delaunay': { 'bowyer-watson': 'Bowyer–Watson (5.2)', 'gift-wrapping': 'gift-wrapping (5.6)', flips: 'flips (4.4)',
    'lifted-hull': 'the lifted hull (4.2)' },
  'build cdt': { '': 'the usual one', 'polygon-flips': 'FlipInsertPolygon (5.8)' },
};

let files = [];  // { name, text } or { name, bytes }
let running;     // what ends the run that goes on
let next = 0;

const source = byId('worker').textContent;
const code = unpacked(bytesOf(byId('wasm').textContent), 'gzip').then((bytes) => WebAssembly.compile(bytes));
let worker;

async function readyWorker() {
  const compiled = await code;
  if (!worker) {
    worker = new Worker(URL.createObjectURL(new Blob([source], { type: 'text/javascript' })));
    worker.postMessage({ code: compiled });
  }
  return worker;
}

// One run of the command; undefined if it was cancelled.
async function run(words, wanted = []) {
  const given = files.map(({ name, text: words_, bytes }) => ({ name, bytes: bytes ?? new TextEncoder().encode(words_) }));
  const one = await readyWorker();
  const id = ++next;
  return new Promise((resolve) => {
    running = () => {
      one.terminate();
      worker = undefined;
      resolve(undefined);
    };
    one.onmessage = ({ data }) => {
      if (data.id !== id) return;
      running = undefined;
      resolve(data);
    };
    one.onerror = (event) => {
      event.preventDefault();
      worker = undefined;
      running = undefined;
      resolve({ exit: 5, out: new Uint8Array(), err: new TextEncoder().encode(`The worker ended: ${event.message}\n`), written: {} });
    };
    one.postMessage({ id, words, files: given.map((file) => ({ ...file, bytes: file.bytes.slice() })), wanted });
  });
}

const value = (id) => byId(id).value;

function words() {
  const ask = value('ask');
  const list = [...commands[ask], value('mesh') || 'FILE'];
  if (ask === 'check') {
    if (value('claim')) list.push('--claim', value('claim'));
    if (value('domain')) list.push('--domain', value('domain'));
    if (value('points')) list.push('--points', value('points'));
  }
  if (algorithms[ask] && value('algorithm')) list.push('--algorithm', value('algorithm'));
  return [...list, ...value('more').split(/\s+/).filter(Boolean)];
}

const quoted = (word) => (/^[\w.,/=:+-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`);
const showCommand = () => { byId('command').textContent = ['circumspect', ...words()].map(quoted).join(' '); };

function fill(select, kind, none) {
  const was = select.value;
  const names = files.map((file) => file.name).filter((name) => !kind || endings[kind].test(name) || name === was);
  select.replaceChildren(...(none ? [element('option', { value: '' }, none)] : []),
    ...names.map((name) => element('option', { value: name }, name)));
  select.value = names.includes(was) ? was : none ? '' : names[0] ?? '';
}

// The fields and choices, after the files or the kind of question have changed.
function refresh() {
  const ask = value('ask');
  fill(byId('mesh'), undefined);
  fill(byId('domain'), 'domain', 'none');
  fill(byId('points'), 'points', 'in the mesh, or beside it');
  for (const row of document.querySelectorAll('[data-of]')) row.hidden = !row.dataset.of.split(',').includes(ask);
  const names = Object.entries(algorithms[ask] ?? {});
  if (names.some(([name]) => ![...byId('algorithm').options].some((option) => option.value === name))) {
    byId('algorithm').replaceChildren(...names.map(([name, words_]) => element('option', { value: name }, words_)));
  }
  byId('run').disabled = files.length === 0;
  byId('files').replaceChildren(...files.map(fileEntry));
  showCommand();
}

function fileEntry(file) {
  const size = file.bytes?.length ?? file.text.length;
  const name = element('input', { type: 'text', value: file.name, 'aria-label': 'Name of the file' });
  name.addEventListener('change', () => {
    const other = name.value.replace(/^\/+|\.\.\//g, '');
    if (other && !files.some((one) => one !== file && one.name === other)) file.name = other;
    refresh();
  });
  const parts = [element('div', { class: 'bar' }, name, element('span', { class: 'note' }, `${size.toLocaleString('en')} bytes`),
    button('Remove', () => { files = files.filter((one) => one !== file); refresh(); }))];
  if (file.text !== undefined && size <= shownBytes) {
    const field = element('textarea', { rows: 6, spellcheck: 'false', 'aria-label': `Text of ${file.name}` });
    field.value = file.text;
    field.addEventListener('input', () => { file.text = field.value; });
    field.addEventListener('change', () => { if (file.name === 'drawn.node') plane.readNodes(file.text); });
    parts.push(field);
  }
  return element('li', {}, ...parts);
}

// Adds files, or puts them in the place of those that bear their names, and guesses what is asked
// about them.
function add(some) {
  for (const file of some) {
    files = files.filter((one) => one.name !== file.name);
    files.push(file);
  }
  refresh();
  const named = (pattern) => some.map((file) => file.name).find((name) => pattern.test(name));
  const mesh = named(/\.(ele|tet|npz|qhull-i)$/i) ?? (files.some((f) => /\.ele$/i.test(f.name)) ? undefined : named(endings.mesh));
  const domain = named(/\.(poly|smesh)$/i);
  if (mesh) byId('mesh').value = mesh;
  else if (!files.some((file) => endings.mesh.test(file.name))) {
    byId('mesh').value = domain ?? some[0].name;
    byId('ask').value = 'inspect';
  }
  if (domain && files.some((file) => endings.mesh.test(file.name))) byId('domain').value = domain;
  if (mesh) byId('ask').value = 'check';
  refresh();
}

async function read(list) {
  const some = [];
  for (const file of list) {
    const bytes = new Uint8Array(await file.arrayBuffer());
    let words_;
    try {
      words_ = bytes.length <= shownBytes ? new TextDecoder('utf-8', { fatal: true }).decode(bytes) : undefined;
    } catch {
      // No text: it is kept as bytes.
    }
    some.push(words_ === undefined || words_.includes('\0') ? { name: file.name, bytes } : { name: file.name, text: words_ });
  }
  if (some.length) add(some);
}

function state() {
  return { ask: value('ask'), mesh: value('mesh'), domain: value('domain'), points: value('points'), claim: value('claim'),
    algorithm: value('algorithm'), more: value('more'), files };
}

function take(given) {
  files = given.files.map((file) => ({ ...file }));
  byId('ask').value = given.ask in commands ? given.ask : 'check';
  refresh();
  for (const key of ['mesh', 'domain', 'points', 'claim', 'algorithm', 'more']) {
    byId(key).value = given[key] ?? '';
    if (byId(key).selectedIndex < 0) byId(key).selectedIndex = 0;
  }
  const drawn = files.find((file) => file.name === 'drawn.node');
  if (drawn?.text) plane.readNodes(drawn.text);
  const triangles = files.find((file) => file.name === 'drawn.ele');
  if (drawn?.text && triangles?.text) plane.readTriangles(triangles.text);
  showCommand();
}

const meanings = { 0: 'holds', 1: 'fails', 2: 'usage', 3: 'input', 4: 'undecided', 5: 'error' };

function say(words_) { byId('status').textContent = words_; }

function jsonOf(list) {
  const field = element('pre', { tabindex: '0', 'aria-label': 'The answer as JSON' }, 'Running …');
  const details = element('details', { id: 'json' }, element('summary', {}, 'As JSON'), field);
  details.addEventListener('toggle', async () => {
    if (!details.open || details.dataset.ready) return;
    details.dataset.ready = 'yes';
    const answer = await run([...list, '--format', 'json']);
    field.textContent = answer ? text(answer.out) || text(answer.err) : 'cancelled';
  });
  return details;
}

function show(answer, list, seconds) {
  const out = text(answer.out);
  const err = text(answer.err);
  const lines = (out + err).trimEnd().split('\n');
  const parts = [element('h2', {}, 'Answer'),
    element('p', { class: `verdict ${meanings[answer.exit] ?? 'error'}`, id: 'verdict' }, lines.at(-1).slice(0, 2000)),
    element('p', { class: 'note' }, `Exit code ${answer.exit}, ${seconds.toFixed(2)} s in this browser.`)];
  if (lines.length > 1) {
    parts.push(element('details', { open: '' }, element('summary', {}, 'All that the command prints'),
      element('pre', { tabindex: '0', 'aria-label': 'Output of the command', id: 'output' }, out + err)));
  }
  if (answer.written[page]) {
    const frame = element('iframe', { sandbox: 'allow-scripts', title: 'Pictures', id: 'pictures' });
    frame.srcdoc = text(answer.written[page]);
    const save = element('a', { download: 'verdict.html' }, 'Save the page of pictures');
    save.href = URL.createObjectURL(new Blob([answer.written[page]], { type: 'text/html' }));
    parts.push(frame, element('p', {}, save));
  }
  parts.push(jsonOf(list));
  byId('answer').replaceChildren(...parts);
}

async function ask() {
  running?.();
  const list = words();
  const building = list[0] === 'build';
  say('Running …');
  byId('cancel').disabled = false;
  const start = performance.now();
  const built = value('ask') === 'build delaunay' && value('mesh') === 'drawn.node' ? 'drawn.ele' : 'built.ele';
  const extra = building ? ['-o', built] : [];
  const answer = await run([...list, ...extra, '--html', page], [page, ...(building ? [built, built.replace('ele', 'node')] : [])]);
  byId('cancel').disabled = true;
  if (!answer) {
    say('Cancelled.');
    return;
  }
  show(answer, [...list, ...(building ? extra : [])], (performance.now() - start) / 1000);
  const { [page]: _, ...meshes } = answer.written;
  if (building) keepBuilt(meshes);
  say(`Done: ${byId('verdict').textContent}`);
}

// Meshes that were built are files like others, to be judged or taken away.
function keepBuilt(written) {
  for (const [name, bytes] of Object.entries(written)) {
    files = files.filter((file) => file.name !== name);
    files.push(bytes.length <= shownBytes ? { name, text: text(bytes) } : { name, bytes });
  }
  refresh();
}

const plane = new Plane(async (flipped) => {
  running?.();
  const others = files.filter((file) => !file.name.startsWith('drawn.'));
  files = [...others, { name: 'drawn.node', text: plane.nodeFile() }, ...(flipped ? [{ name: 'drawn.ele', text: plane.eleFile() }] : [])];
  byId('ask').value = flipped ? 'check' : 'build delaunay';
  refresh();
  byId('mesh').value = flipped ? 'drawn.ele' : 'drawn.node';
  for (const id of ['domain', 'points', 'claim', 'more']) byId(id).value = '';
  showCommand();
  if (plane.points.length < 3) return;
  await ask();
  const triangles = files.find((file) => file.name === 'drawn.ele');
  if (!flipped && triangles) plane.readTriangles(triangles.text);
});

byId('draw').append(plane.node);
byId('question').addEventListener('submit', (event) => {
  event.preventDefault();
  ask();
});
byId('cancel').addEventListener('click', () => running?.());
for (const id of ['mesh', 'domain', 'points', 'claim', 'algorithm', 'more']) byId(id).addEventListener('input', showCommand);
byId('ask').addEventListener('input', refresh);
byId('choose').addEventListener('change', (event) => read(event.target.files));
byId('paste').addEventListener('click', () => {
  const free = (i) => (files.some((file) => file.name === `pasted-${i}.node`) ? free(i + 1) : `pasted-${i}.node`);
  add([{ name: free(1), text: '' }]);
  byId('files').lastElementChild.querySelector('textarea').focus();
});
byId('examples').replaceChildren(element('option', { value: '' }, 'Examples'),
  ...Object.keys(examples).map((name) => element('option', { value: name }, name)));
byId('examples').addEventListener('change', (event) => {
  const example = examples[event.target.value];
  if (!example) return;
  take(example);
  ask();
});
byId('link').addEventListener('click', async () => {
  const link = await packState(state());
  if (!link) {
    say('The files are too large for a link; send them beside it.');
    return;
  }
  history.replaceState(null, '', `#${link}`);
  try {
    await navigator.clipboard.writeText(location.href);
    say('The link is in the clipboard and in the address bar.');
  } catch {
    say('The link is in the address bar.');
  }
});
addEventListener('dragover', (event) => event.preventDefault());
addEventListener('drop', (event) => {
  event.preventDefault();
  read(event.dataTransfer.files);
});

async function begin() {
  refresh();
  if (location.hash.length > 1) {
    try {
      take(await unpackState(location.hash.slice(1)));
      await ask();
    } catch (fault) {
      say(`This link holds no state that the page knows: ${fault.message}`);
    }
  }
  await code;
  document.body.dataset.ready = 'yes';
}
addEventListener('hashchange', begin);
begin();

// The licences are unpacked when somebody opens them.
byId('licences').addEventListener('toggle', async () => {
  byId('licences').querySelector('pre').textContent = text(await unpacked(bytesOf(byId('licence-texts').textContent), 'gzip'));
}, { once: true });
