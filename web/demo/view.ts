// SPDX-License-Identifier: MIT
// One of the views: a mesh, and what is painted over it.
import {
  BackSide,
  BufferAttribute,
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
  type MeshStandardMaterialParameters,
  type Plane,
} from 'three';
import type { PolygonMeshInput } from 'kdmanifold';
import { toBufferGeometry } from 'kdmanifold/three';
import type { CreaseFinder } from './crease-finder';
import type { Finding, Kind } from './findings';
import { coloursOf } from './heat-colours';
import type { Heat } from './measure';
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
  // Findings, which would hide distances.
  readonly #painted = new Group();
  #drawn: Drawn[] = [];
  #paints: Paint[] = [];
  #mesh: PolygonMeshInput | null = null;

  constructor(
    readonly element: HTMLElement,
    readonly common: Common,
  ) {
    this.root.add(this.#painted);
    this.scene.add(new HemisphereLight(0xffffff, 0x8090a4, 1.5), this.root);
  }

  /** Shows a mesh, or nothing, without paint, and returns the mesh's geometry. */
  show(mesh: PolygonMeshInput | null): BufferGeometry | null {
    this.#clear();
    this.#mesh = mesh;
    if (mesh === null) return null;
    const geometry = toBufferGeometry(mesh);
    this.#drawn = this.#dress(geometry);
    this.root.add(...this.#drawn);
    void this.#addCreases(geometry);
    this.restyle();
    return geometry;
  }

  /** The mesh that is shown. */
  get mesh(): PolygonMeshInput | null {
    return this.#mesh;
  }

  /** Shows distances as colours, `largest` as the last of these, in place of the faces' own; null: no more. */
  setHeat(heat: Heat | null, largest: number): void {
    this.#remove(this.#drawn.filter(({ material }) => material.name === 'heat'));
    if (heat !== null) {
      const geometry = new BufferGeometry();
      geometry.setAttribute('position', new BufferAttribute(heat.positions, 3));
      const colours = coloursOf(heat.distances, largest);
      geometry.setAttribute('color', new BufferAttribute(colours, 3));
      geometry.setIndex(new BufferAttribute(heat.indices, 1));
      const look = { ...this.#look(), name: 'heat', vertexColors: true };
      const faces = new Mesh(geometry, new MeshStandardMaterial(look));
      this.#drawn.push(faces);
      this.root.add(faces);
    }
    this.restyle();
  }

  /** Paints findings over the mesh, in addition to those that are there. */
  paint(findings: Finding[]): void {
    for (const finding of findings) {
      const made = paint(finding, this.common.cut);
      this.#paints.push(made);
      this.#painted.add(...made.objects);
    }
  }

  /** Takes one kind of finding away. */
  unpaint(kind: Kind): void {
    const gone = this.#paints.filter((made) => made.kind === kind);
    this.#paints = this.#paints.filter((made) => made.kind !== kind);
    for (const { objects, dispose } of gone) {
      this.#painted.remove(...objects);
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
    const isHot = this.#drawn.some(({ material }) => material.name === 'heat');
    this.#painted.visible = !isHot;
    for (const object of this.#drawn) {
      const { name } = object.material;
      if (name === 'wire') object.visible = wireframe;
      if (name === 'front') object.visible = !isHot;
      if (name === 'heat') continue;
      if (name === 'crease') object.visible = creases;
      object.material.color = new Color(colours[name]);
    }
    this.common.draw();
  }

  #clear(): void {
    this.#remove(this.#drawn);
    for (const { kind } of [...this.#paints]) this.unpaint(kind);
    this.common.draw();
  }

  #remove(objects: Drawn[]): void {
    for (const object of objects) {
      object.geometry.dispose();
      object.material.dispose();
      this.root.remove(object);
    }
    this.#drawn = this.#drawn.filter((object) => !objects.includes(object));
  }

  #look(): MeshStandardMaterialParameters {
    return {
      flatShading: true,
      roughness: 0.7,
      clippingPlanes: [this.common.cut],
      polygonOffset: true,
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 1,
    };
  }

  #dress(geometry: BufferGeometry): Drawn[] {
    const clippingPlanes = [this.common.cut];
    const faces = new Mesh(geometry, new MeshStandardMaterial({ ...this.#look(), name: 'front' }));
    const backs = new Mesh(
      geometry,
      new MeshStandardMaterial({ ...this.#look(), name: 'back', side: BackSide }),
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
