// SPDX-License-Identifier: MIT
// What the three.js adapter refuses, and how it says so.
import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  Group,
  InstancedBufferGeometry,
  InstancedMesh,
  Line,
  Mesh,
  MeshBasicMaterial,
  SkinnedMesh,
  Texture,
} from 'three';
import { load, makeManifold } from '../../dist/index.js';
import { fromBufferGeometry, fromObject3D, toBufferGeometry, toMesh } from '../../dist/three.js';
import { asResult, failure, square } from './support/three-source.js';

const named = (geometry, name = 'part') => Object.assign(new Mesh(geometry), { name });
const inGroup = (mesh) => new Group().add(new Mesh(new BoxGeometry()), mesh);
const reason = (mesh) => failure(() => fromObject3D(inGroup(mesh)));

test('what is no object of three.js', () => {
  const expected = 'expected an Object3D or a BufferGeometry of three.js, got';
  const kinds = [
    [undefined, 'undefined'],
    [null, 'null'],
    [7, 'number'],
    ['scene', 'string'],
    [[new Mesh()], 'an object of class Array'],
    [{ positions: new Float32Array(9) }, 'an object of class Object'],
    [new MeshBasicMaterial(), 'an object of type "MeshBasicMaterial"'],
  ];
  for (const [value, kind] of kinds) {
    expect(failure(() => fromObject3D(value))).toBe(`INVALID_MESH: object: ${expected} ${kind}`);
  }
  expect(failure(() => fromObject3D(new Texture()))).toMatch(/^INVALID_MESH: object: expected/);
  expect(failure(() => fromBufferGeometry(new Mesh(square())))).toBe(
    'INVALID_MESH: geometry: expected a BufferGeometry of three.js, got an object of type "Mesh"; use fromObject3D',
  );
  expect(failure(() => fromBufferGeometry(undefined))).toMatch(/^INVALID_MESH: .* got undefined$/);
});

test('objects without any surface', () => {
  const empty = Object.assign(new Group(), { name: 'empty' });
  expect(failure(() => fromObject3D(empty))).toBe(
    'INVALID_MESH: Group "empty": there is no mesh in it',
  );
  empty.add(Object.assign(new Line(square()), { name: 'rim' }), new Mesh());
  expect(failure(() => fromObject3D(empty))).toBe(
    'INVALID_MESH: Group "empty": nothing in it has a surface that is drawn ' +
      '(Line "rim": lines have no surface, and 1 more)',
  );
  const hidden = named(square(), 'ghost');
  hidden.visible = false;
  expect(failure(() => fromObject3D(hidden))).toMatch('(Mesh "ghost": not visible)');
  expect(failure(() => fromObject3D(new BufferGeometry()))).toMatch('no attribute "position"');
  expect(failure(() => fromObject3D(square().setIndex([])))).toMatch('no triangle');
});

test('geometries that are broken, by the name of their object', () => {
  const broken = (change) => {
    const geometry = square();
    change(geometry);
    return reason(named(geometry));
  };
  expect(broken((g) => g.setIndex([0, 1, 2, 1, 3]))).toBe(
    'INVALID_MESH: Mesh "part": 5 indices are to be drawn, which is not a multiple of 3',
  );
  expect(broken((g) => g.setIndex(null))).toBe(
    'INVALID_MESH: Mesh "part": 4 vertices are to be drawn, which is not a multiple of 3',
  );
  expect(broken((g) => g.setIndex([0, 1, 2, 1, 3, 4]))).toBe(
    'INVALID_MESH: Mesh "part": index[5] is 4, but there are only 4 vertices',
  );
  expect(broken((g) => g.getAttribute('position').setY(3, NaN))).toBe(
    'INVALID_MESH: Mesh "part": coordinate y of vertex 3 is NaN',
  );
  expect(
    broken((g) =>
      g.deleteAttribute('position').setAttribute('uv', new BufferAttribute(new Float32Array(2), 2)),
    ),
  ).toBe('INVALID_MESH: Mesh "part": its geometry has no attribute "position"');
  expect(
    broken((g) => g.setAttribute('position', new BufferAttribute(new Float32Array(8), 2))),
  ).toBe('INVALID_MESH: Mesh "part": its attribute "position" has 2 numbers per vertex, not 3');
  expect(broken((g) => (g.getAttribute('position').array = null))).toMatch(
    'Mesh "part", attribute "position": its numbers cannot be read',
  );
  expect(broken((g) => (g.getAttribute('position').count = 5))).toMatch(
    'Mesh "part", attribute "position": its array has 12 numbers, but 5 items need 15',
  );
  const unnamed = named(square().setIndex([0, 1]), '');
  expect(reason(unnamed)).toMatch(`Mesh ${unnamed.uuid}: 2 indices`);
});

test('objects that cannot be read, or are broken', () => {
  const batched = Object.assign(named(square()), { isBatchedMesh: true });
  expect(reason(batched)).toMatch(
    /^INVALID_MESH: BatchedMesh "part": .*invisible to leave it out$/,
  );
  batched.visible = false;
  expect(fromObject3D(inGroup(batched)).skipped).toHaveLength(1);
  const custom = new InstancedBufferGeometry().copy(square());
  expect(reason(named(custom))).toMatch(/^INVALID_MESH: Mesh "part": .*InstancedBufferGeometry/);
  expect(reason(Object.assign(named(square()), { geometry: {} }))).toBe(
    'INVALID_MESH: Mesh "part": its geometry is no BufferGeometry',
  );
  const away = named(square());
  away.position.x = NaN;
  expect(reason(away)).toMatch('Mesh "part": its matrix has numbers that are not finite');
  const few = Object.assign(new InstancedMesh(square(), new MeshBasicMaterial(), 2), { count: 3 });
  expect(reason(few)).toMatch(/InstancedMesh .*, instanceMatrix: it has 2 items for 3 instances/);
  const arm = new SkinnedMesh(square());
  arm.geometry.setAttribute('skinIndex', new BufferAttribute(new Uint8Array(16), 4));
  arm.geometry.setAttribute('skinWeight', new BufferAttribute(new Uint8Array(16), 4));
  expect(reason(arm)).toMatch('it is skinned, but has no skeleton');
  const morphed = named(square());
  morphed.geometry.morphAttributes.position = [new BufferAttribute(new Float32Array(3), 3)];
  morphed.morphTargetInfluences = [1];
  expect(reason(morphed)).toMatch('morph target 0 of "position": it has 1 items, not 4');
});

test('options', () => {
  const from = fromObject3D(new Mesh(square()));
  const result = asResult(from);
  const calls = [
    [() => fromObject3D(new Mesh(square()), { visible: true }), 'visible: no such option'],
    [
      () => fromObject3D(new Mesh(square()), { onlyVisible: 1 }),
      'onlyVisible: expected true or false',
    ],
    [() => fromObject3D(new Mesh(square()), null), 'options: expected an object, got null'],
    [() => toBufferGeometry(result, { form: from }), 'form: no such option'],
    [
      () => toBufferGeometry(result, { from, attributes: 'uv' }),
      'attributes: expected an array of names',
    ],
    [
      () => toBufferGeometry(result, { from, attributes: ['uv'] }),
      'attributes: "uv": none of the geometries has it',
    ],
    [
      () => toBufferGeometry(result, { from, attributes: ['normal'] }),
      'attributes: "normal": it belongs to the old surface only',
    ],
    [
      () => toBufferGeometry(result, { from, seamTolerance: -1 }),
      'seamTolerance: expected a number from 0 to 1',
    ],
  ];
  for (const [call, message] of calls) expect(failure(call)).toBe(`INVALID_OPTION: ${message}`);
});

test('results that were not made of what is given', async () => {
  const from = fromObject3D(new Mesh(new BoxGeometry()));
  const result = asResult(from);
  const { positions, indices } = result;
  const use = (mesh, source = from) => failure(() => toBufferGeometry(mesh, { from: source }));
  expect(use({ positions, indices })).toBe(
    'INVALID_MESH: the mesh has no sourceFaces, which `from` needs',
  );
  const sourceFaces = result.sourceFaces.slice();
  sourceFaces[5] = 12;
  expect(use({ ...result, sourceFaces })).toBe(
    'INVALID_MESH: sourceFaces[5] is 12, but `from` has only 12 triangles',
  );
  expect(use({ ...result, sourceFaces: sourceFaces.slice(1) })).toBe(
    'INVALID_MESH: sourceFaces: length 11, but there are 12 triangles',
  );
  for (const other of [null, {}, { positions, indices }, new Mesh()]) {
    expect(use(result, other)).toBe(
      'INVALID_MESH: from: expected what fromObject3D or fromBufferGeometry returned',
    );
  }
  expect(failure(() => toMesh(result))).toMatch('INVALID_MESH: from: expected');
  for (const wrong of [undefined, { mesh: result }, [1, 2, 3]]) {
    expect(use(wrong)).toMatch(/^INVALID_MESH: mesh: it has no positions, got /);
  }
  const { mesh } = await makeManifold(from, { transfer: true });
  expect(use(mesh)).toBe(
    'INVALID_MESH: from: it has 0 triangles, but was made with 12; with the option `transfer` its arrays are gone',
  );
});

test('attributes that cannot be read are refused, and may be left out', async () => {
  const geometry = new BoxGeometry().setAttribute(
    'heat',
    new BufferAttribute(new Float32Array(5), 1),
  );
  const from = fromObject3D(named(geometry));
  const grid = (await load()).buildGrid(from);
  const result = grid.extract();
  grid.delete();
  expect(failure(() => toBufferGeometry(result, { from }))).toBe(
    'INVALID_MESH: Mesh "part": attribute "heat" has 5 items, but number 6 is used',
  );
  const { attributes } = toBufferGeometry(result, { from, attributes: ['uv'] });
  expect(Object.keys(attributes)).toEqual(['position', 'uv']);
});
