// SPDX-License-Identifier: MIT
// This package and its peers behind one shape: a mesh goes in, a mesh and seconds by stage come
// out. A peer that refuses an input says so with `refused`.
import { load } from '../../dist/index.js';

/** Processor time: of this process, as the native program's is; see runner.cpp. */
function now() {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1e6;
}

/** Runs `work` and attributes the time between progress calls to the phase named first. */
function timed(seconds, firstPhase, work) {
  let phase = firstPhase;
  let since = now();
  const enter = (next) => {
    const time = now();
    seconds[phase] = (seconds[phase] ?? 0) + time - since;
    phase = next;
    since = time;
  };
  const result = work((_, next) => {
    if (next !== phase) enter(next);
  });
  enter(phase);
  return result;
}

/** One run of mesh -> grid -> mesh in WebAssembly. */
export async function runWasm(bytes, format, setting) {
  const kdm = await load({ threads: 1 });
  const seconds = {};
  const start = now();
  const input = timed(seconds, 'read', () => kdm.parseMesh(bytes, format));
  const grid = timed(seconds, 'prepare', (onProgress) =>
    kdm.buildGrid(input, { ...setting, onProgress }),
  );
  try {
    const mesh = timed(seconds, 'extract', (onProgress) => grid.extract({ onProgress }));
    seconds.total = now() - start;
    return { mesh, seconds, input: grid.input, stats: grid.stats };
  } finally {
    grid.delete();
  }
}

/** meshoptimizer's voxel remesher: resolution cells on the longest axis, a triangle soup out. The flag
 * 'Solve' makes it place vertices at features. */
export async function meshoptimizer(mesh, resolution, flags = []) {
  const { MeshoptSimplifier } = await import('meshoptimizer');
  await MeshoptSimplifier.ready;
  const positions = Float32Array.from(mesh.positions);
  const start = now();
  const soup = MeshoptSimplifier.remesh(mesh.indices, positions, 3, resolution, flags);
  const seconds = now() - start;
  return { mesh: weld(soup), seconds };
}

let loadedManifold;

/** The module of manifold-3d. */
export async function manifoldModule() {
  if (loadedManifold === undefined) {
    const { default: Module } = await import('manifold-3d');
    loadedManifold = await Module();
    loadedManifold.setup();
  }
  return loadedManifold;
}

/**
 * manifold-3d takes closed manifold input only and gives it back as it is: a lower bound. With `union` its parts are
 * joined first.
 */
export async function manifold3d(mesh, { union = false } = {}) {
  const { Manifold, Mesh } = await manifoldModule();
  const start = now();
  let manifold;
  try {
    const input = new Mesh({
      numProp: 3,
      vertProperties: Float32Array.from(mesh.positions),
      triVerts: Uint32Array.from(mesh.indices),
    });
    input.merge();
    manifold = new Manifold(input);
    if (union) manifold = joined(manifold);
    const result = manifold.getMesh();
    const seconds = now() - start;
    return {
      mesh: { positions: result.vertProperties.slice(), indices: result.triVerts.slice() },
      seconds,
    };
  } catch (error) {
    return { refused: error.code ?? error.message };
  } finally {
    manifold?.delete();
  }
}

/**
 * Boolean operations of manifold-3d: `combine` gets the operands and a function that each of its results goes through.
 * Operands that are not closed and manifold are refused.
 */
export async function manifold3dBoolean(operands, combine) {
  const { Manifold, Mesh } = await manifoldModule();
  const made = [];
  const keep = (manifold) => (made.push(manifold), manifold);
  const start = now();
  try {
    const solids = operands.map(({ positions, indices }) => {
      const mesh = new Mesh({ numProp: 3, vertProperties: positions, triVerts: indices });
      mesh.merge();
      return keep(new Manifold(mesh));
    });
    const { vertProperties, triVerts } = combine(solids, keep).getMesh();
    const seconds = now() - start;
    return { mesh: { positions: vertProperties.slice(), indices: triVerts.slice() }, seconds };
  } catch (error) {
    return { refused: error.code ?? error.message };
  } finally {
    for (const manifold of made) manifold.delete();
  }
}

/** Boolean operations of this library, not reduced. */
export async function ownBoolean(operands, expression, options) {
  const kdm = await load({ threads: 1 });
  const start = now();
  const grid = kdm.buildBooleanGrid(expression, operands, options);
  try {
    const mesh = grid.extract({ strict: 'embedded' });
    return { mesh, seconds: now() - start };
  } finally {
    grid.delete();
  }
}

/** Reduces a closed mesh within a distance; seconds are processor time. */
export async function withinError(mesh, error) {
  const kdm = await load({ threads: 1 });
  const start = now();
  const { mesh: few } = kdm.simplifyMesh(mesh, { error });
  return { mesh: few, seconds: now() - start };
}

/** Reduces a closed mesh by count, by each of those who can; seconds are processor time. */
export const reducers = {
  async kdmanifold(mesh, triangles) {
    const kdm = await load({ threads: 1 });
    const start = now();
    const { mesh: few } = kdm.simplifyMesh(mesh, { targetTriangles: [triangles] });
    return { mesh: few, seconds: now() - start };
  },

  async meshoptimizer(mesh, triangles) {
    const { MeshoptSimplifier } = await import('meshoptimizer');
    await MeshoptSimplifier.ready;
    const start = now();
    const [indices] = MeshoptSimplifier.simplify(mesh.indices, mesh.positions, 3, 3 * triangles, 1);
    const seconds = now() - start;
    return { mesh: { positions: mesh.positions, indices }, seconds };
  },

  /**
   * Goes by a tolerance, so the largest number of triangles below what is wanted is searched; one run counts. Undefined:
   * no tolerance gives so few.
   */
  async 'manifold-3d'(mesh, triangles) {
    const { Manifold, Mesh } = await manifoldModule();
    const whole = new Manifold(
      new Mesh({ numProp: 3, vertProperties: mesh.positions, triVerts: mesh.indices }),
    );
    const { min, max } = whole.boundingBox();
    const diagonal = Math.hypot(...max.map((x, k) => x - min[k]));
    let [low, high] = [1e-6, 0.2];
    let best;
    for (let i = 0; i < 12; ++i) {
      const share = Math.sqrt(low * high);
      const start = now();
      const few = whole.simplify(share * diagonal);
      const { vertProperties, triVerts } = few.getMesh();
      const seconds = now() - start;
      if (triVerts.length / 3 > triangles) {
        low = share;
      } else {
        high = share;
        best = { mesh: { positions: vertProperties.slice(), indices: triVerts.slice() }, seconds };
      }
      few.delete();
    }
    whole.delete();
    return best;
  },
};

function joined(manifold) {
  const { Manifold } = loadedManifold;
  const parts = manifold.decompose();
  manifold.delete();
  const union = Manifold.union(parts);
  for (const part of parts) part.delete();
  return union;
}

/** Joins corners of exactly equal position: peers give soups, which are judged at their best. */
function weld(soup) {
  const numbers = new Map();
  const positions = [];
  const indices = new Uint32Array(soup.length / 3);
  for (let corner = 0; corner < indices.length; ++corner) {
    const [x, y, z] = soup.subarray(3 * corner, 3 * corner + 3);
    const key = `${x},${y},${z}`;
    let number = numbers.get(key);
    if (number === undefined) {
      number = numbers.size;
      numbers.set(key, number);
      positions.push(x, y, z);
    }
    indices[corner] = number;
  }
  return { positions: Float32Array.from(positions), indices };
}
