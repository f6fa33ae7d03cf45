// The memory of the compiled library: what a call passes to it and reads from it.

const encoder = new TextEncoder();
const decoder = new TextDecoder();

// What the library asks of a system: to write somewhere, the time, and to end. It has no files. It
// writes only when it must end: `said` then has its last words.
export function imports(memory, said) {
  const view = () => new DataView(memory().buffer);
  const wasi = {
    fd_write(_, vectors, count, written) {
      let size = 0;
      for (let i = 0; i < count; ++i) {
        const [at, length] = [0, 4].map((offset) => view().getUint32(vectors + 8 * i + offset, true));
        said.push(decoder.decode(new Uint8Array(memory().buffer, at, length)));
        size += length;
      }
      view().setUint32(written, size, true);
      return 0;
    },
    fd_close: () => 0,
    fd_read: () => 8,
    fd_seek: () => 8,
    environ_sizes_get(count, size) {
      view().setUint32(count, 0, true);
      view().setUint32(size, 0, true);
      return 0;
    },
    environ_get: () => 0,
    clock_time_get(_, __, to) {
      view().setBigUint64(to, BigInt(Math.round(performance.now() * 1e6)), true);
      return 0;
    },
    proc_exit(status) { throw new WebAssembly.RuntimeError(`the library ended with status ${status}`); },
  };
  const env = {
    emscripten_notify_memory_growth() {},
    __call_sighandler(_, signal) { throw new WebAssembly.RuntimeError(`the library ended by signal ${signal}`); },
  };
  return { wasi_snapshot_preview1: wasi, env };
}

// Makes an instance of the compiled library at once.
export function instance(code) {
  const said = [];
  let exports;
  ({ exports } = new WebAssembly.Instance(code, imports(() => exports.memory, said)));
  exports._initialize();
  return { exports, said };
}

// What one call holds of the library's memory and objects; `end` gives all of it back.
export class Call {
  constructor(library) {
    this.library = library;
    this.ends = [];
  }

  room(bytes) {
    const at = this.library.malloc(Math.max(bytes, 1)) >>> 0;
    if (at === 0) throw new RangeError(`expected room for ${bytes} bytes, found no more memory`);
    this.ends.push(() => this.library.free(at));
    return at;
  }

  // `pointer` is given back by the library's function of that name.
  owned(pointer, name) {
    this.ends.push(() => this.library[name](pointer));
    return pointer;
  }

  doubles(numbers) {
    if (numbers === null) return 0;
    const at = this.room(8 * numbers.length);
    new Float64Array(this.library.memory.buffer, at, numbers.length).set(numbers);
    return at;
  }

  ints(numbers) {
    const at = this.room(4 * numbers.length);
    new Int32Array(this.library.memory.buffer, at, numbers.length).set(numbers);
    return at;
  }

  wideInts(numbers) {
    const at = this.room(8 * numbers.length);
    new BigInt64Array(this.library.memory.buffer, at, numbers.length).set(numbers);
    return at;
  }

  text(words) {
    if (words === undefined || words === null) return 0;
    const bytes = encoder.encode(String(words));
    const at = this.room(bytes.length + 1);
    const to = new Uint8Array(this.library.memory.buffer, at, bytes.length + 1);
    to.set(bytes);
    to[bytes.length] = 0;
    return at;
  }

  texts(list) { return list === null ? 0 : this.ints(list.map((words) => this.text(words))); }

  // A place for a pointer or an int that a function sets.
  slot() { return this.ints([0]); }
  read(slot) { return new Int32Array(this.library.memory.buffer, slot, 1)[0]; }

  string(pointer) {
    const bytes = new Uint8Array(this.library.memory.buffer, pointer >>> 0);
    return decoder.decode(bytes.subarray(0, bytes.indexOf(0)));
  }

  end() { while (this.ends.length) this.ends.pop()(); }
}
