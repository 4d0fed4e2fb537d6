// SPDX-License-Identifier: MIT
// Files and standard streams, read and written whole, with the words of src/cli/files.cpp.
import {
  accessSync,
  constants,
  mkdirSync,
  readFileSync,
  renameSync,
  rmSync,
  statSync,
  writeFileSync,
} from 'node:fs';
import { open } from 'node:fs/promises';
import { dirname } from 'node:path';
import { inputName, standardStream } from './formats.js';
import { KdManifoldError } from '../errors.js';

const reasons: Record<string, string> = {
  ENOENT: 'there is no such file or folder',
  EACCES: 'it is not permitted',
  EPERM: 'it is not permitted',
  EISDIR: 'it is a folder',
  ENOTDIR: 'a part of its path is no folder',
  ENOSPC: 'no space is left',
  EROFS: 'nothing can be written there',
  EFBIG: 'the file would be too large',
  EPIPE: 'nobody reads it any more',
  ENAMETOOLONG: 'the name is too long',
};

function reason(error: unknown): string {
  const { code = '', errno, message } = error as NodeJS.ErrnoException;
  return reasons[code] ?? (errno === undefined ? message : `error ${-errno} of the system`);
}

function fail(name: string, what: string): never {
  throw new KdManifoldError('IO_ERROR', `${name}: ${what}`);
}

/** Returns the bytes of a file, or those of standard input for `-`. */
export async function readAll(path: string): Promise<Uint8Array> {
  try {
    if (path !== standardStream) return readFileSync(path);
    const blocks: Buffer[] = [];
    for await (const block of process.stdin) blocks.push(block as Buffer);
    return Buffer.concat(blocks);
  } catch (error) {
    return fail(inputName(path), `cannot be read: ${reason(error)}`);
  }
}

// What a path leads to.
function kindOf(path: string): 'nothing' | 'file' | 'folder' | 'other' {
  try {
    const status = statSync(path);
    if (status.isFile()) return 'file';
    return status.isDirectory() ? 'folder' : 'other';
  } catch {
    return 'nothing';
  }
}

/** Says whether there is something. */
export const exists = (path: string): boolean => kindOf(path) !== 'nothing';

/** Throws if the path is a folder, or a file that exists while `force` is not set. */
export function checkTarget(path: string, force: boolean): void {
  if (path === standardStream) return;
  const kind = kindOf(path);
  if (kind === 'folder') fail(path, 'it is a folder; --out-dir puts results into folders');
  if (kind === 'file' && !force) fail(path, 'it exists already; --force overwrites it');
}

/** Throws unless files can be made in the folder; `subject` begins the message. */
export function checkFolder(folder: string, subject: string): void {
  const kind = kindOf(folder);
  if (kind === 'nothing') fail(subject, `there is no folder ${folder}`);
  if (kind !== 'folder') fail(subject, `${folder} is no folder`);
  try {
    accessSync(folder, constants.W_OK | constants.X_OK);
  } catch {
    fail(subject, `nothing can be written into the folder ${folder}`);
  }
}

/** Throws unless the file can be made in its folder. */
export function checkFolderOf(path: string): void {
  if (path === standardStream || kindOf(path) === 'other') return;
  checkFolder(dirname(path), path);
}

/** Makes the folder unless it is there. */
export function makeFolder(folder: string): void {
  if (kindOf(folder) === 'folder') return;
  try {
    mkdirSync(folder);
  } catch (error) {
    fail(folder, `cannot be made: ${reason(error)}`);
  }
}

const signals = ['SIGINT', 'SIGTERM', 'SIGHUP'] as const;

// Writes under another name first. Not synchronously: signals are told between two steps only.
async function writeWhole(path: string, content: Uint8Array): Promise<void> {
  const temporary = `${path}.${process.pid}.part`;
  const stop = (signal: NodeJS.Signals): void => {
    rmSync(temporary, { force: true });
    for (const name of signals) process.off(name, stop);
    process.kill(process.pid, signal);
  };
  for (const name of signals) process.on(name, stop);
  try {
    const file = await open(temporary, 'wx');
    try {
      await file.writeFile(content);
    } finally {
      await file.close();
    }
    renameSync(temporary, path);
  } catch (error) {
    rmSync(temporary, { force: true });
    throw error;
  } finally {
    for (const name of signals) process.off(name, stop);
  }
}

const writeStandardOutput = (content: Uint8Array): Promise<void> =>
  new Promise((resolve, reject) => {
    process.stdout.write(content, (error) => (error ? reject(error) : resolve()));
  });

/**
 * Writes a file, which appears complete or not at all, even if signals come. Devices and pipes are written as they
 * are, `-` is standard output.
 */
export async function writeAll(path: string, content: Uint8Array): Promise<void> {
  const standard = path === standardStream;
  try {
    if (standard) await writeStandardOutput(content);
    else if (kindOf(path) === 'other') writeFileSync(path, content);
    else await writeWhole(path, content);
  } catch (error) {
    fail(standard ? 'standard output' : path, `cannot be written: ${reason(error)}`);
  }
}
