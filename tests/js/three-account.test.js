// SPDX-License-Identifier: MIT
// What one should know of a result reaches those who use three.js.
import { BoxGeometry, Group, InstancedMesh, Matrix4, Mesh, PlaneGeometry } from 'three';
import { makeManifold } from '../../dist/index.js';
import { findLost, fromObject3D, toMesh } from '../../dist/three.js';

// A box with sheets that stand on it and bound nothing.
function boxWithFins() {
  const group = new Group();
  const box = new Mesh(new BoxGeometry(2, 2, 2));
  box.name = 'box';
  const fins = new InstancedMesh(new PlaneGeometry(1, 1), undefined, 3);
  fins.name = 'fins';
  fins.setMatrixAt(0, new Matrix4().makeTranslation(0, 1.5, -0.5));
  fins.setMatrixAt(1, new Matrix4().makeTranslation(0, 0, 0)); // within the box
  fins.setMatrixAt(2, new Matrix4().makeTranslation(0, 1.5, 0.5));
  return group.add(box, fins);
}

test('the account goes along with the object, and into files', async () => {
  const from = fromObject3D(boxWithFins());
  const { mesh, report } = await makeManifold(from, { check: true });
  expect(report.lost.area).toBeCloseTo(2, 1);
  const object = toMesh(mesh, from, { report });
  const { faces, ...lost } = report.lost;
  expect(faces).toHaveLength(4);
  const account = { lost, error: report.error, warnings: report.warnings };
  expect(object.userData).toEqual({ kdmanifold: account });
  expect(object.toJSON().object.userData).toEqual({ kdmanifold: account });
  expect(['AREA_LOST', 'PARTS_LOST']).toContain(object.userData.kdmanifold.warnings[0].code);
  expect(toMesh(mesh, from).userData).toEqual({});
  expect(() => toMesh(mesh, from, { reports: report })).toThrow('reports: no such option');
});

test('objects that lack something are named', async () => {
  const from = fromObject3D(boxWithFins());
  const { report } = await makeManifold(from);
  const lost = findLost(from, report);
  expect(lost.map(({ object, instance }) => [object.name, instance])).toEqual([
    ['fins', 0],
    ['fins', 2],
  ]);
  expect(lost.map(({ triangles }) => [...triangles])).toEqual([
    [12, 13],
    [16, 17],
  ]);
  const whole = fromObject3D(new Mesh(new BoxGeometry()));
  expect(findLost(whole, (await makeManifold(whole)).report)).toEqual([]);
});
