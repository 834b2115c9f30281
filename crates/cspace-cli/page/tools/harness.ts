/** A real browser for the tests, the command beside it, and pages made by the command. */

import { spawn, type ChildProcess } from "node:child_process";
import { existsSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { PNG } from "pngjs";
import puppeteer, { type Browser, type Page } from "puppeteer-core";
import { ALL, MODELS, NO_COMMAND, binary, models, run } from "../test/support/command.js";

/** How long a page may take to be ready (ms): software rendering on a busy machine is slow, and nothing is timed here. */
export const PATIENCE = 120_000;

/** The root of the repository. */
export const root = resolve(MODELS, "..");

/** The browser: what `CHROMIUM` names, or one in a usual place; null where there is none. */
export const browserPath: string | null = [
  process.env["CHROMIUM"],
  "/usr/bin/chromium",
  "/usr/bin/chromium-browser",
  "/usr/bin/google-chrome",
  "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
].find((path): path is string => path !== undefined && existsSync(path)) ?? null;

/** Why tests in a browser are skipped, or `false`. */
export const skip: string | false =
  binary() === null
    ? NO_COMMAND
    : browserPath === null
      ? "there is no browser: install chromium, or name one in CHROMIUM"
      : false;

/** Why tests are skipped that take long and do what others do in another way, or `false`. */
export const long: string | false = ALL ? false : "run with CSPACE_LONG=1";

/**
 * The models that are shown in a browser: one in the plane and one on fixed axes, or all. Tests in Node ask the same kernel about each,
 * in the same engine.
 */
export function shown(): string[] {
  const few = ["peg_hole", "geneva"].map((name) => join(MODELS, `${name}.toml`));
  return models().filter((path) => ALL || process.env["MODELS"] !== undefined || few.includes(path));
}

/** A folder that is removed in the end. */
export function scratch(): { path: string; remove: () => void } {
  const path = mkdtempSync(join(tmpdir(), "cspace-page-"));
  return { path, remove: () => rmSync(path, { recursive: true, force: true, maxRetries: 5 }) };
}

export async function launch(folder: string, more: string[] = []): Promise<Browser> {
  return puppeteer.launch({
    executablePath: browserPath ?? "chromium",
    headless: true,
    userDataDir: join(folder, "profile"),
    protocolTimeout: PATIENCE,
    args: [
      "--no-sandbox",
      "--enable-unsafe-swiftshader",
      "--disable-quic",
      "--no-first-run",
      "--disable-background-networking",
      "--disable-component-update",
      "--disable-sync",
      ...more,
    ],
  });
}

/** A page, and everything that went wrong on it. */
export interface Opened {
  page: Page;
  faults: string[];
}

/** Opens an address and waits until the selected pair is drawn. */
export async function open(browser: Browser, address: string, size = SIZE): Promise<Opened> {
  const opened = await load(browser, address, size);
  await drawn(opened.page);
  return opened;
}

/** Waits until the selected pair is drawn. */
export async function drawn(page: Page): Promise<void> {
  await page.waitForFunction("window.cspace !== undefined", { timeout: PATIENCE });
  await page.evaluate("window.cspace.ready");
}

const SIZE = { width: 1440, height: 900 };

/** Opens an address. */
export async function load(browser: Browser, address: string, size = SIZE): Promise<Opened> {
  const page = await browser.newPage();
  const faults: string[] = [];
  page.on("console", (message) => {
    if (message.type() === "error" || message.type() === "warn") {
      // What the driver says of its own speed is not the page's.
      if (!/GPU stall|swiftshader|software WebGL|GL Driver Message/i.test(message.text())) {
        faults.push(`${message.type()}: ${message.text()}`);
      }
    }
  });
  page.on("pageerror", (error) => faults.push(String(error)));
  page.on("requestfailed", (request) => faults.push(`${request.url()} failed`));
  await page.setViewport(size);
  await page.goto(address, { waitUntil: "load", timeout: PATIENCE });
  return { page, faults };
}

/** A model as one file, written by the command. */
export function exported(model: string, folder: string, more: string[] = []): string {
  const path = join(folder, `${model.replaceAll(/[^a-z0-9]+/gi, "_")}.html`);
  run(["export", model, "-o", path, ...more]);
  return path;
}

export const addressOf = (path: string): string => pathToFileURL(path).href;

/** `cspace view`, of a file or without one, until it is stopped. */
export async function serve(model: string | null, more: string[] = []): Promise<{ address: string; stop: () => void }> {
  const child: ChildProcess = spawn(binary() ?? "cspace", ["view", ...(model === null ? [] : [model]), "--no-open", ...more], {
    stdio: ["ignore", "pipe", "pipe"],
  });
  const address = await new Promise<string>((found, failed) => {
    let text = "";
    child.stdout?.on("data", (bytes: Buffer) => {
      text += bytes.toString("utf8");
      const line = /http:\/\/\S+/.exec(text);
      if (line !== null) {
        found(line[0]);
      }
    });
    child.on("exit", (code) => failed(new Error(`cspace view ended with ${code}: ${text}`)));
  });
  return { address, stop: () => child.kill("SIGINT") };
}

/** The picture of an element, decoded. */
export async function pictureOf(page: Page, selector: string): Promise<PNG> {
  const element = await page.waitForSelector(selector, { visible: true, timeout: PATIENCE });
  if (element === null) {
    throw new Error(`there is no ${selector}`);
  }
  return PNG.sync.read(Buffer.from(await element.screenshot()));
}

/** How many colours a picture has, told apart by the upper five bits of each channel. */
export function colours(picture: PNG): number {
  const seen = new Set<number>();
  for (let i = 0; i < picture.data.length; i += 4) {
    const channel = (k: number): number => (picture.data[i + k] ?? 0) >> 3;
    seen.add((channel(0) << 10) | (channel(1) << 5) | channel(2));
  }
  return seen.size;
}

/** The share of pixels that differ by more than a few grey levels; 1 of pictures of different size. */
export function difference(a: PNG, b: PNG): number {
  /** What anti-aliasing and rounding of colours may change, of 255. */
  const LEVELS = 12;
  if (a.width !== b.width || a.height !== b.height) {
    return 1;
  }
  let differing = 0;
  for (let i = 0; i < a.data.length; i += 4) {
    const far = [0, 1, 2].some((k) => Math.abs((a.data[i + k] ?? 0) - (b.data[i + k] ?? 0)) > LEVELS);
    differing += far ? 1 : 0;
  }
  return differing / (a.width * a.height);
}
