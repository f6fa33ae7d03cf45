// For Vitest and Jest: expect.extend(matchers). What is received is an object with points and
// simplices, a Delaunator, or d3's Delaunay; the message of a failure has the witness.
import { check } from '#index';

function judged(received, options, isNot) {
  const verdict = check(received, options);
  return { pass: verdict.holds, message: () => (isNot ? `expected the claim to fail, but it holds:\n${verdict.text}` : verdict.text),
    actual: verdict.text };
}

export const matchers = {
  toBeDelaunay(received, options = {}) { return judged(received, { claim: 'delaunay', ...options }, this?.isNot); },
  toBeTriangulation(received, options = {}) { return judged(received, { claim: 'triangulation', ...options }, this?.isNot); },
  toBeComplex(received, options = {}) { return judged(received, { claim: 'complex', ...options }, this?.isNot); },
  // Of a mesh and its domain: { claim: 'cdt', domain: { points, segments } }.
  toHold(received, options = {}) { return judged(received, options, this?.isNot); },
};
export default matchers;
