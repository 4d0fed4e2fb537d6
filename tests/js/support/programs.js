// SPDX-License-Identifier: MIT
// The two command lines, native and in Node, run side by side.
import { spawnSync } from 'node:child_process';
import { readdirSync, writeFileSync } from 'node:fs';
import { execute, nativeCli, nodeCli } from './paths.js';

const commands = { native: [nativeCli], Node: [process.execPath, nodeCli] };

/** Names, and functions that run a program with arguments and tell how it ended. */
export const programs = Object.entries(commands).map(([name, [command, ...before]]) => [
  name,
  (args, options) => execute(command, [...before, ...args], options),
]);

/** Runs both. */
export const both = (args, options) => programs.map(([, run]) => run(args, options));

/** Runs both with bytes in and out; `input` is standard input. */
export const bothWithBytes = (args, options) =>
  Object.values(commands).map(([command, ...before]) => {
    const { status, stdout, stderr } = spawnSync(command, [...before, ...args], options);
    return { status, stdout, stderr: stderr.toString() };
  });

/** Commands for a shell, quoted. */
export const shellCommands = Object.entries(commands).map(([name, words]) => [
  name,
  words.map((word) => `'${word}'`).join(' '),
]);

/** Writes a mesh into a file by its extension. */
export const writeMesh = (kdm, path, mesh) =>
  writeFileSync(path, kdm.formatMesh(mesh, path.slice(path.lastIndexOf('.') + 1)));

/** Times and sizes differ from run to run, and from program to program. */
export const withoutNumbers = (text) => text.replace(/\d+\.\d+/g, '#');

/** The names in a folder, in order. */
export const namesIn = (folder) => readdirSync(folder).sort();
