// SPDX-License-Identifier: MIT
// What both command lines refuse: with the same words, status 2, and nothing written.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { load } from '../../../dist/index.js';
import { cube } from '../support/meshes.js';
import { both, namesIn, writeMesh } from '../support/programs.js';
import { withFolder } from '../support/paths.js';

let kdm;
beforeAll(async () => {
  kdm = await load();
});

const seeHelp = ' (--help lists the options)';
const noFormat = "the file's name ends in none of .obj, .stl, .ply, .off and .glb";
const noOption = (word) => `there is no such option; did you mean ${word}?`;

// Run in a folder with a.obj, b.obj, old.obj, the folder `inner`, and not a single grid.
const wrong = [
  // What is missing or too much.
  [[], `INPUT is required${seeHelp}`],
  [[''], `INPUT is empty${seeHelp}`],
  [['--json'], `INPUT is required${seeHelp}`],
  [['a.obj', '--depth'], '--depth: the value is missing'],
  [['a.obj', '--depth', '--json'], '--depth: the value is missing'],
  [['a.obj', '-o'], '-o: the value is missing'],
  [['a.obj', '--saveGrid'], '--saveGrid: the value is missing'],
  [['a.obj', '--output='], '--output: the value is empty'],
  [['a.obj', '--json=yes'], '--json: takes no value'],
  [['a.obj', '--noUnfold=1'], '--noUnfold: takes no value'],
  [['a.obj', '-o', 'x.obj', '--output', 'y.obj'], '--output: is given twice'],
  [['a.obj', '--splitError=1', '--split-error', '2'], '--split-error: is given twice'],
  // What does not exist.
  [['a.obj', '--unheard-of'], `--unheard-of: there is no such option${seeHelp}`],
  [['a.obj', '--tolerence', '1'], `--tolerence: ${noOption('--tolerance')}`],
  [['a.obj', '--tol=1'], `--tol: ${noOption('--tolerance')}`],
  [
    ['a.obj', '--relativeTolerence', '1'],
    `--relativeTolerence: ${noOption('--relative-tolerance')}`,
  ],
  [['a.obj', '-tolerance', '1'], `-tolerance: ${noOption('--tolerance')}`],
  [['a.obj', '--unfold'], `--unfold: ${noOption('--no-unfold')}`],
  [['a.obj', '--ouput', 'x.obj'], `--ouput: ${noOption('--output')}`],
  [['a.obj', '-ox.obj'], `-ox.obj: ${noOption('-o x.obj')}`],
  [['a.obj', '-x'], `-x: there is no such option${seeHelp}`],
  [['a.obj', '-1'], `-1: there is no such option${seeHelp}`],
  // Values.
  [['a.obj', '--depth', '0'], "--depth: '0' is no whole number from 1 to 60"],
  [['a.obj', '--depth', 'deep'], "--depth: 'deep' is no whole number from 1 to 60"],
  [['a.obj', '--depth', '9.5'], "--depth: '9.5' is no whole number from 1 to 60"],
  [['a.obj', '--tolerance=-1'], "--tolerance: '-1' is no number from 0 on"],
  [['a.obj', '--tolerance', '-1'], "--tolerance: '-1' is no number from 0 on"],
  [['a.obj', '--tolerance', 'inf'], "--tolerance: 'inf' is no number from 0 on"],
  [['a.obj', '--relativeTolerance', '1mm'], "--relativeTolerance: '1mm' is no number from 0 on"],
  [['a.obj', '--crease-angle', '180.5'], "--crease-angle: '180.5' is no number from 0 to 180"],
  [
    ['a.obj', '--strategy', 'best'],
    "--strategy: 'best' is none of adaptive, octree, feature, median, uniform",
  ],
  [
    ['a.obj', '--strategy', 'octre'],
    "--strategy: 'octre' is none of adaptive, octree, feature, median, uniform; did you mean octree?",
  ],
  [
    ['a.obj', '--inside', 'postive'],
    "--inside: 'postive' is none of repair, positive, odd, nonzero, sheet; did you mean positive?",
  ],
  [
    ['a.obj', '--inputFormat', 'obi'],
    "--inputFormat: 'obi' is none of obj, stl, ply, off, glb; did you mean obj?",
  ],
  [['a.obj', '--target-triangles', '0'], "--target-triangles: '0' is no whole number from 1 on"],
  [
    ['a.obj', '--target-triangles', '9,8.5'],
    "--target-triangles: '8.5' is no whole number from 1 on",
  ],
  [['a.obj', '--target-triangles', '9,'], "--target-triangles: '' is no whole number from 1 on"],
  [
    ['a.obj', '--targetTriangles', '9,9'],
    "--targetTriangles: '9' must be smaller than the number before",
  ],
  [
    ['a.obj', '--targetTriangles', '9', '--noReduce'],
    '--targetTriangles: not together with --noReduce',
  ],
  [
    ['a.obj', '--target-triangles', '9', '--quads'],
    '--target-triangles: not together with --quads',
  ],
  [
    ['a.obj', '--target-triangles', '9', '--no-strict'],
    '--target-triangles: not together with --strict off',
  ],
  [
    ['a.obj', '--target-triangles', '9,8', '-o', '-', '--format', 'stl'],
    '--target-triangles: standard output takes one level, not several',
  ],
  [
    ['a.obj', '--target-triangles', '9', '--relative-tolerance', '0'],
    '--target-triangles: not together with --relative-tolerance 0',
  ],
  [['a.obj', '--cells', '0'], "--cells: '0' is no whole number from 1 to 500000"],
  [
    ['a.obj', '--strategy', 'octree', '--cells', '80', '--depth', '9'],
    '--depth: not together with --cells',
  ],
  [['a.obj', '--cells', '80'], '--cells: only with --strategy octree or uniform'],
  // Files.
  [['missing.obj'], 'missing.obj: cannot be read: there is no such file or folder'],
  [['a.obj/b.obj'], 'a.obj/b.obj: cannot be read: a part of its path is no folder'],
  [['inner', '--input-format', 'obj'], 'inner: cannot be read: it is a folder'],
  [['no.kdgrid'], 'no.kdgrid: cannot be read: there is no such file or folder'],
  [['a.step'], `a.step: ${noFormat}; --input-format tells the format of other names`],
  [['a'], `a: ${noFormat}; --input-format tells the format of other names`],
  [['a.gltf'], `a.gltf: ${noFormat}; .gltf files are not supported, .glb files are`],
  [['a.obj', '-o', 'out.step'], `out.step: ${noFormat}; --format tells the format of other names`],
  [['a.obj', '-o', 'out.stp'], `out.stp: ${noFormat}; did you mean .stl?`],
  [['a.obj', '-o', 'out.kdgrid'], `out.kdgrid: ${noFormat}; --save-grid keeps grids`],
  [['-'], 'standard input has no name that tells its format; --input-format does'],
  [['a.obj', '-o', '-'], 'standard output has no name that tells its format; --format does'],
  [['a.obj', '-o', 'no/such/x.obj'], 'no/such/x.obj: there is no folder no/such'],
  [['a.obj', '-o', 'b.obj/x.obj'], 'b.obj/x.obj: b.obj is no folder'],
  [
    ['a.obj', '-o', 'inner', '--format', 'obj'],
    'inner: it is a folder; --out-dir puts results into folders',
  ],
  [['a.obj', '-o', 'old.obj'], 'old.obj: it exists already; --force overwrites it'],
  [['a.obj', '-o', 'a.obj'], 'a.obj: it exists already; --force overwrites it'],
  [['a.obj', '--save-grid', 'no/x.kdgrid'], 'no/x.kdgrid: there is no folder no'],
  [['a.obj', '--save-grid', 'x.obj'], "--save-grid: 'x.obj' does not end in .kdgrid"],
  [['a.obj', '--out-dir', 'old.obj'], '--out-dir: old.obj is no folder'],
  [['a.obj', '--outDir', 'no/such'], '--outDir: there is no folder no'],
  [['x*.obj'], 'x*.obj: no file fits this pattern'],
  // What does not go together.
  [
    ['a.obj', 'b.obj', '-o', 'x.obj'],
    '-o: it takes the result of one input, but there are 2; --out-dir takes those of several',
  ],
  [
    ['?.obj', '--output', 'x.obj'],
    '--output: it takes the result of one input, but there are 2; --out-dir takes those of several',
  ],
  [
    ['a.obj', 'b.obj', '--save-grid', 'x.kdgrid'],
    '--save-grid: it takes the grid of one input, but there are 2',
  ],
  [['a.obj', '-o', 'x.obj', '--out-dir', 'inner'], '--out-dir: not together with -o'],
  [
    ['a.obj', '--saveGrid', 'x.kdgrid', '--out-dir', 'inner'],
    '--out-dir: not together with --saveGrid',
  ],
  [
    ['a.obj', './a.obj', '--out-dir', 'inner'],
    '--out-dir: a.obj and ./a.obj would both become inner/a.obj',
  ],
  [
    ['a.obj', 'a.off', '--out-dir', 'inner', '--format', 'stl'],
    '--out-dir: a.obj and a.off would both become inner/a.stl',
  ],
  [['-', '--out-dir', 'inner'], '--out-dir: standard input has no name that its result could have'],
  [['a.kdgrid', '--out-dir', 'inner'], '--out-dir: what a.kdgrid becomes is for --format to say'],
  [['a.obj', '--no-strict', '--strict=off'], '--no-strict: not together with --strict'],
  [['a.obj', '--format', 'stl'], '--format: only with -o or --out-dir'],
  [
    ['a.obj', '--tolerance', '1', '--relativeTolerance', '0.001'],
    '--relativeTolerance: not together with --tolerance',
  ],
  [
    ['a.obj', '--tolerance=1', '--strategy', 'uniform'],
    '--tolerance: only with --strategy adaptive, octree or feature',
  ],
  [
    ['a.obj', '--relative-tolerance=1', '--strategy', 'median'],
    '--relative-tolerance: only with --strategy adaptive, octree or feature',
  ],
  [
    ['a.obj', '--windingThreshold', '0', '--inside', 'odd'],
    '--windingThreshold: only with --inside repair',
  ],
  [
    ['a.obj', '--largest-hole', '1', '--inside', 'sheet'],
    '--largest-hole: only with --inside repair',
  ],
  [
    ['a.obj', '--largest-hole', '1', '--thicken', '1'],
    '--largest-hole: not together with --thicken, which leaves no holes',
  ],
  [
    ['a.obj', '--pairing', 'inside', '--inside', 'sheet'],
    '--pairing: only trace or hermite with --inside sheet',
  ],
  [
    ['a.obj', '--minimum-thickness', '1', '--strategy', 'uniform'],
    '--minimum-thickness: only with --strategy adaptive, octree or feature',
  ],
  [
    ['a.obj', '--minimumGap', '1', '--inside', 'odd'],
    '--minimumGap: only with --inside repair or positive',
  ],
  [
    ['a.obj', '--minimum-thickness', '100'],
    'a.obj: all of the solid is thinner than --minimum-thickness',
  ],
  [
    ['a.obj', '--union', 'b.obj', '--minimum-gap', '1'],
    expect.stringMatching(/--minimum-gap: not for Boolean operations$/),
  ],
  [['a.obj', '--remove-material', '1'], '--remove-material: only with --simplify'],
  [['a.obj', '--addMaterial', '1'], '--addMaterial: only with --simplify'],
  [['a.obj', '--thicken-what', 'sheets'], '--thicken-what: only with --thicken'],
  [
    ['a.obj', '--thicken', '1', '--thickenWhat', 'sheets', '--inside', 'odd'],
    '--thickenWhat: sheets only with --inside repair',
  ],
  [
    ['a.obj', '--thicken', '1', '--thicken-what', 'sheets', '--winding-threshold', '0.5'],
    '--thicken-what: not sheets together with --winding-threshold',
  ],
  [['a.obj', '--quads', '--strict', 'embedded'], '--strict: not embedded together with --quads'],
  [['a.obj', '--quads', '--linkError', '1'], '--linkError: not together with --quads'],
  [['a.obj', '--crease-angle', '30'], '--crease-angle: only with --normals'],
  [
    ['a.obj', '--normals', '-o', 'x.stl'],
    'a.obj: --normals: of the files only .obj and .glb have them',
  ],
  [
    ['a.obj', '--inside', 'sheet', '--parts', 'largest'],
    'a.obj: --parts: only all for a sheet, which encloses nothing',
  ],
  [
    ['a.obj', '--inside', 'sheet', '--dropCavities', '1'],
    'a.obj: --dropCavities: not for a sheet, which encloses nothing',
  ],
  [
    ['a.obj', '--quads', '--strict', 'manifold', '--drop-handles', '1'],
    '--drop-handles: not together with --quads',
  ],
  [
    ['a.obj', '--drop-parts', '100'],
    'a.obj: all parts of the result are smaller than --drop-parts',
  ],
  [
    ['open.obj', '--largestHole', '0.001'],
    expect.stringMatching(
      /^open\.obj: 1 of 1 holes are wider than --largestHole, which is 0\.001;/,
    ),
  ],
  [['a.obj', '--json', '--quiet'], '--quiet: not together with --json, which prints a report'],
  [['a.obj', '--threads', '0'], "--threads: '0' is no whole number from 1 to 256"],
  [['a.obj', '--threads', '257'], "--threads: '257' is no whole number from 1 to 256"],
  [
    ['a.kdgrid', '--pairing', 'trace', '--depth=9'],
    '--depth: the grid in a.kdgrid is built already',
  ],
  [['a.kdgrid', '--stats'], '--stats: a.kdgrid is a grid, which has no faces'],
  [
    ['a.obj', '--thicken', '1e-8'],
    expect.stringMatching(/^a\.obj: --thicken is 1e-08; for a model of this size it must be /),
  ],
];

test.each(wrong.map(([args, message]) => [args.join(' '), args, message]))(
  'arguments "%s"',
  (_, args, message) =>
    withFolder((folder) => {
      for (const name of ['a.obj', 'b.obj']) writeMesh(kdm, join(folder, name), cube());
      const { positions, indices } = cube();
      writeMesh(kdm, join(folder, 'open.obj'), { positions, indices: indices.slice(3) });
      writeFileSync(join(folder, 'old.obj'), 'precious');
      mkdirSync(join(folder, 'inner'));
      const before = namesIn(folder);
      const [native, node] = both(args, { cwd: folder, input: '' });
      expect(native).toMatchObject({ status: 2, stdout: '' });
      expect(native.stderr).toMatch(/^kdmanifold: [^\n]+\n$/);
      expect(native.stderr.slice('kdmanifold: '.length, -1)).toEqual(message);
      expect(node).toEqual(native);
      expect(namesIn(folder)).toEqual(before);
      expect(namesIn(join(folder, 'inner'))).toEqual([]);
      expect(readFileSync(join(folder, 'old.obj'), 'utf8')).toBe('precious');
    }),
);

test('there are enough of them', () => {
  expect(wrong.length).toBeGreaterThan(60);
});

const broken = {
  'open.obj': 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n',
  'malformed.obj': 'v 0 0 0\nv 1 zero 0\n',
  'range.obj': 'v 0 0 0\nf 1 2 9\n',
  'empty.obj': '',
  'cut.ply': 'ply\nformat binary_little_endian 1.0\nelement vertex 5\n',
  'nonsense.stl': 'hello',
  'short.off': 'OFF\n4 4 0\n0 0 0\n',
  'empty.glb': '',
  'nonsense.glb': 'glTF and more',
  'text.glb': '{"asset":{"version":"2.0"}}',
  'model.step': 'ISO-10303-21;',
  'a\nb\x1b.obj': 'v 0 0\n',
};

test.each(Object.entries(broken))('bad input %j: one line with its name', (name, content) =>
  withFolder((folder) => {
    writeFileSync(join(folder, name), content);
    const [native, node] = both([name, '-o', 'out.obj'], { cwd: folder });
    expect(native).toMatchObject({ status: 2, stdout: '' });
    expect(native.stderr).toMatch(/^kdmanifold: [^\n]+\n$/);
    // eslint-disable-next-line no-control-regex -- what must not reach a terminal
    expect(native.stderr).toContain(name.replace(/[\0-\x1f]/g, ' '));
    expect(node).toEqual(native);
    expect(namesIn(folder)).toEqual([name]);
  }),
);

test('help is given whatever else is wrong, but not behind --', () => {
  for (const args of [
    ['--bogus', '-h'],
    ['--depth', '--help'],
    ['--version', '--help'],
  ]) {
    for (const { status, stdout } of both(args)) {
      expect(status).toBe(0);
      expect(stdout).toContain('Usage: kdmanifold [OPTIONS] INPUT...');
    }
  }
  for (const { status, stderr } of both(['--', '--help'])) {
    expect(status).toBe(2);
    expect(stderr).toContain("--help: the file's name ends in none of");
  }
});
