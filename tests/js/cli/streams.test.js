// SPDX-License-Identifier: MIT
// Standard input and output, formats by name, --quiet.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { load } from '../../../dist/index.js';
import { cube, torus } from '../support/meshes.js';
import {
  both,
  bothWithBytes,
  namesIn,
  programs,
  shellCommands,
  withoutNumbers,
  writeMesh,
} from '../support/programs.js';
import { execute, withFolder } from '../support/paths.js';

let kdm;
beforeAll(async () => {
  kdm = await load();
});

test('bytes in and out are those of files, and the report goes to standard error', () =>
  withFolder((folder) => {
    writeMesh(kdm, join(folder, 'a.ply'), torus());
    const input = readFileSync(join(folder, 'a.ply'));
    for (const format of ['obj', 'stl', 'ply', 'off', 'glb']) {
      both(['a.ply', '-o', `out.${format}`, '--force'], { cwd: folder });
      const expected = readFileSync(join(folder, `out.${format}`));
      const args = ['-', '--input-format', 'ply', '-o', '-', '--format', format];
      const [native, node] = bothWithBytes(args, { input });
      expect({ ...native, stdout: 0, stderr: 0 }).toEqual({ status: 0, stdout: 0, stderr: 0 });
      expect(native.stdout.equals(expected)).toBe(true);
      expect(node.stdout.equals(expected)).toBe(true);
      expect(native.stderr).toMatch(
        /^input {4}standard input: .*\n[^]*output {3}standard output: /,
      );
      expect(withoutNumbers(node.stderr)).toBe(withoutNumbers(native.stderr));
      for (const { stderr, stdout } of bothWithBytes([...args, '--quiet'], { input })) {
        expect(stderr).toBe('');
        expect(stdout.equals(expected)).toBe(true);
      }
    }
    const args = ['a.ply', '-o', '-', '--format', 'off', '--json'];
    for (const { stdout, stderr } of both(args, { cwd: folder })) {
      expect(JSON.parse(stderr).output.twoManifold).toBe(true);
      expect(stdout.startsWith('OFF\n')).toBe(true);
    }
  }));

test('formats count, whatever names say', () =>
  withFolder((folder) => {
    writeFileSync(join(folder, 'a.dat'), kdm.formatMesh(cube(), 'off'));
    writeFileSync(join(folder, 'b.stl'), kdm.formatMesh(cube(), 'obj'));
    for (const [name, run] of programs) {
      const args = ['a.dat', '--input-format', 'off', '-o', `${name}.obj`, '--format', 'ply'];
      expect(run(args, { cwd: folder })).toMatchObject({ status: 0, stderr: '' });
      expect(readFileSync(join(folder, `${name}.obj`), 'latin1').startsWith('ply\n')).toBe(true);
      expect(run(['b.stl', '--inputFormat=obj'], { cwd: folder }).status).toBe(0);
    }
  }));

test('bad standard input: one line, nothing on standard output', () => {
  const [native, node] = both(['-', '--input-format', 'obj', '-o', '-', '--format', 'stl'], {
    input: 'v 0 0 zero\n',
  });
  expect(native).toMatchObject({ status: 2, stdout: '' });
  expect(native.stderr).toMatch(/^kdmanifold: standard input: line 1: [^\n]+\n$/);
  expect(node).toEqual(native);
});

test('--quiet prints nothing but errors', () =>
  withFolder((folder) => {
    writeMesh(kdm, join(folder, 'a.obj'), cube());
    for (const [name, run] of programs) {
      const args = ['a.obj', 'none.obj', '--out-dir', name, '--quiet', '--check', '--stats'];
      expect(run(args, { cwd: folder })).toEqual({
        status: 2,
        stdout: '',
        stderr: 'kdmanifold: none.obj: cannot be read: there is no such file or folder\n',
      });
      expect(namesIn(join(folder, name))).toEqual(['a.obj']);
    }
  }));

test.each(shellCommands)('%s: a reader that has gone is an error, not a crash', (_, command) =>
  withFolder((folder) => {
    writeMesh(kdm, join(folder, 'a.ply'), torus());
    // More than a pipe holds, so that writing meets the closed end.
    const args = 'a.ply -o - --format obj --quiet --relative-tolerance 0.0003 --no-reduce';
    const script = `(${command} ${args}; echo "status $?" >&2) | head -c 1 > /dev/null`;
    const { stderr } = execute('sh', ['-c', script], { cwd: folder });
    expect(stderr).toBe(
      'kdmanifold: standard output: cannot be written: nobody reads it any more\nstatus 2\n',
    );
  }),
);

test('devices are written as they are', () =>
  withFolder((folder) => {
    writeMesh(kdm, join(folder, 'a.obj'), cube());
    for (const { status, stderr } of both(['a.obj', '-o', '/dev/null', '--format', 'stl'], {
      cwd: folder,
    })) {
      expect({ status, stderr }).toEqual({ status: 0, stderr: '' });
    }
    expect(execute('sh', ['-c', 'test -c /dev/null']).status).toBe(0);
  }));
