/** Numbers as text. */

/** Digits shown of lengths and degrees; what is typed or copied has all. */
const SHOWN_DIGITS = 6;

/** Coordinates, angles and times beyond this are taken for mistakes, wherever they come from: views could not show them (any unit). */
export const LARGEST_NUMBER = 1e12;

/** Whether a number can be shown. */
export function isUsable(value: unknown): value is number {
  return typeof value === "number" && Math.abs(value) <= LARGEST_NUMBER;
}

export function short(value: number): string {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  return minus(size < 1e-4 || size >= 1e7 ? value.toExponential(2) : String(Number(value.toPrecision(SHOWN_DIGITS))));
}

/** The text of a number with minus signs in place of hyphens. */
export function minus(text: string): string {
  return text.replaceAll("-", "−");
}

export function length(value: number, unit: string | null): string {
  return unit ? `${short(value)} ${unit}` : short(value);
}

/** Angles of less are rounding (degrees). */
const NO_ANGLE = 1e-9;

/** With so many digits of its own or, as {@link within}, of a span (radians). */
export function degrees(angle: number, digits = SHOWN_DIGITS, span?: number): string {
  const value = (angle * 180) / Math.PI;
  return `${short(span !== undefined ? within(value, (span * 180) / Math.PI, digits) : Math.abs(value) < NO_ANGLE ? 0 : rounded(value, digits))}°`;
}

/** To the last decimal of so many digits of a span: what is less is nothing beside it. */
export function within(value: number, span: number, digits = SHOWN_DIGITS): number {
  const step = 10 ** (Math.floor(Math.log10(span)) + 1 - digits);
  return step > 0 && Number.isFinite(value) ? rounded(Math.round(value / step) * step, 15) || 0 : value;
}

/** To the few digits that people compare by eye. */
export function rounded(value: number, digits = 3): number {
  return Number.isFinite(value) ? Number(value.toPrecision(digits)) : value;
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
  const step = inDegrees <= 1 ? lengthStep(inDegrees) : (DEGREE_STEPS.find((s) => s >= inDegrees) ?? 360 * lengthStep(inDegrees / 360));
  return (step * Math.PI) / 180;
}
