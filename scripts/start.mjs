// SPDX-License-Identifier: MIT
// `npm start [-- --dev]`: builds what is out of date and serves the demo page. The page is the built
// one, under its strict content-security policy; with --dev it is Vite's development server.
import { builders } from './build.mjs';
import { root } from './run.mjs';

builders.package();

process.chdir(root);
const dev = process.argv.includes('--dev');
const port = Number(process.env.PORT ?? 4173);
const configFile = `${root}/web/demo/vite.config.ts`;
// Here, not at the top: Vite is installed by the set-up of `builders`.
const vite = await import('vite');
if (!dev) await vite.build({ configFile, logLevel: 'warn' });
const server = dev
  ? await (await vite.createServer({ configFile, server: { port } })).listen()
  : await vite.preview({ configFile, preview: { port } });
console.log('\nkdmanifold is served here (Ctrl+C ends it):');
server.printUrls();
