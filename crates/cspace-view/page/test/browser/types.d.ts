import type { CspaceScript } from "../../src/ui/script.js";
declare global {
  interface Window {
    cspace: CspaceScript;
  }
}
