// One run of the command, compiled for the web, in a memory of its own: for the page's worker, and
// for tests in Node.
//   make: the factory that Emscripten wrote (circumspect.js); code: the compiled module
// (circumspect.wasm)
//   words: the command line; files: [{ name, bytes }], what it may read, by their names in its
// folder
//   wanted: names of files that it may write
// Gives { exit, out, err, written }, all but `exit` as bytes.
const folder = '/input';

// All bytes that a stream was given one by one.
class Bytes {
  constructor() {
    this.bytes = new Uint8Array(4096);
    this.size = 0;
  }

  push(byte) {
    if (this.size === this.bytes.length) {
      const longer = new Uint8Array(2 * this.size);
      longer.set(this.bytes);
      this.bytes = longer;
    }
    this.bytes[this.size++] = byte;
  }

  all() { return this.bytes.slice(0, this.size); }
}

const withoutMemory = (fault) => fault instanceof RangeError || /memory|allocat/i.test(String(fault?.message));

export async function judge(make, code, words, files, wanted = []) {
  const out = new Bytes();
  const err = new Bytes();
  const module = await make({
    instantiateWasm(imports, done) {
      WebAssembly.instantiate(code, imports).then((instance) => done(instance, code));
      return {};
    },
    preRun: [(it) => it.FS.init(() => null, (byte) => out.push(byte), (byte) => err.push(byte))],
    quit(_, status) { throw status; },  // in Node it would end more than the command
  });
  const { FS } = module;
  FS.mkdir(folder);
  for (const { name, bytes } of files) {
    const parts = name.split('/').slice(0, -1);
    parts.forEach((_, i) => {
      const path = `${folder}/${parts.slice(0, i + 1).join('/')}`;
      if (!FS.analyzePath(path).exists) FS.mkdir(path);
    });
    FS.writeFile(`${folder}/${name}`, bytes, { canOwn: true });
  }
  FS.chdir(folder);
  let exit;
  try {
    exit = module.callMain(words);
  } catch (fault) {
    if (fault?.name === 'ExitStatus') {
      exit = fault.status;
    } else {
      const text = withoutMemory(fault) ? 'circumspect: out of memory\n' : `circumspect: internal error, please report it: ${fault}\n`;
      for (const byte of new TextEncoder().encode(text)) err.push(byte);
      exit = 5;
    }
  }
  const written = {};
  for (const name of wanted) {
    if (FS.analyzePath(`${folder}/${name}`).exists) written[name] = FS.readFile(`${folder}/${name}`);
  }
  return { exit, out: out.all(), err: err.all(), written };
}
