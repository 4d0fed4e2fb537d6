// SPDX-License-Identifier: MIT
// Meshes of three.js objects: where their triangles are, which are there, and what is told of the rest.
import {
  Bone,
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  Group,
  InstancedMesh,
  InterleavedBuffer,
  InterleavedBufferAttribute,
  Line,
  LOD,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  Object3D,
  PlaneGeometry,
  Points,
  REVISION,
  Scene,
  Skeleton,
  SkinnedMesh,
  Sprite,
  Vector3,
} from 'three';
import { load } from '../../dist/index.js';
import { fromObject3D } from '../../dist/three.js';
import { faults, volume } from './support/meshes.js';
import { square } from './support/three-source.js';

const box = () => new Mesh(new BoxGeometry(1, 2, 3));
const reasons = ({ skipped }) => skipped.map(({ name, reason }) => `${name}: ${reason}`);

function named(object, name) {
  object.name = name;
  return object;
}

test('runs with the three.js that it is meant for', () => {
  expect(REVISION === '150').toBe(globalThis.oldestThree ?? false);
});

test('world matrices count, those of parents too, in 64 bits', () => {
  const group = new Group();
  group.position.set(1e7, 0, 0);
  const inner = new Group();
  inner.rotation.z = Math.PI / 2;
  const mesh = box();
  mesh.position.set(0, 0, 0.25);
  group.add(inner.add(mesh));
  new Scene().add(group);
  // Also if only the mesh is given.
  for (const object of [group, mesh]) {
    const { positions } = fromObject3D(object);
    expect(positions).toBeInstanceOf(Float64Array);
    const [xs, ys, zs] = [0, 1, 2].map((c) => positions.filter((_, i) => i % 3 === c));
    // 32 bits tell 1e7 + 1 from 1e7 + 0, but not the rounding of the rotation.
    expect(Math.max(...xs) - 1e7).toBeCloseTo(1, 7);
    expect(Math.max(...ys)).toBeCloseTo(0.5, 12);
    expect([Math.min(...zs), Math.max(...zs)]).toEqual([-1.25, 1.75]);
  }
});

test('mirrored objects keep their outside outside', () => {
  const mesh = box();
  mesh.scale.x = -2;
  expect(volume(fromObject3D(mesh))).toBeCloseTo(12, 9);
  // Twice mirrored is not mirrored.
  const group = new Group().add(mesh);
  group.scale.z = -1;
  expect(volume(fromObject3D(group))).toBeCloseTo(12, 9);
});

test('a group becomes one mesh, and with it a solid', async () => {
  const group = new Group();
  for (const x of [0, 0.5]) {
    const mesh = box();
    mesh.position.x = x;
    mesh.scale.y = -1;
    group.add(mesh);
  }
  const kdm = await load();
  const grid = kdm.buildGrid(fromObject3D(group));
  const result = grid.extract();
  grid.delete();
  expect(faults(result)).toEqual([]);
  expect(volume(result)).toBeCloseTo(9, 3);
});

test('every instance up to the count is there, mirrored ones turned', () => {
  const mesh = named(new InstancedMesh(new BoxGeometry(), new MeshBasicMaterial(), 4), 'many');
  const flat = new Matrix4().makeScale(1, 0, 1);
  mesh.setMatrixAt(0, new Matrix4().makeTranslation(0.5, 0, 0));
  mesh.setMatrixAt(1, new Matrix4().makeScale(-1, 1, 1).setPosition(3, 0, 0));
  mesh.setMatrixAt(2, flat);
  mesh.count = 3;
  mesh.position.y = 10;
  const from = fromObject3D(mesh);
  expect(from.indices).toHaveLength(2 * 36);
  expect(volume(from)).toBeCloseTo(2, 9);
  const part = (first) => ({
    positions: from.positions,
    indices: from.indices.slice(first, first + 36),
  });
  expect([0, 36].map((first) => volume(part(first)))).toEqual(
    [1, 1].map((v) => expect.closeTo(v, 9)),
  );
  expect(from.source.parts.map(({ instance, object }) => [instance, object.name])).toEqual([
    [0, 'many'],
    [1, 'many'],
  ]);
  expect(Math.min(...from.positions.filter((_, i) => i % 3 === 1))).toBe(9.5);
  expect(Math.max(...from.positions.filter((_, i) => i % 3 === 0))).toBe(3.5);
  expect(reasons(from)).toEqual([
    'InstancedMesh "many", instance 2: its matrix scales it to nothing',
  ]);
});

test('only what the draw range holds is there, with only its vertices', () => {
  const geometry = new PlaneGeometry(1, 1, 4, 1);
  geometry.getAttribute('position').array.fill(NaN, 0, 3); // not used within the draw range
  geometry.setDrawRange(6, 12);
  const from = fromObject3D(new Mesh(geometry));
  expect(from.indices).toHaveLength(12);
  expect(from.positions).toHaveLength(3 * 6);
  const corners = [...from.indices].map((i) => from.source.vertices[i]);
  expect(corners).toEqual([...geometry.getIndex().array.slice(6, 18)]);
  const soup = new PlaneGeometry(1, 1, 4, 1).toNonIndexed();
  soup.setDrawRange(3, Infinity);
  expect(fromObject3D(new Mesh(soup)).indices).toHaveLength(21);
});

test('with several materials, what is in the draw range and in a group of one is there', () => {
  const geometry = new PlaneGeometry(1, 1, 4, 1); // 24 corners
  geometry.addGroup(0, 6, 1);
  geometry.addGroup(6, 6, 7);
  geometry.addGroup(12, 6, 0);
  geometry.setDrawRange(3, 18);
  const materials = [new MeshBasicMaterial(), new MeshBasicMaterial()];
  const mesh = named(new Mesh(geometry, materials), 'strip');
  const from = fromObject3D(mesh);
  expect([...from.source.materialIndices]).toEqual([1, 0, 0]);
  expect([...from.indices].map((i) => from.source.vertices[i])).toEqual([
    ...geometry.getIndex().array.slice(3, 6),
    ...geometry.getIndex().array.slice(12, 18),
  ]);
  expect(from.source.materials).toEqual(materials);
  expect(reasons(from)).toEqual([
    'Mesh "strip": group 1: there is no material 7',
    'Mesh "strip": 3 corners of triangles are in no group, so no material draws them',
  ]);
  // A single material does not look at groups.
  mesh.material = materials[0];
  expect(fromObject3D(mesh).indices).toHaveLength(18);
});

test('morph targets are applied as they are now', () => {
  for (const relative of [false, true]) {
    const geometry = square();
    const target = (z) =>
      new BufferAttribute(
        new Float32Array(12).map((_, i) => (i % 3 === 2 ? z : 0)),
        3,
      );
    geometry.morphAttributes.position = [target(1), target(10)];
    geometry.morphTargetsRelative = relative;
    const mesh = new Mesh(geometry);
    mesh.morphTargetInfluences = [0.5, 0.25];
    const { positions } = fromObject3D(mesh);
    const keep = relative ? 1 : 0.25;
    expect([...positions]).toEqual([0, 0, 3, keep, 0, 3, 0, keep, 3, keep, keep, 3]);
  }
});

test('skinned meshes are posed by their bones, wherever these are', () => {
  const geometry = square();
  const indices = Uint16Array.of(0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0);
  const weights = Float32Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0.5, 0.5, 0, 0, 0, 1, 0, 0);
  geometry.setAttribute('skinIndex', new BufferAttribute(indices, 4));
  geometry.setAttribute('skinWeight', new BufferAttribute(weights, 4));
  geometry.morphAttributes.position = [new BufferAttribute(new Float32Array(12).fill(1), 3)];
  geometry.morphTargetsRelative = true;
  const mesh = new SkinnedMesh(geometry);
  mesh.morphTargetInfluences = [2];
  const bones = [new Bone(), new Bone()];
  const elsewhere = new Group().add(...bones);
  mesh.bind(new Skeleton(bones), new Matrix4());
  mesh.bindMode = 'detached';
  bones[1].position.z = 4;
  elsewhere.position.x = 8; // nobody has updated its matrix yet
  const { positions } = fromObject3D(mesh);
  expect([...positions]).toEqual([10, 2, 2, 11, 2, 6, 10, 3, 4, 11, 3, 6]);
  expect(() => fromObject3D(named(new SkinnedMesh(square()), 'arm'))).toThrow(
    'SkinnedMesh "arm": it is skinned, but has no attributes "skinIndex" and "skinWeight"',
  );
});

test('a skinned mesh that moves with its bones stays with them', () => {
  const geometry = square();
  geometry.setAttribute('skinIndex', new BufferAttribute(new Uint8Array(16), 4));
  const weights = new Uint8Array(16).map((_, i) => (i % 4 === 0 ? 255 : 0));
  geometry.setAttribute('skinWeight', new BufferAttribute(weights, 4, true));
  const mesh = new SkinnedMesh(geometry);
  const bone = new Bone();
  mesh.add(bone);
  mesh.bind(new Skeleton([bone]));
  mesh.position.x = 5;
  bone.position.z = 1;
  expect([...fromObject3D(mesh).positions]).toEqual([5, 0, 1, 6, 0, 1, 5, 1, 1, 6, 1, 1]);
});

test('instances may be morphed each on its own', () => {
  const geometry = square();
  const up = Float32Array.of(0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1);
  geometry.morphAttributes.position = [new BufferAttribute(up, 3)];
  geometry.morphTargetsRelative = true;
  const mesh = new InstancedMesh(geometry, new MeshBasicMaterial(), 2);
  for (const i of [0, 1]) mesh.setMatrixAt(i, new Matrix4());
  if (typeof mesh.setMorphAt !== 'function') return; // not in old versions
  for (const i of [0, 1]) mesh.setMorphAt(i, { morphTargetInfluences: [i + 1] });
  const { positions } = fromObject3D(mesh);
  expect([...positions.filter((_, i) => i % 3 === 2)]).toEqual([1, 1, 1, 1, 2, 2, 2, 2]);
});

test('of levels of detail the finest is taken, whichever is shown', () => {
  const lod = named(new LOD(), 'tree');
  lod.addLevel(named(new Mesh(new BoxGeometry(1, 1, 1)), 'coarse'), 10);
  lod.addLevel(named(new Mesh(new BoxGeometry(1, 1, 1, 2, 2, 2)), 'fine'), 0);
  const [fine, coarse] = lod.levels.map(({ object }) => object);
  fine.visible = false;
  const from = fromObject3D(lod);
  expect(from.source.parts.map(({ object }) => object)).toEqual([fine]);
  expect(reasons(from)).toEqual(['Mesh "coarse": level 1 of LOD "tree": the finest one is taken']);
  expect(from.skipped[0].object).toBe(coarse);
});

test('what has no surface, or is not visible, is told', () => {
  const group = new Group();
  const hidden = named(new Group().add(box()), 'hidden');
  hidden.visible = false;
  const glass = named(new Mesh(square(), new MeshBasicMaterial({ visible: false })), 'glass');
  group.add(
    box(),
    named(new Line(square()), 'line'),
    named(new Points(square()), 'points'),
    named(new Sprite(), 'sprite'),
    hidden,
    glass,
    new Bone(),
    named(new Mesh(), 'empty'),
    named(Object.assign(new Mesh(), { isLineSegments2: true }), 'fat'),
  );
  const unseen = ['Group "hidden": not visible', 'Mesh "glass": its material is not visible'];
  const others = [
    'Line "line": lines have no surface',
    'Points "points": points have no surface',
    'Sprite "sprite": a sprite has no surface of its own',
    'Mesh "fat": lines have no surface',
    'Mesh "empty": its geometry is empty',
  ];
  const from = fromObject3D(group);
  expect(from.indices).toHaveLength(36);
  expect(reasons(from).sort()).toEqual([...unseen, ...others].sort());
  const all = fromObject3D(group, { onlyVisible: false });
  expect(all.indices).toHaveLength(36 + 36 + 6);
  expect(reasons(all).sort()).toEqual(others.sort());
});

test('interleaved and quantised positions', () => {
  // As KHR_mesh_quantization has them: whole numbers, normalised or not, scaled by the node.
  const data = new InterleavedBuffer(new Int16Array(4 * 6), 6);
  const corners = [
    [0, 0, 0],
    [32767, 0, 0],
    [0, 32767, 0],
    [32767, 32767, -32768],
  ];
  corners.forEach((corner, i) => data.array.set(corner, 6 * i + 2));
  for (const [normalized, unit] of [
    [true, 1],
    [false, 32767],
  ]) {
    const geometry = new BufferGeometry().setIndex([0, 1, 2, 1, 3, 2]);
    geometry.setAttribute('position', new InterleavedBufferAttribute(data, 3, 2, normalized));
    const mesh = new Mesh(geometry);
    mesh.scale.setScalar(1 / unit);
    const expected = [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, normalized ? -1 : -32768 / 32767];
    expect([...fromObject3D(mesh).positions]).toEqual(expected.map((v) => expect.closeTo(v, 12)));
  }
});

test('a geometry alone: its draw range, and its groups for numbers of materials', () => {
  const geometry = new BoxGeometry();
  expect(fromObject3D(geometry).indices).toHaveLength(36);
  geometry.setDrawRange(6, 12);
  const from = fromObject3D(geometry);
  expect(from.indices).toHaveLength(12);
  expect([...from.source.materialIndices]).toEqual([1, 1, 2, 2]);
  expect(from.source.parts[0].object).toBeNull();
});

test('objects of another copy of three.js are welcome', async () => {
  const other = await import(
    globalThis.oldestThree ? '../../node_modules/three/build/three.module.js' : 'three-oldest'
  );
  expect(other.Mesh).not.toBe(Mesh);
  const group = new other.Group();
  const mesh = new other.InstancedMesh(new other.BoxGeometry(), new other.MeshBasicMaterial(), 2);
  for (const i of [0, 1]) mesh.setMatrixAt(i, new other.Matrix4().makeTranslation(2 * i, 0, 0));
  group.add(mesh, new other.Line(new other.BoxGeometry()));
  group.scale.y = -3;
  const from = fromObject3D(group);
  expect(volume(from)).toBeCloseTo(6, 9);
  expect(from.skipped).toHaveLength(1);
  const arm = new other.SkinnedMesh(new other.BoxGeometry());
  const count = arm.geometry.getAttribute('position').count;
  arm.geometry.setAttribute('skinIndex', new other.BufferAttribute(new Uint8Array(4 * count), 4));
  const weights = new Float32Array(4 * count).map((_, i) => (i % 4 === 0 ? 1 : 0));
  arm.geometry.setAttribute('skinWeight', new other.BufferAttribute(weights, 4));
  const bone = new other.Bone();
  arm.add(bone);
  arm.bind(new other.Skeleton([bone]));
  bone.scale.set(2, 2, 2);
  expect(volume(fromObject3D(arm))).toBeCloseTo(8, 9);
});

test('the object is not changed, but for its world matrices', () => {
  const mesh = box();
  mesh.position.x = 3;
  const before = [...mesh.geometry.getAttribute('position').array];
  fromObject3D(new Object3D().add(mesh));
  expect([...mesh.geometry.getAttribute('position').array]).toEqual(before);
  expect(mesh.matrixWorld.elements[12]).toBe(3);
  expect(new Vector3().setFromMatrixPosition(mesh.matrix).x).toBe(3);
});
