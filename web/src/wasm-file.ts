// SPDX-License-Identifier: MIT
// Fetches and compiles a WebAssembly file, and says what to do where that fails.
import { isNode, nodeModule, resolveAddress } from './environment.js';
import { KdManifoldError } from './errors.js';
import type { LoadOptions } from './load-options.js';
import { movedAddress, nodeAddress } from './package-address.js';

/** @internal The names of the files. */
export type WasmFile = 'kdmanifold.wasm' | 'kdmanifold-threads.wasm' | 'kdmanifold-tools.wasm';

/** @internal Compiles a file; rejects with `LOAD_FAILED`. */
export async function compileFile(
  file: WasmFile,
  options: LoadOptions,
): Promise<WebAssembly.Module> {
  const tools = file === 'kdmanifold-tools.wasm';
  const binary = tools ? options.toolsWasmBinary : options.wasmBinary;
  try {
    if (binary === undefined) {
      return await compileFrom(await addressOf(file, options));
    }
    if (Object.prototype.toString.call(binary) === '[object WebAssembly.Module]') return binary;
    return await compileBytes(binary as BufferSource);
  } catch (error) {
    const message =
      error instanceof Failure ? error.message : `it cannot be had (${messageOf(error)})`;
    const option = tools ? 'toolsWasmUrl' : 'wasmUrl';
    const advice =
      error instanceof Failure && error.elsewhere
        ? `; copy node_modules/kdmanifold/dist/${file} to where the page looks for it, or tell its ` +
          `address by the option ${option}`
        : '';
    throw new KdManifoldError('LOAD_FAILED', `${file}: ${message}${advice}`, { cause: error });
  }
}

/** Why it failed, for people; `elsewhere`: the file is not where it was looked for. */
class Failure extends Error {
  readonly elsewhere: boolean;

  constructor(
    message: string,
    { cause, elsewhere = false }: { cause?: unknown; elsewhere?: boolean },
  ) {
    super(message, { cause });
    this.elsewhere = elsewhere;
  }
}

async function compileFrom(url: URL): Promise<WebAssembly.Module> {
  if (isNode() && url.protocol === 'file:') {
    const { readFile } = await nodeModule<typeof import('node:fs/promises')>('fs/promises');
    return compileBytes(await readFile(url));
  }
  let response: Response;
  try {
    response = await fetch(url, { credentials: 'same-origin' });
  } catch (cause) {
    throw new Failure(
      `${url.href} cannot be fetched (${messageOf(cause)}): a content-security policy must allow it in ` +
        `connect-src, and a server of another origin must allow this one (CORS)`,
      { cause },
    );
  }
  const elsewhere = true;
  if (!response.ok) throw new Failure(`${url.href} answered ${response.status}`, { elsewhere });
  const type = response.headers.get('content-type') ?? '';
  if (/^text\/html\b/i.test(type)) {
    throw new Failure(`${url.href} answered a page (${type}) in place of the file`, { elsewhere });
  }
  // Streaming compiles while loading, but demands the right type from the server.
  if (/^application\/wasm\s*$/i.test(type)) {
    return explained(() => WebAssembly.compileStreaming(response));
  }
  const bytes = await response.arrayBuffer();
  const magic = new Uint8Array(bytes, 0, Math.min(4, bytes.byteLength));
  if (String.fromCharCode(...magic) !== '\0asm') {
    throw new Failure(`what ${url.href} answered is no WebAssembly`, { elsewhere });
  }
  return compileBytes(bytes);
}

/** @internal Returns the address of a file: what the caller says, else where the package has it. */
export async function addressOf(
  file: WasmFile | 'kdmanifold-threads.js',
  { wasmUrl, toolsWasmUrl }: LoadOptions,
): Promise<URL> {
  const given = file === 'kdmanifold-tools.wasm' ? toolsWasmUrl : wasmUrl;
  if (given !== undefined) return resolveAddress(given);
  if (isNode()) return nodeAddress(file);
  const moved = movedAddress(file);
  if (moved !== null) return new URL(moved);
  // Bundlers recognise these very forms, put the files among theirs and write their addresses here.
  switch (file) {
    case 'kdmanifold.wasm':
      return new URL('./kdmanifold.wasm', import.meta.url);
    case 'kdmanifold-tools.wasm':
      return new URL('./kdmanifold-tools.wasm', import.meta.url);
    case 'kdmanifold-threads.wasm':
      return new URL('./kdmanifold-threads.wasm', import.meta.url);
    case 'kdmanifold-threads.js':
      return new URL('./kdmanifold-threads.js', import.meta.url);
  }
}

const compileBytes = (bytes: BufferSource): Promise<WebAssembly.Module> =>
  explained(() => WebAssembly.compile(bytes));

async function explained(compile: () => Promise<WebAssembly.Module>): Promise<WebAssembly.Module> {
  try {
    return await compile();
  } catch (cause) {
    const message = messageOf(cause);
    const forbidden = /content security policy|unsafe-eval|disallowed by embedder|blocked by CSP/i;
    throw new Failure(
      forbidden.test(message)
        ? `a content-security policy forbids WebAssembly here: add 'wasm-unsafe-eval' to script-src (${message})`
        : `it cannot be compiled (${message}); is it whole, and of this version of the package?`,
      { cause },
    );
  }
}

const messageOf = (error: unknown): string =>
  error instanceof Error ? error.message : String(error);
