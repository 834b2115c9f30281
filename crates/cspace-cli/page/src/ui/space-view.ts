/** The configuration space in 3-D: x, y and the orientation upwards. The configuration is a point that can be dragged. */

import { AmbientLight, DirectionalLight, PerspectiveCamera, Plane, Raycaster, Scene as Scene3, Spherical, Vector2, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { PlanarKernel } from "../kernel/api.js";
import type { Place } from "../scene.js";
import { TOUCHING } from "./colours.js";
import { DragGoal } from "./drag-goal.js";
import { isPlanar } from "./mechanism.js";
import { boxOf, centerOf } from "./outline.js";
import { Pace } from "./pace.js";
import { wrap } from "./placement.js";
import type { Session } from "./session.js";
import { currentSlice, swings } from "./slices.js";
import { SpaceAxes } from "./space-axes.js";
import { SpaceMarks } from "./space-marks.js";
import type { Key, State } from "./state.js";
import { Surface } from "./surface.js";
import { swing, type SpaceScale } from "./space-scale.js";
import { wheelAngle } from "./viewport.js";

/** How near to the point it is grabbed, in pixels. */
const GRAB = 22;
/** The surface is drawn within this share of the space's extent. */
const DEVIATION = 1 / 700;
/** What lies at the window's ends is still drawn: so much of the extent beyond them. */
const BESIDE_WINDOW = 1e-3;
const FIELD_OF_VIEW = 32;
/** Width to height of a view in which the space is seen whole from the usual distance. */
const SQUARE = 1.1;
/** A region that is looked at has so much room around it. */
const AROUND_REGION = 1.1;
/** Surfaces of edited parts are made again once the parts have not changed for this long (ms). */
const SETTLED = 160;
/** The screen's pixels for each of a coarse frame, along a side. */
const COARSE = 0.4;
/** A turn of π for so many pixels of the pointer, with Shift. */
const PIXELS_PER_HALF_TURN = 360;

const POINT_COLOURS = { free: "#009e73", contact: TOUCHING, blocked: "#b00020" } as const;

export class SpaceView {
  readonly canvas: HTMLCanvasElement;
  /** Called when the user has looked from elsewhere. */
  onCamera: (() => void) | null = null;
  onProgress: ((left: number) => void) | null = null;
  readonly #renderer: WebGLRenderer;
  readonly #pace: Pace;
  #coarse = false;
  readonly #scene = new Scene3();
  readonly #camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 1, 10);
  readonly #controls: OrbitControls;
  /** Above the first and below the last orientation. */
  readonly #window = [new Plane(new Vector3(0, 0, 1), 0), new Plane(new Vector3(0, 0, -1), 0)];
  readonly #marks = new SpaceMarks(this.#window);
  readonly #axes: SpaceAxes;
  readonly #cut = new Plane(new Vector3(0, 0, -1), 0);
  readonly #light = new DirectionalLight(0xffffff, 2.2);
  #scale: SpaceScale = { center: [0, 0], perRadian: 1, deviation: 1, arm: { x: 0, y: 0 } };
  #kernel: PlanarKernel | null = null;
  #surface: Surface | null = null;
  #rebuild: ReturnType<typeof setTimeout> | null = null;
  #size = 1;
  /** Whether the user looks from elsewhere. */
  #moved = false;
  #frame: number | null = null;
  #cameraFrom: readonly number[] | null;

  /** Throws where the browser has no WebGL. */
  constructor(private readonly element: HTMLElement, private readonly session: Session, camera: readonly number[] | null) {
    this.#cameraFrom = camera;
    const canvas = document.createElement("canvas");
    // Asked here first, because three writes errors to the console where there is none.
    const context = canvas.getContext("webgl2", { antialias: true, preserveDrawingBuffer: true, alpha: true });
    if (!context) throw new Error("no context for WebGL 2");
    this.#renderer = new WebGLRenderer({ canvas, context, antialias: true, preserveDrawingBuffer: true, alpha: true });
    this.#renderer.localClippingEnabled = true;
    this.#renderer.setPixelRatio(fineRatio());
    this.#pace = new Pace(context);
    this.canvas = this.#renderer.domElement;
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "application");
    this.canvas.setAttribute("aria-label", "The contact surface in x, y and orientation. Drag to look from elsewhere, drag the point to move the part.");
    element.append(this.canvas);
    this.#axes = new SpaceAxes(element);
    this.#camera.up.set(0, 0, 1);
    this.#camera.add(this.#light);
    this.#light.position.set(0.4, 0.6, 1);
    this.#scene.add(this.#camera, new AmbientLight(0xffffff, 1.1), this.#axes.group, this.#marks.group);
    this.#listen();
    this.#controls = new OrbitControls(this.#camera, this.canvas);
    this.#controls.enableDamping = false;
    this.#controls.addEventListener("change", () => this.#draw());
    this.#controls.addEventListener("end", () => {
      this.#moved = true;
      this.onCamera?.();
    });
    new ResizeObserver(() => this.#resize()).observe(element);
    session.store.subscribe((changed, state) => this.#update(changed, state));
    this.#resize();
  }

  /** When the surface is there. */
  get built(): Promise<void> {
    return this.#surface?.done ?? Promise.resolve();
  }

  /** Azimuth, elevation, distance and target, lengths in sizes of the space; null as long as it is where it was put. */
  get camera(): number[] | null {
    if (!this.#moved) return null;
    const to = this.#controls.target;
    const s = new Spherical().setFromVector3(swap(this.#camera.position.clone().sub(to)));
    return [s.theta, s.phi, s.radius / this.#size, to.x / this.#size, to.y / this.#size, to.z / this.#size];
  }

  setCamera([theta = 0, phi = 1, radius = 2, x = 0, y = 0, z = 0]: readonly number[]): void {
    const to = new Vector3(x, y, z).multiplyScalar(this.#size);
    this.#moved = true;
    this.#controls.target.copy(to);
    this.#camera.position.copy(to).add(unswap(new Vector3().setFromSpherical(new Spherical(radius * this.#size, phi, theta))));
    this.#controls.update();
    this.#draw();
  }

  lookFromTheFront(): void {
    const z = this.#kernel ? ((this.#kernel.window.lo + this.#kernel.window.hi) / 2) * this.#scale.perRadian : 0;
    // A narrow view needs more distance for the same width.
    this.setCamera([0.55, 1.08, 3.25 * Math.max(1, SQUARE / this.#camera.aspect), 0, 0, z / this.#size]);
    this.#moved = false;
    this.onCamera?.();
  }

  /** Looks at what bounds a region, from where the user looks now. */
  fitRegion(region: number): void {
    const box = this.#surface?.boxOf(region);
    if (!box || box.isEmpty()) return;
    const away = this.#camera.position.clone().sub(this.#controls.target).normalize();
    const to = box.getCenter(new Vector3());
    const radius = box.getSize(new Vector3()).length() / 2;
    const narrow = Math.min(1, this.#camera.aspect);
    this.#moved = true;
    this.#controls.target.copy(to);
    this.#camera.position.copy(to).addScaledVector(away, (AROUND_REGION * radius) / (narrow * Math.sin((FIELD_OF_VIEW * Math.PI) / 360)));
    this.#controls.update();
    this.onCamera?.();
    this.#draw();
  }

  #update(changed: ReadonlySet<Key>, state: Readonly<State>): void {
    if (changed.has("space")) this.#open(state);
    const kernel = this.#kernel;
    const c = state.configuration;
    if (kernel && isPlanar(c)) {
      const theta = kernel.window.fullTurn ? wrap(c.theta, kernel.window.lo) : c.theta;
      const z = theta * this.#scale.perRadian;
      if (["configuration", "space", "hidden"].some((k) => changed.has(k as Key))) {
        this.#marks.setTheta(z);
        this.#marks.setSlice(currentSlice(this.session), state.hidden, z, this.#scale);
        this.#cut.constant = z;
      }
      const colour = state.where.classification ? POINT_COLOURS[state.where.classification] : "#888888";
      const aside = swing(this.#scale, c.theta);
      this.#marks.setPoint(c.x + aside.x - this.#scale.center[0], c.y + aside.y - this.#scale.center[1], z, colour);
      if (changed.has("where") || changed.has("space")) this.#marks.light(kernel, state.where.patches, this.#scale);
      if (changed.has("record") || changed.has("space") || changed.has("stale")) {
        this.#marks.setWay(state.record?.kind === "plan" ? state.record.steps.map((s) => s.at) : [], state.stale, kernel, this.#scale);
      }
    }
    if (changed.has("colouring")) this.#surface?.paint(state.colouring);
    if (changed.has("hidden") || changed.has("cut") || changed.has("space")) this.#surface?.show(state.hidden, state.cut);
    if (changed.has("theme")) this.applyTheme();
    if (changed.has("dragging") && !state.dragging) {
      this.#setCoarse(false);
      this.#draw();
    }
    this.#draw();
  }

  #open(state: Readonly<State>): void {
    const kernel = this.session.planar;
    if (kernel === this.#kernel) return;
    const first = !this.#kernel || !state.editing;
    this.#kernel = kernel;
    this.#marks.forgetLight();
    if (this.#rebuild !== null) clearTimeout(this.#rebuild);
    if (!kernel) {
      this.#surface?.dispose();
      this.#surface = null;
      return;
    }
    if (first) {
      this.#measure(kernel);
      this.#build();
    } else {
      this.#surface?.fade(true);
      this.#buildLater();
    }
  }

  /** Not while something is dragged, which is to follow the hand. */
  #buildLater(): void {
    this.#rebuild = setTimeout(() => (this.session.state.dragging ? this.#buildLater() : this.#build()), SETTLED);
  }

  #measure(kernel: PlanarKernel): void {
    const { lo, hi, arm } = this.#drawnBounds(kernel);
    const extent = Math.max(hi[0] - lo[0], hi[1] - lo[1]) || 1;
    const margin = 0.06 * extent;
    const window = kernel.window;
    const full = window.hi - window.lo;
    // The window is as tall as the space is wide, narrow windows too.
    this.#scale = { center: [(lo[0] + hi[0]) / 2, (lo[1] + hi[1]) / 2], perRadian: extent / (full || 1), deviation: extent * DEVIATION, arm };
    this.#size = extent;
    const beside = BESIDE_WINDOW * extent;
    this.#window.forEach((plane, i) => {
      plane.constant = (i === 0 ? -window.lo : window.hi) * this.#scale.perRadian + beside;
    });
    const low: [number, number] = [lo[0] - margin, lo[1] - margin];
    const high: [number, number] = [hi[0] + margin, hi[1] + margin];
    this.#marks.setExtent(high[0] - low[0], high[1] - low[1]);
    this.#axes.build(low, high, [window.lo, window.hi], this.#scale, this.session.scene.unit);
    this.#camera.near = extent / 100;
    this.#camera.far = extent * 40;
    this.#camera.updateProjectionMatrix();
    if (this.#cameraFrom) this.setCamera(this.#cameraFrom);
    else this.lookFromTheFront();
    this.#cameraFrom = null;
  }

  /** Bounds of what is drawn, and the point of the moving part whose places these are. */
  #drawnBounds(kernel: PlanarKernel): { lo: [number, number]; hi: [number, number]; arm: Place } {
    const { pair, state } = this.session;
    if (!pair || !swings(this.session, kernel)) return { ...kernel.bounds(), arm: { x: 0, y: 0 } };
    const [fixed, moving] = [boxOf(state.parts[pair.fixed]?.loops ?? []), boxOf(state.parts[pair.moving]?.loops ?? [])];
    const arm = centerOf(moving);
    // In contact, the part's middle is no farther from the other than its corners are from its middle.
    const reach = Math.hypot(moving.x1 - moving.x0, moving.y1 - moving.y0) / 2;
    return { lo: [fixed.x0 - reach - arm.x, fixed.y0 - reach - arm.y], hi: [fixed.x1 + reach - arm.x, fixed.y1 + reach - arm.y], arm };
  }

  #build(): void {
    const kernel = this.#kernel;
    const { state } = this.session;
    if (!kernel || !isPlanar(state.configuration)) return;
    this.#surface?.dispose();
    const { lo, fullTurn } = kernel.window;
    const theta = fullTurn ? wrap(state.configuration.theta, lo) : state.configuration.theta;
    const surface = new Surface(kernel, this.#scale, theta, state.colouring, { window: this.#window, cut: this.#cut }, (left) => {
      this.#surface?.show(this.session.state.hidden, this.session.state.cut);
      this.onProgress?.(left);
      this.#draw();
    });
    this.#surface = surface;
    surface.show(state.hidden, state.cut);
    this.#scene.add(surface.group);
  }

  applyTheme(): void {
    const dark = getComputedStyle(this.element).colorScheme.includes("dark");
    this.#marks.theme(dark);
    this.#axes.theme(dark);
    this.#draw();
  }

  #resize(): void {
    const { clientWidth: width, clientHeight: height } = this.element;
    if (width === 0 || height === 0) return;
    this.#renderer.setSize(width, height);
    this.#camera.aspect = width / height;
    this.#camera.updateProjectionMatrix();
    this.#marks.resize(width, height);
    if (this.#kernel && !this.#moved) this.lookFromTheFront();
    this.drawNow();
  }

  #draw(): void {
    this.#frame ??= requestAnimationFrame(() => {
      this.#frame = null;
      if (this.#pace.isBusy()) this.#draw();
      else {
        const next = this.#pace.next(this.session.state.dragging, this.#coarse);
        // What is dragged in this view is seen nowhere else so well.
        const waits = next === "none" && this.#controls.enabled;
        this.element.classList.toggle("waits", waits);
        if (waits) return;
        this.#setCoarse(next !== "fine");
        this.drawNow();
      }
    });
  }

  #setCoarse(coarse: boolean): void {
    if (coarse === this.#coarse) return;
    this.#coarse = coarse;
    this.#renderer.setPixelRatio(coarse ? COARSE : fineRatio());
  }

  drawNow(): void {
    if (this.#frame !== null) cancelAnimationFrame(this.#frame);
    this.#frame = null;
    if (!this.#kernel || this.element.clientHeight === 0) return;
    const distance = this.#camera.position.distanceTo(this.#marks.point.position);
    const perPixel = (2 * distance * Math.tan((FIELD_OF_VIEW * Math.PI) / 360)) / Math.max(1, this.element.clientHeight);
    this.#marks.scalePoint(perPixel);
    this.#renderer.render(this.#scene, this.#camera);
    this.#pace.sent();
    this.#axes.place(this.#camera, this.element.clientWidth, this.element.clientHeight);
  }

  #ndc(event: { clientX: number; clientY: number }): Vector2 {
    const r = this.canvas.getBoundingClientRect();
    return new Vector2(((event.clientX - r.left) / r.width) * 2 - 1, 1 - ((event.clientY - r.top) / r.height) * 2);
  }

  #isOnPoint(event: { clientX: number; clientY: number }): boolean {
    const r = this.canvas.getBoundingClientRect();
    const p = this.#marks.point.position.clone().project(this.#camera);
    const [x, y] = [r.left + ((p.x + 1) / 2) * r.width, r.top + ((1 - p.y) / 2) * r.height];
    return this.#kernel !== null && Math.hypot(event.clientX - x, event.clientY - y) < GRAB;
  }

  /** Where the pointer meets the plane of an orientation. */
  #onPlane(event: { clientX: number; clientY: number }, z: number): Vector3 | null {
    const ray = new Raycaster();
    ray.setFromCamera(this.#ndc(event), this.#camera);
    return ray.ray.intersectPlane(new Plane(new Vector3(0, 0, 1), -z), new Vector3());
  }

  /** Registered before the controls, which are to leave the point alone. */
  #listen(): void {
    let drag: { pointer: number; dx: number; dy: number; y: number; goal: DragGoal } | null = null;
    const { store } = this.session;
    this.canvas.addEventListener(
      "pointerdown",
      (event) => {
        const c = this.session.state.configuration;
        if (event.button !== 0 || !this.#isOnPoint(event) || !isPlanar(c)) return;
        const p = this.#marks.point.position;
        const at = this.#onPlane(event, p.z);
        drag = { pointer: event.pointerId, dx: at ? p.x - at.x : 0, dy: at ? p.y - at.y : 0, y: event.clientY, goal: new DragGoal(c, () => this.session.turnedBy) };
        this.#controls.enabled = false;
        this.canvas.setPointerCapture(event.pointerId);
        store.change({ dragging: true, playing: false });
        event.stopImmediatePropagation();
      },
      { capture: true },
    );
    this.canvas.addEventListener("pointermove", (event) => {
      if (!drag || event.pointerId !== drag.pointer) {
        this.canvas.style.cursor = this.#isOnPoint(event) ? "grab" : "";
        return;
      }
      if (event.shiftKey) {
        drag.goal.turn(-((event.clientY - drag.y) * Math.PI) / PIXELS_PER_HALF_TURN);
      } else {
        const at = this.#onPlane(event, this.#marks.point.position.z);
        const now = this.session.state.configuration;
        const aside = swing(this.#scale, isPlanar(now) ? now.theta : 0);
        if (at) drag.goal.moveTo(at.x + drag.dx + this.#scale.center[0] - aside.x, at.y + drag.dy + this.#scale.center[1] - aside.y);
      }
      this.session.aim(drag.goal.placement);
      drag.y = event.clientY;
    });
    const up = (event: PointerEvent) => {
      if (!drag || event.pointerId !== drag.pointer) return;
      drag = null;
      this.#controls.enabled = true;
      store.change({ dragging: false });
    };
    this.canvas.addEventListener("pointerup", up);
    this.canvas.addEventListener("pointercancel", up);
    this.canvas.addEventListener(
      "wheel",
      (event) => {
        if (!drag && !event.shiftKey && !this.#isOnPoint(event)) return;
        event.preventDefault();
        event.stopImmediatePropagation();
        this.session.turn(wheelAngle(event));
      },
      { capture: true, passive: false },
    );
  }
}

/** Pixels of the screen finer than this cannot be seen. */
function fineRatio(): number {
  return Math.min(2, window.devicePixelRatio || 1);
}

/** Spherical coordinates have y upwards. */
function swap(v: Vector3): Vector3 {
  return v.set(v.x, v.z, -v.y);
}

function unswap(v: Vector3): Vector3 {
  return v.set(v.x, -v.z, v.y);
}
