// SPDX-License-Identifier: MIT
// Files that exist, folders that do not, and files that are whole or absent.
import { spawn } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { setImmediate } from 'node:timers/promises';
import { load } from '../../../dist/index.js';
import { cube, torus } from '../support/meshes.js';
import { namesIn, programs, shellCommands, writeMesh } from '../support/programs.js';
import { execute, nodeCli, withFolder } from '../support/paths.js';

let kdm;
beforeAll(async () => {
  kdm = await load();
});

test('what exists is overwritten with --force only', () =>
  withFolder((folder) => {
    writeMesh(kdm, join(folder, 'a.obj'), cube());
    mkdirSync(join(folder, 'out'));
    const options = { cwd: folder };
    const precious = ['old.obj', 'old.kdgrid', 'out/a.obj'];
    for (const [, run] of programs) {
      for (const name of precious) writeFileSync(join(folder, name), 'precious');
      for (const [name, ...args] of [
        ['old.obj', '-o', 'old.obj'],
        ['old.kdgrid', '--save-grid', 'old.kdgrid'],
        ['out/a.obj', '--out-dir', 'out'],
      ]) {
        expect(run(['a.obj', ...args], options)).toEqual({
          status: 2,
          stdout: '',
          stderr: `kdmanifold: ${name}: it exists already; --force overwrites it\n`,
        });
        expect(readFileSync(join(folder, name), 'utf8')).toBe('precious');
        expect(run(['a.obj', ...args, '--force'], options)).toMatchObject({ status: 0 });
        expect(readFileSync(join(folder, name), 'latin1')).not.toBe('precious');
      }
      expect(run(['a.obj', '-o', 'a.obj', '--force'], options).status).toBe(0);
    }
    expect(namesIn(folder)).toEqual(['a.obj', 'old.kdgrid', 'old.obj', 'out']);
  }));

test('of several results, those that exist are refused and the others written', () =>
  withFolder((folder) => {
    for (const name of ['a.obj', 'b.obj']) writeMesh(kdm, join(folder, name), cube());
    for (const [name, run] of programs) {
      mkdirSync(join(folder, name));
      writeFileSync(join(folder, name, 'a.obj'), 'precious');
      const { status, stderr } = run(['a.obj', 'b.obj', '--out-dir', name], { cwd: folder });
      expect(status).toBe(2);
      expect(stderr).toBe(`kdmanifold: ${name}/a.obj: it exists already; --force overwrites it\n`);
      expect(namesIn(join(folder, name))).toEqual(['a.obj', 'b.obj']);
    }
  }));

test('an existing file is kept when the new one cannot be made', () =>
  withFolder((folder) => {
    writeFileSync(join(folder, 'bad.obj'), 'v 0 0 0\nv 1 zero 0\n');
    writeFileSync(join(folder, 'out.obj'), 'precious');
    for (const [, run] of programs) {
      const { status } = run(['bad.obj', '-o', 'out.obj', '--force'], { cwd: folder });
      expect(status).toBe(2);
      expect(readFileSync(join(folder, 'out.obj'), 'utf8')).toBe('precious');
    }
  }));

test('--out-dir is not made for nothing', () =>
  withFolder((folder) => {
    writeFileSync(join(folder, 'bad.obj'), 'v 0 0\n');
    for (const [, run] of programs) {
      expect(run(['bad.obj', '--out-dir', 'new'], { cwd: folder }).status).toBe(2);
    }
    expect(namesIn(folder)).toEqual(['bad.obj']);
  }));

test.each(shellCommands)('%s: a disk that is full leaves nothing', (_, command) =>
  withFolder((folder) => {
    writeMesh(kdm, join(folder, 'a.ply'), torus());
    // Blocks of 512 bytes; the signal of the limit is ignored, so that writing fails.
    const script = `trap '' XFSZ; ulimit -f 4; ${command} a.ply -o out.obj`;
    const { status, stderr } = execute('sh', ['-c', script], { cwd: folder });
    expect({ status, stderr }).toEqual({
      status: 2,
      stderr: 'kdmanifold: out.obj: cannot be written: the file would be too large\n',
    });
    expect(namesIn(folder)).toEqual(['a.ply']);
  }),
);

// The native one writes at once what it has; tests/cpp/cli/files_test.cpp stops it.
test('in Node a signal leaves a whole file or none', () =>
  withFolder(async (folder) => {
    writeMesh(kdm, join(folder, 'a.ply'), torus());
    const args = [nodeCli, 'a.ply', '-o', 'out.obj', '--force', '--relative-tolerance', '0.0002'];
    const isPart = () => readdirSync(folder).some((name) => name.endsWith('.part'));
    let caught = 0;
    for (let attempt = 0; attempt < 20 && caught < 2; ++attempt) {
      const child = spawn(process.execPath, args, { cwd: folder, stdio: 'ignore' });
      const ended = new Promise((resolve) => child.on('exit', (_, signal) => resolve(signal)));
      while (child.exitCode === null && child.signalCode === null && !isPart()) {
        await setImmediate();
      }
      const written = isPart();
      child.kill('SIGTERM');
      if ((await ended) === 'SIGTERM' && written) ++caught;
      expect(isPart()).toBe(false);
      if (existsSync(join(folder, 'out.obj'))) {
        const mesh = kdm.parseMesh(readFileSync(join(folder, 'out.obj')), 'obj');
        expect(kdm.describe(mesh).twoManifold).toBe(true);
      }
    }
    expect(caught).toBe(2);
  }));
