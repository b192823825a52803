// Makes many things with two processes, each thing once its needs are there.
import { fork } from "node:child_process";
import os from "node:os";
import { fileURLToPath } from "node:url";
import { forgetSources } from "./headers.mjs";
import { isMade, key, needs } from "./recipes.mjs";

/** @typedef {import('./recipes.mjs').Recipe} Recipe */
/** @typedef {{ ok: boolean, changed?: boolean, log: string, seconds: number }} Reply */
/** @typedef {{ recipe: Recipe, ok: boolean, log: string, seconds: number }} Done */

/**
 * How a compiling process is started. The compiler's memory grows more than a hundred times in each compile, and each
 * time V8 looks for garbage, of which there is little: with threads of its own that takes half as long as the compiling.
 * And to optimise the compiler's code takes longer than what that saves in one or two dozen compiles.
 */
const engine = ["--single-threaded-gc", "--liftoff-only"];

/**
 * @param {Recipe[]} wanted
 * @param {{ workers?: number, onDone?: (done: Done, left: number) => void }} [options]
 * @returns {Promise<{ built: number, failed: Map<string, string> }>} by key, why each failed thing failed:
 *   the compiler's words, or which need was missing
 */
export async function makeAll(wanted, options = {}) {
  const { workers, onDone } = options;
  let changed = false;
  /** @type {Map<string, { recipe: Recipe, needed: string[], waits: string[] }>} */
  const todo = new Map();
  const visit = (/** @type {Recipe} */ recipe) => {
    const name = key(recipe);
    if (todo.has(name) || isMade(name)) return;
    for (const need of needs(recipe)) visit(need);
    const needed = needs(recipe).map(key);
    todo.set(name, { recipe, needed, waits: needed.filter((need) => todo.has(need)) });
  };
  for (const recipe of wanted) visit(recipe);

  /** @type {Map<string, string>} */
  const failed = new Map();
  let built = 0;
  if (todo.size === 0) return { built, failed };

  const count = Math.min(workers ?? 2, Math.max(1, os.cpus().length), todo.size);
  const script = fileURLToPath(new URL("worker.mjs", import.meta.url));
  const running = new Set();

  const next = () => {
    for (const [name, job] of todo) {
      if (running.has(name)) continue;
      const broken = job.waits.find((need) => failed.has(need));
      if (broken) {
        todo.delete(name);
        failed.set(name, failed.get(broken) ?? "");
        return next();
      }
      if (!job.waits.some((need) => todo.has(need))) return { name, ...job };
    }
    return undefined;
  };

  await new Promise((/** @type {(value?: undefined) => void} */ resolve, reject) => {
    /** @type {{ process: import('node:child_process').ChildProcess, job?: { name: string, recipe: Recipe, needed: string[] } }[]} */
    const hands = [];
    const stop = () => {
      for (const hand of hands) if (hand.process.connected) hand.process.disconnect();
    };
    const deal = () => {
      for (const hand of hands) {
        if (hand.job) continue;
        const job = next();
        if (!job) break;
        hand.job = job;
        running.add(job.name);
        hand.process.send({ recipe: job.recipe, name: job.name, needed: job.needed });
      }
      if (todo.size === 0) {
        stop();
        resolve();
      }
    };
    for (let i = 0; i < count; ++i) {
      const stdio = /** @type {const} */ (["ignore", "inherit", "inherit", "ipc"]);
      const execArgv = [...process.execArgv, ...engine];
      const hand = { process: fork(script, { stdio: [...stdio], execArgv }) };
      hands.push(hand);
      hand.process.on("message", (message) => {
        const reply = /** @type {Reply} */ (message);
        const { job } = /** @type {typeof hands[number]} */ (hand);
        if (!job) return;
        delete (/** @type {typeof hands[number]} */ (hand).job);
        running.delete(job.name);
        todo.delete(job.name);
        if (reply.ok) ++built;
        else failed.set(job.name, reply.log);
        if (reply.changed) changed = true;
        else onDone?.({ recipe: job.recipe, ...reply }, todo.size);
        deal();
      });
      hand.process.on("exit", (code, signal) => {
        if (todo.size === 0) return;
        stop();
        reject(new Error(`a compiling process ended early (${signal ?? `exit code ${code}`})`));
      });
    }
    deal();
  });
  if (!changed) return { built, failed };
  // A file was saved meanwhile: finished results are kept, the rest is examined again.
  forgetSources();
  const again = await makeAll(wanted, options);
  return { built: built + again.built, failed: again.failed };
}
