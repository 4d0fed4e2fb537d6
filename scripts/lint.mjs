// SPDX-License-Identifier: MIT
// `npm run lint`: format and rules of all sources, types of all TypeScript. Changes nothing.
import { files, setup, tool, run } from './run.mjs';

setup('test');
run('clang-format', ['--dry-run', '-Werror', ...files('*.cpp', '*.h')]);
tool('prettier', ['--check', '.', '--log-level', 'warn']);
tool('eslint', ['.']);
for (const project of ['tsconfig.json', 'web/demo/tsconfig.json']) {
  tool('tsc', ['--noEmit', '-p', project]);
}
