// The oracle in a thread of its own: a page goes on meanwhile, and what takes too long can be
// ended.
import { InputError, NoneError, UndecidedError, Verdict } from './oracle.mjs';

const FAULTS = { InputError, NoneError, UndecidedError, RangeError, TypeError };
const QUESTIONS = ['check', 'delaunay', 'constrainedDelaunay', 'compare', 'certify', 'generate', 'orient', 'inBall', 'version'];

// A worker of a page or a thread of Node. `hears` gets what it says, `ended` why it says no more.
async function threadOf(hears, ended) {
  if (typeof globalThis.Worker === 'function') {
    const worker = new Worker(new URL('./page_thread.mjs', import.meta.url), { type: 'module' });
    worker.onmessage = ({ data }) => hears(data);
    worker.onerror = ({ message }) => ended(message ?? 'its module was not loaded');
    return { worker, keeps() {} };
  }
  const { Worker: Thread } = await import(/* webpackIgnore: true */ /* @vite-ignore */ 'node:worker_threads');
  const worker = new Thread(new URL('./node_thread.mjs', import.meta.url));
  worker.on('message', hears);
  worker.on('error', ({ message }) => ended(message));
  worker.on('exit', (code) => ended(`exit code ${code}`));
  // A program need not wait for a thread that nobody asks.
  return { worker, keeps: (isAsked) => (isAsked ? worker.ref() : worker.unref()) };
}

// The functions of the module, each of which gives a promise; end() ends the thread, and what was
// asked is rejected.
export async function startWorker() {
  const waiting = new Map();
  let reason;
  let asked = 0;
  const ended = (why) => {
    reason ??= why;
    for (const { reject } of waiting.values()) reject(new Error(`expected an answer, found that the worker was ended: ${reason}`));
    waiting.clear();
  };
  const hears = ({ number, kind, answer, fault }) => {
    const question = waiting.get(number);
    if (question === undefined) return;  // it was answered, but not heard before the end
    const { resolve, reject } = question;
    waiting.delete(number);
    thread.keeps(waiting.size > 0);
    if (fault) reject(new (FAULTS[fault.name] ?? Error)(fault.message));
    else resolve(kind === 'Verdict' ? new Verdict(answer) : answer);
  };
  const thread = await threadOf(hears, ended);
  thread.keeps(false);
  const ask = (question) => (...words) => new Promise((resolve, reject) => {
    if (reason !== undefined) throw new Error(`expected a worker, found that it was ended: ${reason}; start another`);
    const number = asked++;
    thread.worker.postMessage({ number, question, words });  // throws what cannot be copied, such as a detached array
    waiting.set(number, { resolve, reject });
    thread.keeps(true);
  });
  return {
    ...Object.fromEntries(QUESTIONS.map((question) => [question, ask(question)])),
    end() {
      ended('end() was called');
      thread.worker.terminate();
    },
  };
}
