// SPDX-License-Identifier: MIT
// Boolean operations on both command lines: the same files, the same words.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { load } from '../../../dist/index.js';
import { cube, faults, torus, volume } from '../support/meshes.js';
import { both, programs, withoutNumbers, writeMesh } from '../support/programs.js';
import { withFolder } from '../support/paths.js';

let kdm;
beforeAll(async () => {
  kdm = await load();
});

test('operations are done from left to right, each file where its transform puts it', () =>
  withFolder((folder) => {
    writeMesh(kdm, join(folder, 'a.obj'), cube());
    writeMesh(kdm, join(folder, 'b.stl'), cube());
    const args = ['a.obj', '--union', 'b.stl', '--transform', '1,0,0,1,0,1,0,0,0,0,1,0'];
    args.push('--difference', 'b.stl', '--transform=1,0,0,0,0,1,0,1,0,0,1,0,0,0,0,1', '--check');
    const made = programs.map(([name, run]) => {
      const { status, stdout, stderr } = run([...args, '-o', `${name}.obj`], { cwd: folder });
      expect({ status, stderr }).toEqual({ status: 0, stderr: '' });
      expect(stdout).toContain(', 3 operands');
      return withoutNumbers(stdout).replaceAll(name, '');
    });
    expect(made[1]).toBe(made[0]);
    const [native, node] = programs.map(([name]) => readFileSync(join(folder, `${name}.obj`)));
    expect(node.equals(native)).toBe(true);
    const mesh = kdm.parseMesh(native, 'obj');
    expect(faults(mesh)).toEqual([]);
    expect(volume(mesh)).toBeCloseTo(12 - 4, 2);
  }));

test('the report has one part an operand, in JSON', () =>
  withFolder((folder) => {
    writeMesh(kdm, join(folder, 'a.obj'), torus());
    writeMesh(kdm, join(folder, 'b.obj'), cube());
    const args = ['a.obj', '--symmetric-difference', 'b.obj', '--intersection', 'a.obj', '--json'];
    const [native, node] = both(args, { cwd: folder }).map(({ stdout }) => JSON.parse(stdout));
    expect(native.operands.map(({ triangles }) => triangles)).toEqual([1024, 12, 1024]);
    expect(node.operands).toEqual(native.operands);
    expect(node.output).toEqual(native.output);
    expect(native.output.crossings).toBe(0); // embedded
  }));

test('both merge saved grids to the same bytes', () =>
  withFolder((folder) => {
    writeMesh(kdm, join(folder, 'a.obj'), cube(2, [3, 0, 0.3]));
    writeMesh(kdm, join(folder, 'torus.obj'), torus());
    const box = ['--box=-5,-5,-5,5,5,5', '--tolerance', '0.02'];
    for (const name of ['a', 'torus']) {
      const args = [`${name}.obj`, '--save-grid', `${name}.kdgrid`, '--force', ...box];
      expect(both(args, { cwd: folder }).map(({ status }) => status)).toEqual([0, 0]);
    }
    for (const operation of [
      '--union',
      '--intersection',
      '--difference',
      '--symmetric-difference',
    ]) {
      const saved = ['native.kdgrid', 'node.kdgrid'];
      const [native, node] = saved.map((name, i) => {
        const args = [
          'torus.kdgrid',
          operation,
          'a.kdgrid',
          '--save-grid',
          name,
          '--force',
          '--json',
        ];
        const { status, stdout } = programs[i][1](args, { cwd: folder });
        expect(status).toBe(0);
        return JSON.parse(stdout);
      });
      expect(native.output.twoManifold).toBe(true);
      expect(native.operands).toHaveLength(2);
      expect(node.output).toEqual(native.output);
      const [first, second] = saved.map((name) => readFileSync(join(folder, name)));
      expect(first.equals(second)).toBe(true);
    }
    // Grids over different boxes.
    both(['a.obj', '--save-grid', 'a.kdgrid', '--force'], { cwd: folder });
    const [native, node] = both(['torus.kdgrid', '--union', 'a.kdgrid'], { cwd: folder });
    expect(native.status).toBe(2);
    expect(native.stderr).toMatch(/^kdmanifold: a\.kdgrid: .*different lattices.*--box/);
    expect(node).toEqual(native);
  }));

test('both refuse the same in the same words', () =>
  withFolder((folder) => {
    writeMesh(kdm, join(folder, 'a.obj'), cube());
    for (const args of [
      ['a.obj', '--difference', 'a.obj'],
      ['a.obj', '--union', 'missing.obj'],
      ['a.obj', '--union', '-'],
      ['a.obj', '--union', 'a.kdgrid'],
      ['a.kdgrid', '--union', 'a.obj'],
      ['a.kdgrid', '--union', 'a.kdgrid', '--transform', '1,0,0,0,0,1,0,0,0,0,1,0'],
      ['a.kdgrid', '--union', 'missing.kdgrid'],
      ['a.obj', '--union'],
      ['a.obj', '--union='],
      ['a.obj', '--transform', '1,2,3'],
      ['a.obj', '--transform', '1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,2'],
      ['a.obj', '--union', 'a.obj', '--transform', '1,0,0,x,0,1,0,0,0,0,1,0'],
      ['a.obj', '--union', 'a.obj', '--transform', '1,0,0,0,0,1,0,0,0,0,0,0'],
      ['a.obj', '--transform', '1,0,0,0,0,1,0,0,0,0,1,0', '--transform', '1,0,0,0,0,1,0,0,0,0,1,0'],
      ['a.obj', '--union', 'a.obj', '--inside', 'sheet'],
      ['a.obj', '--union', 'a.obj', '--no-reduce', '--target-triangles', '20'],
    ]) {
      const [native, node] = both(args, { cwd: folder });
      expect(native.status).toBe(2);
      expect(node).toEqual(native);
      expect(native.stderr.trim().split('\n')).toHaveLength(1);
    }
  }));
