// The pictures of cards as SVG images, drawn by the code of the page.
//   node image.mjs (PAGE N OUTPUT [--exaggerate])...     PAGE: written by --html; N: which card,
// from 1
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { Camera } from './camera.js';
import { Drawing, largestStretch } from './drawing.js';
import { imageOf } from './flat.js';

const here = dirname(fileURLToPath(import.meta.url));
const read = (name) => readFileSync(join(here, name), 'utf8');
const colours = read('page.css').match(/:root \{[^}]*\}\n@media \(prefers-color-scheme: dark\) \{[^@]*?\n\}\n/)[0];
const style = (colours + read('roles.css')).replace(/\s+/g, ' ');

function draw(file, number, output, option) {
  const page = readFileSync(file, 'utf8');
  const data = JSON.parse(page.match(/<script type="application\/json" id="data">([^<]*)/)[1]);
  const cards = data.results.flatMap(({ report, cards: own, pictures }) => (report?.violations ?? own).map((v, i) => [v, pictures[i]]));
  const [v, picture] = cards[Number(number) - 1] ?? [];
  if (!picture || picture.why_none) {
    console.error(`image.mjs: expected the number of a card of ${file} with a picture, found ${number}`);
    process.exit(2);
  }
  const drawing = new Drawing(v, picture, option === '--exaggerate' ? largestStretch(picture) : 1);
  writeFileSync(output, imageOf(drawing, new Camera(drawing), `${v.rule}. ${drawing.caption}`, style));
}

const words = process.argv.slice(2);
while (words.length > 0) draw(...words.splice(0, words[3] === '--exaggerate' ? 4 : 3));
