// SPDX-License-Identifier: MIT
// Shells around open surfaces, as a function, as an option and through the worker.
import { load, makeManifold } from '../../dist/index.js';
import { cube, faults, volume } from './support/meshes.js';

let kdm;
beforeAll(async () => {
  kdm = await load();
});

// The cube of size 2 without its first side: five sides of area 4.
const openBox = () => {
  const { positions, indices } = cube();
  return { positions, indices: indices.slice(6) };
};
// Outer box less inner box; both end at the open side.
const wallVolume = (wall) => (2 + wall) ** 2 * (2 + wall / 2) - (2 - wall) ** 2 * (2 - wall / 2);

test('a shell is closed, of the right thickness, and names the faces it comes from', () => {
  const box = openBox();
  const shell = kdm.thicken(box, 0.2);
  expect(shell.positions).toBeInstanceOf(Float64Array);
  expect(faults(shell)).toEqual(faults(cube()));
  expect(volume(shell)).toBeCloseTo(wallVolume(0.2), 6);
  expect(shell.sourceFaces.length).toBe(shell.indices.length / 3);
  expect(Math.max(...shell.sourceFaces)).toBe(box.indices.length / 3 - 1);
});

test('the option thicken builds it', async () => {
  const options = { thicken: 0.2, relativeTolerance: 0.005 };
  const grid = kdm.buildGrid(openBox(), options);
  const mesh = grid.extract();
  expect(grid.input.closed).toBe(true);
  grid.delete();
  expect(volume(mesh)).toBeCloseTo(wallVolume(0.2), 3);
  const converted = await makeManifold(openBox(), { ...options, reduce: false });
  expect(converted.report.output.twoManifold).toBe(true);
  expect(converted.mesh).toEqual({
    positions: mesh.positions,
    indices: mesh.indices,
    sourceFaces: mesh.sourceFaces,
  });
});

// A cube with a fin across its first side, which is at x = 1: from -1 to 1 along y, 0.5 to 3 along x.
const cubeWithFin = () => {
  const { positions, indices } = cube();
  const first = positions.length / 3;
  const fin = [0.5, -1, 0, 3, -1, 0, 3, 1, 0, 0.5, 1, 0];
  return {
    positions: Float64Array.of(...positions, ...fin),
    indices: Uint32Array.of(...indices, ...[0, 1, 2, 0, 2, 3].map((i) => first + i)),
  };
};

test("thickenWhat 'sheets' thickens sheets and leaves solids as they are", async () => {
  const options = { thicken: 0.2, thickenWhat: 'sheets', relativeTolerance: 0.002, reduce: false };
  const { mesh, report } = await makeManifold(cubeWithFin(), options);
  expect(report.input.thickenedParts).toBe(1);
  expect(report.output.components).toBe(1);
  expect(volume(mesh)).toBeCloseTo(8 + 2 * 2 * 0.2, 1);
  const solid = await makeManifold(cube(), options);
  expect(solid.report.input.thickenedParts).toBe(0);
  expect(volume(solid.mesh)).toBeCloseTo(8, 5);
});

test('the thickness itself is a number, whatever gets it', () => {
  expect(() => kdm.buildGrid(cubeWithFin(), { thicken: 'sheets' })).toThrow(
    expect.objectContaining({
      code: 'INVALID_OPTION',
      message: "thicken: expected a number from 0 on beside thickenWhat 'sheets', got 'sheets'",
    }),
  );
});

test.each([0, -1, NaN, Infinity, '1', undefined])('thickness %p is refused', (thickness) => {
  expect(() => kdm.thicken(openBox(), thickness)).toThrow(
    expect.objectContaining({
      code: 'INVALID_OPTION',
      message: expect.stringContaining('thickness'),
    }),
  );
});

test('what is wrong with a mesh or the option is said', () => {
  const { positions } = cube();
  expect(() => kdm.thicken({ positions, indices: Uint32Array.of(0, 0, 1) }, 1)).toThrow(
    expect.objectContaining({ code: 'INVALID_MESH', message: expect.stringContaining('area') }),
  );
  expect(() => kdm.thicken({ positions, indices: Uint32Array.of(0, 1, 8) }, 1)).toThrow(
    expect.objectContaining({ code: 'INVALID_MESH' }),
  );
  expect(() => kdm.buildGrid(cube(), { thicken: -1 })).toThrow(
    expect.objectContaining({
      code: 'INVALID_OPTION',
      message: expect.stringContaining('thicken'),
    }),
  );
});
