/** What the browser keeps for this page. A page from a file may have no storage: then nothing is kept, and nothing is wrong. */

export function kept(key: string): string | null {
  try {
    return localStorage.getItem(key);
  } catch {
    return null;
  }
}

/** Keeps a text, or with null forgets it. */
export function keeping(key: string, text: string | null): void {
  try {
    if (text === null) localStorage.removeItem(key);
    else localStorage.setItem(key, text);
  } catch {
    // It is not there next time.
  }
}
