// SPDX-License-Identifier: MIT
// What `analyze` finds, in the numbers of the caller's arrays.
import { load } from '../../dist/index.js';
import { asSoup, cube, together, torus } from './support/meshes.js';

let kdm;
beforeAll(async () => {
  kdm = await load();
});

const lists = [
  'boundaryEdges',
  'nonManifoldEdges',
  'misorientedEdges',
  'nonManifoldVertices',
  'degenerateFaces',
  'zeroAreaFaces',
  'duplicateFaces',
  'flippedFaces',
  'selfIntersectingFaces',
];

/** The lists that are not empty. */
function found(defects) {
  const all = lists.map((name) => {
    expect(defects[name]).toBeInstanceOf(Uint32Array);
    return [name, [...defects[name]]];
  });
  return Object.fromEntries(all.filter(([, list]) => list.length > 0));
}

const inverted = ({ positions, indices }) => ({ positions, indices: indices.slice().reverse() });

test('a cube has no defects', () => {
  const defects = kdm.analyze(cube(), { selfIntersections: true });
  expect(found(defects)).toEqual({});
  expect(defects.balanced).toBe(true);
  expect(defects.boundaryLoops).toEqual([]);
  expect(defects.nestingKnown).toBe(true);
  expect(defects.selfIntersections).toBe(0);
  expect(defects.report).toEqual(kdm.describe(cube()));
  expect([...defects.partOf]).toEqual(Array(12).fill(0));
  expect(defects.parts).toEqual([
    {
      firstFace: 0,
      faces: 12,
      boundaryLoops: 0,
      closed: true,
      genus: 0,
      area: 24,
      volume: 8,
      inside: null,
      cavity: false,
      insideOut: false,
    },
  ]);
});

test('open edges, and the loops that they form', () => {
  const { positions, indices } = cube();
  // Without its bottom, whose corners are 0, 2, 3, 1.
  const defects = kdm.analyze({ positions, indices: indices.slice(6) });
  expect(found(defects)).toEqual({ boundaryEdges: [0, 1, 2, 0, 1, 3, 3, 2] });
  expect(defects.boundaryLoops).toEqual([Uint32Array.of(0, 1, 3, 2)]);
  expect(defects.balanced).toBe(false);
  expect(defects.parts).toMatchObject([{ closed: false, boundaryLoops: 1, genus: 0, volume: 0 }]);
  // Without bottom and top.
  const tube = kdm.analyze({ positions, indices: indices.slice(12) });
  expect(tube.boundaryLoops).toEqual([Uint32Array.of(0, 1, 3, 2), Uint32Array.of(5, 4, 6, 7)]);
});

test('flipped, doubled and degenerate faces', () => {
  const { positions, indices } = cube();
  const flipped = indices.slice();
  flipped.set([2, 0, 3]); // it was 0, 2, 3
  expect(found(kdm.analyze({ positions, indices: flipped }))).toEqual({
    misorientedEdges: [0, 2, 0, 3, 2, 3],
    flippedFaces: [0],
  });
  const more = Uint32Array.of(...indices, 2, 3, 0, 5, 5, 6);
  const defects = kdm.analyze({ positions, indices: more }, { selfIntersections: true });
  expect(found(defects)).toEqual({
    nonManifoldEdges: [0, 2, 0, 3, 2, 3],
    nonManifoldVertices: [0, 2, 3],
    duplicateFaces: [12],
    degenerateFaces: [13],
    selfIntersectingFaces: [0, 12],
  });
  expect(defects.selfIntersections).toBe(1);
  expect(defects.partOf[13]).toBe(0xffffffff);
  expect(defects.parts[0].genus).toBeNull();
});

test('cavities, parts inside out and parts in others', () => {
  const hollow = kdm.analyze(together(cube(4), inverted(cube(2)), torus(32, 16, 9, 1)));
  expect(hollow.parts.map(({ cavity, inside, genus }) => [cavity, inside, genus])).toEqual([
    [false, null, 0],
    [true, 0, 0],
    [false, null, 1],
  ]);
  const wrong = kdm.analyze(together(cube(2), inverted(cube(2, [5, 0, 0])), cube(1)));
  expect(wrong.parts.map(({ insideOut }) => insideOut)).toEqual([false, true, false]);
  expect([...wrong.flippedFaces]).toEqual(Array.from({ length: 12 }, (_, i) => 12 + i));
  expect(wrong.parts[2]).toMatchObject({ inside: 0, cavity: false });
});

test('a soup is joined first; quads are faces too', () => {
  const defects = kdm.analyze(asSoup(torus()), { selfIntersections: true });
  expect(found(defects)).toEqual({});
  expect(defects.parts).toMatchObject([{ genus: 1, closed: true }]);
  const grid = kdm.buildGrid(torus(), { strategy: 'uniform', depth: 9 });
  const mesh = grid.extract({ quads: true });
  grid.delete();
  expect(mesh.quads.length).toBeGreaterThan(0);
  expect(kdm.analyze(mesh).partOf).toHaveLength(mesh.sourceFaces.length);
  const holed = kdm.analyze({ ...mesh, quads: mesh.quads.slice(4), sourceFaces: null });
  expect(holed.boundaryLoops).toHaveLength(1);
  expect([...holed.boundaryLoops[0]].sort()).toEqual([...mesh.quads.slice(0, 4)].sort());
});

test('meshes without faces', () => {
  const defects = kdm.analyze({ positions: new Float32Array(), indices: new Uint32Array() });
  expect(found(defects)).toEqual({});
  expect(defects).toMatchObject({ balanced: false, boundaryLoops: [], parts: [] });
});

test('what is wrong in the call is named', () => {
  const { positions, indices } = cube();
  expect(() => kdm.analyze({ positions, indices: Uint32Array.of(0, 1, 8) })).toThrow(
    /indices\[2\] is 8/,
  );
  expect(() => kdm.analyze({ positions: positions.map(() => NaN), indices })).toThrow(/finite/);
  expect(() => kdm.analyze(cube(), { selfIntersections: 1 })).toThrow(/selfIntersections.*true/);
  expect(() => kdm.analyze(cube(), { depth: 1 })).toThrow(/depth: no such option/);
  expect(() => kdm.analyze(null)).toThrow(expect.objectContaining({ code: 'INVALID_MESH' }));
});
