import { answers } from './answers.mjs';

// What is asked before the library is there waits for it.
const early = [];
onmessage = ({ data }) => early.push(data);
const answer = answers(await import('./browser.mjs'), (said) => postMessage(said));
early.forEach(answer);
onmessage = ({ data }) => answer(data);
