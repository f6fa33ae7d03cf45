// How the simplices of a mesh are distributed: a bar for each range of a measure.
import { element, svg } from './elements.js';

const ROW = 20, LEFT = 150, BARS = 420, RIGHT = 90;

function words(bounds, bin) {
  if (bin === 0) return `below ${bounds[0]}`;
  return bin === bounds.length ? `from ${bounds[bin - 1]}` : `${bounds[bin - 1]} to ${bounds[bin]}`;
}

// `measured`: its name as `measure`, its `bounds` as texts, and `counts`, one more than those.
export function histogram({ measure, bounds, counts }) {
  const most = Math.max(...counts, 1);
  const bins = counts.map((count, bin) => ({ count, bin }));
  const used = bins.filter(({ count }) => count > 0).map(({ bin }) => bin);
  const shown = bins.slice(used[0] ?? 0, (used.at(-1) ?? -1) + 1);
  const rows = shown.flatMap(({ count, bin }, row) => {
    const middle = (row + 0.7) * ROW, length = BARS * count / most;
    return [
      svg('text', { x: LEFT - 8, y: middle, 'text-anchor': 'end' }, words(bounds, bin)),
      svg('rect', { x: LEFT, y: row * ROW + 2, width: length, height: ROW - 4 }),
      svg('text', { x: LEFT + length + 8, y: middle }, String(count)),
    ];
  });
  const text = shown.map(({ count, bin }) => `${words(bounds, bin)}: ${count}`).join('; ');
  return element('figure', { class: 'histogram' },
    element('figcaption', {}, `${measure}: how many simplices measure how much`),
    svg('svg', { viewBox: `0 0 ${LEFT + BARS + RIGHT} ${shown.length * ROW}`, role: 'img', 'aria-label': `${measure}: ${text}` },
      ...rows));
}
