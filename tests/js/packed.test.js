// SPDX-License-Identifier: MIT
// The package as npm delivers it: packed, installed in an empty folder, used in Node and on a plain page
// without any bundler. (types.test.js: in TypeScript; bundlers.test.js: with bundlers.)
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { launch, openPage } from './support/browser.js';
import { execute, root } from './support/paths.js';
import { serve, strictPolicy } from './support/server.js';

let folder;
let packed;

const tetrahedron = `
  const positions = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]);
  const indices = new Uint32Array([0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]);`;

function npm(args, cwd) {
  const result = execute('npm', args, {
    cwd,
    env: { ...process.env, npm_config_loglevel: 'error' },
  });
  expect({ ...result, stdout: '' }).toMatchObject({ status: 0 });
  return result.stdout;
}

beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), 'kdmanifold-packed-'));
  // dist/ is what the other tests ran on; it need not be built again here.
  [packed] = JSON.parse(
    npm(['pack', '--json', '--ignore-scripts', '--pack-destination', folder], root),
  );
  writeFileSync(join(folder, 'package.json'), '{ "private": true, "type": "module" }');
  // What npm would fetch besides.
  const besides = ['@gltf-transform/core', 'property-graph'].map((name) => {
    const args = ['pack', '--json', '--ignore-scripts', '--pack-destination', folder];
    return JSON.parse(npm([...args, join(root, 'node_modules', name)], root))[0].filename;
  });
  const archives = [packed.filename, ...besides].map((name) => join(folder, name));
  npm(['install', '--offline', '--no-audit', '--no-fund', ...archives], folder);
}, 120_000);

afterAll(() => rmSync(folder, { recursive: true, force: true }));

test('holds what users need and nothing else', () => {
  const names = packed.files.map(({ path }) => path);
  for (const name of ['README.md', 'LICENSE', 'CHANGELOG.md', 'dist/kdmanifold.wasm']) {
    expect(names).toContain(name);
  }
  expect(
    names.filter(
      (name) => !/^(dist\/|(three\/|worker\/)?package\.json$|README|LICENSE|CHANGELOG)/.test(name),
    ),
  ).toEqual([]);
});

test('runs in Node', () => {
  writeFileSync(
    join(folder, 'use.js'),
    `import { makeManifold } from 'kdmanifold';
    import { createRequire } from 'node:module';
    ${tetrahedron}
    const { mesh, report } = await makeManifold({ positions, indices });
    console.log(mesh.indices.length > 0, report.output.twoManifold);
    console.log(createRequire(import.meta.url).resolve('kdmanifold/kdmanifold.wasm').endsWith('dist/kdmanifold.wasm'));`,
  );
  const { stdout, stderr } = execute(process.execPath, ['use.js'], { cwd: folder });
  expect({ stdout, stderr }).toEqual({ stdout: 'true true\ntrue\n', stderr: '' });
});

test('its command line runs through npx', () => {
  writeFileSync(
    join(folder, 'a.obj'),
    'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n',
  );
  const { status, stdout } = execute(
    'npx',
    ['--offline', 'kdmanifold', 'a.obj', '-o', 'b.stl', '--json'],
    {
      cwd: folder,
    },
  );
  expect(status).toBe(0);
  expect(JSON.parse(stdout).output.twoManifold).toBe(true);
  for (const args of [
    ['b.stl', '-o', 'c.glb'],
    ['c.glb', '-o', 'd.obj', '--check'],
  ]) {
    const made = execute('npx', ['--offline', 'kdmanifold', ...args], { cwd: folder });
    expect(made).toMatchObject({ status: 0, stderr: '' });
  }
});

test('runs on a plain page under a strict content-security policy, in a worker', async () => {
  writeFileSync(
    join(folder, 'index.html'),
    '<!doctype html><script type="module" src="page.js"></script>',
  );
  writeFileSync(
    join(folder, 'page.js'),
    `import { load, makeManifold } from './node_modules/kdmanifold/dist/index.js';
    ${tetrahedron}
    const started = [];
    const { Worker } = window;
    window.Worker = class extends Worker {
      constructor(...args) { super(...args); started.push(args[0]); }
    };
    const { report } = await makeManifold({ positions, indices });
    const grid = (await load()).buildGrid({ positions, indices });
    const triangles = grid.extract().indices.length / 3;
    grid.delete();
    const error = await makeManifold({ positions, indices: indices.slice(0, 3) }).catch((e) => e.code);
    document.title = JSON.stringify([report.output.twoManifold, triangles > 0, started.length, error]);`,
  );
  const server = await serve(folder, { 'content-security-policy': strictPolicy });
  const browser = await launch();
  try {
    const { page, errors } = await openPage(browser, `${server.address}/index.html`);
    await page.waitForFunction(() => document.title !== '', null, { timeout: 30_000 });
    expect(JSON.parse(await page.title())).toEqual([true, true, 1, 'NOT_CLOSED']);
    expect(errors.filter((text) => !text.includes('favicon') && !text.includes('404'))).toEqual([]);
  } finally {
    await browser.close();
    await server.close();
  }
});
