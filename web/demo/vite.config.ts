// SPDX-License-Identifier: MIT
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

const dist = fileURLToPath(new URL('../../dist', import.meta.url));

export default defineConfig(({ command }) => ({
  root: fileURLToPath(new URL('.', import.meta.url)),
  base: './',
  // The page uses the package as it is published.
  resolve: { alias: { 'kdmanifold/three': `${dist}/three.js`, kdmanifold: `${dist}/index.js` } },
  worker: { format: 'es' },
  build: {
    outDir: fileURLToPath(new URL('../../build/demo', import.meta.url)),
    emptyOutDir: true,
    chunkSizeWarningLimit: 1000,
  },
  server: { fs: { allow: [dist, fileURLToPath(new URL('../..', import.meta.url))] } },
  plugins: [
    {
      // Vite's development server works with inline styles and a web socket.
      name: 'policy-for-the-built-page-only',
      transformIndexHtml: (html: string) =>
        command === 'serve' && !process.env.KDM_PREVIEW
          ? html.replace(/<meta\s+http-equiv="Content-Security-Policy"[^>]*>/, '')
          : html,
    },
  ],
}));
