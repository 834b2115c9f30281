/** Numbers as text. */

/** Digits shown of lengths and degrees; what is typed or copied has all. */
const SHOWN_DIGITS = 6;

export function short(value: number): string {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  return size < 1e-4 || size >= 1e7 ? value.toExponential(2) : String(Number(value.toPrecision(SHOWN_DIGITS)));
}

export function length(value: number, unit: string | null): string {
  return unit ? `${short(value)} ${unit}` : short(value);
}

export function degrees(angle: number): string {
  return `${short((angle * 180) / Math.PI)}°`;
}

const LENGTH_STEPS = [1, 2, 5] as const;
const DEGREE_STEPS = [1, 2, 5, 10, 15, 30, 45, 90, 180, 360] as const;

/** The least step that people count in and that is not less than `least`. */
export function lengthStep(least: number): number {
  const power = 10 ** Math.floor(Math.log10(least));
  return (LENGTH_STEPS.find((s) => s * power >= least) ?? 10) * power;
}

/** As {@link lengthStep} for angles, in radians; whole degrees where these are fine enough. */
export function angleStep(least: number): number {
  const inDegrees = (least * 180) / Math.PI;
  const step = inDegrees <= 1 ? lengthStep(inDegrees) : (DEGREE_STEPS.find((s) => s >= inDegrees) ?? 360);
  return (step * Math.PI) / 180;
}
