// SPDX-License-Identifier: MIT
// Findings as things to be drawn over a mesh: thick lines, tinted faces, points. What lies behind
// the model shows through it faintly, since holes tend to be on the other side.
import {
  BufferGeometry,
  DoubleSide,
  Float32BufferAttribute,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  Points,
  PointsMaterial,
  type Material,
  type Object3D,
  type Plane,
} from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { defectKinds, type DefectKind, type Finding, type Kind } from './findings';
import { paints } from './legend';

const lineWidth = 2.5;
const pointSize = 8;
const manyPoints = 200;
const smallPoint = 4;
// So many would hide the model, and be slow to draw: they are thin and do not show through.
const manyLines = 5000;
const throughOpacity = 0.22;

/** One kind of finding, painted. */
export interface Paint {
  kind: Kind;
  objects: Object3D[];
  dispose: () => void;
}

/** Objects for the scene; `cut` is the plane beyond which nothing is drawn. */
export function paint(finding: Finding, cut: Plane): Paint {
  const { kind, shape, positions } = finding;
  const common = { color: paints[kind].colour, clippingPlanes: [cut] };
  const through = { ...common, depthTest: false, transparent: true, opacity: throughOpacity };
  const make = { lines: makeLines, points: makePoints, faces: makeFaces }[shape];
  return make(kind, positions, common, through);
}

type Look = Pick<Material, 'clippingPlanes'> &
  Partial<Pick<Material, 'opacity'>> & { color: string };

function makeLines(kind: Kind, positions: Float32Array, near: Look, through: Look): Paint {
  if (positions.length > 6 * manyLines) return makeThinLines(kind, positions, near);
  const geometry = new LineSegmentsGeometry().setPositions(positions);
  const materials = [near, through].map(
    (look) => new LineMaterial({ ...look, linewidth: lineWidth }),
  );
  const objects = materials.map((material) => new LineSegments2(geometry, material));
  return asPaint(kind, geometry, materials, onTop(objects));
}

function makeThinLines(kind: Kind, positions: Float32Array, look: Look): Paint {
  const geometry = geometryOf(positions);
  const material = new LineBasicMaterial(look);
  return asPaint(kind, geometry, [material], onTop([new LineSegments(geometry, material)]));
}

function makePoints(kind: Kind, positions: Float32Array, near: Look, through: Look): Paint {
  const geometry = geometryOf(positions);
  const size = positions.length > 3 * manyPoints ? smallPoint : pointSize;
  const materials = [near, through].map(
    (look) => new PointsMaterial({ ...look, size, sizeAttenuation: false }),
  );
  const objects = materials.map((material) => new Points(geometry, material));
  return asPaint(kind, geometry, materials, onTop(objects));
}

function makeFaces(kind: Kind, positions: Float32Array, near: Look, through: Look): Paint {
  const geometry = geometryOf(positions);
  // In front of the mesh's own faces, which are pushed back by 1, each kind behind the one before
  // it: faces that lie on each other cross as well, and many more faces cross than do else.
  // What is lost is said before all else.
  const offset = isDefect(kind) ? defectKinds.indexOf(kind) / 10 : 0;
  const material = new MeshStandardMaterial({
    ...near,
    flatShading: true,
    roughness: 0.7,
    side: DoubleSide,
    transparent: true,
    opacity: kind === 'crossing' ? 0.5 : kind === 'lost' ? 0.95 : 0.8,
    depthWrite: false,
    polygonOffset: true,
    polygonOffsetFactor: offset,
    polygonOffsetUnits: offset,
  });
  const mesh = new Mesh(geometry, material);
  mesh.renderOrder = 1 - offset;
  if (kind !== 'lost') return asPaint(kind, geometry, [material], [mesh]);
  // Nobody should have to turn the model to see that something is missing.
  const faint = new MeshBasicMaterial({ ...through, side: DoubleSide });
  const behind = new Mesh(geometry, faint);
  behind.renderOrder = 2;
  return asPaint(kind, geometry, [material, faint], [mesh, behind]);
}

const isDefect = (kind: Kind): kind is DefectKind =>
  (defectKinds as readonly Kind[]).includes(kind);

// Drawn after the faces, tinted or not.
function onTop(objects: Object3D[]): Object3D[] {
  for (const object of objects) object.renderOrder = 2;
  return objects;
}

function geometryOf(positions: Float32Array): BufferGeometry {
  return new BufferGeometry().setAttribute('position', new Float32BufferAttribute(positions, 3));
}

function asPaint(
  kind: Kind,
  geometry: BufferGeometry,
  materials: Material[],
  objects: Object3D[],
): Paint {
  return {
    kind,
    objects,
    dispose() {
      geometry.dispose();
      for (const material of materials) material.dispose();
    },
  };
}
