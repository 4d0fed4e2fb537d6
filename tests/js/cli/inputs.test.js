// SPDX-License-Identifier: MIT
// Several inputs, patterns, and --out-dir; names of all kinds.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { load } from '../../../dist/index.js';
import { cube, together, torus } from '../support/meshes.js';
import { both, namesIn, programs, withoutNumbers, writeMesh } from '../support/programs.js';
import { withFolder } from '../support/paths.js';

let kdm;
beforeAll(async () => {
  kdm = await load();
});

const write = (folder, ...names) => {
  for (const name of names) writeMesh(kdm, join(folder, name), cube());
};

// The inputs that both programs see, in their order.
const inputsOf = (args, folder) => {
  const [native, node] = both([...args, '--json', '--stats'], { cwd: folder });
  expect(node.stderr).toBe(native.stderr);
  expect(node.status).toBe(native.status);
  const [files, others] = [native, node].map(({ stdout }) =>
    JSON.parse(stdout).map(({ file }) => file),
  );
  expect(others).toEqual(files);
  return files;
};

test('results go into --out-dir, named after the inputs', () =>
  withFolder((folder) => {
    mkdirSync(join(folder, 'in'));
    write(folder, 'in/a.obj', 'in/b.stl', 'c.ply');
    const made = programs.map(([name, run]) => {
      const args = ['in/a.obj', 'in/b.stl', 'c.ply', '--out-dir', name, '--check'];
      const { status, stdout, stderr } = run(args, { cwd: folder });
      expect({ status, stderr }).toEqual({ status: 0, stderr: '' });
      expect(namesIn(join(folder, name))).toEqual(['a.obj', 'b.stl', 'c.ply']);
      return withoutNumbers(stdout).replaceAll(`${name}/`, '');
    });
    expect(made[1]).toBe(made[0]);
    expect(made[0]).toContain('output   b.stl: ');
    for (const name of ['a.obj', 'b.stl', 'c.ply']) {
      const [native, node] = programs.map(([of]) => readFileSync(join(folder, of, name)));
      expect(node.equals(native)).toBe(true);
    }
  }));

test('--format gives the extension; one input will do', () =>
  withFolder((folder) => {
    write(folder, 'a.b.obj', 'b.ply');
    for (const [name, run] of programs) {
      mkdirSync(join(folder, name));
      const args = ['a.b.obj', '--outDir', `${name}/`, '--format', 'stl', '--quiet'];
      expect(run(args, { cwd: folder })).toEqual({ status: 0, stdout: '', stderr: '' });
      expect(namesIn(join(folder, name))).toEqual(['a.b.stl']);
      expect(kdm.parseMesh(readFileSync(join(folder, name, 'a.b.stl')), 'stl').indices.length).toBe(
        36,
      );
    }
  }));

test('a bad input does not stop the others', () =>
  withFolder((folder) => {
    write(folder, 'a.obj', 'c.obj');
    writeFileSync(join(folder, 'b.obj'), 'v 0 0\n');
    for (const [name, run] of programs) {
      const args = ['a.obj', 'b.obj', 'none.obj', 'c.obj', '--out-dir', name, '--json', '--check'];
      const { status, stdout, stderr } = run(args, { cwd: folder });
      expect(status).toBe(2);
      expect(stderr).toMatch(
        /^kdmanifold: b\.obj: line 1: .*\nkdmanifold: none\.obj: cannot .*\n$/,
      );
      const reports = JSON.parse(stdout);
      expect(reports.map(({ file }) => file)).toEqual(['a.obj', 'b.obj', 'none.obj', 'c.obj']);
      expect(reports[1].error).toMatch(/^b\.obj: line 1: /);
      expect(Object.keys(reports[0])).toEqual([
        'file',
        'input',
        'grid',
        'output',
        'reduce',
        'lost',
        'error',
        'warnings',
        'check',
        'seconds',
        'peakBytes',
      ]);
      expect(namesIn(join(folder, name))).toEqual(['a.obj', 'c.obj']);
    }
  }));

test('without --out-dir it is said how results are kept', () =>
  withFolder((folder) => {
    write(folder, 'a.obj', 'b.obj');
    const [native, node] = both(['a.obj', 'b.obj'], { cwd: folder });
    expect(withoutNumbers(node.stdout)).toBe(withoutNumbers(native.stdout));
    expect(native.stdout.split('\n\n').map((part) => part.split(':')[0])).toEqual([
      'input    a.obj',
      'input    b.obj',
      'nothing was written',
    ]);
    expect(native.stdout).toMatch(/\nnothing was written: --out-dir DIR keeps the results\n$/);
    for (const { stdout } of both(['a.obj'], { cwd: folder })) {
      expect(stdout).toMatch(/\nnothing was written: -o FILE keeps the result\n$/);
    }
    for (const { stdout } of both(['a.obj', '--stats'], { cwd: folder })) {
      expect(stdout).not.toContain('nothing was written');
    }
  }));

test('the status is 1 if a check failed, and 2 if an input was bad besides', () =>
  withFolder((folder) => {
    // Without strictness the edge that two cubes share has four faces.
    writeMesh(kdm, join(folder, 'edge.obj'), together(cube(2), cube(2, [2, 2, 0])));
    write(folder, 'a.obj');
    const raw = ['--strategy', 'median', '--depth', '3', '--no-strict', '--check'];
    for (const { status } of both(['edge.obj', 'a.obj', ...raw], { cwd: folder })) {
      expect(status).toBe(1);
    }
    for (const { status } of both(['edge.obj', 'none.obj', ...raw], { cwd: folder })) {
      expect(status).toBe(2);
    }
  }));

test('patterns that no shell has expanded', () =>
  withFolder((folder) => {
    for (const name of ['x', 'x/y', '.hidden']) mkdirSync(join(folder, name));
    write(folder, 'b.obj', 'a.obj', 'c.stl', 'x/d.obj', 'x/y/e.obj', '.hidden/f.obj', '.g.obj');
    write(folder, '[1].obj', 'é.obj', '𝄞.obj', '\uffee.obj');
    const names = ['[1].obj', 'a.obj', 'b.obj', 'é.obj', '\uffee.obj', '𝄞.obj'];
    expect(inputsOf(['*.obj'], folder)).toEqual(names);
    expect(inputsOf(['?.obj'], folder)).toEqual(names.slice(1));
    expect(inputsOf(['[a-b].???', 'b.obj', '*.stl'], folder)).toEqual(['a.obj', 'b.obj', 'c.stl']);
    expect(inputsOf(['[1].obj', '[!a].obj'], folder)).toEqual([
      '[1].obj',
      'b.obj',
      'é.obj',
      '\uffee.obj',
      '𝄞.obj',
    ]);
    expect(inputsOf(['**/[de].obj'], folder)).toEqual(['x/d.obj', 'x/y/e.obj']);
    expect(inputsOf(['x/**/*.obj'], folder)).toEqual(['x/d.obj', 'x/y/e.obj']);
    expect(inputsOf(['*/*.obj', './a.obj'], folder)).toEqual(['x/d.obj', './a.obj']);
    expect(inputsOf(['.*.obj', 'a*'], folder)).toEqual(['.g.obj', 'a.obj']);
    expect(inputsOf([`${folder}/[ab].obj`], folder)).toEqual(
      ['a.obj', 'b.obj'].map((name) => join(folder, name)),
    );
  }));

test('names with spaces, of other scripts, that begin with a dash; absolute paths', () =>
  withFolder((folder) => {
    const names = ['with space.obj', 'größe-木.obj', '-dash.obj', "quo'te.obj"];
    write(folder, ...names);
    for (const [name, run] of programs) {
      const out = join(folder, name);
      const args = ['--outDir', out, '--quiet', '--', ...names];
      expect(run(args, { cwd: folder })).toEqual({ status: 0, stdout: '', stderr: '' });
      expect(namesIn(out)).toEqual([...names].sort());
      const far = ['--output', join(folder, `${name}.ply`), '--', join(folder, '-dash.obj')];
      expect(run(far, { cwd: '/' })).toMatchObject({ status: 0, stderr: '' });
      const dashes = ['-o', `-${name}.obj`, '--', '-dash.obj'];
      expect(run(dashes, { cwd: folder })).toMatchObject({ status: 0, stderr: '' });
      expect(namesIn(folder)).toContain(`-${name}.obj`);
    }
  }));

test('options in camel case are those with dashes', () =>
  withFolder((folder) => {
    writeMesh(kdm, join(folder, 'a.ply'), torus());
    for (const [, run] of programs) {
      const triangles = (...args) => {
        const { stdout } = run(['a.ply', '--json', ...args], { cwd: folder });
        return JSON.parse(stdout).output.triangles;
      };
      const coarse = triangles('--relative-tolerance', '0.02');
      expect(triangles('--relativeTolerance', '0.02')).toBe(coarse);
      expect(triangles('--relativeTolerance=0.02')).toBe(coarse);
      expect(triangles()).toBeGreaterThan(coarse);
    }
  }));

test('warnings about a file come before those about the result, in the same words', () =>
  withFolder((folder) => {
    const message = '1 face has fewer than three corners; skipped; it is at line 19';
    const open = cube();
    open.indices = open.indices.slice(6);
    writeMesh(kdm, join(folder, 'a.obj'), open);
    writeFileSync(join(folder, 'a.stl'), `${readFileSync(join(folder, 'a.obj'), 'utf8')}f 1 2\n`);
    for (const [, run] of programs) {
      const said = (...args) => run(['a.stl', ...args], { cwd: folder });
      const { status, stdout, stderr } = said('--json');
      expect({ status, stderr }).toEqual({ status: 0, stderr: '' });
      const { warnings } = JSON.parse(stdout);
      expect(warnings[0]).toEqual({ code: 'FACES_SKIPPED', message });
      expect(warnings.map(({ code }) => code)).toEqual(['FACES_SKIPPED', 'HOLES_CLOSED']);
      const text = warnings.map((warning) => `warning  ${warning.message}\n`).join('');
      expect(said().stdout.startsWith(`${text}input    a.stl: `)).toBe(true);
      expect(JSON.parse(said('--stats', '--json').stdout).warnings).toEqual(warnings.slice(0, 1));
      expect(said('--quiet')).toEqual({ status: 0, stdout: '', stderr: '' });
    }
  }));
