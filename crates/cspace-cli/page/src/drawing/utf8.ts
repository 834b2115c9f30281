/** Texts of old DXF files are in the encoding that their header names; the kernel in the page reads UTF-8. */

import type { DrawingSource } from "./scene.js";

/** The header is among the first so many bytes. */
const HEADER = 1 << 16;

/** Encodings by the numbers of code pages that have other names. */
const LABELS: Record<string, string> = { 932: "shift_jis", 936: "gbk", 949: "euc-kr", 950: "big5", 866: "ibm866" };

/** The bytes of a drawing in UTF-8; the same bytes if they are so already, or in no encoding that is known. */
export function inUtf8(bytes: Uint8Array): Uint8Array {
  try {
    new TextDecoder("utf-8", { fatal: true }).decode(bytes);
    return bytes;
  } catch {
    const head = new TextDecoder("latin1").decode(bytes.subarray(0, HEADER));
    const page = /\$DWGCODEPAGE\s+3\s+(?:ansi_|dos)?(\w+)/i.exec(head)?.[1];
    if (page === undefined || head.startsWith("AutoCAD Binary DXF")) return bytes;
    try {
      return new TextEncoder().encode(new TextDecoder(LABELS[page] ?? `windows-${page}`).decode(bytes));
    } catch {
      return bytes;
    }
  }
}

/** What a drawing was read from, with its bytes in UTF-8. */
export function sourceInUtf8(source: DrawingSource): DrawingSource {
  const bytes = Uint8Array.from(atob(source.data), (c) => c.charCodeAt(0));
  const text = inUtf8(bytes);
  if (text === bytes) return source;
  let data = "";
  for (const byte of text) data += String.fromCharCode(byte);
  return { ...source, data: btoa(data) };
}
