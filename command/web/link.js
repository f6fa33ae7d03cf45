// The whole state of the page in its link: what is asked, and all files, as packed JSON behind the
// #.
const kLongest = 60_000;  // characters: what trackers and mail programs leave whole

async function through(stream, bytes) {
  const packed = new Blob([bytes]).stream().pipeThrough(stream);
  return new Uint8Array(await new Response(packed).arrayBuffer());
}

export const unpacked = (bytes, format) => through(new DecompressionStream(format), bytes);

export function bytesOf(base64) {
  return Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
}

export function base64Of(bytes) {
  let text = '';
  for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192));
  return btoa(text);
}

// undefined where the link would be longer than kLongest.
export async function packState(state) {
  const files = state.files.map(({ name, text, bytes }) => (text === undefined ? { name, base64: base64Of(bytes) } : { name, text }));
  const json = new TextEncoder().encode(JSON.stringify({ ...state, files }));
  if (json.length > 100 * kLongest) return undefined;
  const packed = base64Of(await through(new CompressionStream('deflate-raw'), json));
  const link = packed.replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
  return link.length > kLongest ? undefined : link;
}

// Of any text: a state whose every part is what it has to be. Throws where it is none.
export async function unpackState(link) {
  const packed = bytesOf(link.replaceAll('-', '+').replaceAll('_', '/'));
  const state = JSON.parse(new TextDecoder().decode(await unpacked(packed, 'deflate-raw')));
  const texts = Object.fromEntries(['ask', 'mesh', 'domain', 'points', 'claim', 'algorithm', 'more'].map((key) => [key, String(state[key] ?? '')]));
  const files = state.files.map(({ name, text, base64 }) => (base64 === undefined
    ? { name: String(name), text: String(text) } : { name: String(name), bytes: bytesOf(base64) }));
  return { ...texts, files };
}
