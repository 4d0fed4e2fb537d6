// SPDX-License-Identifier: MIT
// Grid.simplify: a smaller grid whose surface stays near to what it was (paper section 4).
import { load, makeManifold } from '../../dist/index.js';
import { cube, faults, together, torus } from './support/meshes.js';

let kdm;
beforeAll(async () => {
  kdm = await load();
});

/** A grid, freed when the work is done. */
function withGrid(work, options = { tolerance: 0.01 }) {
  const grid = kdm.buildGrid(torus(), options);
  try {
    return work(grid);
  } finally {
    grid.delete();
  }
}
const count = ({ indices }) => indices.length / 3;

test('the grid gets smaller and the surface stays within the distance', () => {
  withGrid((grid) => {
    const before = { bytes: grid.save().length, mesh: grid.extract(), stats: grid.stats };
    const report = grid.simplify({ surfaceError: 0.1 });
    expect(report.removedSplits).toBeGreaterThan(0);
    expect(report.cellsBefore).toBe(before.stats.cells);
    expect(report.cells).toBe(grid.stats.cells);
    expect(report.cells).toBe(report.cellsBefore - 2 * report.removedSplits);
    expect(report.hitsBefore).toBe(before.stats.hits);
    expect(report.hits).toBe(grid.stats.hits);
    expect(report.allowedError).toBeCloseTo(0.1, 12);
    expect(grid.save().length).toBeLessThan(before.bytes / 2);
    const mesh = grid.extract();
    expect(faults(mesh)).toEqual([]);
    expect(mesh.report.crossings).toBe(0);
    expect(2 * count(mesh)).toBeLessThan(count(before.mesh));
    const { error } = grid.compare(before.mesh, mesh, { error: true });
    expect(error.toInput.largest).toBeLessThan(0.11);
    expect(error.toOutput.largest).toBeLessThan(0.11);
  });
});

test('calls add up, also of a grid that was saved in between', () => {
  withGrid((grid) => {
    grid.simplify({ surfaceError: 0.03 });
    expect(grid.simplify({ surfaceError: 0.03 }).removedSplits).toBe(0);
    const loaded = kdm.loadGrid(grid.save());
    const report = loaded.simplify({ surfaceError: 0.1 });
    expect(report).toEqual(grid.simplify({ surfaceError: 0.1 }));
    expect(report.removedSplits).toBeGreaterThan(0);
    expect(loaded.save()).toEqual(grid.save());
    loaded.delete();
  });
});

test("the paper's on-metric limits it further", () => {
  const removed = (planeError) =>
    withGrid((grid) => {
      const report = grid.simplify({ surfaceError: 0.1, planeError });
      if (planeError > 0) expect(report.planeError).toBeLessThanOrEqual(planeError);
      return report.removedSplits;
    });
  expect(removed(0.002)).toBeLessThan(removed(0));
  expect(removed(0.002)).toBeGreaterThan(0);
});

describe('thin bodies and cavities', () => {
  const { positions, indices } = cube(0.4);
  const cavity = { positions, indices: indices.slice().reverse() };
  const scene = together(cube(2), cube(0.2, [1.5, 0, 0]), cavity);
  const simplified = (limits) => {
    const grid = kdm.buildGrid(scene, { tolerance: 0.01 });
    const { parts: before } = kdm.analyze(grid.extract());
    const report = grid.simplify({ surfaceError: 0.001, ...limits });
    const { parts } = kdm.analyze(grid.extract());
    grid.delete();
    expect(parts).toHaveLength(before.length - report.removedSurfaces);
    const { removedParts, filledCavities, removedSurfaces, removedHandles } = report;
    return [removedParts, filledCavities, removedSurfaces, removedHandles];
  };

  test('stay by default, and if they are thicker', () => {
    expect(simplified({})).toEqual([0, 0, 0, 0]);
    expect(simplified({ removedMaterial: 0.15, addedMaterial: 0.3 })).toEqual([0, 0, 0, 0]);
  });

  test('go if they are thinner', () => {
    expect(simplified({ removedMaterial: 0.25 })).toEqual([1, 0, 1, 0]);
    expect(simplified({ addedMaterial: 0.5 })).toEqual([0, 1, 1, 0]);
    expect(simplified({ removedMaterial: 0.25, addedMaterial: 0.5 })).toEqual([1, 1, 2, 0]);
  });

  test('go in makeManifold too, beside simplify', async () => {
    const limits = { removeMaterial: 0.25, addMaterial: 0.5 };
    const options = { tolerance: 0.01, simplify: 0.001, ...limits };
    const { report } = await makeManifold(scene, options);
    expect(report.simplify).toMatchObject({ removedParts: 1, filledCavities: 1 });
    for (const [name, value] of Object.entries(limits)) {
      await expect(makeManifold(scene, { [name]: value })).rejects.toThrow(
        expect.objectContaining({
          code: 'INVALID_OPTION',
          message: `${name}: only with \`simplify\``,
        }),
      );
    }
  });

  test('are never all', () => {
    expect(() => simplified({ removedMaterial: 3 })).toThrow(
      expect.objectContaining({
        code: 'EMPTY_RESULT',
        message: 'all of the solid is thinner than `removedMaterial`',
      }),
    );
  });

  test('are nothing that sheets have', () => {
    withGrid(
      (grid) => {
        expect(() => grid.simplify({ surfaceError: 0.01, addedMaterial: 1 })).toThrow(
          expect.objectContaining({
            code: 'INVALID_OPTION',
            message: '`addedMaterial`: not of a sheet, which bounds no material',
          }),
        );
      },
      { tolerance: 0.01, inside: 'sheet' },
    );
  });
});

test('a cancelled call leaves the grid as it was', () => {
  withGrid((grid) => {
    const before = grid.save();
    const told = [];
    const onProgress = (fraction) => {
      told.push(fraction);
      return fraction < 0.5;
    };
    expect(() => grid.simplify({ surfaceError: 0.1, onProgress })).toThrow(
      expect.objectContaining({ code: 'ABORTED' }),
    );
    expect(told.at(-1)).toBeGreaterThanOrEqual(0.5);
    expect(grid.save()).toEqual(before);
    expect(grid.simplify({ surfaceError: 0.1 }).removedSplits).toBeGreaterThan(0);
  });
});

test.each([
  [{}, 'surfaceError: expected a number above 0'],
  [{ surfaceError: 0 }, 'surfaceError: expected a number above 0'],
  [{ surfaceError: -1 }, 'surfaceError: expected a number from 0 on, got -1'],
  [{ surfaceError: NaN }, 'surfaceError: expected a number from 0 on, got NaN'],
  [{ surfaceError: 1, error: 1 }, 'error: no such option'],
  [
    { surfaceError: 1, removedMaterial: -1 },
    'removedMaterial: expected a number from 0 on, got -1',
  ],
  [{ surfaceError: 1, addedMaterial: NaN }, 'addedMaterial: expected a number from 0 on, got NaN'],
])('what is no distance is refused: %j', (options, message) => {
  withGrid((grid) => {
    const before = grid.save();
    expect(() => grid.simplify(options)).toThrow(
      expect.objectContaining({
        code: 'INVALID_OPTION',
        message: expect.stringContaining(message),
      }),
    );
    expect(grid.save()).toEqual(before);
  });
});

test('a deleted grid cannot be simplified', () => {
  const grid = kdm.buildGrid(torus());
  grid.delete();
  expect(() => grid.simplify({ surfaceError: 1 })).toThrow(
    expect.objectContaining({ code: 'DELETED' }),
  );
});
