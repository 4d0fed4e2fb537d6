// SPDX-License-Identifier: MIT
// What a result gets from the three.js objects that it was made of: materials and attributes.
import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  Color,
  Float16BufferAttribute,
  Group,
  InstancedBufferAttribute,
  InstancedMesh,
  InterleavedBuffer,
  InterleavedBufferAttribute,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  Raycaster,
  SphereGeometry,
  Vector3,
} from 'three';
import { load, makeManifold, simplifyMesh } from '../../dist/index.js';
import { fromBufferGeometry, fromObject3D, toBufferGeometry, toMesh } from '../../dist/three.js';
import { asResult, itemsOf, square, withLocal } from './support/three-source.js';

let kdm;
beforeAll(async () => {
  kdm = await load();
});

function convert(from, build, extract) {
  const grid = kdm.buildGrid(from, build);
  const result = grid.extract(extract);
  grid.delete();
  return result;
}

const materials = (count) => Array.from({ length: count }, () => new MeshBasicMaterial());

/** Calls `visit` with the material's number and the vertices of each triangle. */
function visitTriangles(geometry, visit) {
  const index = geometry.getIndex();
  for (const { start, count, materialIndex } of geometry.groups) {
    for (let i = start; i < start + count; i += 3) {
      visit(
        materialIndex,
        [0, 1, 2].map((k) => index.getX(i + k)),
      );
    }
  }
}

const pointsOf = (geometry, vertices, name = 'position') =>
  vertices.map((v) => new Vector3().fromBufferAttribute(geometry.getAttribute(name), v));

function normalOf(geometry, vertices) {
  const [a, b, c] = pointsOf(geometry, vertices);
  return b.sub(a).cross(c.sub(a)).normalize();
}

test('a textured box keeps its sides apart, exactly, however fine they were', () => {
  for (const segments of [1, 7]) {
    const box = new BoxGeometry(1, 1, 1, segments, segments, segments);
    const uv = box.getAttribute('uv');
    const normal = box.getAttribute('normal');
    // Every side has a place of its own in the texture.
    const sideOf = (n) => [n.x, n.y, n.z, -n.x, -n.y, -n.z].findIndex((v) => v > 0.99);
    for (let i = 0; i < uv.count; ++i) {
      const side = sideOf(new Vector3().fromBufferAttribute(normal, i));
      uv.setX(i, (side + 0.8 * uv.getX(i)) / 6);
    }
    const from = fromObject3D(new Mesh(withLocal(box)));
    const result = convert(from);
    expect(result.positions).toHaveLength(24);
    const geometry = toBufferGeometry(result, { from });
    expect(geometry.getAttribute('position').count).toBe(24);
    expect(geometry.groups).toEqual([]);
    const index = geometry.getIndex();
    for (let i = 0; i < index.count; i += 3) {
      const corners = [0, 1, 2].map((k) => index.getX(i + k));
      const side = sideOf(normalOf(geometry, corners));
      for (const corner of corners) {
        const u = 6 * geometry.getAttribute('uv').getX(corner) - side;
        expect(Math.min(Math.abs(u), Math.abs(u - 0.8))).toBeLessThan(1e-3);
      }
      pointsOf(geometry, corners, 'local').forEach((local, k) => {
        expect(local.distanceTo(pointsOf(geometry, corners)[k])).toBeLessThan(2e-3);
      });
    }
  }
});

test('a sphere is split along its seam and at its poles only', () => {
  const from = fromObject3D(new Mesh(new SphereGeometry(1, 64, 32)));
  for (const extract of [{ quads: true }, { normals: true, creaseAngle: 180 }]) {
    const result = convert(from, {}, extract);
    const geometry = toBufferGeometry(result, { from });
    const position = geometry.getAttribute('position');
    const places = new Map();
    itemsOf(position).forEach((place, v) => {
      places.set(`${place}`, [...(places.get(`${place}`) ?? []), v]);
    });
    expect(places.size).toBe(result.positions.length / 3);
    // Three's sphere has its seam where z is 0 and x negative.
    const fromSeam = ({ x, z }) => Math.min(Math.hypot(z, Math.max(x, 0)), Math.hypot(x, z));
    const split = [...places.values()].filter((vertices) => vertices.length > 1);
    const astray = split.filter(([v]) => fromSeam(pointsOf(geometry, [v])[0]) > 0.15);
    expect(astray.length).toBe(0);
    expect(split.length).toBeGreaterThan(16);
    expect(split.length).toBeLessThan(100);
    // No triangle goes all across the texture, and away from the seam all is where it belongs.
    const uv = geometry.getAttribute('uv');
    const index = geometry.getIndex();
    let widest = 0;
    let farthest = 0;
    for (let i = 0; i < index.count; i += 3) {
      const corners = [0, 1, 2].map((k) => index.getX(i + k));
      const us = corners.map((v) => uv.getX(v));
      widest = Math.max(widest, Math.max(...us) - Math.min(...us));
      for (const [k, { x, y, z }] of pointsOf(geometry, corners).entries()) {
        if (Math.hypot(x, z) < 0.4 || (x < 0 && Math.abs(z) < 0.3)) continue;
        const u = (Math.atan2(z, -x) / (2 * Math.PI) + 1) % 1;
        const v = 1 - Math.acos(y) / Math.PI;
        farthest = Math.max(farthest, Math.abs(us[k] - u), Math.abs(uv.getY(corners[k]) - v));
      }
    }
    expect(widest).toBeLessThan(0.5);
    expect(farthest).toBeLessThan(0.01);
  }
});

test('triangles keep their materials, as groups in order', () => {
  const own = materials(6);
  const from = fromObject3D(new Mesh(new BoxGeometry(1, 1, 1, 3, 3, 3), own));
  const geometry = toBufferGeometry(convert(from), { from });
  expect(from.source.materials).toEqual(own);
  expect(geometry.groups.map((group) => group.materialIndex)).toEqual([0, 1, 2, 3, 4, 5]);
  let triangles = 0;
  visitTriangles(geometry, (material, vertices) => {
    const side = new Vector3().setComponent(material >> 1, material % 2 === 0 ? 1 : -1);
    expect(normalOf(geometry, vertices).dot(side)).toBeCloseTo(1, 3);
    ++triangles;
  });
  expect(3 * triangles).toBe(geometry.getIndex().count);
});

test('the materials of several objects are put into one list', () => {
  const [red, green, blue] = materials(3);
  const group = new Group();
  const add = (x, material) => {
    const mesh = new Mesh(new BoxGeometry(), material);
    mesh.position.x = 3 * x;
    group.add(mesh);
  };
  add(0, red);
  add(1, [green, blue, green, blue, green, blue]);
  add(2, red);
  const from = fromObject3D(group);
  const result = convert(from);
  const shown = toMesh(result, from);
  expect(shown.material.map((m) => [red, green, blue].indexOf(m))).toEqual([0, 1, 2, 1, 2, 1, 2]);
  const seen = (from, along) => {
    const [hit] = new Raycaster(new Vector3(...from), new Vector3(...along)).intersectObject(shown);
    return shown.material[hit.face.materialIndex];
  };
  expect(seen([0.1, 0.2, 5], [0, 0, -1])).toBe(red);
  expect(seen([6.1, 0.2, 5], [0, 0, -1])).toBe(red);
  expect(seen([3.1, 5, 0.2], [0, -1, 0])).toBe(green); // side +y is number 2
  expect(seen([3.1, 0.2, -5], [0, 0, 1])).toBe(blue); // side -z is number 5
});

test('keepGroups holds the line between materials on a flat side', async () => {
  const own = materials(2);
  const box = new BoxGeometry(2, 2, 2, 16, 16, 16);
  const index = box.getIndex();
  box.clearGroups();
  for (let i = 0; i < index.count; i += 3) {
    const points = pointsOf(
      box,
      [0, 1, 2].map((k) => index.getX(i + k)),
    );
    const middle = points.reduce((sum, { x }) => sum + x, 0) / 3;
    box.addGroup(i, 3, middle > 0.4 ? 1 : 0);
  }
  const from = fromObject3D(new Mesh(box, own));
  const keepGroups = from.source.materialIndices;
  const { mesh } = await simplifyMesh(from, { error: 0.02, keepGroups });
  const area = [0, 0];
  const geometry = toBufferGeometry(mesh, { from });
  visitTriangles(geometry, (material, vertices) => {
    const [a, b, c] = pointsOf(geometry, vertices);
    area[material] += b.sub(a).cross(c.sub(a)).length() / 2;
  });
  // Lines lie at x = 0.375, where the box has edges.
  expect(area[1]).toBeCloseTo(4 + 8 * 0.625, 3);
  expect(area[0]).toBeCloseTo(24 - 4 - 8 * 0.625, 3);
  expect(mesh.indices.length / 3).toBeLessThanOrEqual(40);
});

test('a mesh with one material gets it back, without groups', () => {
  const [red] = materials(1);
  const from = fromObject3D(new Mesh(new BoxGeometry(), red));
  const shown = toMesh(convert(from, {}, { normals: true }), from);
  expect(shown.material).toBe(red);
  expect(shown.geometry.groups).toEqual([]);
  expect(shown.geometry.getAttribute('normal').count).toBe(24);
  // Without normals of its own it gets some, so that lights show it.
  expect(toMesh(convert(from), from).geometry.getAttribute('normal')).toBeDefined();
});

test('geometries alone carry groups and attributes, too', () => {
  for (const geometry of [new BoxGeometry(), new BoxGeometry().toNonIndexed()]) {
    const from = fromBufferGeometry(withLocal(geometry));
    const made = toBufferGeometry(convert(from), { from });
    expect(made.groups.map(({ materialIndex }) => materialIndex)).toEqual([0, 1, 2, 3, 4, 5]);
    itemsOf(made.getAttribute('local')).forEach((local, v) => {
      const [point] = pointsOf(made, [v]);
      expect(point.distanceTo(new Vector3(...local))).toBeLessThan(2e-3);
    });
    expect(toMesh(convert(from), from).geometry.groups).toHaveLength(6);
  }
});

test('with transforms, mirrored instances and bones, each corner gets what it had', () => {
  const mesh = new InstancedMesh(withLocal(new BoxGeometry(1, 2, 3, 2, 2, 2)), materials(1)[0], 2);
  const places = [
    new Matrix4().makeScale(-1, 2, 1).setPosition(5, 0, 0),
    new Matrix4().makeRotationX(1).setPosition(-5, 0, 0),
  ];
  places.forEach((place, i) => mesh.setMatrixAt(i, place));
  mesh.rotation.y = 0.5;
  const from = fromObject3D(new Group().add(mesh));
  const geometry = toBufferGeometry(convert(from), { from });
  const seen = [0, 0];
  itemsOf(geometry.getAttribute('local')).forEach((local, v) => {
    const [point] = pointsOf(geometry, [v]);
    const far = places.map((place) =>
      new Vector3(...local).applyMatrix4(place).applyMatrix4(mesh.matrixWorld).distanceTo(point),
    );
    const instance = far[0] < far[1] ? 0 : 1;
    ++seen[instance];
    expect(far[instance]).toBeLessThan(0.02);
  });
  expect(Math.min(...seen)).toBeGreaterThanOrEqual(8);
});

test('what only some meshes have is 0 for the others, and colours are white', () => {
  const group = new Group();
  const plain = square().setAttribute(
    'color',
    new BufferAttribute(new Float32Array(16).fill(0.5), 4),
  );
  plain.setAttribute('uv', new BufferAttribute(new Float32Array(8).fill(0.25), 2));
  const bare = new Mesh(square());
  const pink = square().setAttribute(
    'color',
    new BufferAttribute(new Float32Array(12).fill(0.75), 3),
  );
  const heavy = square().setAttribute(
    'weight',
    new BufferAttribute(new Float32Array(4).fill(7), 1),
  );
  group.add(new Mesh(plain), bare, new Mesh(pink), new Mesh(heavy));
  const from = fromObject3D(group);
  const geometry = toBufferGeometry(asResult(from), { from });
  expect(Object.keys(geometry.attributes).sort()).toEqual(['color', 'position', 'uv', 'weight']);
  const firsts = [0, 4, 8, 12];
  const at = (name) => firsts.map((v) => itemsOf(geometry.getAttribute(name))[v]);
  expect(at('color')).toEqual([
    [0.5, 0.5, 0.5, 0.5],
    [1, 1, 1, 1],
    [0.75, 0.75, 0.75, 1],
    [1, 1, 1, 1],
  ]);
  expect(at('uv')).toEqual([
    [0.25, 0.25],
    [0, 0],
    [0, 0],
    [0, 0],
  ]);
  expect(at('weight')).toEqual([[0], [0], [0], [7]]);
});

test('attributes of all kinds: quantised, interleaved, half, wide, and numbers of things', () => {
  const geometry = square();
  geometry.setAttribute(
    'uv',
    new BufferAttribute(Uint16Array.of(0, 0, 65535, 0, 0, 65535, 65535, 65535), 2, true),
  );
  geometry.setAttribute(
    'uv1',
    new BufferAttribute(Uint8Array.of(0, 0, 200, 0, 0, 200, 200, 200), 2),
  );
  const data = new InterleavedBuffer(Int8Array.of(9, 127, 9, -128, 9, 0, 9, 127), 2);
  geometry.setAttribute('wave', new InterleavedBufferAttribute(data, 1, 1, true));
  geometry.setAttribute(
    'half',
    new Float16BufferAttribute(Uint16Array.of(0x3c00, 0x4000, 0, 0xbc00), 1),
  );
  geometry.setAttribute(
    'wide',
    new BufferAttribute(
      new Float32Array(20).map((_, i) => i),
      5,
    ),
  );
  geometry.setAttribute('part', new BufferAttribute(Uint16Array.of(7, 7, 9, 7), 1));
  const from = fromObject3D(new Mesh(geometry));
  const result = asResult(from);
  // One corner moves to the middle of its triangle, off the surface.
  result.positions.set([0.25, 0.25, 3]);
  const made = toBufferGeometry(result, { from });
  const all = (name) =>
    itemsOf(made.getAttribute(name)).map((item) => item.map((v) => expect.closeTo(v, 5)));
  const close = (...items) => items.map((item) => item.map((v) => expect.closeTo(v, 5)));
  expect(all('uv')).toEqual(close([0.25, 0.25], [1, 0], [0, 1], [1, 1]));
  expect(all('uv1')).toEqual(close([50, 50], [200, 0], [0, 200], [200, 200]));
  expect(all('wave')).toEqual(close([0.5 - 0.25], [-1], [0], [1]));
  expect(all('half')).toEqual(close([0.5 + 0.5], [2], [0], [-1]));
  expect(all('wide')[0]).toEqual(close([3.75, 4.75, 5.75, 6.75, 7.75])[0]);
  expect(made.getAttribute('part').array).toEqual(Uint16Array.of(7, 7, 9, 7));
  expect(made.getAttribute('uv').array).toBeInstanceOf(Float32Array);
  expect(made.getAttribute('uv').normalized).toBe(false);
});

test('colours of instances are multiplied, and shown', () => {
  const geometry = square();
  geometry.setAttribute('color', new BufferAttribute(new Float32Array(12).fill(0.5), 3));
  const [plain, showing] = materials(2);
  showing.vertexColors = true;
  for (const [material, base] of [
    [plain, 1],
    [showing, 0.5],
  ]) {
    const mesh = new InstancedMesh(geometry, material, 2);
    [0, 1].forEach((i) => mesh.setMatrixAt(i, new Matrix4().makeTranslation(3 * i, 0, 0)));
    mesh.setColorAt(0, new Color(1, 0, 0));
    mesh.setColorAt(1, new Color(0, 0.5, 1));
    const uncoloured = new Mesh(square(), material);
    const from = fromObject3D(new Group().add(mesh, uncoloured));
    const shown = toMesh(asResult(from), from);
    const colours = itemsOf(shown.geometry.getAttribute('color'));
    expect([0, 4, 8].map((v) => colours[v])).toEqual([
      [base, 0, 0],
      [0, base / 2, base],
      [1, 1, 1],
    ]);
    expect([shown.material].flat().map((own) => own.vertexColors)).toEqual(
      material === plain ? [true, false] : [true, true],
    );
    expect(plain.vertexColors).toBe(false);
  }
});

test('attributes of instances and morphed colours', () => {
  const geometry = square();
  geometry.setAttribute('seed', new InstancedBufferAttribute(Float32Array.of(3, 4), 1));
  const mesh = new InstancedMesh(geometry, materials(1)[0], 2);
  [0, 1].forEach((i) => mesh.setMatrixAt(i, new Matrix4().makeTranslation(3 * i, 0, 0)));
  const from = fromObject3D(mesh);
  const made = toBufferGeometry(asResult(from), { from });
  expect([...made.getAttribute('seed').array]).toEqual([3, 3, 3, 3, 4, 4, 4, 4]);

  const morphing = square();
  morphing.setAttribute('color', new BufferAttribute(new Float32Array(12).fill(0.5), 3));
  morphing.morphAttributes.color = [new BufferAttribute(new Float32Array(12).fill(1), 3)];
  const morphed = new Mesh(morphing);
  morphed.morphTargetInfluences = [0.5];
  const source = fromObject3D(morphed);
  const { color } = toBufferGeometry(asResult(source), { from: source }).attributes;
  expect([...color.array]).toEqual(new Array(12).fill(0.75));
});

test('what belongs to the old surface stays there', () => {
  const geometry = new BoxGeometry();
  const count = geometry.getAttribute('position').count;
  for (const name of ['tangent', 'skinIndex', 'skinWeight']) {
    geometry.setAttribute(name, new BufferAttribute(new Float32Array(4 * count), 4));
  }
  geometry.morphAttributes.position = [geometry.getAttribute('position').clone()];
  const from = fromObject3D(new Mesh(geometry));
  const made = toBufferGeometry(convert(from), { from });
  expect(Object.keys(made.attributes).sort()).toEqual(['position', 'uv']);
  expect(made.morphAttributes).toEqual({});
  const named = toBufferGeometry(convert(from), { from, attributes: [] });
  expect(Object.keys(named.attributes)).toEqual(['position']);
  expect(named.getAttribute('position').count).toBe(8);
});

test('what closes a hole takes after its neighbours', () => {
  const box = withLocal(new BoxGeometry(1, 1, 1, 8, 8, 8));
  const { array } = box.getIndex();
  const own = materials(3);
  box.clearGroups();
  // The side +x is missing, and everything else has material 2.
  box.setIndex([...array].slice(array.length / 6));
  box.addGroup(0, Infinity, 2);
  const from = fromObject3D(new Mesh(box, own));
  const result = convert(from);
  expect(result.sourceFaces).toContain(0xffffffff);
  const geometry = toBufferGeometry(result, { from });
  expect(geometry.groups).toEqual([{ start: 0, count: result.indices.length, materialIndex: 2 }]);
  // On the lid, the values of the hole's rim.
  const extents = itemsOf(geometry.getAttribute('local')).map((local) =>
    Math.max(...local.map(Math.abs)),
  );
  expect(Math.min(...extents)).toBeCloseTo(0.5, 2);
});

test('normals of the result and attributes of the source together', () => {
  const from = fromObject3D(new Mesh(new BoxGeometry(1, 1, 1, 2, 2, 2), materials(6)));
  const geometry = toBufferGeometry(convert(from, {}, { normals: true }), { from });
  expect(geometry.getAttribute('position').count).toBe(24);
  visitTriangles(geometry, (material, vertices) => {
    const normal = normalOf(geometry, vertices);
    for (const own of pointsOf(geometry, vertices, 'normal'))
      expect(own.dot(normal)).toBeCloseTo(1, 3);
  });
});

test('corners beyond their source triangle find what continues it, but no other material', () => {
  const result = {
    positions: Float32Array.of(0, 0, 0, 1, 0.9, 0, 0, 1, 0),
    indices: Uint32Array.of(0, 1, 2),
    sourceFaces: Uint32Array.of(0),
  };
  const geometry = withLocal(square());
  geometry.addGroup(0, 3, 0);
  geometry.addGroup(3, 3, 1);
  const second = (object) =>
    itemsOf(toBufferGeometry(result, { from: fromObject3D(object) }).getAttribute('local'))[1];
  const close = (...item) => item.map((v) => expect.closeTo(v, 6));
  expect(second(new Mesh(geometry))).toEqual(close(1, 0.9, 0));
  // Along the border of the first material.
  expect(second(new Mesh(geometry, materials(2)))).toEqual(close(0.55, 0.45, 0));
});

test('the way round a vertex leads to the other side, however many triangles there are', () => {
  const count = 30_000;
  const positions = new Float32Array(3 * count + 3);
  const disc = new BufferGeometry();
  const indices = [];
  for (let i = 0; i < count; ++i) {
    const angle = (2 * Math.PI * i) / count;
    positions.set([Math.cos(angle), Math.sin(angle), 0], 3 * i + 3);
    indices.push(0, i + 1, ((i + 1) % count) + 1);
  }
  disc.setAttribute('position', new BufferAttribute(positions, 3)).setIndex(indices);
  const from = fromObject3D(withLocal(disc));
  const result = {
    positions: Float32Array.of(-0.5, 0.1, 0.2, 0, 0, 0, 0.3, -0.4, 0.2),
    indices: Uint32Array.of(0, 1, 2),
    sourceFaces: Uint32Array.of(0),
  };
  const close = (...item) => item.map((v) => expect.closeTo(v, 6));
  expect(itemsOf(toBufferGeometry(result, { from }).getAttribute('local'))).toEqual([
    close(-0.5, 0.1, 0),
    close(0, 0, 0),
    close(0.3, -0.4, 0),
  ]);
});

test('there is no seam in a fold, where each side has a nearest point of its own', () => {
  const positions = Float32Array.of(0, 0, 0, 0, 1, 0, -1, 0.5, 1, 1, 0.5, 1);
  const valley = square().setAttribute('position', new BufferAttribute(positions, 3));
  valley.setIndex([0, 1, 2, 1, 0, 3]);
  const result = {
    positions: Float32Array.of(0, 0.3, 0.2, 0, 0.7, 0.2, -1, 0.5, 1, 1, 0.5, 1),
    indices: Uint32Array.of(0, 1, 2, 1, 0, 3),
    sourceFaces: Uint32Array.of(0, 1),
  };
  const verticesOf = (geometry) => {
    const from = fromObject3D(withLocal(geometry));
    return itemsOf(toBufferGeometry(result, { from }).getAttribute('local')).length;
  };
  expect(verticesOf(valley)).toBe(4);
  // But there is if the sides are different.
  const torn = valley.toNonIndexed();
  torn.setAttribute('side', new BufferAttribute(Float32Array.of(0, 0, 0, 1, 1, 1), 1));
  expect(verticesOf(torn)).toBe(6);
});

test('a wider tolerance leaves seams out', () => {
  const geometry = square().toNonIndexed();
  const uv = Float32Array.of(0, 0, 1, 0, 0, 1, 1, 0.01, 1, 1, 0, 1.01);
  geometry.setAttribute('uv', new BufferAttribute(uv, 2));
  const from = fromObject3D(new Mesh(geometry));
  const result = {
    positions: Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0),
    indices: Uint32Array.of(0, 1, 2, 1, 3, 2),
    sourceFaces: Uint32Array.of(0, 1),
  };
  const vertices = (options) =>
    toBufferGeometry(result, { from, ...options }).getAttribute('position').count;
  expect([{}, { seamTolerance: 0.02 }].map(vertices)).toEqual([6, 4]);
});

test('through a shell and the worker', async () => {
  const sheet = withLocal(square());
  sheet.addGroup(0, 3, 1);
  sheet.addGroup(3, 3, 0);
  const from = fromObject3D(new Mesh(sheet, materials(2)));
  const shell = kdm.thicken(from, 0.1);
  const { mesh } = await makeManifold(shell, { strategy: 'uniform', depth: 15 });
  const geometry = toBufferGeometry(mesh, { from });
  const counts = geometry.groups.map(({ materialIndex, count }) => [materialIndex, count > 0]);
  expect(counts).toEqual([
    [0, true],
    [1, true],
  ]);
  itemsOf(geometry.getAttribute('local')).forEach((local, v) => {
    const [point] = pointsOf(geometry, [v]);
    expect(point.distanceTo(new Vector3(...local))).toBeLessThan(0.16);
  });
});
