/**
 * The range of a slider. It grows by half of its width, downwards or upwards, as often as it takes until a value lies within: also when the
 * slider is let go at an end. A count stays 1 or more.
 */
export function widened(range: readonly [number, number], value: number, isCount: boolean): [number, number] {
  let [lo, hi] = range;
  const step = () => (isCount ? Math.ceil : Number)((hi - lo) / 2 || 1);
  while (value >= hi) hi += step();
  while (value <= lo && !(isCount && lo <= 1)) lo -= step();
  return [isCount ? Math.max(1, lo) : lo, hi];
}
