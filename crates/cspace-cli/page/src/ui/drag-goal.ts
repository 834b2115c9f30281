/**
 * Where a drag leads to. Contacts may push and tilt the part meanwhile, but the goal stays where the pointer has it, with the orientation
 * of the beginning and what the user has turned since: a part that is tilted on the way is straight again once there is room.
 */

import type { Placement } from "./placement.js";

export class DragGoal {
  #x: number;
  #y: number;
  readonly #theta: number;
  readonly #turnedBefore: number;
  /** Turned by this drag itself (radians). */
  #turned = 0;

  /** `turns` is by how much the user has turned the part, by wheel and keys, since ever. */
  constructor(start: Placement, private readonly turns: () => number) {
    [this.#x, this.#y, this.#theta] = [start.x, start.y, start.theta];
    this.#turnedBefore = turns();
  }

  get placement(): Placement {
    return { x: this.#x, y: this.#y, theta: this.#theta + this.#turned + this.turns() - this.#turnedBefore };
  }

  moveBy(dx: number, dy: number): void {
    this.moveTo(this.#x + dx, this.#y + dy);
  }

  moveTo(x: number, y: number): void {
    [this.#x, this.#y] = [x, y];
  }

  turn(by: number): void {
    this.#turned += by;
  }
}
