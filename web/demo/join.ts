// SPDX-License-Identifier: MIT
// Converts the input, or joins it with a second model.
import {
  boolean,
  makeManifold,
  openBooleanScene,
  type BuildOptions,
  type Conversion,
  type ExtractOptions,
  type JobOptions,
  type MeshInput,
  type OpenBooleanScene,
} from 'kdmanifold';
import { Matrix4, Vector3 } from 'three';
import type { Joined } from './second-model';

type Options = BuildOptions & ExtractOptions & JobOptions;

// What is seen while something is dragged must come at once.
const coarseTolerance = 0.01;

/** Makes a result of the input, and of the second model if there is one. */
export function convertBoth(
  mesh: MeshInput,
  second: Joined | null,
  options: Options,
): Promise<Conversion> {
  return second === null
    ? makeManifold(mesh, { ...options, check: true })
    : boolean(second.operation, [mesh, second.mesh], {
        ...options,
        transforms: [null, second.transform],
      });
}

/** The same in a rough way, for as long as the second model is on the move: of a result only what changes is made anew. */
export class CoarseJoin {
  #scene: OpenBooleanScene | null = null;
  #meshes: MeshInput[] = [];
  #settings = '';

  convert(
    mesh: MeshInput,
    second: Joined,
    { relativeTolerance = 0, inside, windingThreshold, thicken, parts }: Options,
  ): Promise<Conversion> {
    const options = {
      relativeTolerance: Math.max(relativeTolerance, coarseTolerance),
      inside,
      windingThreshold,
      thicken,
      parts,
      reduce: false,
      strict: 'manifold',
    } as const;
    const meshes = [mesh, second.mesh];
    const settings = JSON.stringify([second.operation, options]);
    if (settings !== this.#settings || meshes.some((one, i) => one !== this.#meshes[i])) {
      this.forget();
      [this.#meshes, this.#settings] = [meshes, settings];
    }
    this.#scene ??= openBooleanScene(second.operation, meshes, options);
    return this.#scene.update(1, second.transform);
  }

  /** Gives the memory back. */
  forget(): void {
    this.#scene?.close();
    this.#scene = null;
    [this.#meshes, this.#settings] = [[], ''];
  }
}

/** Both meshes in one pair of arrays, where they are. */
export function together(mesh: MeshInput, second: Joined): MeshInput {
  const matrix = new Matrix4().fromArray(second.transform);
  const moved = Float64Array.from(second.mesh.positions);
  const point = new Vector3();
  for (let i = 0; i < moved.length; i += 3)
    point.fromArray(moved, i).applyMatrix4(matrix).toArray(moved, i);
  const first = mesh.positions.length;
  const positions = new Float64Array(first + moved.length);
  positions.set(mesh.positions);
  positions.set(moved, first);
  const [own, other] = [cornersOf(mesh), cornersOf(second.mesh)];
  const indices = new Uint32Array(own.length + other.length);
  indices.set(own);
  indices.set(
    other.map((corner) => corner + first / 3),
    own.length,
  );
  return { positions, indices };
}

const cornersOf = ({ positions, indices }: MeshInput): Uint32Array =>
  indices
    ? Uint32Array.from(indices)
    : Uint32Array.from({ length: positions.length / 3 }, (_, i) => i);
