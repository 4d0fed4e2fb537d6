// SPDX-License-Identifier: MIT
// What people see at a terminal, which `script` makes.
import { join } from 'node:path';
import { load } from '../../../dist/index.js';
import { torus } from '../support/meshes.js';
import { shellCommands, writeMesh } from '../support/programs.js';
import { execute, withFolder } from '../support/paths.js';

let kdm;
beforeAll(async () => {
  kdm = await load();
});

// What the terminal gets of standard error; standard output goes to a file.
const atTerminal = (command, folder) => {
  const script = ['-q', '-e', '-c', `${command} > report.txt`, 'typescript'];
  const { status, stdout } = execute('script', script, { cwd: folder });
  return { status, shown: stdout };
};

test.each(shellCommands)(
  '%s: one line is written over and over, and gone at the end',
  (_, program) =>
    withFolder((folder) => {
      writeMesh(kdm, join(folder, 'a.ply'), torus());
      const { status, shown } = atTerminal(`${program} a.ply -o b.obj`, folder);
      expect(status).toBe(0);
      expect(shown).not.toContain('\n');
      const lines = shown.split('\r').map((line) => line.replace('\x1b[K', ''));
      expect(lines[0]).toBe('');
      expect(lines.at(-1)).toBe('');
      const steps = [...new Set(lines.map((line) => line.split(' ')[0]))];
      expect(steps).toEqual([
        '',
        'reading',
        'building',
        'extracting',
        'reducing',
        'writing',
        'checking',
      ]);
      expect(lines).toContain('building 0 %, prepare');
      expect(lines).toContain('extracting 100 %, faces');
    }),
);

test.each(shellCommands)('%s: of several inputs the number comes first', (_, program) =>
  withFolder((folder) => {
    for (const name of ['a.ply', 'b.ply']) writeMesh(kdm, join(folder, name), torus());
    const { shown } = atTerminal(`${program} a.ply b.ply --json`, folder);
    expect(shown).toContain('\r1 of 2: reading\x1b[K');
    expect(shown).toContain('\r2 of 2: building 0 %, prepare\x1b[K');
    expect(shown.endsWith('\r\x1b[K')).toBe(true);
  }),
);

test.each(shellCommands)('%s: errors stand on a line of their own', (_, program) =>
  withFolder((folder) => {
    const { status, shown } = atTerminal(`${program} none.obj`, folder);
    expect(status).toBe(2);
    expect(shown.split('\x1b[K').at(-1)).toBe(
      'kdmanifold: none.obj: cannot be read: there is no such file or folder\r\n',
    );
  }),
);

test.each(shellCommands)('%s: none with --quiet', (_, program) =>
  withFolder((folder) => {
    writeMesh(kdm, join(folder, 'a.ply'), torus());
    expect(atTerminal(`${program} a.ply --quiet`, folder)).toEqual({ status: 0, shown: '' });
  }),
);
