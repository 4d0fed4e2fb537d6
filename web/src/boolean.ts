// SPDX-License-Identifier: MIT
// Boolean operations in a worker.
import { checkMakeOptions } from './check-input.js';
import { buffersOf } from './convert.js';
import { KdManifoldError } from './errors.js';
import type { BooleanExpression, BooleanOperation } from './expression.js';
import { jobKeys, jobOf, ownMesh, type JobOptions } from './job.js';
import { checkSolids, solidKeys, type SolidOptions } from './solids.js';
import type {
  BuildOptions,
  Conversion,
  ExtractOptions,
  MeshInput,
  ReductionOptions,
} from './types.js';
import { submit } from './worker/pool.js';

/** Everything that `boolean` can be told. */
export interface BooleanOptions
  extends BuildOptions, ExtractOptions, ReductionOptions, SolidOptions, JobOptions {}

const own = [...solidKeys, ...jobKeys];

/**
 * Makes the union, intersection, difference or symmetric difference of meshes in whatever state, or what any expression
 * says of them: each is prepared as `makeManifold` does, then all are joined exactly; faces on faces, also of different
 * operands, leave nothing behind. Works in a worker as `makeManifold` does, and reduces the result as that does unless
 * `reduce` is false.
 *
 * @param expression - an operation, which joins all operands from left to right, or an expression over their numbers:
 *   `['difference', 0, ['union', 1, 2]]`
 * @param operands - the meshes; their arrays are copied unless `transfer` is set
 * @param options - how to build and extract, where the operands go, where to work, how to be told and stopped
 * @returns the mesh, whose `sourceOperands` and `sourceFaces` name the face behind each face, and the account, with one
 *   report an operand
 * @throws {@link KdManifoldError} with `INVALID_MESH`, `INVALID_OPTION`, `NOT_CLOSED` (an operand that encloses nothing),
 * `EMPTY_RESULT` (nothing is left), `OUT_OF_MEMORY`, `ABORTED`, `LOAD_FAILED`; a signal's own reason where it was given
 * one
 *
 * @example
 * ```js
 * import { boolean } from 'kdmanifold';
 *
 * const moved = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.5, 0, 0, 1];
 * const part = { positions, indices };
 * const { mesh } = await boolean('difference', [part, part], { transforms: [null, moved] });
 * console.log(mesh.indices.length / 3, mesh.sourceOperands);
 * ```
 */
export async function boolean(
  expression: BooleanOperation | BooleanExpression,
  operands: readonly MeshInput[],
  options: BooleanOptions = {},
): Promise<Conversion> {
  if (typeof options !== 'object' || options === null) {
    throw new KdManifoldError('INVALID_OPTION', 'options: expected an object');
  }
  const checked = checkSolids(expression, operands, options);
  const made = checkMakeOptions(options, own);
  const job = jobOf(options);
  const solids = checked.solids.map((solid) => ({ ...solid, ...ownMesh(solid, options) }));
  return submit({
    ...job,
    transfer: buffersOf(...solids),
    order: {
      type: 'convert',
      subject: { ...checked, solids },
      ...made,
      check: false,
    },
  });
}
