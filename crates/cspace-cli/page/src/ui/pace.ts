/**
 * How fast frames of the 3-D view are drawn. Where that is in software, or on a slow card, the view would hold up all else: so no frame is
 * begun before the last is finished, and while something is dragged frames are coarser, or none.
 */

/** Frames that take longer keep the hand waiting (ms); they are looked for at every frame of the page, so that a fast card takes up to 17. */
const SLOW = 30;
/** Of coarse frames that take longer (ms) none are drawn until the hand lets go. */
const TOO_SLOW = 50;
/** A frame of which nothing is heard for this long (ms) is not waited for: a context may be lost. */
const LONGEST = 1000;

export class Pace {
  #fence: WebGLSync | null = null;
  #sent = 0;
  #took = 0;

  constructor(private readonly gl: WebGL2RenderingContext) {}

  /** A frame has been handed to the card. */
  sent(): void {
    this.#forget();
    this.#fence = this.gl.fenceSync(this.gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    this.gl.flush();
    this.#sent = performance.now();
  }

  /** Whether the last frame is still being drawn. */
  isBusy(): boolean {
    if (!this.#fence) return false;
    const took = performance.now() - this.#sent;
    const finished = this.gl.getSyncParameter(this.#fence, this.gl.SYNC_STATUS) === this.gl.SIGNALED;
    if (!finished && took < LONGEST) return true;
    this.#took = took;
    this.#forget();
    return false;
  }

  /** How the next frame is drawn, after one that was coarse or not: while something is dragged, coarse or not at all. */
  next(isDragged: boolean, isCoarse: boolean): "fine" | "coarse" | "none" {
    if (!isDragged || (!isCoarse && this.#took <= SLOW)) return "fine";
    return isCoarse && this.#took > TOO_SLOW ? "none" : "coarse";
  }

  #forget(): void {
    if (this.#fence) this.gl.deleteSync(this.#fence);
    this.#fence = null;
  }
}
