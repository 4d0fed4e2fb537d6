// SPDX-License-Identifier: MIT
// Fetches and compiles a WebAssembly file, and says what to do where that fails.
import { baseAddress, isNode, nodeModule } from './environment.js';
import { KdManifoldError } from './errors.js';
import type { LoadOptions } from './load-options.js';
import { movedAddress, nodeAddress } from './package-address.js';

const file = 'kdmanifold.wasm';

/** @internal Compiles the file; rejects with `LOAD_FAILED`. */
export async function compileFile(options: LoadOptions): Promise<WebAssembly.Module> {
  try {
    return await compileFrom(options);
  } catch (error) {
    if (error instanceof KdManifoldError) throw error;
    throw loadFailed(String(error instanceof Error ? error.message : error), error);
  }
}

async function compileFrom({ wasmBinary, wasmUrl }: LoadOptions): Promise<WebAssembly.Module> {
  if (wasmBinary !== undefined) {
    if (Object.prototype.toString.call(wasmBinary) === '[object WebAssembly.Module]') {
      return wasmBinary;
    }
    return compileBytes(wasmBinary as BufferSource);
  }
  const url = await addressOf(wasmUrl);
  if (isNode() && url.protocol === 'file:') {
    const { readFile } = await nodeModule<typeof import('node:fs/promises')>('fs/promises');
    return compileBytes(await readFile(url));
  }
  let response: Response;
  try {
    response = await fetch(url, { credentials: 'same-origin' });
  } catch (error) {
    throw loadFailed(
      `${url.href} cannot be fetched (${messageOf(error)}): a content-security policy must allow it in ` +
        `connect-src, and a server of another origin must allow this one (CORS)`,
      error,
    );
  }
  if (!response.ok) throw loadFailed(`${url.href} answered ${response.status}; ${whereToCopy}`);
  const type = response.headers.get('content-type') ?? '';
  if (/^text\/html\b/i.test(type)) {
    throw loadFailed(`${url.href} answered a page (${type}) in place of the file; ${whereToCopy}`);
  }
  // Streaming compiles while loading, but demands the right type from the server.
  if (/^application\/wasm\s*$/i.test(type)) {
    return explained(() => WebAssembly.compileStreaming(response));
  }
  const bytes = await response.arrayBuffer();
  const magic = new Uint8Array(bytes, 0, Math.min(4, bytes.byteLength));
  if (String.fromCharCode(...magic) !== '\0asm') {
    throw loadFailed(`what ${url.href} answered is no WebAssembly; ${whereToCopy}`);
  }
  return compileBytes(bytes);
}

const whereToCopy =
  `copy node_modules/kdmanifold/dist/${file} to where the page looks for it, ` +
  `or tell its address by the option wasmUrl`;

async function addressOf(given: LoadOptions['wasmUrl']): Promise<URL> {
  if (given !== undefined) {
    const address = typeof given === 'string' ? given : given.href;
    return new URL(address, await baseAddress());
  }
  if (isNode()) return nodeAddress(file);
  const moved = movedAddress(file);
  if (moved !== null) return new URL(moved);
  // Bundlers recognise this very form, put the file among theirs and write its address here.
  return new URL('./kdmanifold.wasm', import.meta.url);
}

const compileBytes = (bytes: BufferSource): Promise<WebAssembly.Module> =>
  explained(() => WebAssembly.compile(bytes));

async function explained(compile: () => Promise<WebAssembly.Module>): Promise<WebAssembly.Module> {
  try {
    return await compile();
  } catch (error) {
    const message = messageOf(error);
    const forbidden = /content security policy|unsafe-eval|disallowed by embedder|blocked by CSP/i;
    throw loadFailed(
      forbidden.test(message)
        ? `a content-security policy forbids WebAssembly here: add 'wasm-unsafe-eval' to script-src (${message})`
        : `it cannot be compiled (${message}); is it whole, and of this version of the package?`,
      error,
    );
  }
}

const messageOf = (error: unknown): string =>
  error instanceof Error ? error.message : String(error);

function loadFailed(message: string, cause?: unknown): KdManifoldError {
  return new KdManifoldError('LOAD_FAILED', `${file}: ${message}`, { cause });
}
