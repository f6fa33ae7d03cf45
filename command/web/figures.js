// Figures of chapter 4, as the corpus has them: bundle.mjs puts the texts of the files in.
import chazelle from '../../corpus/domains/figure-4-13-chazelle-1.poly';
import encircled from '../../corpus/domains/figure-4-15-encircled-segment.poly';
import occluded from '../../corpus/domains/figure-4-14-occluded.poly';
import segments from '../../corpus/domains/figure-4-12-three-segments.poly';
import cubes from '../../corpus/accept/figure-4-4-two-cubes.node';
import cubesMesh from '../../corpus/accept/figure-4-4-two-cubes.ele';
import lines from '../../corpus/accept/figure-4-2-skew-lines-5.node';
import sliver from '../../corpus/accept/figure-4-1-sliver.node';
import sliverMesh from '../../corpus/accept/figure-4-1-sliver.ele';

const domain = (name, text) => ({ ask: 'inspect', mesh: name, files: [{ name, text }] });
const mesh = (name, node, ele) => ({ ask: 'check', mesh: `${name}.ele`,
  files: [{ name: `${name}.node`, text: node }, { name: `${name}.ele`, text: ele }] });

export const figures = {
  'Bowyer–Watson, step by step': { ask: 'build delaunay', algorithm: 'bowyer-watson', mesh: 'steps.node', files: [
    { name: 'steps.node', text: '7 2 0 0\n1 0 0\n2 6 1\n3 7 5\n4 1 6\n5 3 2\n6 4 4\n7 2 4\n' }] },
  'Figure 4.1: a sliver': mesh('sliver', sliver, sliverMesh),
  'Figure 4.2: points of two skew lines, step by step': { ask: 'build delaunay', algorithm: 'gift-wrapping', mesh: 'lines.node',
    files: [{ name: 'lines.node', text: lines }] },
  'Figure 4.4: two cubes': mesh('cubes', cubes, cubesMesh),
  'Figure 4.12: three segments in a cube': domain('three-segments.poly', segments),
  'Figure 4.13: Chazelle’s polyhedron': domain('chazelle.poly', chazelle),
  'Figure 4.14: a vertex behind a polygon, by FlipInsertPolygon': { ...domain('occluded.poly', occluded), ask: 'build cdt',
    algorithm: 'polygon-flips' },
  'Figure 4.15: a segment that three tetrahedra encircle': domain('encircled.poly', encircled),
};
