// SPDX-License-Identifier: MIT
// A server for folders of files, with a content-security policy as strict as it gets.
import { createServer } from 'node:http';
import { readFile } from 'node:fs/promises';
import { extname, join, normalize } from 'node:path';

const types = {
  '.css': 'text/css',
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.svg': 'image/svg+xml',
  '.wasm': 'application/wasm',
};

export const strictPolicy =
  "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; connect-src 'self'";

/**
 * Serves `folder`; `headers` go with every answer. `instead` holds contents by path that stand in place of files;
 * null: there is none; a page is told as such. Resolves to {address, requested, close}; `requested` lists the paths so far.
 */
export function serve(folder, headers = {}, instead = {}) {
  const requested = [];
  const server = createServer(async (request, response) => {
    const path = new URL(request.url, 'http://local').pathname;
    requested.push(path);
    const file = join(folder, normalize(path.endsWith('/') ? `${path}index.html` : path));
    try {
      const content = path in instead ? instead[path] : await readFile(file);
      if (content === null) throw new Error('not there');
      const isPage = String(content.slice(0, 9)) === '<!doctype';
      const type = isPage ? 'text/html' : (types[extname(file)] ?? 'text/plain');
      response.writeHead(200, { 'content-type': type, ...headers });
      response.end(content);
    } catch {
      response.writeHead(404).end();
    }
  });
  return new Promise((resolve) => {
    server.listen(0, '127.0.0.1', () => {
      resolve({
        address: `http://127.0.0.1:${server.address().port}`,
        requested,
        close: () => new Promise((done) => server.close(done).closeAllConnections()),
      });
    });
  });
}
