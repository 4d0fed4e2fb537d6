// SPDX-License-Identifier: MIT
// Meshes from and to three.js geometries.
import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  InterleavedBuffer,
  InterleavedBufferAttribute,
  Mesh,
  MeshBasicMaterial,
  Raycaster,
  Vector3,
} from 'three';
import { load } from '../../dist/index.js';
import { fromBufferGeometry, toBufferGeometry } from '../../dist/three.js';
import { cube, faults, volume } from './support/meshes.js';

let kdm;
beforeAll(async () => {
  kdm = await load();
});

function convert(mesh, extract) {
  const grid = kdm.buildGrid(mesh, { strategy: 'uniform', depth: 9 });
  const result = grid.extract(extract);
  grid.delete();
  return result;
}

test("three's own box, whose corners are in triplicate, becomes a solid", () => {
  const geometry = new BoxGeometry(1, 2, 3);
  const result = convert(fromBufferGeometry(geometry));
  expect(faults(result)).toEqual([]);
  expect(volume(result)).toBeCloseTo(6, 4);
});

test('indexed and not, the arrays are copies', () => {
  const geometry = new BoxGeometry();
  const indexed = fromBufferGeometry(geometry);
  expect(indexed.indices).toHaveLength(36);
  indexed.positions.fill(9);
  expect(geometry.getAttribute('position').getX(0)).toBe(0.5);
  const soup = fromBufferGeometry(geometry.toNonIndexed());
  expect(soup.indices).toBeNull();
  expect(soup.positions).toHaveLength(108);
});

test('interleaved, normalised and 64-bit attributes', () => {
  const interleaved = new BufferGeometry().setAttribute(
    'position',
    new InterleavedBufferAttribute(
      new InterleavedBuffer(Float32Array.of(1, 2, 3, 9, 4, 5, 6, 9, 7, 8, 9, 9), 4),
      3,
      0,
    ),
  );
  expect([...fromBufferGeometry(interleaved).positions]).toEqual([1, 2, 3, 4, 5, 6, 7, 8, 9]);
  const bytes = new BufferGeometry().setAttribute(
    'position',
    new BufferAttribute(Uint8Array.of(0, 255, 51), 3, true),
  );
  expect([...fromBufferGeometry(bytes).positions]).toEqual([0, 1, Math.fround(0.2)]);
  const precise = new BufferGeometry().setAttribute(
    'position',
    new BufferAttribute(Float64Array.of(0.1, 0.2, 0.3), 3),
  );
  expect([...fromBufferGeometry(precise).positions]).toEqual([0.1, 0.2, 0.3]);
});

test('geometries that are no meshes are refused', () => {
  expect(() => fromBufferGeometry(new BufferGeometry())).toThrow('"position"');
  const flat = new BufferGeometry().setAttribute(
    'position',
    new BufferAttribute(new Float32Array(4), 2),
  );
  expect(() => fromBufferGeometry(flat)).toThrow('2 numbers per vertex');
});

test('a result can be shown: rays hit it where the cube is', () => {
  const geometry = toBufferGeometry(convert(cube(2)));
  const shown = new Mesh(geometry, new MeshBasicMaterial());
  const ray = new Raycaster(new Vector3(0.3, 0.2, 9), new Vector3(0, 0, -1));
  const [hit] = ray.intersectObject(shown);
  expect(hit.point.z).toBeCloseTo(1, 5);
  expect(hit.face.normal.z).toBeCloseTo(1, 5);
});

test('quads become two triangles each', () => {
  const result = convert(cube(2), { quads: true });
  expect(result.quads.length).toBeGreaterThan(0);
  const geometry = toBufferGeometry(result);
  expect(geometry.getIndex().count).toBe(result.indices.length + (result.quads.length / 4) * 6);
  const { positions, indices } = fromBufferGeometry(geometry);
  expect(faults({ positions, indices })).toEqual([]);
  expect(volume({ positions, indices })).toBeCloseTo(8, 4);
});

test('64-bit positions and soups are shown too', () => {
  const soup = toBufferGeometry({ positions: Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0) });
  expect(soup.getAttribute('position').array.constructor.name).toBe('Float32Array');
  expect(soup.getIndex()).toBeNull();
});

test('corner normals become an attribute, with a vertex for each normal at a crease', () => {
  for (const quads of [false, true]) {
    const result = convert(cube(), { normals: true, quads });
    const geometry = toBufferGeometry(result);
    const position = geometry.getAttribute('position');
    const normal = geometry.getAttribute('normal');
    const index = geometry.getIndex();
    expect(normal.count).toBe(position.count);
    expect(index.count).toBe(result.indices.length + ((result.quads?.length ?? 0) / 4) * 6);
    // Each face's plane is that of its corners' normals, and no two vertices are the same.
    const [a, b, c, n] = [new Vector3(), new Vector3(), new Vector3(), new Vector3()];
    for (let i = 0; i < index.count; i += 3) {
      const corners = [0, 1, 2].map((k) => index.getX(i + k));
      [a, b, c].forEach((p, k) => p.fromBufferAttribute(position, corners[k]));
      const across = b.sub(a).cross(c.sub(a)).normalize();
      for (const corner of corners) {
        expect(n.fromBufferAttribute(normal, corner).dot(across)).toBeCloseTo(1, 3);
      }
    }
    const keys = Array.from({ length: position.count }, (_, i) =>
      [position, normal].map((x) => [x.getX(i), x.getY(i), x.getZ(i)].map((v) => v + 0)).join(),
    );
    expect(new Set(keys).size).toBe(keys.length);
    // Vertices on the cube's edges are there more than once.
    const places = new Set(keys.map((key) => key.split(',').slice(0, 3).join()));
    expect(places.size).toBe(result.positions.length / 3);
    expect(position.count).toBeGreaterThan(places.size);
  }
  const smooth = toBufferGeometry(convert(cube(), { normals: true, creaseAngle: 180 }));
  expect(smooth.getAttribute('position').count).toBe(convert(cube()).positions.length / 3);
});
