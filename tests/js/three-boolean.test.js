// SPDX-License-Identifier: MIT
// Results of Boolean operations have the materials and attributes of all operands.
import {
  BoxGeometry,
  BufferAttribute,
  Color,
  Group,
  IcosahedronGeometry,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  SphereGeometry,
  Vector3,
} from 'three';
import { boolean, load } from '../../dist/index.js';
import { fromBufferGeometry, fromObject3D, toBufferGeometry, toMesh } from '../../dist/three.js';
import { failure } from './support/three-source.js';

const materials = (count) => Array.from({ length: count }, () => new MeshBasicMaterial());
const options = { relativeTolerance: 0.002 };

/** A box of side 2, a material a side, and a ball that takes its upper corner away. */
function boxAndBall() {
  const own = materials(6);
  const box = new Mesh(new BoxGeometry(2, 2, 2), own);
  const paint = new MeshBasicMaterial();
  const ball = new Mesh(new SphereGeometry(1, 32, 16), paint);
  ball.position.set(1, 1, 1);
  return { box, ball, own, paint };
}

/** Per triangle its material and the middle of its corners. */
function triangles({ geometry, material }) {
  const index = geometry.getIndex();
  const position = geometry.getAttribute('position');
  return geometry.groups.flatMap(({ start, count, materialIndex }) =>
    Array.from({ length: count / 3 }, (_, t) => {
      const corners = [0, 1, 2].map((k) => index.getX(start + 3 * t + k));
      const points = corners.map((v) => new Vector3().fromBufferAttribute(position, v));
      const middle = points[0].clone().add(points[1]).add(points[2]).divideScalar(3);
      return { material: [material].flat()[materialIndex], corners, middle };
    }),
  );
}

test('each part has the material of its operand, what is cut that of the operand that cuts', async () => {
  const { box, ball, own, paint } = boxAndBall();
  const from = [fromObject3D(box), fromObject3D(ball)];
  const { mesh } = await boolean('difference', from, options);
  const object = toMesh(mesh, from);
  expect(object.material).toEqual([...own, paint]);
  const all = triangles(object);
  expect(all).toHaveLength(mesh.indices.length / 3);
  expect(new Set(all.map(({ material }) => material)).size).toBe(7);
  const sides = [
    [1, 0, 0],
    [-1, 0, 0],
    [0, 1, 0],
    [0, -1, 0],
    [0, 0, 1],
    [0, 0, -1],
  ].map((side) => new Vector3(...side));
  for (const { material, middle } of all) {
    if (material === paint) {
      expect(Math.abs(middle.distanceTo(ball.position) - 1)).toBeLessThan(0.05);
    } else {
      expect(middle.dot(sides[own.indexOf(material)])).toBeCloseTo(1, 2);
    }
  }
});

test('attributes are those of the operands, at the places to which they were moved', async () => {
  const local = (geometry) =>
    geometry.setAttribute(
      'local',
      new BufferAttribute(geometry.attributes.position.array.slice(), 3),
    );
  const box = local(new BoxGeometry(2, 2, 2));
  const ball = local(new IcosahedronGeometry(1, 6));
  const from = [fromBufferGeometry(box), fromBufferGeometry(ball)];
  const shift = new Vector3(1, 1, 1);
  const transforms = [null, new Matrix4().makeTranslation(1, 1, 1).elements];
  const { mesh } = await boolean('union', from, { ...options, transforms });
  const geometry = toBufferGeometry(mesh, { from, transforms, attributes: ['local'] });
  const { position, local: carried } = geometry.attributes;
  // The box's six groups, then the ball, which has none.
  expect(geometry.groups.map(({ materialIndex }) => materialIndex)).toEqual([0, 1, 2, 3, 4, 5, 6]);
  const index = geometry.getIndex();
  let moved = 0;
  for (const { start, count, materialIndex } of geometry.groups) {
    for (let i = start; i < start + count; ++i) {
      const v = index.getX(i);
      const place = new Vector3().fromBufferAttribute(position, v);
      if (materialIndex === 6) place.sub(shift);
      const value = new Vector3().fromBufferAttribute(carried, v);
      expect(value.distanceTo(place)).toBeLessThan(0.02);
      moved += materialIndex === 6 ? 1 : 0;
    }
  }
  expect(moved).toBeGreaterThan(100);
  const all = toBufferGeometry(mesh, { from, transforms });
  expect(Object.keys(all.attributes).sort()).toEqual(['local', 'position', 'uv']);
});

test('a material that operands share is one, and then no groups are needed', async () => {
  const [material] = materials(1);
  const a = new Mesh(new BoxGeometry(2, 2, 2), material);
  const b = new Mesh(new BoxGeometry(2, 2, 2), material);
  b.position.x = 1;
  const from = [a, b].map((object) => fromObject3D(object));
  const { mesh } = await boolean('union', from, options);
  const object = toMesh(mesh, from);
  expect(object.material).toBe(material);
  expect(object.geometry.groups).toEqual([]);
  // Among others, it has one group for all.
  const group = new Group().add(a, new Mesh(new BoxGeometry(0.5, 0.5, 9), materials(1)[0]));
  const both = [fromObject3D(group), fromObject3D(b)];
  const second = toMesh((await boolean('union', both, options)).mesh, both);
  expect(second.material).toHaveLength(2);
  expect(second.geometry.groups).toHaveLength(2);
});

test('colours of one operand are white on the others, and quads are no obstacle', async () => {
  const kdm = await load();
  const box = new BoxGeometry(2, 2, 2);
  const colours = new Float32Array(box.attributes.position.count * 3).fill(0.25);
  box.setAttribute('color', new BufferAttribute(colours, 3));
  const from = [box, new SphereGeometry(1.25, 32, 16)].map((one) => fromBufferGeometry(one));
  const grid = kdm.buildBooleanGrid('union', from, options);
  const mesh = grid.extract({ quads: true });
  grid.delete();
  expect(mesh.quads.length).toBeGreaterThan(0);
  const { attributes } = toBufferGeometry(mesh, { from });
  const found = new Set();
  for (let v = 0; v < attributes.color.count; ++v) {
    found.add(new Color().fromBufferAttribute(attributes.color, v).r);
  }
  expect([...found].sort()).toEqual([0.25, 1]);
});

test('the box in which a complement is taken takes after its neighbours', async () => {
  const from = [fromBufferGeometry(new SphereGeometry(1, 16, 8))];
  const { mesh } = await boolean(['complement', 0], from, options);
  expect(mesh.sourceOperands.includes(0xffffffff)).toBe(true);
  expect(toBufferGeometry(mesh, { from }).attributes.uv.count).toBeGreaterThan(0);
});

test('says what does not fit', async () => {
  const { box, ball } = boxAndBall();
  const from = [fromObject3D(box), fromObject3D(ball)];
  const { mesh } = await boolean('difference', from, options);
  const fails = (given, others = {}, one = mesh) =>
    failure(() => toBufferGeometry(one, { from: given, ...others }));
  expect(fails([])).toBe('INVALID_MESH: from: expected one source at least');
  expect(fails([from[0]])).toMatch(/^INVALID_MESH: sourceOperands\[\d+\] is 1, but `from` has 1$/);
  expect(fails([from[1], from[0]])).toMatch(
    /^INVALID_MESH: sourceFaces\[\d+\] is \d+, but source 1 of `from` has only 12 triangles$/,
  );
  expect(fails([from[0], {}])).toMatch(/^INVALID_MESH: from: expected what fromObject3D/);
  expect(fails([from[0], fromBufferGeometry(ball.geometry)])).toMatch(
    /others of geometries alone$/,
  );
  expect(fails(from, { transforms: [null] })).toBe(
    'INVALID_OPTION: transforms: length 1, but there are 2 operands',
  );
  expect(fails(from[0], { transforms: [null] })).toBe(
    'INVALID_OPTION: transforms: only with an array of operands',
  );
  const { positions, indices, sourceFaces } = mesh;
  expect(fails(from, {}, { positions, indices, sourceFaces })).toBe(
    'INVALID_MESH: the mesh has no sourceOperands, which several sources need',
  );
});
