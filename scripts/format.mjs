// SPDX-License-Identifier: MIT
// `npm run format`: brings all sources into their form.
import { files, setup, tool, run } from './run.mjs';

setup('test');
run('clang-format', ['-i', ...files('*.cpp', '*.h')]);
tool('prettier', ['--write', '.', '--log-level', 'warn']);
