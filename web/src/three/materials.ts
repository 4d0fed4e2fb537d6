// SPDX-License-Identifier: MIT
// Numbers the materials of several objects, so that one mesh can have them all.
import { MeshBasicMaterial } from 'three';
import type { Material } from 'three';

type Materials = Material | Material[];

/** The materials of all objects so far. Those of one object have numbers in a row. */
export class MaterialList {
  readonly materials: Material[] = [];
  #plain = new Map<Materials, number>();
  #tinted = new Map<Materials, number>();

  /** The number of an object's first material. With `tinted`, the materials show vertex colours. */
  add(given: Materials | null | undefined, tinted: boolean): number {
    const own = given ?? new MeshBasicMaterial();
    const known = tinted ? this.#tinted : this.#plain;
    const number = known.get(own) ?? this.materials.length;
    if (!known.has(own)) {
      known.set(own, number);
      for (const material of Array.isArray(own) ? own : [own]) {
        this.materials.push(tinted ? showingColours(material) : material);
      }
    }
    return number;
  }
}

// The colours of instances become vertex colours, which a material must be told to show.
function showingColours(material: Material): Material {
  if (material.vertexColors) return material;
  const copy = material.clone();
  copy.vertexColors = true;
  return copy;
}
