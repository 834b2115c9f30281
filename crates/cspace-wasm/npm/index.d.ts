export * from "./cspace.js";

/** Loads the library: in a browser from beside this module, in Node from the package. Nothing else can be called before. */
export function load(): Promise<void>;
