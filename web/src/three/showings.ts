// SPDX-License-Identifier: MIT
// How often and where a mesh is shown: once, or once an instance.
import type { InstancedMesh, Mesh } from 'three';
import { readAttribute } from './attributes.js';
import type { Skipped } from './collect.js';
import { isInstanced, nameOf, refuse } from './kinds.js';
import type { MaterialList } from './materials.js';
import type { SourcePart } from './source.js';
import { drawnOf, surfaceOf, type Surface } from './surface.js';
import { multiply, orientationOf, type Matrix } from './transform.js';

/** A surface at its place. */
export interface Showing {
  surface: Surface;
  matrix: Matrix;
  mirrored: boolean;
  /** What is added to the numbers of the surface's materials. */
  firstMaterial: number;
  part: Omit<SourcePart, 'firstTriangle' | 'firstVertex'>;
}

interface Instance {
  name: string;
  instance: number;
  matrix: Matrix;
  influences: number[] | null;
  tint: number[] | null;
}

/** Lists the showings of a mesh, and notes those without any area. */
export function showingsOf(
  mesh: Mesh,
  onlyVisible: boolean,
  list: MaterialList,
  skipped: Skipped[],
): Showing[] {
  const drawn = drawnOf(mesh, onlyVisible, skipped);
  if (drawn === null) return [];
  const what = nameOf(mesh);
  const { geometry, material } = mesh;
  const coloured = [material].flat().some((own) => own.vertexColors);
  const surfaces = new Map<number[] | null, Surface>();
  const showings: Showing[] = [];
  for (const { name, instance, matrix, influences, tint } of instancesOf(mesh, skipped)) {
    const orientation = orientationOf(matrix);
    if (Number.isNaN(orientation)) refuse(name, 'its matrix has numbers that are not finite');
    if (orientation === 0) {
      skipped.push({ object: mesh, name, reason: 'its matrix scales it to nothing' });
      continue;
    }
    const surface = surfaces.get(influences) ?? surfaceOf(mesh, geometry, influences, drawn, what);
    surfaces.set(influences, surface);
    showings.push({
      surface,
      matrix,
      mirrored: orientation < 0,
      firstMaterial: list.add(material, tint !== null),
      part: {
        object: mesh,
        geometry,
        instance,
        influences,
        tint,
        coloured: tint === null || coloured,
      },
    });
  }
  return showings;
}

function instancesOf(mesh: Mesh, skipped: Skipped[]): Instance[] {
  const { elements } = mesh.matrixWorld;
  const influences = mesh.morphTargetInfluences ?? null;
  const name = nameOf(mesh);
  if (!isInstanced(mesh)) return [{ name, instance: 0, matrix: elements, influences, tint: null }];
  if (mesh.count === 0) skipped.push({ object: mesh, name, reason: 'it has no instances' });
  const matrixOf = itemsOf(mesh, 'instanceMatrix');
  const tintOf = mesh.instanceColor ? itemsOf(mesh, 'instanceColor') : () => null;
  return Array.from({ length: mesh.count }, (_, instance) => ({
    name: `${name}, instance ${instance}`,
    instance,
    matrix: multiply(elements, matrixOf(instance)),
    influences: mesh.morphTexture ? instanceInfluences(mesh, instance) : influences,
    tint: tintOf(instance),
  }));
}

/** How to get the numbers of one instance. */
function itemsOf(
  mesh: InstancedMesh,
  name: 'instanceMatrix' | 'instanceColor',
): (instance: number) => number[] {
  const what = `${nameOf(mesh)}, ${name}`;
  const { array, itemSize, count } = readAttribute(
    mesh[name] as InstancedMesh['instanceMatrix'],
    what,
  );
  if (count < mesh.count) refuse(what, `it has ${count} items for ${mesh.count} instances`);
  return (instance) =>
    Array.from({ length: itemSize }, (_, c) => array[itemSize * instance + c] as number);
}

// Newer three.js only: morph targets that count differently for each instance.
function instanceInfluences(mesh: InstancedMesh, instance: number): number[] {
  const [targets = []] = Object.values(mesh.geometry.morphAttributes);
  const holder = { morphTargetInfluences: targets.map(() => 0) };
  mesh.getMorphAt(instance, holder as unknown as Mesh);
  return holder.morphTargetInfluences;
}
