// SPDX-License-Identifier: MIT
// Pages that cannot start the worker, or cannot have the WebAssembly file: what they are told.
import { launch, openPage } from '../support/browser.js';
import { root } from '../support/paths.js';
import { serve, strictPolicy } from '../support/server.js';

let browser;
beforeAll(async () => {
  browser = await launch();
});
afterAll(() => browser.close());

const html =
  '<!doctype html><link rel="icon" href="data:," /><script type="module" src="page.js"></script>';

/**
 * Opens a page that runs `body` with the package's functions; `folders` and `files` are what its server has,
 * `elsewhere` whether the package comes from another origin. Resolves to {outcome, warnings, workers}.
 */
async function open(body, { headers, files = {}, elsewhere = false } = {}) {
  const other = elsewhere && (await serve(root, { 'access-control-allow-origin': '*' }));
  const dist = elsewhere ? `${other.address}/dist` : './dist';
  const script = `
    import { load, makeManifold, preload } from '${dist}/index.js';
    const positions = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]);
    const indices = new Uint32Array([0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]);
    const mesh = { positions, indices };
    const run = async () => { ${body} };
    document.title = JSON.stringify(await run().catch(({ code, message }) => [code, message]));`;
  const server = await serve(root, headers, { '/index.html': html, '/page.js': script, ...files });
  const { page, warnings } = await openPage(browser, `${server.address}/index.html`);
  try {
    await page.waitForFunction(() => document.title !== '', null, { timeout: 30_000 });
    return { outcome: JSON.parse(await page.title()), warnings };
  } finally {
    await page.close();
    await server.close();
    if (other) await other.close();
  }
}

const thread = 'return (await makeManifold(mesh)).report.thread;';
const twice = `${thread.replace('return', 'const first =')} ${thread.replace('return', 'return first +')}`;

test('a worker is started without a word', async () => {
  const { outcome, warnings } = await open(thread);
  expect([outcome, warnings]).toEqual(['worker', []]);
});

test('from another origin it is started by way of a Blob', async () => {
  const { outcome, warnings } = await open(thread, { elsewhere: true });
  expect([outcome, warnings]).toEqual(['worker', []]);
});

test('workerUrl of another origin is started by way of a Blob', async () => {
  const other = await serve(root, { 'access-control-allow-origin': '*' });
  const url = `${other.address}/dist/kdmanifold-worker.js`;
  const { outcome } = await open(thread.replace('(mesh)', `(mesh, { workerUrl: '${url}' })`));
  await other.close();
  expect(outcome).toBe('worker');
});

test('workerUrl and wasmUrl are relative to the page', async () => {
  const { outcome } = await open(
    thread.replace(
      '(mesh)',
      `(mesh, { workerUrl: 'dist/kdmanifold-worker.js', wasmUrl: 'dist/kdmanifold.wasm' })`,
    ),
  );
  expect(outcome).toBe('worker');
});

test('a worker of the page, or a function that starts one, is used', async () => {
  const start = `new Worker('dist/kdmanifold-worker.js', { type: 'module' })`;
  const body = `
    const given = await makeManifold(mesh, { worker: ${start} });
    const started = await makeManifold(mesh, { worker: () => ${start} });
    return [given.report.thread, started.report.thread];`;
  expect((await open(body)).outcome).toEqual(['worker', 'worker']);
});

test('a policy without worker-src: one warning that names it, and the calling thread works', async () => {
  const headers = {
    'content-security-policy': strictPolicy.replace("worker-src 'self'", "worker-src 'none'"),
  };
  const { outcome, warnings } = await open(twice, { headers });
  expect(outcome).toBe('mainmain');
  expect(warnings.filter((text) => text.startsWith('kdmanifold:'))).toEqual([
    expect.stringMatching(/no worker could be started \(the content-security policy's worker-src/),
  ]);
});

test('a worker file that is not there: one warning, and the calling thread works', async () => {
  const { outcome, warnings } = await open(twice, {
    files: { '/dist/kdmanifold-worker.js': null },
  });
  expect(outcome).toBe('mainmain');
  expect(warnings.filter((text) => text.startsWith('kdmanifold:'))).toEqual([
    expect.stringMatching(/no worker could be started .*kdmanifold-worker\.js/),
  ]);
});

test.each([
  ['is not there', null, /kdmanifold\.wasm answered 404; copy node_modules.*wasmUrl/],
  ['is a page', '<!doctype html>', /answered a page \(text\/html\).*copy node_modules.*wasmUrl/],
])('a WebAssembly file that %s: LOAD_FAILED says what to do', async (_, content, message) => {
  const { outcome } = await open(thread, { files: { '/dist/kdmanifold.wasm': content } });
  expect(outcome).toEqual(['LOAD_FAILED', expect.stringMatching(message)]);
});

test.each([
  ["'wasm-unsafe-eval'", '', /'wasm-unsafe-eval' to script-src/],
  ["connect-src 'self'", "connect-src 'none'", /connect-src/],
])('a policy without %s: LOAD_FAILED names it', async (without, instead, message) => {
  const headers = { 'content-security-policy': strictPolicy.replace(without, instead) };
  const { outcome } = await open(thread, { headers });
  expect(outcome).toEqual(['LOAD_FAILED', expect.stringMatching(message)]);
});
