// SPDX-License-Identifier: MIT
// Helpers for the tests of the three.js adapter.
import { BufferAttribute, BufferGeometry } from 'three';

/** A mesh as its own result: every triangle stands for itself. */
export function asResult({ positions, indices }) {
  const count = (indices?.length ?? positions.length / 3) / 3;
  return {
    positions: Float32Array.from(positions),
    indices,
    sourceFaces: Uint32Array.from({ length: count }, (_, i) => i),
  };
}

/** A geometry of two triangles, [0, 1, 2] and [1, 3, 2], of the unit square, with an index. */
export function square() {
  const geometry = new BufferGeometry();
  const positions = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0);
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  return geometry.setIndex([0, 1, 2, 1, 3, 2]);
}

/** A copy of the positions as an attribute of another name, which no transformation changes. */
export function withLocal(geometry, name = 'local') {
  const { array } = geometry.getAttribute('position');
  return geometry.setAttribute(name, new BufferAttribute(array.slice(), 3));
}

/** The numbers of an attribute, one array per vertex. */
export function itemsOf(attribute) {
  return Array.from({ length: attribute.count }, (_, i) => [
    ...attribute.array.slice(attribute.itemSize * i, attribute.itemSize * (i + 1)),
  ]);
}

/** The code, and the message, that a call fails with. */
export function failure(call) {
  try {
    call();
  } catch (error) {
    return `${error.code}: ${error.message}`;
  }
  return 'none';
}
