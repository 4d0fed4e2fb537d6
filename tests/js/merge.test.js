// SPDX-License-Identifier: MIT
// Grids that are merged without their meshes.
import { load } from '../../dist/index.js';
import { cube, faults, torus, volume } from './support/meshes.js';

const box = [-5, -5, -5, 5, 5, 5];
let kdm;
let first;
let second;
beforeAll(async () => {
  kdm = await load();
  first = kdm.buildGrid(torus(), { tolerance: 0.02, box });
  // It takes a piece off the ring.
  second = kdm.loadGrid(kdm.buildGrid(cube(2, [3, 0, 0.3]), { tolerance: 0.02, box }).save());
});
afterAll(() => {
  for (const grid of [first, second]) grid.delete();
});

const errorOf = (action) => {
  try {
    action();
  } catch (error) {
    return error;
  }
  return undefined;
};

test('a merged grid is extracted as any other, and can be saved and merged again', () => {
  const far = kdm.buildGrid(cube(0.5, [4.5, 4.5, 0]), { tolerance: 0.02, box });
  const both = first.merge(far, 'union');
  const [whole, part] = [volume(both.extract()), volume(second.extract())];
  const volumes = {};
  for (const operation of ['union', 'intersection', 'difference', 'symmetricDifference']) {
    const merged = both.merge(second, operation);
    const mesh = merged.extract();
    expect(faults(mesh)).toEqual([]);
    expect(new Set(mesh.sourceOperands).size).toBeGreaterThan(1);
    expect(merged.operands).toHaveLength(3);
    volumes[operation] = volume(mesh);
    const again = kdm.loadGrid(merged.save());
    expect(again.extract().positions).toEqual(mesh.positions);
    for (const grid of [merged, again]) grid.delete();
  }
  for (const grid of [far, both]) grid.delete();
  const { union, intersection, difference, symmetricDifference } = volumes;
  expect(intersection).toBeGreaterThan(1);
  expect(union).toBeCloseTo(whole + part - intersection, 1);
  expect(difference).toBeCloseTo(whole - intersection, 1);
  expect(symmetricDifference).toBeCloseTo(union - intersection, 1);
});

test('an expression says which grid is which', () => {
  const cut = first.merge(second, ['difference', 1, 0]);
  const same = second.merge(first, 'difference');
  expect(volume(cut.extract())).toBeGreaterThan(1);
  expect(volume(cut.extract())).toBeCloseTo(volume(same.extract()), 1);
  for (const grid of [cut, same]) grid.delete();
});

test('what cannot be merged is refused, and the grids stay as they are', () => {
  const before = first.save();
  const elsewhere = kdm.buildGrid(cube(), { tolerance: 0.02 });
  expect(errorOf(() => first.merge(elsewhere, 'union'))).toMatchObject({
    code: 'INVALID_OPTION',
    message: expect.stringContaining('`box`'),
  });
  elsewhere.delete();
  expect(errorOf(() => first.merge(elsewhere, 'union')).code).toBe('DELETED');
  expect(errorOf(() => first.merge(first, 'difference')).code).toBe('EMPTY_RESULT');
  expect(errorOf(() => first.merge(second, 'xor')).code).toBe('INVALID_OPTION');
  expect(errorOf(() => first.merge(second, ['union', 0, 2])).code).toBe('INVALID_OPTION');
  expect(errorOf(() => first.merge(second, 'complement')).code).toBe('INVALID_OPTION');
  expect(errorOf(() => first.merge(cube(), 'union')).message).toMatch(/^other: /);
  const { code } = errorOf(() => first.merge(second, 'union', { onProgress: () => false }));
  expect(code).toBe('ABORTED');
  expect(first.save()).toEqual(before);
  first.merge(second, 'union').delete();
});

test('a grid is laid over a box that holds the model', () => {
  expect(errorOf(() => kdm.buildGrid(torus(), { box: [0, 0, 0, 1, 1, 1] }))).toMatchObject({
    code: 'INVALID_OPTION',
    message: expect.stringMatching(/^`box`: the model reaches out of it/),
  });
});
