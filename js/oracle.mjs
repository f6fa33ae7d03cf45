// The oracle for scripts: what the compiled library says, as values of JavaScript.
import { countOf, indicesOf, isArray, listOf, numbersOf, partsOf, placesOf, simplicesOf } from './arrays.mjs';
import { Call } from './memory.mjs';

// The input is at fault, not the mesh.
export class InputError extends Error { name = 'InputError'; }
// What was asked for does not exist.
export class NoneError extends Error { name = 'NoneError'; }
// No answer was found within the limits.
export class UndecidedError extends Error { name = 'UndecidedError'; }

const FAULTS = { 1: TypeError, 2: InputError, 3: NoneError, 4: UndecidedError, 5: RangeError };
// By the option of C that would settle a fault, what to do here.
const ADVICE = {
  merge_equal_points: "; to take equal points for one, give duplicates: 'merge'",
  allow_empty: '; to judge an empty mesh, give allowEmpty: true',
};
const KINDS = ['by-walls', 'enclosed', 'hull', 'even-odd', 'winding'];
const OPTIONS = {
  check: ['claim', 'domain', 'within', 'weights', 'dimension', 'vertices', 'oriented', 'byDefinition', 'maxViolations', 'duplicates',
    'allowEmpty', 'name', 'pictures', 'demands', 'require', 'exceptSharp', 'limit'],
  points: ['weights', 'dimension'],
  generate: ['dimension', 'count', 'seed'],
};

function refuseUnknown(options, known) {
  if (!isOption(options)) throw new TypeError(`expected options as an object, found ${JSON.stringify(options)}`);
  for (const name of Object.keys(options)) {
    if (!known.includes(name)) throw new TypeError(`expected options among ${known.join(', ')}, found ${name}`);
  }
}

// Where each list begins in all of them, and where the last one ends.
function starts(lists) {
  let end = 0;
  return [0, ...lists.map(({ length }) => (end += length))];
}

const isOption = (value) => value !== null && typeof value === 'object' && !isArray(value);

// (points, simplices, options), or (mesh, options).
function meshAndOptions(first, second, third) {
  if (isArray(first) || isArray(second)) return [{ points: first, ...simplicesOf(second) }, third ?? {}];
  return [partsOf(first), second ?? {}];
}

// What was judged: does it hold, and if not, why.
export class Verdict {
  constructor(facts) { Object.assign(this, facts); }
  // What the command would print: each witness, then one line.
  toString() { return this.text; }
  // By the name of each broken rule, how often it is broken.
  get rules() { return Object.fromEntries((this.report.rules ?? []).map(({ rule, count }) => [rule, count])); }
  get violations() { return this.report.violations ?? []; }
  get causes() { return this.report.causes ?? []; }
}

// A trap, an exception of C++ and a stack that is full leave the library's memory in no state to go
// on with.
const breaksLibrary = (fault) => fault instanceof WebAssembly.RuntimeError || fault instanceof WebAssembly.Exception ||
  (fault instanceof RangeError && /call stack/.test(fault.message));

// Why the library ended: GMP says so when there is no memory for a number, and an assertion says
// which it is.
function endOf(fault, said) {
  const words = said.join('').trim();
  if (words !== '' && !/memory/i.test(words)) return new Error(`internal error: ${words}; please report it`, { cause: fault });
  return new RangeError('expected memory for this mesh and its exact numbers, found no more: the library was ended', { cause: fault });
}

// `instantiate`: makes a new instance of the compiled library, without waiting.
export function oracle(instantiate) {
  let library;
  let said;
  const call = (act) => {
    if (library === undefined) ({ exports: library, said } = instantiate());
    const one = new Call(library);
    try {
      const found = act(one, library);
      one.end();
      return found;
    } catch (fault) {
      if (breaksLibrary(fault)) {
        library = undefined;
        throw endOf(fault, said);
      }
      one.end();
      throw fault;
    }
  };
  const demand = (one, status) => {
    if (status === 0) return;
    const Fault = FAULTS[status] ?? Error;
    throw new Fault(one.string(library.last_fault()) + (ADVICE[one.string(library.last_option())] ?? ''));
  };
  const result = (one, name, ...words) => {
    const slot = one.slot();
    demand(one, library[name](...words, slot));
    return one.read(slot);
  };

  const points = (one, { points: values, weights }, options) => {
    const numbers = numbersOf(values, 'points', options.dimension);
    const heights = weights === undefined || weights === null ? null : numbersOf(weights, 'weights', 1);
    if (heights && heights.length !== numbers.rows) {
      throw new RangeError(`expected a weight for each of ${numbers.rows} points, found ${heights.length}`);
    }
    return { numbers, dimension: numbers.columns, arguments: [numbers.columns, numbers.rows, one.doubles(numbers.doubles),
      one.texts(numbers.texts), heights ? one.doubles(heights.doubles) : 0, heights ? one.texts(heights.texts) : 0] };
  };

  const pointSet = (one, values, options) =>
    one.owned(library.mesh_new(...points(one, { points: values, weights: options.weights }, options).arguments, 0, 0, 0), 'mesh_delete');

  const mesh = (one, parts, options) => {
    const dimension = options.dimension ?? parts.dimension;
    const set = points(one, { points: parts.points, weights: options.weights ?? parts.weights }, { dimension });
    const { indices, columns } = indicesOf(parts.simplices, 'simplices', options.vertices ?? parts.vertices ?? set.dimension + 1);
    const isWide = indices instanceof BigInt64Array;
    return one.owned(library.mesh_new(...set.arguments, columns === 0 ? 0 : indices.length / columns, columns, isWide ? 8 : 4,
      isWide ? one.wideInts(indices) : one.ints(indices)), 'mesh_delete');
  };

  const seeds = (one, values, what, dimension) => {
    const numbers = numbersOf(values, what, dimension);
    return [numbers.rows, one.doubles(numbers.doubles), one.texts(numbers.texts)];
  };

  const domain = (one, asked) => {
    if (!isOption(asked)) throw new TypeError('expected a domain as an object with points, segments and polygons');
    refuseUnknown(asked, ['points', 'segments', 'polygons', 'polygonHoles', 'holes', 'regions', 'kind', 'mergeCoplanar', 'dimension']);
    const kind = KINDS.indexOf(asked.kind ?? 'by-walls');
    if (kind < 0) throw new TypeError(`expected the kind ${KINDS.slice(1).join(', ')}, found ${asked.kind}`);
    const set = points(one, { points: asked.points }, { dimension: asked.dimension });
    const made = one.owned(library.domain_new(...set.arguments.slice(0, 4), kind, Number(Boolean(asked.mergeCoplanar))), 'domain_delete');
    const part = (name) => listOf(asked[name], name);
    if (part('segments').length > 0) {
      const indices = placesOf(asked.segments, 'segments', 2);
      library.domain_segments(made, indices.length / 2, one.ints(indices));
    }
    if (part('polygons').length > 0) {
      // A polygon is a list of corners, or of several such lists: its outline, holes, segments,
      // vertices.
      const lines = Array.from(asked.polygons, (given) => {
        const polygon = listOf(given, 'a polygon');
        return typeof polygon[0] === 'number' ? [polygon] : Array.from(polygon, (line) => listOf(line, 'a line of a polygon'));
      });
      const all = lines.flat();
      const corners = placesOf(all.flatMap((line) => Array.from(line)), 'polygons', 1);
      library.domain_polygons(made, lines.length, one.ints(starts(lines)), all.length, one.ints(starts(all)), corners.length, one.ints(corners));
    }
    if (part('holes').length > 0) library.domain_holes(made, ...seeds(one, asked.holes, 'holes', set.dimension));
    if (part('regions').length > 0) library.domain_regions(made, ...seeds(one, asked.regions, 'regions', set.dimension));
    const inPolygons = Object.entries(asked.polygonHoles ?? {}).flatMap(([polygon, places]) =>
      Array.from(listOf(places, 'polygonHoles'), (place) => [Number(polygon), place]));
    if (inPolygons.length > 0) {
      const [count, ...arrays] = seeds(one, inPolygons.map(([, place]) => place), 'polygonHoles', 3);
      library.domain_polygon_holes(made, count, one.ints(placesOf(inPolygons.map(([polygon]) => polygon), 'the keys of polygonHoles', 1)), ...arrays);
    }
    return made;
  };

  const verdictOf = (one, verdict, options) => {
    const isOneOf = (value) => (value < 0 ? undefined : value === 1);
    const notes = [];
    for (let note = library.verdict_note(verdict, 0); note !== 0; note = library.verdict_note(verdict, notes.length)) {
      notes.push(one.string(note));
    }
    const facts = {
      holds: library.verdict_holds(verdict) === 1,
      unique: isOneOf(library.verdict_unique(verdict)),
      canonical: isOneOf(library.verdict_canonical(verdict)),
      text: one.string(library.verdict_text(verdict)).trimEnd(),
      notes,
      report: JSON.parse(one.string(library.verdict_json(verdict))).results[0],
    };
    if (options.pictures) {
      const page = one.owned(result(one, 'verdict_page', verdict), 'document_delete');
      facts.page = one.string(library.document_text(page));
    }
    return new Verdict(facts);
  };

  const check = (...words) => call((one) => {
    const [parts, options] = meshAndOptions(...words);
    refuseUnknown(options, OPTIONS.check);
    if (![undefined, 'merge'].includes(options.duplicates)) {
      throw new TypeError(`expected duplicates: "merge", found ${options.duplicates}`);
    }
    if (options.limit !== undefined && !(options.limit > 0)) {
      throw new RangeError(`expected a limit in seconds, above 0, found ${options.limit}`);
    }
    const required = [options.require ?? []].flat();
    if (options.exceptSharp !== undefined && required.length === 0) {
      throw new TypeError('expected requirements, as `require`, beside `exceptSharp`, found none');
    }
    const maxViolations = options.maxViolations ?? 20;
    const most = maxViolations === Infinity ? 0 : countOf(maxViolations, 'maxViolations');
    const judged = mesh(one, parts, options);
    const filled = options.domain === undefined ? 0 : domain(one, options.domain);
    const verdict = result(one, 'check', one.text(options.claim), judged, filled, most,
      Number(Boolean(options.byDefinition)), Number(Boolean(options.oriented)), one.text(options.within), one.text(options.name),
      options.pictures ? 20 : 0, Number(options.duplicates === 'merge'), Number(Boolean(options.allowEmpty)),
      one.text([options.demands ?? []].flat().join(' ')), required.length, one.texts(required), one.text(options.exceptSharp),
      options.limit ?? 0);
    return verdictOf(one, one.owned(verdict, 'verdict_delete'), options);
  });

  const triangulation = (one, made) => {
    const width = library.triangulation_dimension(made) + 1;
    if (width <= 0) return { simplices: new Int32Array(0), vertices: 0 };
    const count = library.triangulation_count(made, width);
    const to = one.room(4 * count * width);
    library.triangulation_copy(made, width, to);
    return { simplices: new Int32Array(library.memory.buffer, to, count * width).slice(), vertices: width };
  };

  const predicate = (name, more) => (...places) => call((one) => {
    const numbers = numbersOf(places, 'points');
    if (numbers.rows !== numbers.columns + more) {
      throw new RangeError(`expected ${numbers.columns + more} points of ${numbers.columns} coordinates, found ${numbers.rows}`);
    }
    const slot = one.slot();
    demand(one, numbers.doubles ? library[name](numbers.columns, one.doubles(numbers.doubles), slot)
      : library[`${name}_exact`](numbers.columns, one.texts(numbers.texts), slot));
    return one.read(slot);
  });

  return {
    check,
    // The canonical Delaunay triangulation of points, weighted if `weights` are given: { simplices,
    // vertices }, flat.
    delaunay: (values, options = {}) => call((one) => {
      refuseUnknown(options, OPTIONS.points);
      return triangulation(one, one.owned(result(one, 'delaunay', pointSet(one, values, options)), 'triangulation_delete'));
    }),
    constrainedDelaunay: (asked) => call((one) =>
      triangulation(one, one.owned(result(one, 'constrained_delaunay', domain(one, asked)), 'triangulation_delete'))),
    // Are two meshes one complex, whatever their numbering?
    compare: (a, b) => call((one) => {
      const [same, document] = [one.slot(), one.slot()];
      const [left, right] = [a, b].map((of) => mesh(one, partsOf(of), {}));
      demand(one, library.compare(left, right, same, document));
      const text = one.string(library.document_text(one.owned(one.read(document), 'document_delete')));
      return JSON.parse(text);
    }),
    // What proves a verdict to circumspect-verified.
    certify: (...words) => call((one) => {
      const [parts, options] = meshAndOptions(...words);
      refuseUnknown(options, ['claim', 'dimension', 'vertices', 'weights']);
      const [holds, document] = [one.slot(), one.slot()];
      demand(one, library.certify(one.text(options.claim ?? 'delaunay'), mesh(one, parts, options), holds, document));
      const text = one.string(library.document_text(one.owned(one.read(document), 'document_delete')));
      return { holds: one.read(holds) === 1, text };
    }),
    // The points that a seed stands for, the same on every machine: { points, dimension, weights },
    // flat.
    generate: (family, options = {}) => call((one) => {
      refuseUnknown(options, OPTIONS.generate);
      const { dimension = 2, count = 20, seed = 0 } = options;
      for (const [name, value] of Object.entries({ dimension, count })) countOf(value, name);
      if (!Number.isSafeInteger(seed) || seed < 0) throw new RangeError(`expected seed as a whole number, found ${seed}`);
      const drawing = one.owned(result(one, 'generate', one.text(family), dimension, count, seed), 'drawing_delete');
      const drawn = library.drawing_mesh(drawing);
      const rows = library.mesh_points(drawn);
      const array = (at, length) => new Float64Array(library.memory.buffer, at, length).slice();
      const weights = library.mesh_weights(drawn);
      return { points: array(library.mesh_coordinates(drawn) >>> 0, rows * dimension), dimension,
        weights: weights === 0 ? undefined : array(weights >>> 0, rows) };
    }),
    // The sign of det(p0 − pd, …): in the plane 1 if counterclockwise.
    orient: predicate('orientation', 1),
    // Is the last point inside (1), on (0) or outside (−1) the sphere through the others?
    inBall: predicate('in_ball', 2),
    version: () => call((one) => one.string(library.version())),
  };
}
