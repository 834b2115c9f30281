/** Work that may lag behind the hand: it takes no more than a share of the time, however often it is asked for. */

/** It rests for so many times as long as it took. */
const REST = 6;

/** Asks for the work; it is done once after a pause (ms), with what is then there. */
export function unhurried(work: () => void, pause: number): () => void {
  let waiting = false;
  let earliest = 0;
  return () => {
    if (waiting) return;
    waiting = true;
    setTimeout(() => {
      waiting = false;
      const begin = performance.now();
      work();
      const end = performance.now();
      earliest = end + REST * (end - begin);
    }, Math.max(pause, earliest - performance.now()));
  };
}
