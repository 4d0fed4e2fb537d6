// SPDX-License-Identifier: MIT
// The sample models: made here, so they are nobody else's and cost no download. One is damaged in
// all ways; most consist of shells that overlap, which is what a modeller produces and a slicer
// refuses.
import {
  BoxGeometry,
  ExtrudeGeometry,
  Matrix4,
  Path,
  Shape,
  Vector3,
  type BufferGeometry,
  type Vector2Tuple,
} from 'three';
import type { MeshInput } from 'kdmanifold';
import { fromBufferGeometry } from 'kdmanifold/three';
import { damage } from './damage';

/** A sample by its name in the menu. */
export interface Sample {
  name: string;
  make(): MeshInput;
}

export const samples: Sample[] = [
  { name: 'Damaged knot', make: () => damage(torusKnot()) },
  { name: 'Bracket (five overlapping parts)', make: bracket },
  { name: 'Gear with a shaft', make: gear },
  { name: 'Torus knot', make: torusKnot },
  { name: 'Overlapping and hollow shells', make: shells },
  { name: 'Cube', make: () => soup(new BoxGeometry(2, 2, 2)) },
];

/** Puts meshes side by side in one pair of arrays, without joining anything. */
function together(parts: MeshInput[]): MeshInput {
  const positions = new Float32Array(parts.reduce((sum, part) => sum + part.positions.length, 0));
  const indices: number[] = [];
  let at = 0;
  for (const part of parts) {
    positions.set(part.positions, at);
    const count = part.positions.length / 3;
    const own = part.indices ?? Uint32Array.from({ length: count }, (_, i) => i);
    for (const index of own) indices.push(index + at / 3);
    at += part.positions.length;
  }
  return { positions, indices: Uint32Array.from(indices) };
}

function soup(geometry: BufferGeometry, place = new Matrix4()): MeshInput {
  return fromBufferGeometry(geometry.applyMatrix4(place));
}

function circle(x: number, y: number, radius: number, steps: number): Path {
  const path = new Path();
  for (let i = 0; i < steps; ++i) {
    const angle = (-2 * Math.PI * i) / steps;
    const point: Vector2Tuple = [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
    if (i === 0) path.moveTo(...point);
    else path.lineTo(...point);
  }
  path.closePath();
  return path;
}

function extrude(outline: Vector2Tuple[], holes: Path[], depth: number): ExtrudeGeometry {
  const shape = new Shape();
  outline.forEach((point, i) => (i === 0 ? shape.moveTo(...point) : shape.lineTo(...point)));
  shape.closePath();
  shape.holes = holes;
  return new ExtrudeGeometry(shape, { depth, bevelEnabled: false, curveSegments: 1 });
}

function rectangle(x0: number, y0: number, x1: number, y1: number): Vector2Tuple[] {
  return [
    [x0, y0],
    [x1, y0],
    [x1, y1],
    [x0, y1],
  ];
}

function bracket(): MeshInput {
  const base = extrude(
    rectangle(-40, -25, 40, 25),
    [circle(-28, 0, 5, 32), circle(28, 0, 5, 32)],
    8,
  );
  const upright = extrude(rectangle(-25, 0, 25, 50), [circle(0, 32, 10, 48)], 8);
  const boss = extrude(ring(0, 32, 16, 48), [circle(0, 32, 10, 48)], 16);
  const rib = (): ExtrudeGeometry =>
    extrude(
      [
        [0, 2],
        [26, 2],
        [26, 10],
        [4, 36],
        [0, 36],
      ],
      [],
      6,
    );
  // Shapes lie in the xy plane: stand them up, the ribs along y.
  const stand = turn([1, 0, 0], [0, 0, 1], [0, -1, 0]);
  const along = turn([0, -1, 0], [0, 0, 1], [-1, 0, 0]);
  return together([
    soup(base),
    soup(upright, new Matrix4().setPosition(0, 24, 0).multiply(stand)),
    soup(boss, new Matrix4().setPosition(0, 26, 0).multiply(stand)),
    soup(rib(), new Matrix4().setPosition(-15, 18, 0).multiply(along)),
    soup(rib(), new Matrix4().setPosition(21, 18, 0).multiply(along)),
  ]);
}

function turn(x: number[], y: number[], z: number[]): Matrix4 {
  return new Matrix4().makeBasis(new Vector3(...x), new Vector3(...y), new Vector3(...z));
}

function ring(x: number, y: number, radius: number, steps: number): Vector2Tuple[] {
  return Array.from({ length: steps }, (_, i): Vector2Tuple => {
    const angle = (2 * Math.PI * i) / steps;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
  });
}

function gear(): MeshInput {
  const teeth = 18;
  const outline: Vector2Tuple[] = [];
  for (let tooth = 0; tooth < teeth; ++tooth) {
    for (const [part, radius] of [
      [0.0, 25],
      [0.32, 25],
      [0.42, 30],
      [0.9, 30],
    ] as const) {
      const angle = (2 * Math.PI * (tooth + part)) / teeth;
      outline.push([radius * Math.cos(angle), radius * Math.sin(angle)]);
    }
  }
  const windows = Array.from({ length: 6 }, (_, i) => {
    const angle = (Math.PI * i) / 3;
    return circle(15 * Math.cos(angle), 15 * Math.sin(angle), 4.5, 32);
  });
  const shaft = extrude(ring(0, 0, 7, 48), [circle(0, 0, 4, 48)], 30);
  return together([
    soup(extrude(outline, [...windows, circle(0, 0, 4, 48)], 10)),
    soup(shaft, new Matrix4().setPosition(0, 0, -10)),
  ]);
}

// Rings of points along a curve; numbers wrap around, so the ends meet exactly.
function torusKnot(): MeshInput {
  const [p, q, along, around, thickness] = [2, 3, 320, 32, 5];
  const positions = new Float32Array(along * around * 3);
  const curve = (u: number): [number, number, number] => {
    const radius = 16 * (2 + Math.cos((q * u) / p)) * 0.5;
    return [radius * Math.cos(u), radius * Math.sin(u), 8 * Math.sin((q * u) / p)];
  };
  for (let i = 0; i < along; ++i) {
    const u = (i / along) * p * 2 * Math.PI;
    const [here, next] = [curve(u), curve(u + 0.01)];
    const tangent = next.map((value, k) => value - (here[k] ?? 0));
    const sum = next.map((value, k) => value + (here[k] ?? 0));
    const side = normal(cross(tangent, sum));
    const up = normal(cross(side, tangent));
    for (let j = 0; j < around; ++j) {
      const v = (j / around) * 2 * Math.PI;
      for (let k = 0; k < 3; ++k) {
        positions[(i * around + j) * 3 + k] =
          (here[k] ?? 0) +
          thickness * (Math.cos(v) * (side[k] ?? 0) + Math.sin(v) * (up[k] ?? 0)) * 0.8;
      }
    }
  }
  return { positions, indices: wrappedGrid(along, around) };
}

function wrappedGrid(along: number, around: number): Uint32Array {
  const indices: number[] = [];
  for (let i = 0; i < along; ++i) {
    for (let j = 0; j < around; ++j) {
      const [a, b] = [i * around, ((i + 1) % along) * around];
      const [c, d] = [j, (j + 1) % around];
      indices.push(a + c, b + c, b + d, a + c, b + d, a + d);
    }
  }
  return Uint32Array.from(indices);
}

type Vector = readonly number[];

function cross(a: Vector, b: Vector): Vector {
  const [ax = 0, ay = 0, az = 0] = a;
  const [bx = 0, by = 0, bz = 0] = b;
  return [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
}

function normal(a: Vector): Vector {
  const length = Math.hypot(...a);
  return a.map((value) => value / length);
}

// Two balls and a box that overlap, and a cavity: a ball turned inside out within the first.
function shells(): MeshInput {
  return together([
    ball(0, 0, 0, 20, 1),
    ball(0, 0, 0, 13, -1),
    ball(22, 4, 6, 14, 1),
    soup(new BoxGeometry(18, 18, 60), new Matrix4().setPosition(-14, -10, 4)),
  ]);
}

function ball(x: number, y: number, z: number, radius: number, side: 1 | -1): MeshInput {
  const [around, rows] = [48, 24];
  const positions: number[] = [x, y, z - radius];
  for (let i = 1; i < rows; ++i) {
    const v = (i / rows - 0.5) * Math.PI;
    for (let j = 0; j < around; ++j) {
      const u = (j / around) * 2 * Math.PI;
      positions.push(
        x + radius * Math.cos(v) * Math.cos(u),
        y + radius * Math.cos(v) * Math.sin(u),
        z + radius * Math.sin(v),
      );
    }
  }
  const top = positions.push(x, y, z + radius) / 3 - 1;
  const indices: number[] = [];
  const triangle = (a: number, b: number, c: number): void => {
    indices.push(a, ...(side > 0 ? [b, c] : [c, b]));
  };
  const at = (i: number, j: number): number => 1 + (i - 1) * around + (j % around);
  for (let j = 0; j < around; ++j) {
    triangle(0, at(1, j + 1), at(1, j));
    triangle(top, at(rows - 1, j), at(rows - 1, j + 1));
    for (let i = 1; i + 1 < rows; ++i) {
      triangle(at(i, j), at(i, j + 1), at(i + 1, j + 1));
      triangle(at(i, j), at(i + 1, j + 1), at(i + 1, j));
    }
  }
  return { positions: Float32Array.from(positions), indices: Uint32Array.from(indices) };
}
