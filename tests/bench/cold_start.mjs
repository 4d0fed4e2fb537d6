// SPDX-License-Identifier: MIT
// `npm run bench -- --cold-start [--repeat 5]`: from opening a page to the first result on it, beside manifold-3d
// and meshoptimizer: without a bundler, files zipped, caches empty, on this machine and at 10 Mbit/s. Then, in Node,
// the process's memory after 50 conversions, 20 aborts and close(), and two conversions at once beside one after the other.
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join } from 'node:path';
import { parseArgs } from 'node:util';
import { gzipSync } from 'node:zlib';
import { builders } from '../../scripts/build.mjs';
import { output, root } from '../../scripts/run.mjs';
import { median, printTable } from './shared.mjs';

const { values } = parseArgs({ options: { repeat: { type: 'string', default: '5' } } });
const repeat = Number(values.repeat);
builders.package();
const { launch } = await import('../js/support/browser.js');

const torus = `
function torus(along, around) {
  const positions = new Float32Array(along * around * 3);
  const indices = new Uint32Array(along * around * 6);
  for (let i = 0, p = 0, t = 0; i < along; ++i) {
    for (let j = 0; j < around; ++j) {
      const [u, v] = [(i / along) * 2 * Math.PI, (j / around) * 2 * Math.PI];
      const radius = 3 + Math.cos(v);
      positions.set([radius * Math.cos(u), radius * Math.sin(u), Math.sin(v)], p);
      const [a, b] = [i * around, ((i + 1) % along) * around];
      const [c, d] = [j, (j + 1) % around];
      indices.set([a + c, b + c, b + d, a + c, b + d, a + d], t);
      p += 3;
      t += 6;
    }
  }
  return { positions, indices };
}`;

const engines = {
  kdmanifold: `
    import { makeManifold } from '/dist/index.js';
    const { mesh } = await makeManifold(torus(64, 32));
    const count = mesh.indices.length;`,
  'manifold-3d': `
    import Module from '/node_modules/manifold-3d/manifold.js';
    const module = await Module({ locateFile: () => '/node_modules/manifold-3d/manifold.wasm' });
    module.setup();
    const { positions, indices } = torus(64, 32);
    const input = new module.Mesh({ numProp: 3, vertProperties: positions, triVerts: indices });
    input.merge();
    const count = new module.Manifold(input).getMesh().triVerts.length;`,
  'meshoptimizer remesh': `
    import { MeshoptSimplifier } from '/node_modules/meshoptimizer/meshopt_simplifier.js';
    await MeshoptSimplifier.ready;
    const { positions, indices } = torus(64, 32);
    const count = MeshoptSimplifier.remesh(indices, positions, 3, 64).length;`,
};

const types = { '.html': 'text/html', '.js': 'text/javascript', '.wasm': 'application/wasm' };

/** Serves the project's folder, zipped, and the pages given; counts the bytes that it sends. */
async function serve(pages) {
  const zipped = new Map();
  const sent = { bytes: 0 };
  const server = createServer((request, response) => {
    const path = new URL(request.url, 'http://local').pathname;
    try {
      if (!zipped.has(path))
        zipped.set(path, gzipSync(pages[path] ?? readFileSync(join(root, path))));
      const content = zipped.get(path);
      sent.bytes += content.length;
      const type = types[extname(path) || '.html'] ?? 'text/plain';
      response.writeHead(200, { 'content-type': type, 'content-encoding': 'gzip' }).end(content);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  const close = () => server.close().closeAllConnections();
  return { address: `http://127.0.0.1:${server.address().port}`, sent, close };
}

const pageOf = (body) => `<!doctype html><link rel="icon" href="data:," /><script type="module">
  ${body}
</script>`;
const done = `document.title = 'done'`;

async function open(browser, address, megabits) {
  const context = await browser.newContext();
  const page = await context.newPage();
  page.on('pageerror', (error) => console.error(String(error)));
  if (megabits !== undefined) {
    const session = await context.newCDPSession(page);
    await session.send('Network.enable');
    const throughput = (megabits * 1e6) / 8;
    await session.send('Network.emulateNetworkConditions', {
      offline: false,
      latency: 20,
      downloadThroughput: throughput,
      uploadThroughput: throughput,
    });
  }
  await page.goto(address);
  await page.waitForFunction(`document.title === 'done'`, null, { timeout: 120_000 });
  const result = await page.evaluate('globalThis.result');
  await context.close();
  return result;
}

const milliseconds = (value) => Math.round(value);
const browser = await launch();
try {
  const rows = [];
  for (const [engine, code] of Object.entries(engines)) {
    const imports = code.match(/^\s*import .*$/gm).join('\n');
    const work = code.replace(/^\s*import .*$/gm, '');
    const body = `${imports}\n${torus}\n${work}\n globalThis.result = performance.now(); ${done}; void count;`;
    const server = await serve({ '/': pageOf(body) });
    const times = {};
    for (const [network, megabits] of Object.entries({ local: undefined, '10 Mbit/s': 10 })) {
      const runs = [];
      for (let i = 0; i < repeat; ++i) runs.push(await open(browser, server.address, megabits));
      times[network] = milliseconds(median(runs));
    }
    const bytes = Math.round(server.sent.bytes / (2 * repeat) / 1000);
    rows.push({
      engine,
      'kB fetched': bytes,
      'local ms': times.local,
      '10 Mbit/s ms': times['10 Mbit/s'],
    });
    server.close();
  }
  printTable(rows);
} finally {
  await browser.close();
}

const life = `
  const { close, makeManifold } = await import('${root}/dist/index.js');
  ${torus}
  const input = torus(512, 128);
  const memory = async () => {
    for (let i = 0; i < 5; ++i) {
      gc();
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
    return Math.round(process.memoryUsage.rss() / 2 ** 20);
  };
  const rows = [];
  const note = (what, value) => rows.push({ what, value });
  note('before the first conversion, MB', await memory());
  await makeManifold(input);
  note('after 1 conversion of 131,072 triangles, MB', await memory());
  for (let i = 1; i < 50; ++i) await makeManifold(input);
  note('after 50, MB', await memory());
  for (let i = 0; i < 20; ++i) {
    const controller = new AbortController();
    const one = makeManifold(input, { signal: controller.signal }).catch(() => {});
    setTimeout(() => controller.abort(), 100);
    await one;
  }
  note('after 20 aborts more, MB', await memory());
  await close();
  note('after close(), MB', await memory());
  const time = async (concurrency) => {
    const from = performance.now();
    await Promise.all([0, 1].map(() => makeManifold(input, { concurrency })));
    return performance.now() - from;
  };
  const times = { 1: [], 2: [] };
  await time(2);
  for (let i = 0; i < ${repeat}; ++i) for (const n of [1, 2]) times[n].push(await time(n));
  const median = (list) => Math.round(list.sort((a, b) => a - b)[list.length >> 1]);
  note('two conversions one after the other, ms', median(times[1]));
  note('two at once, concurrency 2, ms', median(times[2]));
  await close();
  console.log(JSON.stringify(rows));`;
console.log('');
const flags = ['--expose-gc', '--input-type=module', '--eval', life];
printTable(JSON.parse(output(process.execPath, flags)));
