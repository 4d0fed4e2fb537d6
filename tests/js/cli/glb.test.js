// SPDX-License-Identifier: MIT
// GLB files, which the native command line reads by itself and the one in Node with glTF Transform:
// the same meshes, the same bytes, the same refusals.
import { Accessor, Document, WebIO } from '@gltf-transform/core';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { load } from '../../../dist/index.js';
import { cube, torus } from '../support/meshes.js';
import { both, programs, writeMesh } from '../support/programs.js';
import { execute, root, withFolder } from '../support/paths.js';

let kdm;
beforeAll(async () => {
  kdm = await load();
});

// Makes a file as others make them: a torus that is moved, turned, scaled and mirrored, and a cube below it.
async function scene({ quantized = false } = {}) {
  const document = new Document();
  const buffer = document.createBuffer();
  const points = (array) =>
    document.createAccessor().setType(Accessor.Type.VEC3).setArray(array).setBuffer(buffer);
  const numbers = (array) => document.createAccessor().setArray(array).setBuffer(buffer);
  const meshOf = ({ positions, indices }) =>
    document.createMesh().addPrimitive(
      document
        .createPrimitive()
        .setAttribute(
          'POSITION',
          quantized
            ? points(Int16Array.from(positions, (x) => 8000 * x)).setNormalized(true)
            : points(Float32Array.from(positions)),
        )
        .setIndices(numbers(Uint16Array.from(indices))),
    );
  const child = document
    .createNode()
    .setMesh(meshOf(cube(2)))
    .setTranslation([0, 9, 0]);
  const node = document
    .createNode()
    .setMesh(meshOf(torus()))
    .setTranslation([1, 2, 3])
    .setRotation([0.18257418583505536, 0.3651483716701107, 0.5477225575051661, 0.7302967433402214])
    .setScale([1.5, -0.7, 1.1])
    .addChild(child);
  document.createScene().addChild(node);
  return Buffer.from(await new WebIO().writeBinary(document));
}

const parts = (bytes) => {
  const length = bytes.readUInt32LE(12);
  return { json: JSON.parse(bytes.subarray(20, 20 + length)), binary: bytes.subarray(28 + length) };
};

function joined({ json, binary }) {
  const text = Buffer.from(JSON.stringify(json));
  const padded = Buffer.concat([text, Buffer.alloc(-text.length & 3, ' ')]);
  const header = Buffer.alloc(20);
  const sizes = Buffer.alloc(8);
  [0x46546c67, 2, 28 + padded.length + binary.length, padded.length, 0x4e4f534a].forEach(
    (word, i) => header.writeUInt32LE(word, 4 * i),
  );
  [binary.length, 0x004e4942].forEach((word, i) => sizes.writeUInt32LE(word, 4 * i));
  return Buffer.concat([header, padded, sizes, binary]);
}

test.each([[{}], [{ quantized: true }]])('scenes are read alike: %j', (options) =>
  withFolder(async (folder) => {
    writeFileSync(join(folder, 'a.glb'), await scene(options));
    const [native, node] = programs.map(([name, run]) => {
      const args = ['a.glb', '-o', `${name}.ply`, '--json'];
      const { status, stdout, stderr } = run(args, { cwd: folder });
      expect({ status, stderr }).toEqual({ status: 0, stderr: '' });
      return { bytes: readFileSync(join(folder, `${name}.ply`)), report: JSON.parse(stdout) };
    });
    expect(node.bytes.equals(native.bytes)).toBe(true);
    expect(node.report.input).toEqual(native.report.input);
    expect(native.report.input).toMatchObject({ triangles: 1036, components: 2, flipped: false });
    const scale = options.quantized ? (8000 / 32767) ** 3 : 1;
    const volume = scale * 1.5 * 0.7 * 1.1 * (2 * Math.PI ** 2 * 3 * 0.95 + 8);
    expect(native.report.output.volume / volume).toBeCloseTo(1, 1);
  }),
);

test('what is written is the same from both, and right', () =>
  withFolder(async (folder) => {
    writeMesh(kdm, join(folder, 'a.ply'), torus());
    for (const set of [
      [],
      ['--normals'],
      ['--quads', '--strategy', 'uniform'],
      ['--normals', '--quads'],
    ]) {
      const [native, node] = programs.map(([name, run]) => {
        const args = ['a.ply', '-o', `${name}.glb`, '--force', '--json', ...set];
        const { stdout } = run(args, { cwd: folder });
        return { bytes: readFileSync(join(folder, `${name}.glb`)), ...JSON.parse(stdout) };
      });
      expect(node.bytes.equals(native.bytes)).toBe(true);
      expect(native.bytes.length).toBe(native.bytes.readUInt32LE(8));
      expect(native.bytes.length % 4).toBe(0);
      const document = await new WebIO().readBinary(native.bytes);
      const [primitive] = document.getRoot().listMeshes()[0].listPrimitives();
      const { triangles, quads, vertices } = native.output;
      expect(primitive.getIndices().getCount()).toBe(3 * (triangles + 2 * quads));
      const positions = primitive.getAttribute('POSITION');
      const { json } = parts(native.bytes);
      expect(json.accessors[0].min).toEqual(positions.getMin([]));
      expect(json.accessors[0].max).toEqual(positions.getMax([]));
      const normals = primitive.getAttribute('NORMAL');
      expect(normals !== null).toBe(set.includes('--normals'));
      if (normals === null) {
        expect(positions.getCount()).toBe(vertices);
        continue;
      }
      expect(normals.getCount()).toBe(positions.getCount());
      for (let i = 0; i < normals.getCount(); ++i) {
        expect(Math.hypot(...normals.getElement(i, []))).toBeCloseTo(1, 5);
      }
    }
  }));

const wrongs = {
  'compressed.glb': (file) => (file.json.extensionsRequired = ['KHR_draco_mesh_compression']),
  'meshopt.glb': (file) => (file.json.extensionsRequired = ['EXT_meshopt_compression']),
  'unknown.glb': (file) => (file.json.extensionsRequired = ['KHR_unheard_of']),
  'external.glb': (file) => (file.json.buffers[0].uri = 'a.bin'),
  'circle.glb': (file) => (file.json.nodes[1].children = [1]),
  'no-mesh.glb': (file) => (file.json.nodes[0].mesh = 7),
  'fraction.glb': (file) => (file.json.nodes[0].mesh = 0.5),
  'list.glb': (file) => (file.json.accessors = {}),
  'null.glb': (file) => (file.json.accessors[0] = null),
  'matrix.glb': (file) => (file.json.nodes[0].matrix = [1, 2]),
  'count.glb': (file) => (file.json.accessors[0].count += 1000),
  'type.glb': (file) => (file.json.accessors[0].componentType = 5130),
  'view.glb': (file) => (file.json.bufferViews[0].byteOffset = 1e9),
  'buffer.glb': (file) => (file.json.bufferViews[0].buffer = 1),
  'sparse.glb': (file) => (file.json.accessors[0].sparse = { count: 1 }),
  'mode.glb': (file) => (file.json.meshes[0].primitives[0].mode = 7),
  'corners.glb': (file) => (file.json.accessors[1].count -= 1),
  'nan.glb': (file) => file.binary.fill(0xff),
  'far.glb': (file) => (file.json.nodes[0].scale = [1e200, 1, 1]),
  'none.glb': (file) => (file.json = { asset: { version: '2.0' } }),
};

test.each(Object.entries(wrongs))('%s: both say the same', (name, change) =>
  withFolder(async (folder) => {
    const file = parts(await scene());
    change(file);
    writeFileSync(join(folder, name), joined(file));
    const [native, node] = both([name, '--stats', '--json', '-o', 'x.obj', '--force'], {
      cwd: folder,
    });
    expect(native.stderr).toMatch(new RegExp(`^kdmanifold: ${name}: .+\n$`));
    expect({ status: node.status, stderr: node.stderr }).toEqual({
      status: native.status,
      stderr: native.stderr,
    });
    expect(native.status).toBe(2);
  }),
);

test('what is left out of a file is a warning', () =>
  withFolder(async (folder) => {
    const file = parts(await scene());
    file.json.meshes[0].primitives[0].mode = 0;
    writeFileSync(join(folder, 'a.glb'), joined(file));
    for (const { status, stdout } of both(['a.glb', '--stats', '--json'], { cwd: folder })) {
      expect(status).toBe(0);
      expect(JSON.parse(stdout).warnings).toEqual([
        {
          code: 'NOT_READ',
          message: '1 primitives without triangles (points or lines) are left out',
        },
      ]);
    }
  }));

test('damaged files: both read the same or refuse with the same words', () =>
  withFolder(async (folder) => {
    const whole = await scene();
    let seed = 1;
    const random = (below) => {
      seed = (seed * 48271) % 2147483647;
      return seed % below;
    };
    const names = Array.from({ length: 150 }, (_, i) => `${i}.glb`);
    for (const name of names) {
      const bytes = Buffer.from(whole);
      // In the JSON, digits for digits: most else is malformed, and says so.
      const at = random(3) ? 20 + random(whole.readUInt32LE(12)) : random(bytes.length);
      const digit = bytes[at] >= 48 && bytes[at] <= 57;
      bytes[at] = digit ? 48 + random(10) : bytes[at] ^ (1 << random(8));
      writeFileSync(join(folder, name), random(10) ? bytes : bytes.subarray(0, at));
    }
    // Only looking is quick, also where coordinates have become large.
    const [native, node] = both([...names, '--stats', '--json'], { cwd: folder });
    expect(node.stderr).toBe(native.stderr);
    const outcome = ({ stdout }) =>
      JSON.parse(stdout).map(({ file, error, input, defects }) => ({
        file,
        error,
        input,
        defects,
      }));
    expect(outcome(node)).toEqual(outcome(native));
    expect(outcome(native).filter(({ error }) => error).length).toBeGreaterThan(20);
    expect(outcome(native).filter(({ error }) => !error).length).toBeGreaterThan(20);
  }));

test('the library is loaded for GLB files only', () => {
  const dist = join(root, 'dist');
  const mention = readdirSync(dist).filter(
    (name) =>
      name.endsWith('.js') && readFileSync(join(dist, name), 'utf8').includes('gltf-transform'),
  );
  expect(mention).toEqual(['cli.js']);
  expect(readFileSync(join(dist, 'cli.js'), 'utf8')).toMatch(
    /await import\(["']@gltf-transform\/core["']\)/,
  );
});

test('without the library there is a clear word', () =>
  withFolder(async (folder) => {
    // A copy of the program that finds no packages.
    execute('cp', ['-r', join(root, 'dist'), folder]);
    writeFileSync(join(folder, 'package.json'), '{ "type": "module" }');
    writeFileSync(join(folder, 'a.glb'), await scene());
    writeMesh(kdm, join(folder, 'a.obj'), cube());
    const run = (...args) => execute(process.execPath, ['dist/cli.js', ...args], { cwd: folder });
    expect(run('a.glb')).toEqual({
      status: 2,
      stdout: '',
      stderr:
        'kdmanifold: a.glb: GLB files are read by the package @gltf-transform/core, which is not installed\n',
    });
    expect(run('a.obj', '-o', 'b.glb', '--quiet').status).toBe(0);
  }));
