// SPDX-License-Identifier: MIT
// Reads attributes of geometries as plain numbers: sees through interleaving, normalisation and half
// floats, and applies morph targets.
import { DataUtils } from 'three';
import type { BufferGeometry } from 'three';
import { is, refuse } from './kinds.js';

/** An attribute's numbers, without gaps. May be the attribute's own array: not to be written to. */
export interface Values {
  array: ArrayLike<number>;
  itemSize: number;
  count: number;
  /** Above 0: there is one item for so many instances, not one for each vertex. */
  perInstances: number;
}

/** What the attributes of all versions of three.js have in common. */
export interface RawAttribute {
  array?: unknown;
  data?: { array: unknown; stride: number; meshPerAttribute?: number };
  offset?: number;
  itemSize: number;
  count: number;
  normalized?: boolean;
  meshPerAttribute?: number;
  gpuType?: number;
}

const scales: Record<string, number> = {
  Int8Array: 127,
  Uint8Array: 255,
  Uint8ClampedArray: 255,
  Int16Array: 32767,
  Uint16Array: 65535,
  Int32Array: 2147483647,
  Uint32Array: 4294967295,
};

const typeOf = (array: unknown): string =>
  (array as { [Symbol.toStringTag]?: string } | undefined)?.[Symbol.toStringTag] ?? 'none';

/** The class name of an attribute's array if it holds whole numbers that mean themselves; else null. */
export function wholeType(attribute: RawAttribute): string | null {
  const type = typeOf(attribute.data?.array ?? attribute.array);
  const whole =
    type in scales && !attribute.normalized && !is(attribute, 'isFloat16BufferAttribute');
  return whole ? type : null;
}

/** Reads an attribute; `what` names it in errors. */
export function readAttribute(attribute: RawAttribute, what: string): Values {
  const { itemSize, count, data } = attribute;
  const array = (data?.array ?? attribute.array) as ArrayLike<number>;
  if (!ArrayBuffer.isView(array)) {
    refuse(what, 'its numbers cannot be read: they are not, or no longer, in main memory');
  }
  const stride = data?.stride ?? itemSize;
  const offset = data === undefined ? 0 : (attribute.offset ?? 0);
  const needed = count === 0 ? 0 : (count - 1) * stride + offset + itemSize;
  if (!(needed <= array.length)) {
    refuse(what, `its array has ${array.length} numbers, but ${count} items need ${needed}`);
  }
  const instanced = is(attribute, 'isInstancedBufferAttribute') ? attribute : undefined;
  const shared = is(data, 'isInstancedInterleavedBuffer') ? data : instanced;
  const perInstances = shared === undefined ? 0 : (shared.meshPerAttribute ?? 1);
  const half = is(attribute, 'isFloat16BufferAttribute') && typeOf(array) === 'Uint16Array';
  const scale = attribute.normalized ? (scales[typeOf(array)] ?? 1) : 1;
  if (stride === itemSize && offset === 0 && scale === 1 && !half) {
    return { array, itemSize, count, perInstances };
  }
  const values = new Float64Array(count * itemSize);
  for (let i = 0, to = 0; i < count; ++i) {
    for (let c = 0; c < itemSize; ++c, ++to) {
      const value = array[i * stride + offset + c] as number;
      if (half) values[to] = DataUtils.fromHalfFloat(value);
      else values[to] = scale === 1 ? value : Math.max(value / scale, -1);
    }
  }
  return { array: values, itemSize, count, perInstances };
}

/** Reads the attribute `name`, morphed by `influences`; null if there is none. */
export function readMorphed(
  geometry: BufferGeometry,
  name: string,
  influences: ArrayLike<number> | null,
  what: string,
): Values | null {
  const attribute = geometry.getAttribute(name) as RawAttribute | undefined;
  if (attribute === undefined) return null;
  const base = readAttribute(attribute, `${what}, attribute "${name}"`);
  const targets = (geometry.morphAttributes as Record<string, RawAttribute[] | undefined>)[name];
  if (influences === null || targets === undefined) return base;
  let sum = 0;
  for (let t = 0; t < targets.length; ++t) sum += influences[t] ?? 0;
  const keep = geometry.morphTargetsRelative ? 1 : 1 - sum;
  const morphed = Float64Array.from(base.array, (value) => keep * value);
  targets.forEach((target, t) => {
    const influence = influences[t] ?? 0;
    if (influence === 0) return;
    const label = `${what}, morph target ${t} of "${name}"`;
    const { array, count, itemSize } = readAttribute(target, label);
    if (count < base.count) refuse(label, `it has ${count} items, not ${base.count}`);
    // A target may have fewer numbers per vertex: colours without alpha.
    const common = Math.min(itemSize, base.itemSize);
    for (let i = 0; i < base.count; ++i) {
      for (let c = 0; c < common; ++c) {
        const at = base.itemSize * i + c;
        morphed[at] = (morphed[at] as number) + influence * (array[itemSize * i + c] as number);
      }
    }
  });
  return { ...base, array: morphed };
}
