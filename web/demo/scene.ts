// SPDX-License-Identifier: MIT
// Two views of one space: one renderer, one camera, one set of controls, so they can never part.
import {
  BackSide,
  BufferGeometry,
  Color,
  DirectionalLight,
  Float32BufferAttribute,
  Group,
  HemisphereLight,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  PerspectiveCamera,
  Plane,
  Scene,
  Sphere,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { PolygonMeshInput } from 'kdmanifold';
import { toBufferGeometry } from 'kdmanifold/three';
import { CreaseFinder } from './crease-finder';
import type { Finding, Kind } from './findings';
import { turnByKey } from './keyboard';
import { paint, type Paint } from './overlay';
import { sides, type Side } from './sides';

interface View {
  element: HTMLElement;
  scene: Scene;
  /** Holds what is drawn, turned so that up is up. */
  root: Group;
  drawn: Drawn[];
  /** Findings painted over what is drawn. */
  paints: Paint[];
}

// The material's name says what the thing is there for.
type Drawn =
  | Mesh<BufferGeometry, MeshStandardMaterial | MeshBasicMaterial>
  | LineSegments<BufferGeometry, LineBasicMaterial>;

/** Which lines are drawn over the faces. */
export interface Lines {
  wireframe: boolean;
  creases: boolean;
}

/** The 3D part of the page. */
export class Stage {
  readonly #renderer: WebGLRenderer;
  readonly #camera = new PerspectiveCamera(35, 1, 0.01, 100);
  readonly #controls: OrbitControls;
  readonly #views: { input: View; output: View };
  readonly #light = new DirectionalLight(0xffffff, 2.2);
  // Faces in front of the plane are not drawn; the inside of the model shows its back faces' colour.
  readonly #cut = new Plane(new Vector3(0, 1, 0), 1);
  readonly #host: HTMLElement;
  readonly #lines: Lines = { wireframe: false, creases: true };
  readonly #creases = new CreaseFinder();
  #sphere = new Sphere(new Vector3(), 1);
  #centre = new Vector3();
  #scheduled = false;

  constructor(
    host: HTMLElement,
    canvas: HTMLCanvasElement,
    input: HTMLElement,
    output: HTMLElement,
  ) {
    this.#host = host;
    this.#renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.#renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.#renderer.localClippingEnabled = true;
    this.#renderer.setScissorTest(true);
    this.#views = { input: makeView(input), output: makeView(output) };
    this.#camera.add(this.#light);
    this.#light.position.set(0.6, 1, 0.8);
    this.#camera.up.set(0, 0, 1);
    this.#controls = new OrbitControls(this.#camera, host);
    this.#controls.addEventListener('change', () => this.draw());
    host.addEventListener('keydown', (event) => {
      if (!turnByKey(event, this.#camera, this.#controls.target)) return;
      this.#controls.update();
      this.draw();
    });
    new ResizeObserver(() => this.draw()).observe(host);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.#recolour());
    this.lookFrom('corner');
  }

  /** Shows a mesh, or nothing; input decides where the camera looks. */
  show(which: 'input' | 'output', mesh: PolygonMeshInput | null): void {
    const view = this.#views[which];
    for (const object of view.drawn) {
      object.geometry.dispose();
      object.material.dispose();
      view.root.remove(object);
    }
    view.drawn = [];
    this.#clearPaints(view);
    if (mesh !== null) {
      const geometry = toBufferGeometry(mesh);
      if (which === 'input') this.#frame(geometry);
      view.drawn = this.#dress(geometry);
      view.root.add(...view.drawn);
      void this.#addCreases(view, geometry);
    }
    this.#applyLines();
    this.#recolour();
  }

  /** Paints findings over a mesh, in addition to those that are there. */
  paint(which: 'input' | 'output', findings: Finding[]): void {
    const { paints, root } = this.#views[which];
    for (const finding of findings) {
      const made = paint(finding, this.#cut);
      paints.push(made);
      root.add(...made.objects);
    }
    this.draw();
  }

  /** Takes one kind of finding away. */
  unpaint(which: 'input' | 'output', kind: Kind): void {
    const view = this.#views[which];
    const gone = view.paints.filter((made) => made.kind === kind);
    view.paints = view.paints.filter((made) => made.kind !== kind);
    for (const { objects, dispose } of gone) {
      view.root.remove(...objects);
      dispose();
    }
    this.draw();
  }

  /** Shows or hides one kind of finding. */
  showPaint(kind: Kind, visible: boolean): void {
    for (const { paints } of Object.values(this.#views)) {
      for (const made of paints) {
        if (made.kind !== kind) continue;
        for (const object of made.objects) object.visible = visible;
      }
    }
    this.draw();
  }

  /** Switches lines on and off. */
  setLines(lines: Lines): void {
    Object.assign(this.#lines, lines);
    this.#applyLines();
    this.draw();
  }

  /** Which of the model's axes points up. */
  setUp(axis: 'y' | 'z'): void {
    for (const { root } of Object.values(this.#views)) {
      root.rotation.x = axis === 'y' ? Math.PI / 2 : 0;
    }
    this.#lookAgain();
  }

  /** Cuts away a share (0 to 1) of the model from the front. */
  setCut(share: number): void {
    this.#cut.constant = this.#sphere.radius * (1.001 - 2 * share) - this.#centre.y;
    this.draw();
  }

  /** Looks at all of the model from one side. */
  lookFrom(side: Side): void {
    const away = sides[side].clone().normalize();
    // The narrower of the two angles of view counts.
    const { clientWidth, clientHeight } = this.#views.input.element;
    const aspect = Math.min(1, clientWidth / Math.max(clientHeight, 1)) || 1;
    const angle = Math.atan(aspect * Math.tan((this.#camera.fov * Math.PI) / 360));
    const distance = (this.#sphere.radius * 1.06) / Math.sin(angle);
    this.#camera.position.copy(this.#centre).addScaledVector(away, distance);
    this.#camera.near = distance / 100;
    this.#camera.far = distance * 20;
    this.#controls.target.copy(this.#centre);
    this.#controls.update();
    this.draw();
  }

  /** Draws with the next frame. */
  draw(): void {
    if (this.#scheduled) return;
    this.#scheduled = true;
    requestAnimationFrame(() => {
      this.#scheduled = false;
      this.#render();
    });
  }

  #dress(geometry: BufferGeometry): Drawn[] {
    const clippingPlanes = [this.#cut];
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
  async #addCreases(view: View, geometry: BufferGeometry): Promise<void> {
    const lines = await this.#creases.find(geometry);
    if (view.drawn[0]?.geometry !== geometry) return;
    const ends = new BufferGeometry();
    ends.setAttribute('position', new Float32BufferAttribute(lines, 3));
    const material = new LineBasicMaterial({ name: 'crease', clippingPlanes: [this.#cut] });
    const edges = new LineSegments(ends, material);
    view.drawn.push(edges);
    view.root.add(edges);
    this.#applyLines();
    this.#recolour();
  }

  #clearPaints(view: View): void {
    for (const { objects, dispose } of view.paints) {
      view.root.remove(...objects);
      dispose();
    }
    view.paints = [];
  }

  #frame(geometry: BufferGeometry): void {
    geometry.computeBoundingSphere();
    const sphere = geometry.boundingSphere;
    if (sphere === null || !(sphere.radius > 0)) return;
    this.#sphere = sphere;
    this.#lookAgain();
  }

  #lookAgain(): void {
    const { root } = this.#views.input;
    this.#centre = this.#sphere.center.clone().applyEuler(root.rotation);
    this.lookFrom('corner');
  }

  #applyLines(): void {
    for (const { drawn } of Object.values(this.#views)) {
      for (const object of drawn) {
        const { name } = object.material;
        if (name === 'wire') object.visible = this.#lines.wireframe;
        if (name === 'crease') object.visible = this.#lines.creases;
      }
    }
  }

  #recolour(): void {
    const dark = matchMedia('(prefers-color-scheme: dark)').matches;
    const colours: Record<string, string> = dark
      ? { front: '#7f9cbc', back: '#b4553f', wire: '#c9d8ea', crease: '#e8f0fa' }
      : { front: '#9db6d3', back: '#d9694c', wire: '#32465c', crease: '#14202e' };
    for (const { drawn } of Object.values(this.#views)) {
      for (const { material } of drawn) material.color = new Color(colours[material.name]);
    }
    this.draw();
  }

  #render(): void {
    const host = this.#host.getBoundingClientRect();
    this.#renderer.setSize(host.width, host.height, false);
    for (const { element, scene } of Object.values(this.#views)) {
      const box = element.getBoundingClientRect();
      const [left, bottom] = [box.left - host.left, host.bottom - box.bottom];
      this.#renderer.setViewport(left, bottom, box.width, box.height);
      this.#renderer.setScissor(left, bottom, box.width, box.height);
      this.#camera.aspect = box.width / Math.max(box.height, 1);
      this.#camera.updateProjectionMatrix();
      // The light travels with the camera, which belongs to no scene for longer than one frame.
      scene.add(this.#camera);
      this.#renderer.render(scene, this.#camera);
    }
  }
}

function makeView(element: HTMLElement): View {
  const scene = new Scene();
  const root = new Group();
  scene.add(new HemisphereLight(0xffffff, 0x8090a4, 1.5), root);
  return { element, scene, root, drawn: [], paints: [] };
}
