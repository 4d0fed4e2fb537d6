// SPDX-License-Identifier: MIT
// The synchronous interface: what goes in, what comes out, every option.
import { readFileSync } from 'node:fs';
import { formatFromPath, Grid, KdManifold, load, makeManifold } from '../../dist/index.js';
import {
  asSoup,
  cube,
  eulerCharacteristic,
  faults,
  together,
  torus,
  volume,
} from './support/meshes.js';
import { root } from './support/paths.js';

let kdm;
beforeAll(async () => {
  kdm = await load();
});

function convert(mesh, build = {}, extract = {}) {
  const grid = kdm.buildGrid(mesh, build);
  try {
    return grid.extract(extract);
  } finally {
    grid.delete();
  }
}

const same = (a, b) => {
  expect(Buffer.from(a.positions.buffer).equals(Buffer.from(b.positions.buffer))).toBe(true);
  expect(Buffer.from(a.indices.buffer).equals(Buffer.from(b.indices.buffer))).toBe(true);
};

test('loading again gives the same object, of the version in package.json', async () => {
  expect(await load()).toBe(kdm);
  expect(kdm).toBeInstanceOf(KdManifold);
  expect(kdm.version).toBe(JSON.parse(readFileSync(`${root}/package.json`, 'utf8')).version);
});

test('a cube comes back as a cube', () => {
  const mesh = convert(cube());
  expect(faults(mesh)).toEqual([]);
  expect(volume(mesh)).toBeCloseTo(8, 5);
  expect(eulerCharacteristic(mesh)).toBe(2);
  expect(mesh.positions.constructor.name).toBe('Float32Array');
  expect(mesh.indices.constructor.name).toBe('Uint32Array');
  expect(mesh.quads).toBeUndefined();
  expect(mesh.sourceFaces).toHaveLength(mesh.indices.length / 3);
  expect(Math.max(...mesh.sourceFaces)).toBeLessThan(12);
  expect(mesh.report.droppedPillows).toBeGreaterThanOrEqual(0);
  expect(mesh.report.insertedVertices).toBeGreaterThanOrEqual(0);
});

test('positions and indices of every allowed class give the same result', () => {
  const { positions, indices } = torus();
  const expected = convert({ positions, indices });
  same(convert({ positions: Float64Array.from(positions), indices }), expected);
  same(convert({ positions, indices: Uint16Array.from(indices) }), expected);
  same(convert(asSoup({ positions, indices })), expected);
  same(convert({ positions, indices, sourceFaces: null, quads: undefined }), expected);
});

test('arrays that are views into larger buffers are read where they are', () => {
  const { positions, indices } = cube();
  const floats = new Float32Array(100).fill(NaN);
  floats.set(positions, 7);
  const numbers = new Uint16Array(100).fill(65535);
  numbers.set(indices, 3);
  same(
    convert({ positions: floats.subarray(7, 31), indices: numbers.subarray(3, 39) }),
    convert({ positions, indices }),
  );
});

test.each(['adaptive', 'octree', 'feature', 'median', 'uniform'])('strategy %s', (strategy) => {
  const mesh = convert(torus(), { strategy, depth: 18 });
  expect(faults(mesh)).toEqual([]);
  expect(volume(mesh)).toBeGreaterThan(0);
});

test('depth limits the tree', () => {
  const grid = kdm.buildGrid(torus(), { strategy: 'uniform', depth: 12 });
  expect(grid.stats.depth).toBe(12);
  grid.delete();
});

// One vertex for each cell of 10 x 10 x 10 that is not amid the others.
test('cells give any resolution', () => {
  const options = { strategy: 'uniform', cells: 10 };
  const mesh = convert(cube(4), options, { strict: 'off' });
  expect(mesh.positions).toHaveLength(3 * (10 ** 3 - 8 ** 3));
});

test('a smaller tolerance gives more triangles, absolute or relative', () => {
  const count = (options) => convert(torus(64, 32), options).indices.length;
  expect(count({ relativeTolerance: 0.0005 })).toBeGreaterThan(count({ relativeTolerance: 0.02 }));
  expect(count({ tolerance: 0.005 })).toBeGreaterThan(count({ tolerance: 0.2 }));
});

// Two cubes, the second within the first: once in the union, a hollow where winding is even.
test('inside decides what overlapping and nested shells mean', () => {
  const nested = together(cube(4), cube(2));
  const options = { strategy: 'uniform', depth: 15 };
  const of = (inside) => volume(convert(nested, { ...options, inside }));
  expect(of('positive')).toBeCloseTo(64, 1);
  expect(of('nonzero')).toBeCloseTo(64, 1);
  expect(of('odd')).toBeCloseTo(56, 1);
});

test('a sheet stays open, and its boundary is counted', () => {
  const { positions, indices } = torus();
  const open = { positions, indices: indices.slice(60) };
  const grid = kdm.buildGrid(open, { inside: 'sheet' });
  expect(grid.input).toMatchObject({ closed: false, boundaryLoops: 1 });
  const mesh = grid.extract();
  expect(mesh.report.boundaryLoops).toBe(1);
  expect(kdm.describe(mesh)).toMatchObject({
    closed: false,
    twoManifold: false,
    manifold: true,
    boundaryLoops: 1,
    components: 1,
    eulerCharacteristic: -1,
  });
  grid.delete();
  // A square is four corners at any tolerance.
  const square = convert(
    {
      positions: new Float32Array([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]),
      indices: new Uint16Array([0, 1, 2, 0, 2, 3]),
    },
    { inside: 'sheet', relativeTolerance: 0.05 },
  );
  expect(square.indices).toHaveLength(6);
});

test.each(['trace', 'hermite', 'inside', 'outside'])('pairing %s', (pairing) => {
  const mesh = convert(torus(), { strategy: 'uniform', depth: 9, pairing });
  expect(faults(mesh)).toEqual([]);
});

test('quads on request, and as many faces in all as source faces', () => {
  const mesh = convert(torus(), { strategy: 'uniform', depth: 12 }, { quads: true });
  expect(mesh.quads.length).toBeGreaterThan(0);
  expect(mesh.sourceFaces).toHaveLength(mesh.indices.length / 3 + mesh.quads.length / 4);
  expect(faults(mesh)).toEqual([]);
});

test('normals on request: those of the faces of a cube', () => {
  expect(convert(cube()).cornerNormals).toBeUndefined();
  for (const quads of [false, true]) {
    const mesh = convert(
      cube(),
      { strategy: 'uniform', depth: 9 },
      { normals: true, creaseAngle: 45, quads },
    );
    const { cornerNormals } = mesh;
    expect(cornerNormals).toBeInstanceOf(Float32Array);
    expect(cornerNormals).toHaveLength(3 * (mesh.indices.length + (mesh.quads?.length ?? 0)));
    const seen = new Set();
    for (let i = 0; i < cornerNormals.length; i += 3) {
      seen.add([...cornerNormals.subarray(i, i + 3)].map((x) => x + 0).join());
    }
    expect([...seen].sort()).toEqual(
      ['1,0,0', '-1,0,0', '0,1,0', '0,-1,0', '0,0,1', '0,0,-1'].sort(),
    );
    // They go into OBJ files, and the mesh is still one that can be described.
    expect(Buffer.from(kdm.formatMesh(mesh, 'obj')).toString().match(/^vn /gm)).toHaveLength(6);
    expect(kdm.describe(mesh).twoManifold).toBe(true);
  }
});

test.each(['constrained', 'projection'])('position %s', (position) => {
  const mesh = convert(torus(), { strategy: 'uniform', depth: 9 }, { position });
  expect(faults(mesh)).toEqual([]);
});

test('without strict nothing is dropped or inserted', () => {
  const mesh = convert(torus(), { strategy: 'uniform', depth: 9 }, { strict: 'off' });
  expect(mesh.report).toMatchObject({ droppedPillows: 0, insertedVertices: 0 });
});

test('embedded results do not meet themselves, in the numbers handed out', () => {
  const build = { strategy: 'median', depth: 12 };
  const plain = convert(torus(), build, { strict: 'manifold' });
  expect(kdm.findSelfIntersections(plain).pairs).toBeGreaterThan(0);
  expect(plain.report).toMatchObject({ crossings: null, refinedHits: 0 });
  const mesh = convert(torus(), build);
  expect(mesh.report.crossings).toBe(0);
  expect(kdm.findSelfIntersections(mesh).pairs).toBe(0);
  expect(faults(mesh)).toEqual([]);
});

test('edges between leaves keep to the tolerance unless told otherwise', () => {
  const count = (linkError) =>
    convert(torus(), {}, { linkError, strict: 'manifold' }).report.linkVertices;
  expect(count(1e9)).toBe(0);
  expect(count(1e-5)).toBeGreaterThan(count(0));
});

test("source faces are the caller's numbers where given", () => {
  const mesh = cube();
  const sourceFaces = Uint32Array.from({ length: 12 }, (_, i) => 1000 + i);
  const from = new Set(convert({ ...mesh, sourceFaces }).sourceFaces);
  expect(Math.min(...from)).toBeGreaterThanOrEqual(1000);
  expect(Math.max(...from)).toBeLessThan(1012);
});

test('a grid describes itself and its input', () => {
  const grid = kdm.buildGrid(asSoup(cube()));
  expect(grid).toBeInstanceOf(Grid);
  expect(grid.input).toMatchObject({
    vertices: 8,
    triangles: 12,
    closed: true,
    boundaryEdges: 0,
    nonManifoldEdges: 0,
    degenerateFaces: 0,
    cancelledFaces: 0,
    duplicateFaces: 0,
    sewnEdges: 0,
    turnedFaces: 0,
    turnedParts: 0,
    nestingKnown: true,
    components: 1,
    flipped: false,
  });
  expect(grid.input.latticeStep).toBeGreaterThan(0);
  expect(grid.stats.cells).toBeGreaterThan(grid.stats.leaves);
  expect(grid.stats.bytes).toBeGreaterThan(0);
  expect(grid.stats).toMatchObject({ topologyResolved: true, unresolvedLeaves: 0 });
  grid.delete();
});

test('exact digits stand for the same numbers in 32 and in 64 bits', () => {
  const mesh = convert(torus(), { relativeTolerance: 0.02 });
  for (const format of ['obj', 'off']) {
    const exact = kdm.parseMesh(kdm.formatMesh(mesh, format, { exact: true }), format);
    expect(exact.positions).toEqual(Float64Array.from(mesh.positions));
    const short = kdm.parseMesh(kdm.formatMesh(mesh, format), format);
    expect(short.positions).not.toEqual(exact.positions);
    expect(Float32Array.from(short.positions)).toEqual(mesh.positions);
  }
});

test('a mesh inside out is turned, and said to be', () => {
  const { positions, indices } = cube();
  const grid = kdm.buildGrid({ positions, indices: indices.slice().reverse() });
  expect(grid.input.flipped).toBe(true);
  expect(volume(grid.extract())).toBeCloseTo(8, 5);
  grid.delete();
});

test('a grid can be extracted from again; results are copies', () => {
  const grid = kdm.buildGrid(torus());
  const first = grid.extract();
  const kept = first.positions.slice();
  first.positions.fill(0);
  const second = grid.extract();
  expect(second.positions).toEqual(kept);
  grid.delete();
});

test('a saved grid comes back', () => {
  const grid = kdm.buildGrid(torus(), { relativeTolerance: 0.01 });
  const bytes = grid.save();
  expect(bytes).toBeInstanceOf(Uint8Array);
  expect(grid.save()).toEqual(bytes);
  expect(bytes.length).toBeLessThan(grid.stats.bytes);
  const shifted = new Uint8Array(bytes.length + 5);
  shifted.set(bytes, 3);
  for (const content of [bytes, bytes.buffer, shifted.subarray(3, 3 + bytes.length)]) {
    const loaded = kdm.loadGrid(content);
    expect(loaded).toBeInstanceOf(Grid);
    expect(loaded.input).toEqual(grid.input);
    expect({ ...loaded.stats, bytes: 0 }).toEqual({ ...grid.stats, bytes: 0 });
    same(loaded.extract(), grid.extract());
    expect(loaded.save()).toEqual(bytes);
    loaded.delete();
  }
  grid.delete();
});

test('delete may be called twice; dispose is delete', () => {
  const grid = kdm.buildGrid(cube());
  grid.delete();
  grid.delete();
  const other = kdm.buildGrid(cube());
  other[Symbol.dispose]();
  expect(() => other.stats).toThrow('deleted');
});

test('progress goes from 0 to 1 and never back', () => {
  const seen = [];
  const grid = kdm.buildGrid(torus(128, 64), {
    onProgress: (fraction) => void seen.push(fraction),
  });
  grid.extract({ onProgress: (fraction) => void seen.push(1 + fraction) });
  grid.delete();
  expect(seen.length).toBeGreaterThan(2);
  expect(seen).toEqual([...seen].sort((a, b) => a - b));
  expect(Math.min(...seen)).toBeGreaterThanOrEqual(0);
  expect(Math.max(...seen)).toBeLessThanOrEqual(2);
});

test('self-intersections are found', () => {
  expect(kdm.findSelfIntersections(cube())).toEqual({ pairs: 0, faces: new Uint32Array() });
  const { pairs, faces } = kdm.findSelfIntersections(together(cube(2), cube(2, [1, 1, 1])));
  expect(pairs).toBeGreaterThan(10);
  expect(faces).toBeInstanceOf(Uint32Array);
  expect([...faces]).toEqual([...faces].sort((a, b) => a - b));
});

test('describe counts', () => {
  const report = kdm.describe(cube());
  expect(report).toMatchObject({
    vertices: 8,
    triangles: 12,
    components: 1,
    eulerCharacteristic: 2,
    closed: true,
    twoManifold: true,
  });
  expect(report.volume).toBeCloseTo(8);
  expect(report.area).toBeCloseTo(24);
  expect([...report.bounds.min, ...report.bounds.max]).toEqual([-1, -1, -1, 1, 1, 1]);
  const { positions, indices } = cube();
  expect(kdm.describe({ positions, indices: indices.slice(3) })).toMatchObject({
    boundaryEdges: 3,
    boundaryLoops: 1,
    closed: false,
    twoManifold: false,
    manifold: true,
  });
});

test.each(['obj', 'stl', 'ply', 'off'])('%s: what is written can be read', (format) => {
  const mesh = torus();
  const read = kdm.parseMesh(kdm.formatMesh(mesh, format), format, `torus.${format}`);
  expect(read.indices).toHaveLength(mesh.indices.length);
  expect(volume(read)).toBeCloseTo(volume(mesh), 3);
  expect(faults(convert(read))).toEqual([]);
});

test('meshes are parsed from text, bytes and buffers', () => {
  const text = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n';
  const bytes = new TextEncoder().encode(text);
  for (const content of [text, bytes, bytes.buffer, Buffer.from(text)]) {
    expect([...kdm.parseMesh(content, 'obj').indices]).toEqual([
      0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3,
    ]);
  }
});

test('content counts more than the format asked for, and what is skipped is said', () => {
  const corners = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 1\n';
  const { indices, warnings } = kdm.parseMesh(`${corners}f 1 2 3\nf 1 2 4\nf 1 2\n`, 'stl');
  expect([...indices]).toEqual([0, 1, 2]);
  expect(warnings).toEqual([
    {
      code: 'FACES_SKIPPED',
      message: '1 face has a coordinate that is not a number; skipped; it is at line 4',
    },
    {
      code: 'FACES_SKIPPED',
      message: '1 face has fewer than three corners; skipped; it is at line 7',
    },
  ]);
  expect(kdm.parseMesh(`${corners}f 1 2 3\n`, 'obj').warnings).toEqual([]);
  const zipped = new Uint8Array([0x1f, 0x8b, 8, 0]);
  expect(() => kdm.parseMesh(zipped, 'stl')).toThrow('gzip-compressed');
});

test('formats go by extension', () => {
  expect(formatFromPath('a/b.c/Part.STL')).toBe('stl');
  expect(() => formatFromPath('part')).toThrow('ends in none of');
});

test.each([
  ['plain arrays', (list) => [...list], (list) => [...list]],
  ['64-bit positions', (list) => Float64Array.from(list), (list) => Uint16Array.from(list)],
  ['Int32Array', (list) => list, (list) => Int32Array.from(list)],
  ['Int16Array', (list) => list, (list) => Int16Array.from(list)],
  ['Int8Array', (list) => list, (list) => Int8Array.from(list)],
  ['Uint8Array', (list) => list, (list) => Uint8Array.from(list)],
])('meshes may have %s', async (_, toPositions, toIndices) => {
  const { positions, indices } = cube();
  const given = {
    positions: toPositions(positions),
    indices: toIndices(indices),
    sourceFaces: toIndices(indices.slice(0, 12)),
  };
  const wanted = (await makeManifold({ positions, indices, sourceFaces: indices.slice(0, 12) }))
    .mesh;
  for (const transfer of [false, true]) {
    expect((await makeManifold(globalThis.structuredClone(given), { transfer })).mesh).toEqual(
      wanted,
    );
  }
});
