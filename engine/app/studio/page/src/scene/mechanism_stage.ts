// 3-D view. The module depends on three and is thus loaded only when the view is shown.

import {Box3, DirectionalLight, Group, HemisphereLight, PerspectiveCamera, Scene, Spherical, Vector3, WebGLRenderer} from "three";
import {OrbitControls} from "three/examples/jsm/controls/OrbitControls.js";
import {AxisTriad} from "./axis_triad";
import {aimAt} from "./mechanism_aim";
import {MechanismLabels} from "./mechanism_labels";
import {extentOf, isKnown, type Mechanism, type Placed} from "./mechanism_model";
import {type Colors, type Part, partOf} from "./mechanism_parts";

const angle = Math.PI / 36, nearer = 0.9; // of one press of a key
const opening = 40; // degrees

interface Named {
  part: Part;
  /** Position of its label. */
  label: Vector3 | undefined;
}

/** Returns the label position: the centre of the points, or the tip of a force, away from its point of action. */
function nameAt({element, points}: Placed, thick: number): Vector3 {
  const middle = new Vector3();
  for (const point of points) middle.addScaledVector(new Vector3(...point), 1 / points.length);
  if (element.kind !== "force") return middle;
  const [x = 1, y = 0, z = 0] = element.direction ?? [];
  return middle.addScaledVector(new Vector3(x, y, z).normalize(), 8 * thick);
}

/** Mechanism in space. Dragging, or arrows and + and -, rotate and zoom it; it is redrawn only after a change. */
export class MechanismStage {
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(opening, 1, 0.001, 100);
  private readonly controls: OrbitControls;
  private readonly labels = new MechanismLabels();
  private readonly axes: AxisTriad;
  private readonly sizes: ResizeObserver;
  private bodies = new Group();
  private named: Named[] = [];
  private thick = 0; // of housings [m]
  private box = new Box3(); // of all bodies at first [m]
  /** True for the initial view, which is fitted again after a change of its size. */
  private isHome = true;
  private last: Placed[] = [];
  private frame: number | undefined;

  /** Throws if the browser has no WebGL. */
  constructor(private readonly host: HTMLElement, private mechanism: Mechanism, private colors: Colors) {
    this.renderer = new WebGLRenderer({antialias: true, alpha: true});
    const {domElement} = this.renderer;
    domElement.classList.add("mechanism-canvas");
    domElement.tabIndex = 0;
    domElement.dataset.focus = domElement.dataset.ownKeys = "";
    domElement.setAttribute("role", "application");
    domElement.setAttribute("aria-label", `Mechanism ${mechanism.title}; arrows turn it, + and - change its size, Home resets the view`);
    this.axes = new AxisTriad((mechanism.axes ?? ["x", "y", "z"]).slice(0, mechanism.dimensions));
    this.host.append(domElement, this.labels.element, this.axes.element);
    this.camera.up.copy(this.up);
    this.controls = new OrbitControls(this.camera, domElement);
    this.controls.addEventListener("change", () => this.later());
    this.controls.addEventListener("start", () => { this.isHome = false; });
    domElement.addEventListener("keydown", (event) => this.press(event));
    const sun = new DirectionalLight("#ffffff", 2.2);
    sun.position.set(1, 2, 3);
    this.camera.add(sun);
    this.scene.add(new HemisphereLight("#ffffff", "#8090a0", 1.6), this.camera, this.bodies);
    this.sizes = new ResizeObserver(() => (this.isHome ? this.goHome() : this.resize()));
    this.sizes.observe(host);
  }

  dispose(): void {
    if (this.frame !== undefined) cancelAnimationFrame(this.frame);
    this.sizes.disconnect();
    this.controls.dispose();
    this.clear();
    this.renderer.dispose();
    this.renderer.domElement.remove();
    this.labels.element.remove();
    this.axes.element.remove();
  }

  /** Shows the mechanism at another instant; the first call creates its bodies. */
  show(all: readonly Placed[]): void {
    const known = all.filter(isKnown);
    if (this.named.length !== all.length) {
      if (known.length < all.length) return;
      this.make(all);
    }
    this.last = [...all];
    all.forEach((one, i) => {
      if (!isKnown(one)) return;
      this.named[i].part.move(one.points);
      this.named[i].label?.copy(nameAt(one, this.thick));
    });
    this.later();
  }

  /** Changes the colours. */
  recolor(colors: Colors): void {
    this.colors = colors;
    if (this.last.length === 0) return;
    const {position} = this.camera, kept = position.clone(), target = this.controls.target.clone(), all = this.last, {isHome} = this;
    this.clear();
    this.show(all);
    this.isHome = isHome;
    position.copy(kept);
    this.controls.target.copy(target);
    this.controls.update();
  }

  private get up(): Vector3 {
    return this.mechanism.up === "z" ? new Vector3(0, 0, 1) : new Vector3(0, 1, 0);
  }

  private clear(): void {
    this.bodies.traverse((object) => {
      const {geometry, material} = object as unknown as {geometry?: {dispose(): void}; material?: {dispose(): void}};
      geometry?.dispose();
      material?.dispose();
    });
    this.bodies.clear();
    this.labels.clear();
    this.named = [];
  }

  private make(all: readonly Placed[]): void {
    const {radius} = extentOf(all);
    this.thick = 0.035 * radius;
    const making = {colors: this.colors, thick: this.thick, up: this.up};
    this.named = all.map(({element, points}): Named => {
      const part = partOf(element, points, making);
      this.bodies.add(part.object);
      return {part, label: element.name ? this.labels.add(element.name) : undefined};
    });
    all.forEach(({points}, i) => this.named[i].part.move(points));
    this.box.setFromObject(this.bodies);
    [this.camera.near, this.camera.far] = [0.02 * radius, 50 * radius];
    this.goHome();
  }

  /** Sets the initial view; a plane mechanism is seen nearly from the front. */
  private goHome(): void {
    const eye = this.mechanism.dimensions === 2 ? new Vector3(0.15, 0.12, 1) : this.up.z === 1 ? new Vector3(1, 0.8, 0.5) : new Vector3(0.9, 0.5, 1);
    this.isHome = true;
    this.resize();
    if (this.box.isEmpty()) return;
    const {position, target} = aimAt(this.box, eye, this.camera);
    this.camera.position.copy(position);
    this.controls.target.copy(target);
    this.controls.update();
  }

  private press(event: KeyboardEvent): void {
    const turns: Record<string, [theta: number, phi: number]> = {ArrowLeft: [-angle, 0], ArrowRight: [angle, 0], ArrowUp: [0, -angle], ArrowDown: [0, angle]};
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (event.key in turns) this.turn(...turns[event.key], 1);
    else if (event.key === "+" || event.key === "=") this.turn(0, 0, nearer);
    else if (event.key === "-") this.turn(0, 0, 1 / nearer);
    else if (event.key === "Home") this.goHome();
    else return;
    event.preventDefault();
  }

  private turn(theta: number, phi: number, times: number): void {
    const {position} = this.camera, {target} = this.controls, offset = position.clone().sub(target), turned = this.up.z === 1;
    if (turned) offset.set(offset.y, offset.z, offset.x);
    this.isHome = false;
    const at = new Spherical().setFromVector3(offset);
    at.theta += theta;
    at.phi = Math.min(Math.PI - 0.02, Math.max(0.02, at.phi + phi));
    at.radius *= times;
    offset.setFromSpherical(at);
    if (turned) offset.set(offset.z, offset.x, offset.y);
    position.copy(target).add(offset);
    this.controls.update();
    this.later();
  }

  private resize(): void {
    const {clientWidth: width, clientHeight: height} = this.host;
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(window.devicePixelRatio);
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.later();
  }

  private later(): void {
    this.frame ??= requestAnimationFrame(() => {
      this.frame = undefined;
      this.renderer.render(this.scene, this.camera);
      this.labels.put(this.camera, this.host.clientWidth, this.host.clientHeight);
      this.axes.turn(this.camera);
    });
  }
}
