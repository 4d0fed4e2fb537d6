// SPDX-License-Identifier: MIT
// Every error a caller can provoke: its code, what its message names, and that all goes on after it.
import { load, makeManifold } from '../../dist/index.js';
import { cube, faults, torus } from './support/meshes.js';

let kdm;
beforeAll(async () => {
  kdm = await load();
});

const { positions, indices } = cube();
const build = (mesh, options) => () => kdm.buildGrid(mesh, options);
const withPosition = (index, value) => {
  const changed = positions.slice();
  changed[index] = value;
  return { positions: changed, indices };
};
const withIndex = (index, value) => {
  const changed = indices.slice();
  changed[index] = value;
  return { positions, indices: changed };
};
// As 64-bit numbers this is more than WebAssembly can address; here it is pages never touched.
const enormous = () => ({ positions: new Float32Array(540_000_000) });
const savedGrid = () => {
  const grid = kdm.buildGrid(cube());
  const bytes = grid.save();
  grid.delete();
  return bytes;
};
const damagedGrid = () => {
  const bytes = savedGrid();
  bytes[bytes.length >> 1] ^= 4;
  return bytes;
};
const deletedGrid = () => {
  const grid = kdm.buildGrid(cube());
  grid.delete();
  return grid;
};

// What happens, the code, what the message must say.
const table = [
  ['no mesh', build(null), 'INVALID_MESH', /mesh.*null/],
  ['a mesh that is no object', build('cube'), 'INVALID_MESH', /mesh.*string/],
  ['no positions', build({ indices }), 'INVALID_MESH', /positions.*undefined/],
  [
    'a plain array of words',
    build({ positions: [0, 1, 'two'], indices }),
    'INVALID_MESH',
    /^positions\[2\] is two, which is no number$/,
  ],
  [
    'a plain array of points',
    build({ positions: [[0, 0, 0]], indices }),
    'INVALID_MESH',
    /^positions\[0\] is a plain array, which is no number$/,
  ],
  [
    'whole positions',
    build({ positions: Int32Array.from(positions), indices }),
    'INVALID_MESH',
    /^positions: expected Float32Array or Float64Array, got Int32Array; Float32Array\.from\(positions\) makes one$/,
  ],
  [
    'a negative index',
    build({ positions, indices: Int32Array.of(0, 1, -1) }),
    'INVALID_MESH',
    /^indices\[2\] is -1; vertices are numbered 0, 1, 2 and so on$/,
  ],
  [
    'half an index',
    build({ positions, indices: [0, 1, 2.5] }),
    'INVALID_MESH',
    /^indices\[2\] is 2\.5; vertices are numbered/,
  ],
  [
    'real indices',
    build({ positions, indices: Float32Array.from(indices) }),
    'INVALID_MESH',
    /^indices: expected Uint32Array or Uint16Array, got Float32Array; Uint32Array\.from\(indices\) makes one$/,
  ],
  [
    'big indices',
    build({ positions, indices: BigUint64Array.of(0n, 1n, 2n) }),
    'INVALID_MESH',
    /^indices: .*got BigUint64Array; Uint32Array\.from\(indices, Number\) makes one$/,
  ],
  [
    'a DataView',
    build({ positions: new DataView(positions.buffer), indices }),
    'INVALID_MESH',
    /^positions: .*got DataView; new Float32Array\(\.\.\.\) makes one of its bytes$/,
  ],
  [
    'a bare buffer',
    build({ positions: positions.slice().buffer, indices }),
    'INVALID_MESH',
    /^positions: .*got object; new Float32Array\(\.\.\.\) makes one of its bytes$/,
  ],
  [
    'an attribute of three.js',
    build({ positions: { array: positions, itemSize: 3 }, indices }),
    'INVALID_MESH',
    /^positions: .*got object; its member array may be one$/,
  ],
  [
    'an array that was handed over',
    () => {
      const gone = positions.slice();
      globalThis.structuredClone(gone, { transfer: [gone.buffer] });
      kdm.buildGrid({ positions: gone, indices });
    },
    'INVALID_MESH',
    /^positions: its buffer was handed over to another thread, so the array is empty now$/,
  ],
  [
    'a length no multiple of 3',
    build({ positions: positions.slice(1), indices }),
    'INVALID_MESH',
    /positions.*23.*multiple of 3/,
  ],
  [
    'a number of indices no multiple of 3',
    build({ positions, indices: indices.slice(1) }),
    'INVALID_MESH',
    /indices.*35.*multiple of 3/,
  ],
  ['a soup of part of a triangle', build({ positions }), 'INVALID_MESH', /24.*multiple of 9/],
  [
    'an index out of range',
    build(withIndex(7, 8)),
    'INVALID_MESH',
    /indices\[7\] is 8.*8 vertices/,
  ],
  ['NaN', build(withPosition(5, NaN)), 'INVALID_MESH', /positions\[5\] is NaN/],
  ['infinity', build(withPosition(6, -Infinity)), 'INVALID_MESH', /positions\[6\] is -Infinity/],
  [
    'no vertices',
    build({ positions: new Float32Array(), indices: new Uint32Array() }),
    'INVALID_MESH',
    /no vertices/,
  ],
  ['no triangles', build({ positions, indices: new Uint32Array() }), 'INVALID_MESH', /no faces/],
  [
    'source faces of the wrong number',
    build({ positions, indices, sourceFaces: new Uint32Array(3) }),
    'INVALID_MESH',
    /sourceFaces.*3.*12/,
  ],
  [
    'quads out of range',
    () => kdm.describe({ positions, indices, quads: Uint32Array.of(0, 1, 2, 9) }),
    'INVALID_MESH',
    /quads\[3\] is 9/,
  ],
  [
    'an open mesh, not to be repaired',
    build({ positions, indices: indices.slice(3) }, { inside: 'positive' }),
    'NOT_CLOSED',
    /3.*edge/,
  ],
  [
    'a surface that encloses nothing',
    build({ positions, indices: indices.slice(0, 3) }),
    'NOT_CLOSED',
    /encloses nothing/,
  ],
  [
    'a face turned over',
    build(
      {
        positions,
        indices: Uint32Array.of(...[...indices.slice(0, 3)].reverse(), ...indices.slice(3)),
      },
      { inside: 'positive' },
    ),
    'NOT_CLOSED',
    /edge/,
  ],
  ['options that are none', build(cube(), 5), 'INVALID_OPTION', /options.*number/],
  ['an unknown option', build(cube(), { dept: 3 }), 'INVALID_OPTION', /dept\b/],
  [
    'an inherited name as option',
    build(cube(), { constructor: 1 }),
    'INVALID_OPTION',
    /constructor/,
  ],
  [
    'an unknown strategy',
    build(cube(), { strategy: 'best' }),
    'INVALID_OPTION',
    /strategy.*'best'/,
  ],
  ['an unknown inside rule', build(cube(), { inside: 'all' }), 'INVALID_OPTION', /inside.*'all'/],
  ['an unknown pairing', build(cube(), { pairing: null }), 'INVALID_OPTION', /pairing.*null/],
  ['a depth of 0', build(cube(), { depth: 0 }), 'INVALID_OPTION', /depth.*1 to 60.*0/],
  ['a depth of 61', build(cube(), { depth: 61 }), 'INVALID_OPTION', /depth.*61/],
  ['half a depth', build(cube(), { depth: 7.5 }), 'INVALID_OPTION', /depth.*7\.5/],
  ['depth in words', build(cube(), { depth: '9' }), 'INVALID_OPTION', /depth.*'9'/],
  ['a negative tolerance', build(cube(), { tolerance: -1 }), 'INVALID_OPTION', /tolerance.*-1/],
  [
    'an infinite tolerance',
    build(cube(), { relativeTolerance: Infinity }),
    'INVALID_OPTION',
    /relativeTolerance.*Infinity/,
  ],
  [
    'two tolerances',
    build(cube(), { tolerance: 0.1, relativeTolerance: 0.1 }),
    'INVALID_OPTION',
    /^relativeTolerance: not together with `tolerance`$/,
  ],
  [
    'a tolerance where none is asked for',
    build(cube(), { strategy: 'uniform', tolerance: 0.1 }),
    'INVALID_OPTION',
    /^tolerance: only with `strategy` adaptive, octree or feature$/,
  ],
  [
    'cells of no regular grid',
    build(cube(), { cells: 80 }),
    'INVALID_OPTION',
    /^cells: only with `strategy` octree or uniform$/,
  ],
  [
    'cells beside a depth',
    build(cube(), { strategy: 'octree', depth: 9, cells: 80 }),
    'INVALID_OPTION',
    /^depth: not together with `cells`$/,
  ],
  [
    'cells beside a tolerance',
    build(cube(), { strategy: 'octree', tolerance: 1, cells: 80 }),
    'INVALID_OPTION',
    /^tolerance: not together with `cells`$/,
  ],
  [
    'no cells',
    build(cube(), { strategy: 'octree', cells: 0 }),
    'INVALID_OPTION',
    /cells.*1 to 500000.*0/,
  ],
  [
    'a threshold for closed input',
    build(cube(), { inside: 'odd', windingThreshold: 0.3 }),
    'INVALID_OPTION',
    /^windingThreshold: only with `inside` repair$/,
  ],
  [
    'the largest hole of a shell',
    build(cube(), { thicken: 0.3, largestHole: 0.3 }),
    'INVALID_OPTION',
    /^largestHole: not together with `thicken`, which leaves no holes$/,
  ],
  [
    'an inside pairing without inside',
    build(cube(), { inside: 'sheet', pairing: 'inside' }),
    'INVALID_OPTION',
    /^pairing: only trace or hermite with `inside` sheet$/,
  ],
  [
    'a hole that is too wide',
    build({ positions, indices: indices.slice(3) }, { largestHole: 0.1 }),
    'NOT_CLOSED',
    /^1 of 1 holes are wider than `largestHole`, which is 0\.1;/,
  ],
  ...[
    [{ quads: true, linkError: 1 }, /^linkError: not together with `quads`$/],
    [{ creaseAngle: 20 }, /^creaseAngle: only with `normals`$/],
  ].map(([options, message]) => [
    `options without effect: ${Object.keys(options).join(' and ')}`,
    () => {
      const grid = kdm.buildGrid(cube());
      try {
        grid.extract(options);
      } finally {
        grid.delete();
      }
    },
    'INVALID_OPTION',
    message,
  ]),
  [
    'parts that are all too small',
    () => {
      const grid = kdm.buildGrid(cube());
      try {
        grid.extract({ dropParts: 4 });
      } finally {
        grid.delete();
      }
    },
    'EMPTY_RESULT',
    /^all parts of the result are smaller than `dropParts`$/,
  ],
  [
    'parts of a sheet',
    () => {
      const grid = kdm.buildGrid(cube(), { inside: 'sheet' });
      try {
        grid.extract({ parts: 'largest' });
      } finally {
        grid.delete();
      }
    },
    'INVALID_OPTION',
    /`parts`: only all for a sheet/,
  ],
  [
    'progress that is no function',
    build(cube(), { onProgress: 1 }),
    'INVALID_OPTION',
    /onProgress/,
  ],
  [
    'an unknown extraction option',
    () => {
      const grid = kdm.buildGrid(cube());
      try {
        grid.extract({ depth: 3 });
      } finally {
        grid.delete();
      }
    },
    'INVALID_OPTION',
    /depth/,
  ],
  [
    'quads that are not a flag',
    () => {
      const grid = kdm.buildGrid(cube());
      try {
        grid.extract({ quads: 1 });
      } finally {
        grid.delete();
      }
    },
    'INVALID_OPTION',
    /quads.*true or false/,
  ],
  ['an unknown format', () => kdm.parseMesh('', 'step'), 'INVALID_OPTION', /format.*'step'/],
  ['an unknown output format', () => kdm.formatMesh(cube(), 'x3d'), 'INVALID_OPTION', /'x3d'/],
  ['a malformed file', () => kdm.parseMesh('v 0 0\n', 'obj', 'a.obj'), 'PARSE_ERROR', /a\.obj.*1/],
  [
    'a truncated file',
    () => kdm.parseMesh(kdm.formatMesh(cube(), 'stl').slice(0, 200), 'stl', 'cut.stl'),
    'PARSE_ERROR',
    /cut\.stl/,
  ],
  [
    'a crease angle beyond 180',
    () => kdm.buildGrid(cube()).extract({ creaseAngle: 181 }),
    'INVALID_OPTION',
    /creaseAngle.*0 to 180.*181/,
  ],
  [
    'corner normals of the wrong length',
    () => kdm.formatMesh({ ...cube(), cornerNormals: new Float32Array(9) }, 'obj'),
    'INVALID_MESH',
    /cornerNormals.*9.*36/,
  ],
  [
    'corner normals that are not finite',
    () => kdm.formatMesh({ ...cube(), cornerNormals: new Float32Array(108).fill(NaN) }, 'obj'),
    'INVALID_MESH',
    /corner_normals\[0\]/,
  ],
  ['no bytes of a grid', () => kdm.loadGrid('kdgrid'), 'INVALID_OPTION', /content.*string/],
  ['null for a grid', () => kdm.loadGrid(null), 'INVALID_OPTION', /content.*null/],
  ['an empty grid file', () => kdm.loadGrid(new Uint8Array()), 'PARSE_ERROR', /grid: byte 0/],
  ['a grid cut off', () => kdm.loadGrid(savedGrid().slice(0, -1)), 'PARSE_ERROR', /cut off/],
  [
    'a damaged grid',
    () => kdm.loadGrid(damagedGrid(), 'a.kdgrid'),
    'PARSE_ERROR',
    /a\.kdgrid.*damaged/,
  ],
  ['a stop by the callback', build(torus(64, 64), { onProgress: () => false }), 'ABORTED', /./],
  [
    'nothing is left',
    () => kdm.buildGrid(cube(), { tolerance: 1e9 }).extract(),
    'EMPTY_RESULT',
    /nothing of the surface is left.*smaller tolerance/,
  ],
  ['use after delete: extract', () => deletedGrid().extract(), 'DELETED', /deleted/],
  ['use after delete: save', () => deletedGrid().save(), 'DELETED', /deleted/],
  ['use after delete: stats', () => deletedGrid().stats, 'DELETED', /deleted/],
  ['use after delete: input', () => deletedGrid().input, 'DELETED', /deleted/],
  ['more memory than there is', () => kdm.buildGrid(enormous()), 'OUT_OF_MEMORY', /memory/],
];

test.each(table)('%s', (_, action, code, message) => {
  let error;
  try {
    action();
  } catch (caught) {
    error = caught;
  }
  expect(error).toMatchObject({ name: 'KdManifoldError', code });
  expect(error).toBeInstanceOf(Error);
  expect(error.message).toMatch(message);
  expect(error.message).not.toMatch(/\n/);
  // The module works on.
  const grid = kdm.buildGrid(cube());
  expect(faults(grid.extract())).toEqual([]);
  grid.delete();
});

test('an error of the callback comes out as it is', () => {
  const mine = new TypeError('mine');
  const onProgress = () => {
    throw mine;
  };
  expect(build(torus(64, 64), { onProgress })).toThrow(mine);
});

const { AbortSignal } = globalThis;
const asyncTable = [
  ['an unknown option', cube(), { quick: true }, 'INVALID_OPTION', /quick/],
  ['a signal that is none', cube(), { signal: {} }, 'INVALID_OPTION', /signal/],
  ['transfer that is no flag', cube(), { transfer: 1 }, 'INVALID_OPTION', /transfer/],
  ['progress that is no function', cube(), { onProgress: {} }, 'INVALID_OPTION', /onProgress/],
  ['a bad mesh', { positions: [] }, {}, 'INVALID_MESH', /no vertices/],
  [
    'an open mesh',
    { positions, indices: indices.slice(3) },
    { inside: 'positive' },
    'NOT_CLOSED',
    /edge/,
  ],
  ['an aborted signal', cube(), { signal: AbortSignal.abort() }, 'ABORTED', /stopped/],
  ['worker that is none', cube(), { worker: true }, 'INVALID_OPTION', /worker/],
  ['a worker address that is none', cube(), { workerUrl: 7 }, 'INVALID_OPTION', /workerUrl/],
  ['concurrency 0', cube(), { concurrency: 0 }, 'INVALID_OPTION', /concurrency.*1 to 64.*0/],
  [
    'one worker for two',
    cube(),
    { concurrency: 2, worker: { postMessage() {} } },
    'INVALID_OPTION',
    /worker.*function/,
  ],
  ['wasm that is none', cube(), { wasmBinary: 'no' }, 'INVALID_OPTION', /wasmBinary/],
  ['too little memory', enormous(), { transfer: true }, 'OUT_OF_MEMORY', /memory/],
];

test.each(asyncTable)('makeManifold rejects: %s', async (_, mesh, options, code, message) => {
  const error = await makeManifold(mesh, options).catch((caught) => caught);
  expect(error).toMatchObject({ name: 'KdManifoldError', code });
  expect(error.message).toMatch(message);
  const { report } = await makeManifold(cube());
  expect(report.output.twoManifold).toBe(true);
});

test('a WebAssembly file that is not there: LOAD_FAILED, and the next load works', async () => {
  const fresh = await import('../../build/js/load.js?fresh');
  const missing = new URL('./missing.wasm', import.meta.url);
  await expect(fresh.load({ wasmUrl: missing })).rejects.toMatchObject({
    code: 'LOAD_FAILED',
    message: expect.stringMatching(/kdmanifold.wasm: .*missing.wasm/),
  });
  await expect(fresh.load({ wasmBinary: new Uint8Array(8) })).rejects.toMatchObject({
    code: 'LOAD_FAILED',
    message: expect.stringMatching(/kdmanifold.wasm: it cannot be compiled/),
  });
  expect((await fresh.load()).version).toBe(kdm.version);
});
