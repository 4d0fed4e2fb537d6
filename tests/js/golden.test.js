// SPDX-License-Identifier: MIT
// WebAssembly gives the same bytes as the native library: the hashes of tests/cpp/whole/golden_test.cpp.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { load, makeManifold } from '../../dist/index.js';
import { root } from './support/paths.js';

const entries = JSON.parse(readFileSync(join(root, 'tests/golden/hashes.json'), 'utf8'));

// FNV-1a of 64 bits over 32-bit little-endian words, in two halves: numbers hold 53 bits.
function hash(arrays) {
  let [high, low] = [0xcbf29ce4, 0x84222325];
  for (const array of arrays) {
    for (const byte of new Uint8Array(array.buffer, array.byteOffset, array.byteLength)) {
      low = (low ^ byte) >>> 0;
      // Times 0x100000001b3 = 2^40 + 0x1b3.
      const product = low * 0x1b3;
      high = (high * 0x1b3 + Math.floor(product / 2 ** 32) + ((low << 8) >>> 0)) % 2 ** 32;
      low = product % 2 ** 32;
    }
  }
  return [high, low].map((half) => (half >>> 0).toString(16).padStart(8, '0')).join('');
}

test('there are hashes', () => expect(entries.length).toBeGreaterThan(20));

test.each(
  entries.map((entry) => [
    entry.relativeTolerance === undefined
      ? `${entry.input} ${entry.strategy} ${entry.depth} ${entry.pairing}`
      : `${entry.input} reduced ${entry.relativeTolerance} ${entry.targetTriangles}`,
    entry,
  ]),
)('%s', async (_, entry) => {
  const kdm = await load();
  if (entry.relativeTolerance !== undefined) return expectReduced(kdm, entry);
  const { input, strategy, depth, inside, pairing, quads } = entry;
  const file = readFileSync(join(root, 'tests/data', input));
  const grid = kdm.buildGrid(kdm.parseMesh(file, 'obj', input), {
    strategy,
    depth,
    inside,
    pairing,
  });
  const mesh = grid.extract({ quads });
  grid.delete();
  expectMesh(mesh, entry);
});

function expectMesh(mesh, entry) {
  expect(mesh.positions.length / 3).toBe(entry.vertices);
  expect(mesh.indices.length / 3).toBe(entry.triangles);
  const { positions, indices, quads = new Uint32Array(), sourceFaces } = mesh;
  expect(hash([positions, indices, quads, sourceFaces])).toBe(entry.hash);
}

async function expectReduced(kdm, entry) {
  const { input, relativeTolerance, targetTriangles } = entry;
  const file = readFileSync(join(root, 'tests/data', input));
  const { mesh } = await makeManifold(kdm.parseMesh(file, 'obj', input), {
    relativeTolerance,
    ...(targetTriangles.length > 0 && { targetTriangles }),
  });
  expectMesh(mesh, entry);
}
