// SPDX-License-Identifier: MIT
// What a result lacks and how far it is from its input: the same by all ways into the package.
import { load, makeManifold } from '../../dist/index.js';
import { cube, faults, together, torus } from './support/meshes.js';

let kdm;
beforeAll(async () => {
  kdm = await load();
});

// A square that stands on a cube and bounds nothing.
function cubeWithFin() {
  const { positions, indices } = cube();
  const corners = [-0.5, 0, 1, 0.5, 0, 1, 0.5, 0, 2, -0.5, 0, 2];
  return {
    positions: Float32Array.from([...positions, ...corners]),
    indices: Uint32Array.from([...indices, 8, 9, 10, 8, 10, 11]),
  };
}

test('nothing is missing of a torus, and distances are small', async () => {
  const { report } = await makeManifold(torus(), { tolerance: 0.01, check: true });
  expect(report.lost).toEqual({
    area: 0,
    parts: 0,
    largest: 0,
    share: 0,
    innerArea: 0,
    faces: new Uint32Array(0),
  });
  for (const { largest, rms } of [report.error.toInput, report.error.toOutput]) {
    expect(largest).toBeLessThan(0.02);
    expect(rms).toBeLessThan(largest);
    expect(rms).toBeGreaterThan(0);
  }
});

test('without check nothing is measured, but what is lost is told', async () => {
  const { report } = await makeManifold(cubeWithFin());
  expect(report.error).toBeNull();
  expect(report.lost.area).toBeCloseTo(1, 1);
  expect(report.lost.parts).toBe(1);
  expect(report.lost.faces).toEqual(Uint32Array.of(12, 13));
  expect(['AREA_LOST', 'PARTS_LOST']).toContain(report.warnings[0].code);
});

test('parts and cavities smaller than asked for go, and all of it is told', async () => {
  const cavity = cube(1);
  cavity.indices.reverse();
  const input = together(cube(4), cavity, cube(0.5, [10, 0, 0]));
  const options = { tolerance: 0.01, dropParts: 0.9, dropCavities: 1.8 };
  const { mesh, report } = await makeManifold(input, options);
  expect(faults(mesh)).toEqual([]);
  expect(report.output).toMatchObject({ components: 1, smallParts: 1, smallCavities: 1 });
  expect(report.output.volume).toBeCloseTo(64, 1);
  expect(report.output.smallPartsVolume).toBeCloseTo(0.125, 2);
  expect(report.output.smallCavitiesVolume).toBeCloseTo(1, 1);
  expect(report.lost.area).toBeCloseTo(1.5 + 6, 1);
  expect(report.warnings.map(({ code }) => code)).toEqual([
    'AREA_LOST',
    'PARTS_DROPPED',
    'CAVITIES_FILLED',
  ]);
  const grid = kdm.buildGrid(input, { tolerance: 0.01 });
  expect(grid.extract().report).toMatchObject({ smallParts: 0, smallCavities: 0 });
  expect(grid.extract({ dropCavities: 1.8 }).report).toMatchObject({
    smallParts: 0,
    smallCavities: 1,
  });
  grid.delete();
});

test('what is thinner than asked for goes, gaps are filled, and all of it is told', async () => {
  const plate = cube(2, [0, 0, 3]);
  for (let i = 2; i < plate.positions.length; i += 3) {
    plate.positions[i] = 3 + 0.05 * Math.sign(plate.positions[i] - 3);
  }
  const thin = together(cube(2), plate); // 0.1 thick
  const options = { tolerance: 0.01, minimumThickness: 0.2 };
  const one = await makeManifold(thin, options);
  expect(faults(one.mesh)).toEqual([]);
  expect(one.report.output).toMatchObject({ components: 1, eulerCharacteristic: 2 });
  expect(one.report.grid.thinArea).toBeCloseTo(8.8, 1);
  expect(one.report.warnings.map(({ code }) => code)).toContain('THIN_REMOVED');
  const kept = await makeManifold(thin, { ...options, minimumThickness: 0.05 });
  expect(kept.mesh).toEqual((await makeManifold(thin, { tolerance: 0.01 })).mesh);
  const apart = together(cube(2), cube(2, [2.1, 0, 0]));
  const joined = await makeManifold(apart, { tolerance: 0.01, minimumGap: 0.2 });
  expect(faults(joined.mesh)).toEqual([]);
  expect(joined.report.output).toMatchObject({ components: 1, eulerCharacteristic: 2 });
  expect(joined.report.warnings.map(({ code }) => code)).toContain('GAPS_FILLED');
});

test('handles smaller than asked for go, and how many is told', async () => {
  const ring = torus();
  const { mesh, report } = await makeManifold(ring, { tolerance: 0.01, dropHandles: 100 });
  expect(faults(mesh)).toEqual([]);
  expect(report.output).toMatchObject({
    components: 1,
    eulerCharacteristic: 2,
    smallHandles: 1,
    keptHandles: 0,
    twoManifold: true,
    crossings: 0,
  });
  expect(report.warnings.map(({ code }) => code)).toEqual(['HANDLES_REMOVED']);
  const kept = await makeManifold(ring, { tolerance: 0.01, dropHandles: 0.1 });
  expect(kept.report.output).toMatchObject({ eulerCharacteristic: 0, smallHandles: 0 });
});

test('walls within the solid are not lost', async () => {
  const input = together(cube(), cube(2, [1, 1, 1]));
  const { report } = await makeManifold(input, { check: true });
  expect(report.lost.area).toBe(0);
  expect(report.lost.innerArea).toBeCloseTo(6, 0);
  expect(report.error.toOutput.largest).toBeLessThan(0.05);
  expect(report.warnings.map(({ code }) => code)).not.toContain('AREA_LOST');
});

test('a grid compares any result with its input', () => {
  const input = together(cube(), cube(2, [5, 0, 0]));
  const grid = kdm.buildGrid(input);
  const whole = grid.compare(input, grid.extract());
  expect(whole).toMatchObject({ error: null, warnings: [] });
  expect(whole.lost.area).toBe(0);
  const half = grid.compare(input, cube(), { error: true });
  expect(half.lost.share).toBeCloseTo(0.5, 9);
  expect(half.error.toOutput.largest).toBeCloseTo(5, 6);
  expect(half.error.toInput.largest).toBeCloseTo(0, 6);
  expect(half.warnings).toEqual([
    {
      code: 'AREA_LOST',
      message:
        "50 % of the input's area is missing from the result, in 1 piece, the largest with an area of 24",
    },
  ]);
  for (const wrong of [{ error: 1 }, { errors: true }, null]) {
    expect(() => grid.compare(input, cube(), wrong)).toThrow(/error|options/);
  }
  grid.delete();
  expect(() => grid.compare(input, cube())).toThrow(/deleted/);
});

test('positions tell where the topology was given up', async () => {
  const input = together(torus(), cube(2, [3, 0, 0]));
  const { report } = await makeManifold(input);
  const { unresolvedLeaves, unresolvedPositions } = report.grid;
  expect(unresolvedLeaves).toBeGreaterThan(0);
  expect(unresolvedPositions[Symbol.toStringTag]).toBe('Float64Array');
  expect(unresolvedPositions.length).toBe(3 * Math.min(unresolvedLeaves, 1000));
  for (let i = 0; i < unresolvedPositions.length; i += 3) {
    expect(Math.abs(unresolvedPositions[i] - 3)).toBeLessThan(1.5);
  }
});

test('check is true or false', async () => {
  await expect(makeManifold(cube(), { check: 'yes' })).rejects.toThrow(
    'check: expected true or false',
  );
});
