// SPDX-License-Identifier: MIT
// The packed package in fresh folders with those bundlers that most people have; `npm run bundlers` tries all.
import { mkdtempSync, rmSync } from 'node:fs';
import { availableParallelism, tmpdir } from 'node:os';
import { join } from 'node:path';
import { cases } from '../bundlers/cases.mjs';
import { pack, tryCase } from '../bundlers/try.mjs';
import { launch } from './support/browser.js';
import { serve } from './support/server.js';

let folder;
let packed;
beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), 'kdmanifold-packed-'));
  packed = pack(folder);
}, 60_000);
afterAll(() => rmSync(folder, { recursive: true, force: true }));

const good = { thread: 'worker', twoManifold: true, same: true };
// The main module once, for makeManifold and load together, and the tools for load.
const both = (pattern) => [expect.stringMatching(pattern), expect.stringMatching(pattern)];
const attempt = (name, headers) =>
  tryCase(cases[name], packed, { launch, serve: (files) => serve(files, headers) });

test.each(['vite 8', 'webpack', 'esbuild'])(
  '%s: no warning, a worker does it, and the WebAssembly file is the one that was built',
  async (name) => {
    const result = await attempt(name);
    expect(result).toMatchObject({ problems: [], warnings: [], outcomes: [good], workers: [1] });
    expect(result.wasm).toEqual(both(/^\/(assets\/)?[\w.-]*\.wasm$/));
  },
  400_000,
);

test.each(['vite 8', 'webpack', 'esbuild'])(
  '%s: a page that is isolated has threads',
  async (name) => {
    const result = await attempt(name, {
      'cross-origin-opener-policy': 'same-origin',
      'cross-origin-embedder-policy': 'require-corp',
    });
    const threads = Math.min(16, availableParallelism());
    expect(result).toMatchObject({
      problems: [],
      warnings: [],
      outcomes: [{ ...good, threads }],
    });
  },
  400_000,
);

test("vite 8's development server: the same, but that the files stay where they are", async () => {
  const result = await attempt('vite 8 development');
  expect(result).toMatchObject({ problems: [], warnings: [], outcomes: [good], workers: [1] });
  expect(result.wasm).toEqual(both(/^\/node_modules\/kdmanifold\/dist\/kdmanifold.*\.wasm$/));
}, 400_000);

test('next: the same in a client component, and in a server component on the server', async () => {
  const result = await attempt('next');
  expect(result).toMatchObject({ problems: [], warnings: [], outcomes: [good, good] });
  expect(result.workers).toEqual([1, 0]);
  expect(result.wasm).toEqual(both(/^\/_next\/static\/media\/.*\.wasm$/));
}, 400_000);
