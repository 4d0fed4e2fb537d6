// SPDX-License-Identifier: MIT
// What the other scripts share: running commands, setting up, finding the project's files. Only
// Node's own modules are used, so all of it works before `npm ci`.
import { spawnSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';

/** The project's folder, without a slash at the end. */
export const root = fileURLToPath(new URL('..', import.meta.url)).replace(/\/$/, '');

/** Compilers at a time; more than the machine has only costs memory. */
export const jobs = process.env.KDM_JOBS ?? '2';

/** Runs a command in the project's folder and shows its output; ends the script if it fails. */
export function run(command, args, options = {}) {
  const { status, error } = tryRun(command, args, options);
  if (error || status !== 0) {
    console.error(`\n${[command, ...args].join(' ')}: ${error?.message ?? `status ${status}`}`);
    process.exit(status || 1);
  }
}

/** The same, and hands the outcome back. */
export function tryRun(command, args, { env, ...options } = {}) {
  return spawnSync(command, args, {
    cwd: root,
    stdio: 'inherit',
    env: { ...process.env, ...env },
    ...options,
  });
}

/** What a command prints. */
export function output(command, args, options = {}) {
  const result = spawnSync(command, args, {
    cwd: root,
    encoding: 'utf8',
    maxBuffer: 1 << 28,
    ...options,
  });
  if (result.error) throw result.error;
  if (result.status !== 0) throw new Error(`${command} ${args.join(' ')}: ${result.stderr}`);
  return result.stdout;
}

/** Installs what the groups (see there) need and this machine lacks. */
export function setup(...groups) {
  run('sh', ['scripts/setup.sh', ...groups]);
}

/** Runs a tool of node_modules. */
export function tool(name, args, options) {
  run(`${root}/node_modules/.bin/${name}`, args, options);
}

/** The project's own files whose names match, committed or not, but none that git ignores. */
export function files(...patterns) {
  return output('git', ['ls-files', '-co', '--exclude-standard', '--deduplicate', ...patterns])
    .split('\n')
    .filter(Boolean);
}
