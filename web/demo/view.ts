// SPDX-License-Identifier: MIT
// One of the views: a mesh, and what is painted over it.
import {
  BackSide,
  BufferGeometry,
  Color,
  Float32BufferAttribute,
  Group,
  HemisphereLight,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  Scene,
  type Plane,
} from 'three';
import type { PolygonMeshInput } from 'kdmanifold';
import { toBufferGeometry } from 'kdmanifold/three';
import type { CreaseFinder } from './crease-finder';
import type { Finding, Kind } from './findings';
import { paint, type Paint } from './overlay';

// The material's name says what the thing is there for.
type Drawn =
  | Mesh<BufferGeometry, MeshStandardMaterial | MeshBasicMaterial>
  | LineSegments<BufferGeometry, LineBasicMaterial>;

/** Which lines are drawn over the faces. */
export interface Lines {
  wireframe: boolean;
  creases: boolean;
}

/** What all views have in common. */
export interface Common {
  /** Faces in front of the plane are not drawn; the inside of a model shows its back faces' colour. */
  cut: Plane;
  lines: Lines;
  creases: CreaseFinder;
  /** Asks for the next frame. */
  draw: () => void;
}

/** What is drawn in one element of the page. */
export class View {
  readonly scene = new Scene();
  /** Holds what is drawn, turned so that up is up. */
  readonly root = new Group();
  #drawn: Drawn[] = [];
  #paints: Paint[] = [];

  constructor(
    readonly element: HTMLElement,
    readonly common: Common,
  ) {
    this.scene.add(new HemisphereLight(0xffffff, 0x8090a4, 1.5), this.root);
  }

  /** Shows a mesh, or nothing, without paint, and returns the mesh's geometry. */
  show(mesh: PolygonMeshInput | null): BufferGeometry | null {
    this.#clear();
    if (mesh === null) return null;
    const geometry = toBufferGeometry(mesh);
    this.#drawn = this.#dress(geometry);
    this.root.add(...this.#drawn);
    void this.#addCreases(geometry);
    this.restyle();
    return geometry;
  }

  /** Paints findings over the mesh, in addition to those that are there. */
  paint(findings: Finding[]): void {
    for (const finding of findings) {
      const made = paint(finding, this.common.cut);
      this.#paints.push(made);
      this.root.add(...made.objects);
    }
  }

  /** Takes one kind of finding away. */
  unpaint(kind: Kind): void {
    const gone = this.#paints.filter((made) => made.kind === kind);
    this.#paints = this.#paints.filter((made) => made.kind !== kind);
    for (const { objects, dispose } of gone) {
      this.root.remove(...objects);
      dispose();
    }
  }

  /** Shows or hides one kind of finding. */
  showPaint(kind: Kind, visible: boolean): void {
    for (const made of this.#paints) {
      if (made.kind !== kind) continue;
      for (const object of made.objects) object.visible = visible;
    }
  }

  /** Takes over which lines are to be seen, and colours that go with a light or a dark page. */
  restyle(): void {
    const { wireframe, creases } = this.common.lines;
    const dark = matchMedia('(prefers-color-scheme: dark)').matches;
    const colours: Record<string, string> = dark
      ? { front: '#7f9cbc', back: '#b4553f', wire: '#c9d8ea', crease: '#e8f0fa' }
      : { front: '#9db6d3', back: '#d9694c', wire: '#32465c', crease: '#14202e' };
    for (const object of this.#drawn) {
      const { name } = object.material;
      if (name === 'wire') object.visible = wireframe;
      if (name === 'crease') object.visible = creases;
      object.material.color = new Color(colours[name]);
    }
    this.common.draw();
  }

  #clear(): void {
    for (const object of this.#drawn) {
      object.geometry.dispose();
      object.material.dispose();
      this.root.remove(object);
    }
    this.#drawn = [];
    for (const { kind } of [...this.#paints]) this.unpaint(kind);
    this.common.draw();
  }

  #dress(geometry: BufferGeometry): Drawn[] {
    const clippingPlanes = [this.common.cut];
    const offset = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };
    const common = { flatShading: true, roughness: 0.7, clippingPlanes, ...offset };
    const faces = new Mesh(geometry, new MeshStandardMaterial({ ...common, name: 'front' }));
    const backs = new Mesh(
      geometry,
      new MeshStandardMaterial({ ...common, name: 'back', side: BackSide }),
    );
    const wires = new Mesh(
      geometry,
      new MeshBasicMaterial({ name: 'wire', wireframe: true, clippingPlanes }),
    );
    return [faces, backs, wires];
  }

  // The sharp edges come when they are found, unless something else is shown by then.
  async #addCreases(geometry: BufferGeometry): Promise<void> {
    const lines = await this.common.creases.find(geometry);
    if (this.#drawn[0]?.geometry !== geometry) return;
    const ends = new BufferGeometry();
    ends.setAttribute('position', new Float32BufferAttribute(lines, 3));
    const material = new LineBasicMaterial({
      name: 'crease',
      clippingPlanes: [this.common.cut],
    });
    const edges = new LineSegments(ends, material);
    this.#drawn.push(edges);
    this.root.add(edges);
    this.restyle();
  }
}
