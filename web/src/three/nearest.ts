// SPDX-License-Identifier: MIT
// Finds the point of a surface that is nearest to another point, from a triangle near it on: walks over
// edges as long as that leads nearer. It never crosses a seam, where triangles share no vertices.

/** Walks; holds what it found last. */
export class NearestPoint {
  /** The triangle of the point. */
  triangle = 0;
  /** The weights of the triangle's second and third corner. That of the first is what is left to 1. */
  second = 0;
  third = 0;
  /** The square of the distance. */
  distance = Infinity;

  #on = 0; // the corners with a weight above 0, as bits
  #positions: ArrayLike<number>;
  #corners: ArrayLike<number>;
  #mates: Int32Array;
  #touching: number;

  /**
   * The vertices of `corners` are joined where there is no seam, and `mates` are those of its edges. A
   * distance whose square is not above `touching` is none.
   */
  constructor(
    positions: ArrayLike<number>,
    corners: ArrayLike<number>,
    mates: Int32Array,
    touching: number,
  ) {
    this.#positions = positions;
    this.#corners = corners;
    this.#mates = mates;
    this.#touching = touching;
  }

  /** Finds a point from `triangle` on. */
  find(triangle: number, x: number, y: number, z: number): void {
    this.distance = Infinity;
    this.#try(triangle, x, y, z);
    while (this.distance > this.#touching && this.#step(x, y, z));
  }

  /** Goes on to a triangle that is nearer, over the edge or round the vertex where the point is. */
  #step(x: number, y: number, z: number): boolean {
    const { triangle } = this;
    switch (this.#on) {
      case 3:
        return this.#cross(3 * triangle, x, y, z);
      case 6:
        return this.#cross(3 * triangle + 1, x, y, z);
      case 5:
        return this.#cross(3 * triangle + 2, x, y, z);
      case 1:
        return this.#turn(triangle, 0, x, y, z);
      case 2:
        return this.#turn(triangle, 1, x, y, z);
      case 4:
        return this.#turn(triangle, 2, x, y, z);
      default:
        return false; // inside, where the distance is least
    }
  }

  #cross(edge: number, x: number, y: number, z: number): boolean {
    const mate = this.#mates[edge] as number;
    return mate >= 0 && this.#try(Math.floor(mate / 3), x, y, z);
  }

  #turn(triangle: number, corner: number, x: number, y: number, z: number): boolean {
    return (
      this.#turnOver(3 * triangle + corner, true, x, y, z) ||
      this.#turnOver(3 * triangle + ((corner + 2) % 3), false, x, y, z)
    );
  }

  /** Goes round the vertex at the start or the end of an edge, over that edge first. */
  #turnOver(edge: number, atStart: boolean, x: number, y: number, z: number): boolean {
    const vertex = this.#corners[atStart ? edge : nextOf(edge)] as number;
    const start = Math.floor(edge / 3);
    let mate = this.#mates[edge] as number;
    // Mates are so of each other: the way round leads back, or ends.
    while (mate >= 0 && Math.floor(mate / 3) !== start) {
      if (this.#try(Math.floor(mate / 3), x, y, z)) return true;
      const other = this.#corners[mate] === vertex ? nextOf(nextOf(mate)) : nextOf(mate);
      mate = this.#mates[other] as number;
    }
    return false;
  }

  /** Takes the nearest point of a triangle if it is nearer than what was found. */
  #try(triangle: number, x: number, y: number, z: number): boolean {
    const p = this.#positions;
    const a = 3 * (this.#corners[3 * triangle] as number);
    const b = 3 * (this.#corners[3 * triangle + 1] as number);
    const c = 3 * (this.#corners[3 * triangle + 2] as number);
    const ax = p[a] as number;
    const ay = p[a + 1] as number;
    const az = p[a + 2] as number;
    const ux = (p[b] as number) - ax;
    const uy = (p[b + 1] as number) - ay;
    const uz = (p[b + 2] as number) - az;
    const vx = (p[c] as number) - ax;
    const vy = (p[c + 1] as number) - ay;
    const vz = (p[c + 2] as number) - az;
    const qx = x - ax;
    const qy = y - ay;
    const qz = z - az;
    const uu = ux * ux + uy * uy + uz * uz;
    const uv = ux * vx + uy * vy + uz * vz;
    const vv = vx * vx + vy * vy + vz * vz;
    const uq = ux * qx + uy * qy + uz * qz;
    const vq = vx * qx + vy * qy + vz * qz;
    const determinant = uu * vv - uv * uv;
    const s = vv * uq - uv * vq;
    const t = uu * vq - uv * uq;
    const distanceAt = (second: number, third: number): number => {
      const dx = qx - second * ux - third * vx;
      const dy = qy - second * uy - third * vy;
      const dz = qz - second * uz - third * vz;
      return dx * dx + dy * dy + dz * dz;
    };
    if (determinant > 0 && s > 0 && t > 0 && s + t < determinant) {
      const second = s / determinant;
      const third = t / determinant;
      return this.#take(triangle, 7, second, third, distanceAt(second, third));
    }
    // Otherwise it is on one of the edges.
    const onU = along(uq, uu);
    const onV = along(vq, vv);
    const onW = along(vq - uq + uu - uv, uu - 2 * uv + vv);
    const takenU = this.#take(triangle, ends(onU, 1, 2), onU, 0, distanceAt(onU, 0));
    const takenV = this.#take(triangle, ends(onV, 1, 4), 0, onV, distanceAt(0, onV));
    const takenW = this.#take(triangle, ends(onW, 2, 4), 1 - onW, onW, distanceAt(1 - onW, onW));
    return takenU || takenV || takenW;
  }

  #take(triangle: number, on: number, second: number, third: number, distance: number): boolean {
    if (!(distance < this.distance)) return false;
    this.#on = on;
    this.triangle = triangle;
    this.second = second;
    this.third = third;
    this.distance = distance;
    return true;
  }
}

/** The next edge, or corner, of the same triangle. */
function nextOf(edge: number): number {
  return edge % 3 === 2 ? edge - 2 : edge + 1;
}

/** How far along an edge, from 0 to 1, the point is that is nearest. */
function along(dot: number, length: number): number {
  return length > 0 ? Math.min(Math.max(dot / length, 0), 1) : 0;
}

/** Which ends of an edge have a weight there. */
function ends(along: number, start: number, end: number): number {
  return (along < 1 ? start : 0) + (along > 0 ? end : 0);
}
