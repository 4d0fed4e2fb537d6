// SPDX-License-Identifier: MIT
// What nobody should drop on a page, given to the native command line: numbers without end or
// without sense, everything in one place, on one line or in one plane, millions of copies, triangles
// all through each other. Each must end in a closed 2-manifold or in an error that says why, within
// a time and a limit of memory; how long each takes.
import { closeSync, openSync, writeFileSync, writeSync } from 'node:fs';
import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { builders } from '../../../scripts/build.mjs';
import { root } from '../../../scripts/run.mjs';
import { measure, printTable, randomNumbers } from '../../bench/shared.mjs';

const mostSeconds = 120;
const refused = 2; // the exit status
const mostBytes = 4 * 2 ** 30;
const relativeTolerance = '0.002';

const cube = {
  positions: [...Array(8).keys()].map((i) => [i & 1, (i >> 1) & 1, i >> 2]),
  faces: ['0231', '4576', '0154', '2673', '0462', '1375'].map((face) => [...face].map(Number)),
};

const obj = ({ positions, faces }) =>
  [
    ...positions.map((p) => `v ${p.join(' ')}`),
    ...faces.map((face) => `f ${face.map((i) => i + 1).join(' ')}`),
    '',
  ].join('\n');

const moved = (mesh, change) => ({ ...mesh, positions: mesh.positions.map((p) => p.map(change)) });

/** Triangles by themselves, each corner by `corner(triangle, random)`. */
function triangles(count, corner) {
  const random = randomNumbers(1);
  const positions = [];
  for (let i = 0; i < count; ++i) {
    const middle = [random(), random(), random()];
    for (let k = 0; k < 3; ++k) positions.push(corner(middle, random));
  }
  const faces = Array.from({ length: count }, (_, i) => [3 * i, 3 * i + 1, 3 * i + 2]);
  return { positions, faces };
}

const near = (size) => (middle, random) => middle.map((x) => x + size * (random() - 0.5));

/** Binary STL, written in pieces: the same triangle again and again. */
function writeCopies(path, count) {
  const facet = Buffer.alloc(50);
  [0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0].forEach((x, i) => facet.writeFloatLE(x, 4 * i));
  const piece = Buffer.concat(Array(10_000).fill(facet));
  const header = Buffer.alloc(84);
  header.writeUInt32LE(count, 80);
  const file = openSync(path, 'w');
  writeSync(file, header);
  for (let left = count; left > 0; left -= 10_000) {
    writeSync(file, piece, 0, 50 * Math.min(left, 10_000));
  }
  closeSync(file);
}

// Name, the file's text or what writes it, further options, and whether a solid must come out.
const cases = [
  ['empty file', '', [], false],
  ['points only', obj({ ...cube, faces: [] }), [], false],
  ['one triangle', obj(triangles(1, near(1))), [], false],
  ['one triangle, thickened', obj(triangles(1, near(1))), ['--thicken', '0.05'], true],
  ['all points equal', obj(moved(cube, () => 3)), [], false],
  ['all on a line', obj(triangles(50, (_, random) => Array(3).fill(random()))), [], false],
  ['300 triangles in a plane', obj(triangles(300, (m, r) => [r(), r(), 0])), [], undefined],
  ['a cube of 1e30', obj(moved(cube, (x) => x * 1e30)), [], true],
  ['a cube of 1e-30', obj(moved(cube, (x) => x * 1e-30)), [], true],
  ['a cube of 1e200', obj(moved(cube, (x) => x * 1e200)), [], false],
  ['a cube 1e6 times its size away', obj(moved(cube, (x) => x + 1e6)), [], true],
  ['a coordinate that is no number', obj(cube).replace('v 0', 'v nan'), [], false],
  ['a coordinate without end', obj(cube).replace('v 0', 'v inf'), [], false],
  ['a corner out of range', obj(cube).replace('f 1', 'f 99'), [], false],
  ['2,000 triangles of a tenth', obj(triangles(2000, near(0.1))), [], undefined],
  ['2,000 large triangles', obj(triangles(2000, near(1))), [], undefined],
  ['20,000 triangles of a fortieth', obj(triangles(20_000, near(0.025))), [], undefined],
  ['10 million copies of a triangle', (path) => writeCopies(path, 1e7), [], false, 'stl'],
  ['the same, looked at', (path) => writeCopies(path, 1e7), ['--stats'], true, 'stl'],
  ['the same, thickened', (path) => writeCopies(path, 1e7), ['--thicken', '0.05'], true, 'stl'],
];

export default function hostile({ tools, folder }) {
  builders.native();
  const program = join(root, 'build/native/src/cli/kdmanifold');
  const rows = cases.map(([name, text, options, solid, format = 'obj']) => {
    const path = join(folder, `hostile.${format}`);
    if (typeof text === 'string') writeFileSync(path, text);
    else text(path);
    const out = join(folder, 'result.obj');
    const looks = options.includes('--stats');
    const args = [
      path,
      ...options,
      ...(looks ? [] : ['-o', out, '--force', '--relative-tolerance']),
    ];
    if (!looks) args.push(relativeTolerance);
    const started = performance.now();
    const { status, stderr, signal } = spawnSync(
      'sh',
      ['-c', `ulimit -v ${mostBytes / 1024}; exec "$0" "$@"`, program, ...args],
      { encoding: 'utf8', timeout: 1000 * mostSeconds },
    );
    const seconds = (performance.now() - started) / 1000;
    const verdict = () => {
      if (status !== 0 && status !== refused) return `FAILS: ended with ${signal ?? status}`;
      if (solid !== undefined && solid !== (status === 0)) return 'FAILS: not as it should end';
      if (status === refused)
        return stderr.startsWith('kdmanifold: ') ? 'ok' : 'FAILS: says nothing';
      return looks || measure(tools, out).twoManifold ? 'ok' : 'FAILS: not 2-manifold';
    };
    return {
      case: name,
      seconds: seconds.toFixed(2),
      verdict: verdict(),
      outcome: status === 0 ? 'done' : stderr.trim().replace(`${folder}/`, '').slice(0, 110),
    };
  });
  printTable(rows);
  return { rows, failures: rows.filter(({ verdict }) => verdict !== 'ok').length };
}
