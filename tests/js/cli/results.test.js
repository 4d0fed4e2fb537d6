// SPDX-License-Identifier: MIT
// The two command lines, native and in Node: same options, same files, same report, same status.
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { load } from '../../../dist/index.js';
import { fileOptions, reportOptions, solidOptions } from '../../../build/js/cli/table.js';
import { buildOptions, extractOptions, reductionOptions } from '../../../build/js/options.js';
import { cube, faults, together, torus } from '../support/meshes.js';
import { both, programs, withoutNumbers, writeMesh } from '../support/programs.js';
import { execute, nodeCli, withFolder } from '../support/paths.js';

let kdm;
beforeAll(async () => {
  kdm = await load();
});

const write = (path, mesh) => writeMesh(kdm, path, mesh);

const keysOf = (value) =>
  value !== null && typeof value === 'object'
    ? Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, keysOf(inner)]))
    : typeof value;

const optionSets = [
  [],
  ['--tolerance', '0.05'],
  ['--tolerance', '0.05', '--no-reduce'],
  ['--tolerance', '0.2', '--target-triangles', '900'],
  ['--relative-tolerance=0.01'],
  ['--strategy', 'octree', '--depth', '15'],
  ['--strategy', 'median', '--depth', '15', '--inside', 'nonzero'],
  ['--strategy', 'uniform', '--depth', '12', '--quads', '--pairing', 'hermite'],
  ['--strategy', 'octree', '--depth', '12', '--normals', '--crease-angle', '40'],
  ['--strategy', 'uniform', '--depth', '9', '--no-strict', '--inside', 'odd'],
  ['--strategy', 'octree', '--depth', '15', '--inside', 'sheet'],
  ['--strategy', 'octree', '--depth', '15', '--thicken', '0.2'],
];

// Only some files have normals.
const withoutNormals = (set) => {
  const at = set.indexOf('--normals');
  return at < 0 ? set : [...set.slice(0, at), ...set.slice(at + 3)];
};

test.each(optionSets.map((set) => [set.join(' '), set]))(
  'the same bytes and numbers from both: %s',
  (_, set) =>
    withFolder((folder) => {
      const input = join(folder, 'input.ply');
      write(input, together(torus(), cube(3, [2.5, 0.2, 0.1])));
      for (const format of ['obj', 'stl', 'ply', 'off', 'glb']) {
        const [native, node] = programs.map(([name, run]) => {
          const output = join(folder, `${name}.${format}`);
          const held = ['obj', 'glb'].includes(format) ? set : withoutNormals(set);
          const result = run([input, '-o', output, '--json', '--check', ...held]);
          expect(result.stderr).toBe('');
          const report = JSON.parse(result.stdout);
          expect(result.status).toBe(report.output.twoManifold ? 0 : 1);
          return { bytes: readFileSync(output), report };
        });
        expect(node.bytes.equals(native.bytes)).toBe(true);
        expect(keysOf(node.report)).toEqual(keysOf(native.report));
        expect(JSON.stringify(keysOf(node.report))).toBe(JSON.stringify(keysOf(native.report)));
        for (const part of ['input', 'output', 'reduce', 'lost', 'error', 'check']) {
          expect(node.report[part]).toEqual(native.report[part]);
        }
        // Sizes in memory differ with the width of pointers; nothing else does.
        const { bytes: nodeBytes, ...nodeGrid } = node.report.grid;
        const { bytes: nativeBytes, ...nativeGrid } = native.report.grid;
        expect(nodeGrid).toEqual(nativeGrid);
        expect(nodeBytes * nativeBytes).toBeGreaterThan(0);
      }
    }),
);

test('every format is read by both alike', () =>
  withFolder((folder) => {
    for (const format of ['obj', 'stl', 'ply', 'off']) {
      const input = join(folder, `input.${format}`);
      write(input, torus());
      const [native, node] = programs.map(([name, run]) => {
        const output = join(folder, `${name}-${format}.ply`);
        expect(run([input, '-o', output]).status).toBe(0);
        return readFileSync(output);
      });
      expect(node.equals(native)).toBe(true);
    }
  }));

test('the text for people is the same but for times and sizes', () =>
  withFolder((folder) => {
    const input = join(folder, 'input.obj');
    write(input, torus());
    const [native, node] = both([input, '--check']).map(({ status, stdout }) => {
      expect(status).toBe(0);
      return withoutNumbers(stdout);
    });
    expect(node).toBe(native);
    expect(node).toContain('2-manifold');
  }));

test('without -o the report comes and no file', () =>
  withFolder((folder) => {
    write(join(folder, 'a.obj'), cube());
    for (const { status, stdout } of both(['a.obj', '--json'], { cwd: folder })) {
      expect(status).toBe(0);
      expect(JSON.parse(stdout).seconds).not.toHaveProperty('write');
    }
    expect(readdirSync(folder)).toEqual(['a.obj']);
  }));

test('a raw surface that is not 2-manifold: --check says so, status 1, file written', () =>
  withFolder((folder) => {
    // Two cubes that meet in an edge.
    write(join(folder, 'a.obj'), together(cube(2), cube(2, [2, 2, 0])));
    const set = ['--strategy', 'uniform', '--depth', '9', '--no-strict', '--check', '--json'];
    for (const [name, run] of programs) {
      const { status, stdout } = run(['a.obj', '-o', `${name}.obj`, ...set], { cwd: folder });
      const { check } = JSON.parse(stdout);
      expect(status).toBe(check.twoManifold ? 0 : 1);
      const read = kdm.parseMesh(readFileSync(join(folder, `${name}.obj`)), 'obj');
      expect(faults(read).length === 0).toBe(check.twoManifold);
    }
  }));

test('a saved grid is the same file from both, and is read by both', () =>
  withFolder((folder) => {
    write(join(folder, 'a.obj'), torus());
    const saved = programs.map(([name, run]) => {
      const files = ['-o', `${name}.ply`, '--save-grid', `${name}.kdgrid`];
      const result = run(['a.obj', ...files, '--no-reduce'], { cwd: folder });
      expect(result).toMatchObject({ status: 0, stderr: '' });
      return readFileSync(join(folder, `${name}.kdgrid`));
    });
    expect(saved[1].equals(saved[0])).toBe(true);
    const direct = readFileSync(join(folder, 'native.ply'));
    // Each reads what the other has written.
    const loaded = programs.map(([, run], i) => {
      const other = programs[1 - i][0];
      const args = [`${other}.kdgrid`, '-o', 'again.ply', '--force', '--check'];
      const result = run(args, { cwd: folder });
      expect(result).toMatchObject({ status: 0, stderr: '' });
      expect(readFileSync(join(folder, 'again.ply')).equals(direct)).toBe(true);
      return result.stdout.replaceAll(other, '').replace(/\d+\.\d+/g, '#');
    });
    expect(loaded[1]).toBe(loaded[0]);
    expect(loaded[0]).toContain('grid     loaded, depth');
  }));

test('a file for each level, the same from both', () =>
  withFolder((folder) => {
    write(join(folder, 'a.obj'), torus());
    const levels = ['--target-triangles', '400,300', '--tolerance', '0.3'];
    const reports = programs.map(([name, run]) => {
      const args = ['a.obj', '-o', `${name}.ply`, ...levels, '--json'];
      return JSON.parse(run(args, { cwd: folder }).stdout);
    });
    const made = reports.map(({ levels }) => levels.map(({ triangles }) => triangles));
    expect(made[1]).toEqual(made[0]);
    const errors = reports.map(({ levels }) => levels.map(({ error }) => error));
    expect(errors[1]).toEqual(errors[0]);
    for (const { toInput, toOutput } of errors[0]) {
      expect(toInput.largest).toBeGreaterThan(toInput.rms);
      expect(toOutput.largest).toBeGreaterThan(toOutput.rms);
      expect(toOutput.largest).toBeLessThan(0.36);
    }
    expect(reports[1].levels.map(({ file }) => file)).toEqual(['Node.1.ply', 'Node.2.ply']);
    for (const level of [1, 2]) {
      const [native, node] = ['native', 'Node'].map((name) =>
        readFileSync(join(folder, `${name}.${level}.ply`)),
      );
      expect(node.equals(native)).toBe(true);
      expect(kdm.parseMesh(node, 'ply').indices.length / 3).toBe(made[0][level - 1]);
    }
    expect(existsSync(join(folder, 'Node.ply'))).toBe(false);
    const texts = both(['a.obj', ...levels], { cwd: folder }).map(({ stdout }) => stdout);
    expect(withoutNumbers(texts[1])).toBe(withoutNumbers(texts[0]));
    expect(texts[0]).toContain(`level    ${made[0][0]} triangles, result to input at most `);
  }));

test('a grid that was built for it is reduced when it is loaded, by both alike', () =>
  withFolder((folder) => {
    write(join(folder, 'a.obj'), torus());
    const [[, native]] = programs;
    native(['a.obj', '--save-grid', 'a.kdgrid', '--tolerance', '0.1'], { cwd: folder });
    const [first, second] = programs.map(([name, run]) => {
      const args = ['a.kdgrid', '-o', `${name}.ply`, '--json'];
      const { reduce, grid } = JSON.parse(run(args, { cwd: folder }).stdout);
      expect(reduce.triangles).toBeLessThan(reduce.trianglesBefore);
      expect(grid.askedTolerance).toBe(0.1);
      expect(grid.tolerance).toBeCloseTo(0.1, 7);
      return readFileSync(join(folder, `${name}.ply`));
    });
    expect(second.equals(first)).toBe(true);
  }));

test('--simplify makes the saved grid smaller, in both alike, also of a grid that is loaded', () =>
  withFolder((folder) => {
    write(join(folder, 'a.obj'), torus());
    const run = (input, ...args) =>
      programs.map(([name, program]) => {
        const files = ['-o', 'a.ply', '--save-grid', `${name}.kdgrid`, '--force', '--json'];
        const result = program([input, ...files, ...args], { cwd: folder });
        expect(result).toMatchObject({ status: 0, stderr: '' });
        const { simplify, grid, seconds, warnings } = JSON.parse(result.stdout);
        const bytes = readFileSync(join(folder, `${name}.kdgrid`));
        return { simplify, cells: grid.cells, steps: Object.keys(seconds), warnings, bytes };
      });
    const tolerance = ['--tolerance', '0.02', '--no-reduce'];
    const [whole] = run('a.obj', ...tolerance);
    expect(whole.simplify).toBeUndefined();
    writeFileSync(join(folder, 'whole.kdgrid'), whole.bytes);
    const direct = run('a.obj', ...tolerance, '--simplify', '0.1');
    const loaded = run('whole.kdgrid', '--simplify', '0.1');
    const [first] = direct;
    expect(direct[1]).toEqual(first);
    expect(loaded[1]).toEqual(loaded[0]);
    expect(loaded[0].bytes.equals(first.bytes)).toBe(true);
    expect(first.simplify).toEqual(loaded[0].simplify);
    expect(first.simplify.cellsBefore).toBe(whole.cells);
    expect(first.simplify.cells).toBe(first.cells);
    expect(first.steps).toEqual(['read', 'build', 'simplify', 'extract', 'write']);
    expect(first.warnings).toEqual([]);
    expect(2 * first.bytes.length).toBeLessThan(whole.bytes.length);
    const texts = both(['a.obj', ...tolerance, '--simplify', '0.1'], { cwd: folder });
    expect(withoutNumbers(texts[1].stdout)).toBe(withoutNumbers(texts[0].stdout));
    expect(texts[0].stdout).toContain(
      `simpler  grid from ${whole.cells} cells to ${first.cells}\n`,
    );
  }));

test('--remove-material and --add-material take thin parts and cavities, in both alike', () =>
  withFolder((folder) => {
    const { positions, indices } = cube(0.4);
    const cavity = { positions, indices: indices.slice().reverse() };
    write(join(folder, 'a.obj'), together(cube(2), cube(0.2, [1.5, 0, 0]), cavity));
    const args = ['a.obj', '-o', 'b.ply', '--force', '--tolerance', '0.01', '--simplify', '0.001'];
    const limits = ['--remove-material', '0.25', '--add-material', '0.5'];
    const counts = both([...args, ...limits, '--json'], { cwd: folder }).map((result) => {
      expect(result).toMatchObject({ status: 0, stderr: '' });
      return JSON.parse(result.stdout).simplify;
    });
    expect(counts[1]).toEqual(counts[0]);
    expect(counts[0]).toMatchObject({
      removedParts: 1,
      filledCavities: 1,
      removedSurfaces: 2,
      removedHandles: 0,
    });
    const texts = both([...args, ...limits], { cwd: folder });
    expect(withoutNumbers(texts[1].stdout)).toBe(withoutNumbers(texts[0].stdout));
    expect(texts[0].stdout).toContain('         1 thin parts removed, 1 thin cavities filled\n');
  }));

test('--stats describes what cannot be built from, in both alike', () =>
  withFolder((folder) => {
    const { positions, indices } = together(cube(4), cube(2), torus());
    write(join(folder, 'open.ply'), { positions, indices: indices.slice(3) });
    const [native, node] = both(['open.ply', '--stats', '--json'], { cwd: folder }).map(
      ({ status, stdout, stderr }) => {
        expect({ status, stderr }).toEqual({ status: 0, stderr: '' });
        return JSON.parse(stdout);
      },
    );
    expect(JSON.stringify(keysOf(node))).toBe(JSON.stringify(keysOf(native)));
    expect(Object.keys(node)).toEqual(['input', 'defects', 'warnings', 'seconds', 'peakBytes']);
    expect(node.input).toEqual(native.input);
    expect(node.defects).toEqual(native.defects);
    expect(node.defects).toMatchObject({
      boundaryEdges: 3,
      boundaryLoops: 1,
      openParts: 1,
      genus: 1,
    });
    const texts = both(['open.ply', '--stats'], { cwd: folder }).map(({ stdout }) =>
      withoutNumbers(stdout),
    );
    expect(texts[1]).toBe(texts[0]);
    expect(texts[0]).toContain('defects  3 open edges, 1 boundary loops, ');
    expect(readdirSync(folder)).toEqual(['open.ply']);
  }));

test('--stats with an output does both', () =>
  withFolder((folder) => {
    write(join(folder, 'a.obj'), cube());
    const args = ['a.obj', '--stats', '--check', '-o', 'b.obj', '--force'];
    const [native, node] = both([...args, '--json'], { cwd: folder }).map(({ status, stdout }) => {
      expect(status).toBe(0);
      return JSON.parse(stdout);
    });
    expect(JSON.stringify(keysOf(node))).toBe(JSON.stringify(keysOf(native)));
    expect(Object.keys(node.seconds)).toEqual([
      'read',
      'analyze',
      'build',
      'extract',
      'reduce',
      'write',
    ]);
    expect(node.defects).toEqual(native.defects);
    expect(node.defects).toMatchObject({ boundaryEdges: 0, selfIntersections: 0, volume: 8 });
    const texts = both(args, { cwd: folder }).map(({ stdout }) => withoutNumbers(stdout));
    expect(texts[1]).toBe(texts[0]);
    expect(texts[0]).toContain('defects  none\n');
  }));

test('--help lists the same options in both, and they are those of the interface', () => {
  const names = both(['--help']).map(({ status, stdout }) => {
    expect(status).toBe(0);
    return [...new Set(stdout.match(/(?<=[\s,])--[a-z-]+/g))].sort();
  });
  expect(names[1]).toEqual(names[0]);
  const own = [
    ...Object.values({ ...fileOptions, ...reportOptions, ...solidOptions }).map(({ flag }) => flag),
    '--help',
    '--no-strict',
    '--version',
  ];
  const table = { ...buildOptions, ...extractOptions, ...reductionOptions };
  const fromTable = Object.values(table).map(({ flag }) => flag);
  expect(names[1].filter((name) => !own.includes(name))).toEqual(fromTable.sort());
  for (const spec of Object.values(buildOptions)) {
    if (spec.kind !== 'choice') continue;
    for (const { stdout } of both(['--help'])) expect(stdout).toContain(spec.words.join('|'));
  }
});

test('--version', () => {
  for (const { status, stdout } of both(['--version'])) {
    expect(status).toBe(0);
    expect(stdout).toBe(`kdmanifold ${kdm.version}\n`);
  }
});

test('the command line of the checkout can be called by its name', () => {
  expect(existsSync(nodeCli)).toBe(true);
  const { status, stdout } = execute(nodeCli, ['--version']);
  expect({ status, stdout }).toEqual({ status: 0, stdout: `kdmanifold ${kdm.version}\n` });
});
