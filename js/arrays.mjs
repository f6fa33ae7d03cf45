// What scripts have of points and simplices, as flat arrays. Nothing is rounded on the way.

export const isArray = (value) => Array.isArray(value) || (ArrayBuffer.isView(value) && !(value instanceof DataView));
const shown = (value) => {
  const text = typeof value === 'bigint' ? `${value}n` : typeof value === 'string' ? JSON.stringify(value) : String(value);
  return text.length > 60 ? `${text.slice(0, 57)}...` : text;
};

export class Numbers {
  // Finite doubles, or texts if some number may not be a double: strings such as "1/3", and
  // BigInts.
  constructor(doubles, texts, columns) { Object.assign(this, { doubles, texts, columns }); }
  get length() { return (this.doubles ?? this.texts).length; }
  get rows() { return this.columns === 0 ? 0 : this.length / this.columns; }
}

// An array looks empty if its buffer went to another thread, or is no longer as long as the
// array; only its methods tell.
function refuseDetached(array, what) {
  if (!isArray(array) || Array.isArray(array) || array.length > 0) return;
  try {
    array.at(0);
  } catch {
    throw new TypeError(`expected ${what}, found an array whose buffer was detached or made smaller: pass a copy, or ask before that`);
  }
}

// A part that may be left out. What is not a list would look like one that is empty.
export function listOf(values, what) {
  refuseDetached(values, what);
  if (values === undefined || values === null) return [];
  if (!isArray(values)) throw new TypeError(`expected ${what} as an array, found ${shown(values)}`);
  return values;
}

// Rows of numbers, nested or flat; `columns`: of flat ones.
function flat(values, what, columns) {
  refuseDetached(values, what);
  if (!isArray(values)) throw new TypeError(`expected ${what} as an array, found ${shown(values)}`);
  if (values.length === 0 || !isArray(values[0])) {
    if (columns === undefined && values.length === 0) return { all: values, columns: 2 };
    if (columns !== undefined && !(Number.isInteger(columns) && columns > 0)) {
      throw new RangeError(`expected how long a row of ${what} is, at least 1, found ${shown(columns)}`);
    }
    if (columns === undefined) {
      throw new TypeError(`expected ${what} as rows, or flat with the option that says how long a row is, found a flat array`);
    }
    if (values.length % columns !== 0) {
      throw new RangeError(`expected ${what} in rows of ${columns}, found ${values.length} numbers`);
    }
    return { all: values, columns };
  }
  for (const row of values) refuseDetached(row, what);
  const width = values[0].length;
  if (width === 0) throw new RangeError(`expected ${what} in rows of at least 1, found an empty row`);
  const all = [];
  for (let i = 0; i < values.length; ++i) {
    if (!isArray(values[i])) throw new TypeError(`expected ${what} in rows of ${width}, found ${shown(values[i])} as row ${i}`);
    if (values[i].length !== width) {
      throw new RangeError(`expected ${what} in rows of ${width}, found row ${i} of ${values[i].length}`);
    }
    for (let k = 0; k < width; ++k) all.push(values[i][k]);
  }
  return { all, columns: width };
}

export function numbersOf(values, what, columns) {
  const { all, columns: width } = flat(values, what, columns);
  if (all instanceof Float64Array || all instanceof Float32Array) return new Numbers(all, null, width);
  let areDoubles = true;
  for (let i = 0; i < all.length; ++i) {
    const type = typeof all[i];
    if (type === 'number') continue;
    if (type !== 'string' && type !== 'bigint') {
      throw new TypeError(`expected numbers, BigInts or texts such as "1/3" as ${what}, found ${shown(all[i])}`);
    }
    areDoubles = false;
  }
  if (areDoubles) return new Numbers(Float64Array.from(all), null, width);
  return new Numbers(null, Array.from(all, exactText), width);
}

// A double as a text of the same value: decimals of it would be read as what they say, 0.1 as 1/10.
function exactText(value) {
  if (typeof value !== 'number') return String(value);
  if (!Number.isFinite(value)) return String(value);
  let numerator = value;
  let exponent = 0;
  while (!Number.isInteger(numerator)) {
    numerator *= 2;
    ++exponent;
  }
  return exponent === 0 ? BigInt(numerator).toString() : `${BigInt(numerator)}/${1n << BigInt(exponent)}`;
}

const FITS = 2 ** 31;

// The library takes 32 bits of a count: one beyond them would become another number.
export function countOf(value, what) {
  if (Number.isInteger(value) && value >= 0 && value < FITS) return value;
  throw new RangeError(`expected ${what} as a whole number from 0 to ${FITS - 1}, found ${shown(value)}`);
}

// Indices of points, as 32-bit or, if one of them needs it, as 64-bit integers. What is not an
// integer is refused; an integer that names no point is a fault of the mesh, which the library
// reports.
export function indicesOf(values, what, columns) {
  const { all, columns: width } = flat(values, what, columns);
  if (all instanceof Int32Array || all instanceof Int16Array || all instanceof Uint16Array || all instanceof Uint8Array) {
    return { indices: all, columns: width };
  }
  const indices = new Int32Array(all.length);
  let isWide = false;
  for (let i = 0; i < all.length; ++i) {
    const index = typeof all[i] === 'bigint' ? Number(all[i]) : all[i];
    if (!Number.isSafeInteger(index)) throw new RangeError(`expected indices of points as ${what}, found ${shown(all[i])}`);
    indices[i] = index;
    isWide ||= index < -FITS || index >= FITS;
  }
  return { indices: isWide ? BigInt64Array.from(all, BigInt) : indices, columns: width };
}

// Of a domain, whose indices all name points.
export function placesOf(values, what, columns) {
  const { indices } = indicesOf(values, what, columns);
  if (indices instanceof BigInt64Array) throw new RangeError(`expected indices of points as ${what}, found one beyond 32 bits`);
  return indices;
}

// Rows of simplices, or what delaunay() gives: flat ones, and how many vertices each has.
export function simplicesOf(given) {
  return isArray(given) || !isArray(given?.simplices) ? { simplices: given } : { simplices: given.simplices, vertices: given.vertices };
}

// Points and simplices of what libraries return: Delaunator and d3-delaunay, or an object that has
// both.
export function partsOf(mesh) {
  if (mesh === null || typeof mesh !== 'object' || isArray(mesh)) {
    throw new TypeError(`expected points and simplices, or an object that has both, found ${shown(mesh)}`);
  }
  const points = mesh.points ?? mesh.coords ?? mesh.vertices ?? mesh.positions;
  const { simplices, vertices } = simplicesOf(mesh.simplices ?? mesh.triangles ?? mesh.tetrahedra ?? mesh.cells);
  if (!isArray(points) || !isArray(simplices)) {
    throw new TypeError('expected an object with points (or coords, vertices, positions) and simplices (or triangles, ' +
      `tetrahedra, cells), found one with ${Object.keys(mesh).slice(0, 8).join(', ') || 'nothing'}`);
  }
  // Those of Delaunator and d3 are flat, and in the plane.
  const isFlat = points.length === 0 || !isArray(points[0]);
  return { points, simplices, vertices, dimension: mesh.dimension ?? (isFlat && mesh.triangles ? 2 : undefined), weights: mesh.weights };
}
