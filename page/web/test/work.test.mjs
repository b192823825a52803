import assert from "node:assert/strict";
import test from "node:test";
import { load } from "./load.mjs";

const { WorkStore, fingerprint, isExerciseId, MAX_VERSIONS, PROGRESS_KEY, CODE_PREFIX } =
  await load("work.ts");

const ID = "02_triangles/ray_triangle";

/** What a browser's localStorage does, with room for so many characters. @param {number} room */
function shelf(room = Number.POSITIVE_INFINITY) {
  /** @type {Map<string, string>} */
  const kept = new Map();
  return {
    room,
    get length() {
      return kept.size;
    },
    key: (/** @type {number} */ index) => [...kept.keys()][index] ?? null,
    getItem: (/** @type {string} */ key) => kept.get(key) ?? null,
    removeItem: (/** @type {string} */ key) => void kept.delete(key),
    setItem(/** @type {string} */ key, /** @type {string} */ value) {
      const others = [...kept].filter(([name]) => name !== key);
      const used = others.reduce((sum, [name, text]) => sum + name.length + text.length, 0);
      if (used + key.length + value.length > this.room) throw new Error("QuotaExceededError");
      kept.set(key, value);
    },
  };
}

/** A clock that goes on one minute with each look. */
function clock() {
  let minute = 0;
  return () => {
    minute += 1;
    return new Date(Date.UTC(2026, 0, 1, 0, minute));
  };
}

/** @param {readonly { text: string }[]} versions */
const texts = (versions) => versions.map(({ text }) => text);

test("code comes back in a later page, with the stub it began from", () => {
  const storage = shelf();
  new WorkStore(storage, clock()).save(ID, "one", "stub-1");
  const later = new WorkStore(storage);
  assert.deepEqual(later.code(ID), {
    text: "one",
    base: "stub-1",
    saved: "2026-01-01T00:01:00Z",
    kept: [],
  });
  assert.equal(later.problem, undefined);
  assert.equal(later.code("01_planes/signed_distance"), undefined);
});

test("saving keeps one text; only what is put aside becomes a version", () => {
  const store = new WorkStore(shelf(), clock());
  store.code(ID);
  store.save(ID, "one", "s");
  store.save(ID, "two", "s");
  assert.deepEqual(store.versions(ID), []);
  store.keep(ID, "reset");
  store.save(ID, "three", "s");
  assert.deepEqual(store.versions(ID), [{ text: "two", at: "2026-01-01T00:03:00Z", why: "reset" }]);
});

test("the same text is one version, the newest", () => {
  const store = new WorkStore(shelf(), clock());
  for (const text of ["one", "two", "one"]) {
    store.save(ID, text, "s");
    store.keep(ID, "checked");
  }
  assert.deepEqual(texts(store.versions(ID)), ["one", "two"]);
});

test("twenty versions are kept, and what was put aside by hand outlives checks", () => {
  const store = new WorkStore(shelf(), clock());
  store.save(ID, "before the reset", "s");
  store.keep(ID, "reset");
  for (let n = 1; n <= 30; n += 1) {
    store.save(ID, `check ${n}`, "s");
    store.keep(ID, "checked");
  }
  const kept = texts(store.versions(ID));
  assert.equal(kept.length, MAX_VERSIONS);
  assert.equal(kept[0], "check 30");
  assert.equal(kept.at(-2), "check 12");
  assert.equal(kept.at(-1), "before the reset");
});

test("when all versions were put aside by hand the oldest goes, and the new one stays", () => {
  const store = new WorkStore(shelf(), clock());
  for (let n = 1; n <= 21; n += 1) {
    store.save(ID, `reset ${n}`, "s");
    store.keep(ID, "reset");
  }
  store.save(ID, "checked", "s");
  store.keep(ID, "checked");
  const kept = texts(store.versions(ID));
  assert.equal(kept.length, MAX_VERSIONS);
  assert.deepEqual([kept[0], kept.at(-1)], ["checked", "reset 3"]);
});

const PASSED = { verdict: "passed", points: 8, max_points: 8 };
const BROKEN = { verdict: "does_not_compile", points: 0, max_points: 8 };
const FAILED = { verdict: "failed", points: 3, max_points: 8 };

/** A check as the page does it: kept first, judged later. @param {any} store @param {string} text @param {object} said */
function check(store, text, said) {
  store.save(ID, text, "s");
  store.keep(ID, "checked");
  store.judged(ID, text, said);
}

test("what passed outlives any number of checks that do not compile", () => {
  const store = new WorkStore(shelf(), clock());
  check(store, "an early pass", PASSED);
  check(store, "most points", { ...PASSED, verdict: "failed", points: 9 });
  check(store, "the last pass", PASSED);
  for (let n = 1; n <= 30; n += 1) check(store, `broken ${n}`, BROKEN);
  const kept = texts(store.versions(ID));
  assert.equal(kept.length, MAX_VERSIONS);
  assert.deepEqual(kept.slice(-4), ["broken 14", "the last pass", "most points", "an early pass"]);
  for (let n = 1; n <= 30; n += 1) check(store, `failed ${n}`, FAILED);
  const later = texts(store.versions(ID));
  assert.equal(later.length, MAX_VERSIONS);
  assert.deepEqual(later.slice(-3), ["failed 13", "the last pass", "most points"]);
});

test("checks that did not compile go first, then other checks, then what was put aside by hand", () => {
  const store = new WorkStore(shelf(), clock());
  store.save(ID, "by hand", "s");
  store.keep(ID, "reset");
  for (let n = 1; n <= 10; n += 1) check(store, `failed ${n}`, FAILED);
  for (let n = 1; n <= 9; n += 1) check(store, `broken ${n}`, BROKEN);
  check(store, "one more", FAILED);
  const kept = texts(store.versions(ID));
  assert.ok(!kept.includes("broken 1"));
  for (const text of ["broken 2", "failed 1", "by hand"]) assert.ok(kept.includes(text), text);
});

test("what a check said stays with the text when it is put aside again", () => {
  const store = new WorkStore(shelf(), clock());
  check(store, "one", PASSED);
  store.keep(ID, "reset");
  store.judged(ID, "another", PASSED);
  assert.deepEqual(store.versions(ID), [
    { text: "one", at: "2026-01-01T00:03:00Z", why: "reset", said: PASSED },
  ]);
});

test("versions of before, without what a check said, are read; nonsense in its place is not", () => {
  const storage = shelf();
  const old = { text: "old", at: "2026-01-01T00:00:00Z", why: "checked" };
  const kept = [old, { ...old, text: "odd", said: "passed" }, { why: "reset" }];
  storage.setItem(CODE_PREFIX + ID, JSON.stringify({ text: "x", base: "", saved: "", kept }));
  const store = new WorkStore(storage, clock());
  assert.deepEqual(store.versions(ID), [old, { ...old, text: "odd" }]);
  store.code(ID);
  for (let n = 1; n <= 18; n += 1) check(store, `check ${n}`, FAILED);
  assert.equal(texts(store.versions(ID)).at(-2), "old");
});

test("keystrokes not yet saved become a version when another tab's text takes their place", () => {
  const storage = shelf();
  const here = new WorkStore(storage, clock());
  const there = new WorkStore(storage, clock());
  here.save(ID, "one", "s");
  there.code(ID);
  there.save(ID, "there", "s");
  const taken = here.takeOver(ID, "one and a half", "one");
  assert.deepEqual(taken, { text: "there", imported: false, aside: true });
  assert.equal(here.code(ID).text, "there");
  assert.deepEqual(
    here.versions(ID).map(({ text, why }) => [text, why]),
    [["one and a half", "other-tab"]],
  );
  // The tab that wrote it hears of that, and goes on with its own keystrokes.
  assert.equal(there.takeOver(ID, "there, and more", "there"), undefined);
});

test("with nothing unsaved another tab's text is taken over, and nothing put aside", () => {
  const storage = shelf();
  const here = new WorkStore(storage, clock());
  const there = new WorkStore(storage, clock());
  here.save(ID, "one", "s");
  there.code(ID);
  there.save(ID, "two", "s");
  const taken = here.takeOver(ID, "one", "one");
  assert.deepEqual(taken, { text: "two", imported: false, aside: false });
  here.save(ID, "three", "s");
  assert.deepEqual(here.versions(ID), []);
});

test("asking what a text began from does not hide what another tab wrote", () => {
  const storage = shelf();
  const here = new WorkStore(storage, clock());
  const there = new WorkStore(storage, clock());
  here.save(ID, "one", "s");
  there.code(ID);
  there.save(ID, "there", "s");
  assert.equal(here.base(ID), "s");
  here.save(ID, "here", "s");
  assert.deepEqual(texts(here.versions(ID)), ["there"]);
});

test("another tab's text becomes a version before it is overwritten", () => {
  const storage = shelf();
  const here = new WorkStore(storage, clock());
  const there = new WorkStore(storage, clock());
  here.save(ID, "one", "s");
  there.code(ID);
  there.save(ID, "there", "s");
  here.save(ID, "here", "s");
  const { text, kept } = here.code(ID);
  assert.equal(text, "here");
  assert.deepEqual(
    kept.map(({ text, why }) => [text, why]),
    [["there", "other-tab"]],
  );
});

test("another tab's text that this one has taken over is not put aside", () => {
  const storage = shelf();
  const here = new WorkStore(storage, clock());
  const there = new WorkStore(storage, clock());
  here.save(ID, "one", "s");
  there.code(ID);
  there.save(ID, "two", "s");
  here.code(ID);
  here.save(ID, "three", "s");
  assert.deepEqual(here.versions(ID), []);
});

test("a text kept beside the present one does not hide what another tab wrote", () => {
  const storage = shelf();
  const here = new WorkStore(storage, clock());
  const there = new WorkStore(storage, clock());
  here.save(ID, "one", "s");
  there.code(ID);
  there.save(ID, "there", "s");
  here.keep(ID, "checked", "tried");
  here.save(ID, "here", "s");
  assert.deepEqual(texts(here.versions(ID)), ["there", "tried"]);
});

test("changes are reported, also those of another tab", () => {
  const store = new WorkStore(shelf(), clock());
  /** @type {unknown[]} */
  const told = [];
  const stop = store.onChange((/** @type {unknown} */ change) => told.push(change));
  store.save(ID, "one", "s");
  store.changedElsewhere(CODE_PREFIX + ID);
  store.changedElsewhere(PROGRESS_KEY);
  store.changedElsewhere("another-site's-key");
  store.changedElsewhere(null);
  stop();
  store.save(ID, "two", "s");
  assert.deepEqual(told, [
    { what: "code", id: ID, elsewhere: false },
    { what: "code", id: ID, elsewhere: true },
    { what: "progress", elsewhere: true },
    { what: "code", id: ID, elsewhere: true },
    { what: "progress", elsewhere: true },
  ]);
});

test("ids are of all code, also of exercises that the book no longer has", () => {
  const storage = shelf();
  storage.setItem("another", "x");
  const store = new WorkStore(storage, clock());
  store.save("09_gone/old_one", "x", "s");
  store.save(ID, "y", "s");
  store.setProgress({ format: "contact-progress/1", exercises: {} });
  assert.deepEqual(store.ids(), [ID, "09_gone/old_one"]);
});

test("without storage everything works, and a sentence says that nothing lasts", () => {
  const store = new WorkStore(undefined, clock());
  assert.match(store.problem, /keeps nothing/);
  store.save(ID, "one", "s");
  store.keep(ID, "reset");
  store.save(ID, "two", "s");
  assert.equal(store.code(ID).text, "two");
  assert.deepEqual(texts(store.versions(ID)), ["one"]);
  assert.deepEqual(store.ids(), [ID]);
  store.setProgress({ format: "contact-progress/1", exercises: { [ID]: { attempts: 3 } } });
  assert.equal(store.progress().exercises[ID].attempts, 3);
});

test("when the storage is full the page goes on, says so, and keeps it once there is room", () => {
  const storage = shelf(400);
  const store = new WorkStore(storage, clock());
  store.save(ID, "short", "s");
  assert.equal(store.problem, undefined);
  store.save(ID, "x".repeat(500), "s");
  assert.match(store.problem, /no more room/);
  assert.equal(store.code(ID).text.length, 500);
  assert.equal(new WorkStore(storage).code(ID).text, "short");
  storage.room = 5000;
  store.setVerdict(ID, "short", {});
  assert.equal(store.problem, undefined);
  assert.equal(new WorkStore(storage).code(ID).text.length, 500);
});

test("a broken record of progress is put aside, not thrown away", () => {
  const storage = shelf();
  storage.setItem(PROGRESS_KEY, "{not JSON");
  const store = new WorkStore(storage, clock());
  assert.deepEqual(store.progress(), { format: "contact-progress/1", exercises: {} });
  assert.equal(storage.getItem(`${PROGRESS_KEY}.broken-2026-01-01T00:01:00Z`), "{not JSON");
  assert.deepEqual(store.progress(), { format: "contact-progress/1", exercises: {} });
  assert.equal(storage.length, 2);
});

test("members of progress that this version does not know stay", () => {
  const storage = shelf();
  const later = { format: "contact-progress/1", exercises: { [ID]: { stars: 3 } }, streak: 7 };
  storage.setItem(PROGRESS_KEY, JSON.stringify(later));
  assert.deepEqual(new WorkStore(storage).progress(), later);
});

test("code that is no record is as if there were none", () => {
  const storage = shelf();
  for (const broken of ["", "null", "[]", '{"text": 3}', "{"]) {
    storage.setItem(CODE_PREFIX + ID, broken);
    assert.equal(new WorkStore(storage).code(ID), undefined, broken);
    assert.deepEqual(new WorkStore(storage).ids(), [], broken);
  }
});

test("the last verdict says of which text it is", () => {
  const storage = shelf();
  new WorkStore(storage, clock()).setVerdict(ID, "one", { points: 3 });
  const last = new WorkStore(storage).verdict(ID);
  assert.deepEqual(last.verdict, { points: 3 });
  assert.equal(last.of, fingerprint("one"));
  assert.notEqual(last.of, fingerprint("one "));
  assert.equal(last.at, "2026-01-01T00:01:00Z");
});

test("an exercise's name is two folders and nothing else", () => {
  for (const id of [ID, "00_vectors/a2", "20_scenes/x_y"]) assert.ok(isExerciseId(id), id);
  for (const id of [
    "",
    "ray",
    "../02_a/b",
    "02_a/../b",
    "02_a/b/c",
    "/02_a/b",
    "02_a\\b",
    "02_A/b",
  ])
    assert.ok(!isExerciseId(id), id);
});
