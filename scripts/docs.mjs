// SPDX-License-Identifier: MIT
// `npm run docs`: the reference pages of both interfaces, in docs/api. Warnings are errors.
import { mkdirSync } from 'node:fs';
import { root, run, setup, tool } from './run.mjs';

setup('test');
mkdirSync(`${root}/docs/api`, { recursive: true });
tool('typedoc', []);
run('doxygen', ['Doxyfile']);
