// SPDX-License-Identifier: MIT
// Tells three.js's classes apart and names objects in messages. By their flags, not by `instanceof`:
// a page often holds several copies of three.js, and the objects of all of them are welcome.
import type { BufferGeometry, InstancedMesh, LOD, Mesh, Object3D, SkinnedMesh } from 'three';
import { KdManifoldError } from '../errors.js';

type Flags = Record<string, unknown>;

/** Whether `value` has a flag such as `isMesh`. */
export function is(value: unknown, flag: string): boolean {
  return typeof value === 'object' && value !== null && (value as Flags)[flag] === true;
}

export const isGeometry = (value: unknown): value is BufferGeometry =>
  is(value, 'isBufferGeometry');
export const isMesh = (value: unknown): value is Mesh => is(value, 'isMesh');
export const isInstanced = (value: unknown): value is InstancedMesh => is(value, 'isInstancedMesh');
export const isSkinned = (value: unknown): value is SkinnedMesh => is(value, 'isSkinnedMesh');
export const isLevels = (value: unknown): value is LOD => is(value, 'isLOD');
export const isObject = (value: unknown): value is Object3D => is(value, 'isObject3D');

/** What to call an object or a geometry: its type, and its name or else its number. */
export function nameOf(thing: { type?: string; name?: string; uuid?: string }): string {
  // To three.js these have the type "Mesh", too.
  const special = ['InstancedMesh', 'BatchedMesh'].find((type) => is(thing, `is${type}`));
  const type = special ?? thing.type;
  return thing.name ? `${type} "${thing.name}"` : `${type} ${thing.uuid}`;
}

/** What a value is that is none of three.js's objects. */
export function kindOf(value: unknown): string {
  if (value === null) return 'null';
  if (typeof value !== 'object') return typeof value;
  const { type } = value as { type?: unknown };
  if (typeof type === 'string') return `an object of type "${type}"`;
  return `an object of class ${value.constructor?.name ?? 'null'}`;
}

export function refuse(what: string, problem: string): never {
  throw new KdManifoldError('INVALID_MESH', `${what}: ${problem}`);
}

/** Checks that `options` is an object with no other keys than `known`. */
export function checkKeys(options: object, known: string[]): void {
  if (typeof options !== 'object' || options === null) {
    throw new KdManifoldError(
      'INVALID_OPTION',
      `options: expected an object, got ${kindOf(options)}`,
    );
  }
  for (const name of Object.keys(options)) {
    if (!known.includes(name)) {
      throw new KdManifoldError('INVALID_OPTION', `${name}: no such option`);
    }
  }
}
