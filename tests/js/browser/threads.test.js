// SPDX-License-Identifier: MIT
// Several threads in a browser: where the page is cross-origin isolated, and nowhere else.
import { launch, openPage } from '../support/browser.js';
import { root } from '../support/paths.js';
import { serve, strictPolicy } from '../support/server.js';

let browser;
beforeAll(async () => {
  browser = await launch();
});
afterAll(() => browser.close());

const isolated = {
  'cross-origin-opener-policy': 'same-origin',
  'cross-origin-embedder-policy': 'require-corp',
  'cross-origin-resource-policy': 'cross-origin',
};
const html =
  '<!doctype html><link rel="icon" href="data:," /><script type="module" src="page.js"></script>';

/**
 * Opens a page that runs `body` with the package's functions. Resolves to {outcome, files, errors, warnings}: `files` are
 * those of the package that were fetched, those of `elsewhere` included, from which the package comes if it is true.
 */
async function open(body, { headers, files = {}, elsewhere = false } = {}) {
  const allowed = { ...headers, 'access-control-allow-origin': '*' };
  const other = elsewhere && (await serve(root, allowed));
  const script = `
    import { load, makeManifold } from '${elsewhere ? other.address : '.'}/dist/index.js';
    import { torus } from './tests/js/support/meshes.js';
    const digest = async ({ positions, indices }) => {
      const bytes = new Uint8Array(await new Blob([positions, indices]).arrayBuffer());
      let sum = 0;
      for (const byte of bytes) sum = (Math.imul(sum, 31) + byte) | 0;
      return [indices.length, sum];
    };
    const run = async () => { ${body} };
    document.title = JSON.stringify(await run().catch(({ code, message }) => [code, message]));`;
  const own = { '/index.html': html, '/page.js': script, ...files };
  const server = await serve(root, headers, own);
  const { page, errors, warnings } = await openPage(browser, `${server.address}/index.html`);
  try {
    await page.waitForFunction(() => document.title !== '', null, { timeout: 60_000 });
    const requested = [...server.requested, ...(other ? other.requested : [])];
    const fetched = requested.filter((path) => path.startsWith('/dist/kdmanifold'));
    const names = [...new Set(fetched.map((path) => path.slice('/dist/'.length)))].sort();
    return { outcome: JSON.parse(await page.title()), files: names, errors, warnings };
  } finally {
    await page.close();
    await server.close();
    if (other) await other.close();
  }
}

const options = { relativeTolerance: 0.001 };
const convert = (settings) => `
  const { mesh, report } = await makeManifold(torus(128, 64), ${JSON.stringify({ ...options, ...settings })});
  return [report.threads, report.thread, await digest(mesh)];`;
const withThreads = ['kdmanifold-threads.js', 'kdmanifold-threads.wasm', 'kdmanifold-worker.js'];
const withOne = ['kdmanifold-worker.js', 'kdmanifold.wasm'];

test('an isolated page has threads, another has not, and bytes are the same', async () => {
  const several = await open(convert({ threads: 3 }), { headers: isolated });
  const one = await open(convert({ threads: 3 }));
  const [, , bytes] = one.outcome;
  expect(bytes[0]).toBeGreaterThan(3000);
  const quiet = { errors: [], warnings: [] };
  expect(several).toEqual({ outcome: [3, 'worker', bytes], files: withThreads, ...quiet });
  expect(one).toEqual({ outcome: [1, 'worker', bytes], files: withOne, ...quiet });
});

test('by itself it has as many as the machine runs at once', async () => {
  const { outcome } = await open(
    `${convert().replace('return [', 'return [navigator.hardwareConcurrency, ')}`,
    { headers: isolated },
  );
  expect(outcome[1]).toBe(Math.min(16, outcome[0]));
});

test('a strict policy allows threads', async () => {
  const headers = { ...isolated, 'content-security-policy': `${strictPolicy}; img-src data:` };
  const { outcome, errors } = await open(convert({ threads: 2 }), { headers });
  expect([outcome.slice(0, 2), errors]).toEqual([[2, 'worker'], []]);
});

test('from another origin threads are started by way of a Blob', async () => {
  const { outcome, files } = await open(convert({ threads: 2 }), {
    headers: isolated,
    elsewhere: true,
  });
  expect([outcome.slice(0, 2), files]).toEqual([[2, 'worker'], withThreads]);
});

test.each(['kdmanifold-threads.wasm', 'kdmanifold-threads.js'])(
  'where %s is not, one thread does the work',
  async (name) => {
    const { outcome, warnings } = await open(convert({ threads: 2 }), {
      headers: isolated,
      files: { [`/dist/${name}`]: null },
    });
    expect([outcome.slice(0, 2), warnings]).toEqual([[1, 'worker'], []]);
  },
);

test("load on a page's own thread has one", async () => {
  const { outcome } = await open('return (await load({ threads: 2 })).threads;', {
    headers: isolated,
  });
  expect(outcome).toBe(1);
});
