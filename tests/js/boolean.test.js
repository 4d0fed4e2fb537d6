// SPDX-License-Identifier: MIT
// Boolean operations: in a worker, and on the thread that calls.
import { boolean, load } from '../../dist/index.js';
import { cube, faults, torus, volume } from './support/meshes.js';

// Columns, as three.js has them.
const movedBy = (x, y, z) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1];

test('operations join all operands from left to right', async () => {
  const operands = [cube(), cube(2, [1, 0, 0]), cube(2, [0, 1, 0])];
  for (const [operation, expected] of [
    ['union', 16],
    ['intersection', 2],
    ['difference', 2],
    ['symmetricDifference', 12],
  ]) {
    const { mesh, report } = await boolean(operation, operands);
    expect(faults(mesh)).toEqual([]);
    expect(volume(mesh)).toBeCloseTo(expected, 1);
    expect(report.output.crossings).toBe(0); // embedded
    expect(report.thread).toBe('worker');
    expect(report.operands).toHaveLength(3);
    expect(report.input.triangles).toBe(36);
    expect(report.reduce.triangles).toBe(mesh.indices.length / 3); // as few as the planes need
    expect(report.reduce.triangles).toBeLessThan(64);
    expect(report).not.toHaveProperty('lost');
  }
});

test('transforms place and mirror operands', async () => {
  const mirror = [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  const corner = cube(2, [1, 1, 1]);
  const { mesh } = await boolean('union', [corner, corner, corner], {
    transforms: [null, movedBy(1, 0, 0), mirror],
  });
  expect(faults(mesh)).toEqual([]);
  expect(volume(mesh)).toBeCloseTo(8 + 4 + 8, 2);
});

test('expressions nest, and a complement ends at the box of all operands', async () => {
  const operands = [cube(4), cube(2), cube(1)];
  const { mesh } = await boolean(['union', ['difference', 0, 1], 2], operands);
  expect(faults(mesh)).toEqual([]);
  expect(volume(mesh)).toBeCloseTo(64 - 8 + 1, 2);
  const { mesh: rest } = await boolean(['complement', ['intersection', 0, 1]], operands);
  expect(volume(rest)).toBeCloseTo(64 - 8, 2);
  expect([...rest.sourceOperands].sort()).toContain(0xffffffff);
});

test('faces name their operands and the faces of these', async () => {
  const { mesh } = await boolean('difference', [cube(), cube(2, [1, 1, 1])], {
    strict: 'manifold',
    reduce: false,
  });
  const faces = mesh.indices.length / 3;
  expect(mesh.sourceOperands).toHaveLength(faces);
  expect(mesh.sourceFaces).toHaveLength(faces);
  expect(new Set(mesh.sourceOperands)).toEqual(new Set([0, 1]));
  expect(Math.max(...mesh.sourceFaces)).toBeLessThan(12);
});

test('operands may be open; what each was like is reported', async () => {
  const { positions, indices } = torus();
  const open = { positions, indices: indices.slice(24) };
  const { mesh, report } = await boolean('difference', [open, cube(2, [3, 0, 0])]);
  expect(faults(mesh)).toEqual([]);
  expect(report.operands.map(({ closed }) => closed)).toEqual([false, true]);
  expect(report.input.closed).toBe(false);
});

test('the synchronous form gives the same mesh', async () => {
  const options = { relativeTolerance: 0.01, transforms: [null, movedBy(0.5, 0.2, 0.1)] };
  const { mesh } = await boolean('union', [torus(), torus()], { ...options, reduce: false });
  const grid = (await load()).buildBooleanGrid('union', [torus(), torus()], options);
  const expected = grid.extract({ strict: 'embedded' });
  expect(grid.operands).toHaveLength(2);
  const again = (await load()).loadGrid(grid.save());
  expect(again.extract({ strict: 'embedded' })).toEqual(expected);
  expect(again.operands).toEqual(grid.operands);
  for (const one of [grid, again]) one.delete();
  for (const [name, array] of Object.entries(mesh)) expect(array).toEqual(expected[name]);
});

test('arrays are taken only if that is allowed', async () => {
  const part = torus();
  await boolean('union', [part, part]);
  expect(part.positions.length).toBeGreaterThan(0);
  await boolean('union', [part, part], { transfer: true });
  expect(part.positions.length).toBe(0);
});

test('progress is told, and a signal stops', async () => {
  const fractions = [];
  await boolean('union', [torus(128, 64), cube()], {
    onProgress: (fraction) => void fractions.push(fraction),
  });
  expect(fractions.at(-1)).toBe(1);
  expect(fractions).toEqual([...fractions].sort((a, b) => a - b));
  const controller = new AbortController();
  const stopped = boolean('union', [torus(512, 256), cube()], {
    signal: controller.signal,
    onProgress: () => controller.abort(new Error('enough')),
  });
  await expect(stopped).rejects.toThrow('enough');
});

test.each([
  ['difference', [cube(), cube()], {}, 'EMPTY_RESULT', /leaves nothing/],
  ['unite', [cube()], {}, 'INVALID_OPTION', /^expression: expected one of union, .*got 'unite'/],
  [['union', 0, 2], [cube(), cube()], {}, 'INVALID_OPTION', /names operand 2, but there are 2/],
  [['union'], [cube()], {}, 'INVALID_OPTION', /'union' needs one operand/],
  [['complement', 0, 0], [cube()], {}, 'INVALID_OPTION', /'complement' takes one operand/],
  ['union', [], {}, 'INVALID_OPTION', /^operands: /],
  ['union', [cube(), { positions: 7 }], {}, 'INVALID_MESH', /^operand 1: positions: expected/],
  ['union', [cube()], { transforms: [[1]] }, 'INVALID_OPTION', /^operand 0: transform: .*16/],
  ['union', [cube()], { transforms: [] }, 'INVALID_OPTION', /^transforms: length 0/],
  ['union', [cube()], { transforms: [Array(16).fill(0)] }, 'INVALID_OPTION', /not affine/],
  [
    'union',
    [cube(), cube()],
    { transforms: [null, [1, 0, 0, 0, 2, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]] },
    'INVALID_OPTION',
    /^operand 1: transform: it is not invertible/,
  ],
  ['union', [cube()], { insides: ['most'] }, 'INVALID_OPTION', /^operand 0: inside: expected/],
  ['union', [cube()], { inside: 'sheet' }, 'INVALID_OPTION', /^operand 0: inside: sheets/],
  ['union', [cube()], { sharpness: 1 }, 'INVALID_OPTION', /^sharpness: no such option/],
  ['union', [cube()], { reduce: true, quads: true }, 'INVALID_OPTION', /^reduce: not together/],
  ['union', [cube()], { check: true }, 'INVALID_OPTION', /^check: no such option/],
])(
  '%j is refused with what is wrong (%#)',
  async (expression, operands, options, code, message) => {
    const failed = boolean(expression, operands, options);
    await expect(failed).rejects.toMatchObject({ code, message: expect.stringMatching(message) });
  },
);

test('results are reduced within the tolerance, and name their operands', async () => {
  const operands = [torus(128, 64), cube(2, [2, 0, 0])];
  const few = await boolean('union', operands, { relativeTolerance: 0.005 });
  const own = await boolean('union', operands, { relativeTolerance: 0.005, reduce: false });
  expect(own.report.reduce).toBeNull();
  expect(few.mesh.indices.length).toBeLessThan(0.5 * own.mesh.indices.length);
  expect(faults(few.mesh)).toEqual([]);
  expect(few.report.output.crossings).toBe(0);
  expect(few.mesh.sourceOperands).toHaveLength(few.mesh.indices.length / 3);
  expect(new Set(few.mesh.sourceOperands)).toEqual(new Set([0, 1]));
  expect(volume(few.mesh) / volume(own.mesh)).toBeCloseTo(1, 1);
  const { levels } = await boolean('union', operands, {
    relativeTolerance: 0.02,
    targetTriangles: [800, 400],
  });
  expect(levels.map(({ indices }) => indices.length / 3 <= 800)).toEqual([true, true]);
});
