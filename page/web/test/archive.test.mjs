import assert from "node:assert/strict";
import test from "node:test";
import { strFromU8, strToU8, unzipSync, zipSync } from "fflate";
import { load } from "./load.mjs";

const archive = await load("archive.ts");
const { exportWork, importWork, mergeProgress, ArchiveError } = archive;
const { WorkStore, fingerprint } = await load("work.ts");

const RAY = "02_triangles/ray_triangle";
const PLANE = "01_planes/sphere_plane";
const ABOUT = { format: "contact-submission/1", exported: "2026-01-01T00:00:00Z", from: "contact" };

/** @param {Record<string, unknown>} files texts, or data that becomes JSON */
const zip = (files) =>
  zipSync(
    Object.fromEntries(
      Object.entries(files).map(([name, content]) => [
        name,
        content instanceof Uint8Array
          ? content
          : strToU8(typeof content === "string" ? content : JSON.stringify(content)),
      ]),
    ),
  );

const empty = () => new WorkStore(undefined);

/** @param {Record<string, unknown>} exercises */
const progress = (exercises) => ({ format: "contact-progress/1", exercises });

test("what is exported comes back as it was", () => {
  const from = empty();
  const code = 'int α = 1;  // "ü"\r\n\t\n';
  from.save(RAY, code, "s");
  from.save("09_gone/old_one", "x", "s");
  from.setProgress(progress({ [RAY]: { attempts: 2, best_points: 7.5, tests: { a: "passed" } } }));
  const bytes = exportWork(from, new Date("2026-02-03T04:05:06.789Z"));
  const files = unzipSync(bytes);
  assert.deepEqual(Object.keys(files).sort(), [
    "contact-submission.json",
    `work/${RAY}.cpp`,
    "work/09_gone/old_one.cpp",
    "work/progress.json",
  ]);
  assert.deepEqual(JSON.parse(strFromU8(files["contact-submission.json"] ?? new Uint8Array())), {
    format: "contact-submission/1",
    exported: "2026-02-03T04:05:06Z",
    from: "page",
  });
  const to = empty();
  const imported = importWork(bytes, to);
  assert.deepEqual(imported.added, [RAY, "09_gone/old_one"]);
  assert.deepEqual([imported.replaced, imported.same, imported.ignored], [[], [], []]);
  assert.equal(imported.progress, 1);
  assert.equal(to.code(RAY).text, code);
  assert.deepEqual(to.progress(), from.progress());
  assert.deepEqual(importWork(bytes, to).same, [RAY, "09_gone/old_one"]);
});

test("a text that is replaced becomes an earlier version, and keeps its stub's name", () => {
  const store = empty();
  store.save(RAY, "mine", "stub-1");
  const bytes = zip({ "contact-submission.json": ABOUT, [`work/${RAY}.cpp`]: "theirs" });
  assert.deepEqual(importWork(bytes, store).replaced, [RAY]);
  assert.equal(store.code(RAY).text, "theirs");
  assert.equal(store.code(RAY).base, "stub-1");
  assert.deepEqual(
    store.versions(RAY).map((/** @type {any} */ { text, why }) => [text, why]),
    [["mine", "import"]],
  );
});

/** @param {Uint8Array} bytes @param {RegExp} words */
function refused(bytes, words) {
  const store = empty();
  store.save(RAY, "mine", "s");
  assert.throws(
    () => importWork(bytes, store),
    (error) => error instanceof ArchiveError && words.test(/** @type {Error} */ (error).message),
  );
  assert.equal(store.code(RAY).text, "mine");
  assert.deepEqual(store.versions(RAY), []);
}

test("an open page knows an import from another tab's text", () => {
  /** @type {Map<string, string>} */
  const kept = new Map();
  const storage = {
    get length() {
      return kept.size;
    },
    key: (/** @type {number} */ index) => [...kept.keys()][index] ?? null,
    getItem: (/** @type {string} */ key) => kept.get(key) ?? null,
    removeItem: (/** @type {string} */ key) => void kept.delete(key),
    setItem: (/** @type {string} */ key, /** @type {string} */ value) => void kept.set(key, value),
  };
  const page = new WorkStore(storage);
  page.save(RAY, "mine", "s");
  importWork(
    zip({ "contact-submission.json": ABOUT, [`work/${RAY}.cpp`]: "theirs" }),
    new WorkStore(storage),
  );
  const taken = { text: "theirs", imported: true, aside: false };
  assert.deepEqual(page.takeOver(RAY, "mine", "mine"), taken);
  const tab = new WorkStore(storage);
  tab.code(RAY);
  tab.save(RAY, "typed there", "s");
  assert.equal(page.takeOver(RAY, "theirs", "theirs")?.imported, false);
});

test("what is not ours is refused, and nothing changes", () => {
  const code = { [`work/${RAY}.cpp`]: "theirs" };
  refused(strToU8("no archive at all"), /not a zip archive/);
  refused(new Uint8Array(), /not a zip archive/);
  refused(zip(code), /not an export of Contact Hours/);
  refused(zip({ ...code, "contact-submission.json": "{" }), /not an export of Contact Hours/);
  refused(zip({ ...code, "contact-submission.json": "null" }), /not an export of Contact Hours/);
  refused(zip({ ...code, "contact-submission.json": { format: "x/1" } }), /not an export/);
  const newer = { ...ABOUT, format: "contact-submission/2" };
  refused(zip({ ...code, "contact-submission.json": newer }), /newer version/);
  const whole = zip({ ...code, "contact-submission.json": ABOUT });
  refused(whole.subarray(0, whole.length - 30), /not a zip archive/);
});

test("one bad file refuses the whole archive before anything is taken from it", () => {
  const good = { "contact-submission.json": ABOUT, [`work/${RAY}.cpp`]: "theirs" };
  refused(zip({ ...good, [`work/${PLANE}.cpp`]: new Uint8Array([0xff, 0xfe, 0x41]) }), /UTF-8/);
  refused(zip({ ...good, "work/progress.json": "[]" }), /not a record of progress/);
  const odd = { format: "contact-progress/1", exercises: [] };
  refused(zip({ ...good, "work/progress.json": odd }), /not a record of progress/);
});

test("hostile and stray names are left alone", () => {
  const names = [
    "../work/02_triangles/ray_triangle.cpp",
    "/work/02_triangles/ray_triangle.cpp",
    "work/../02_triangles/ray_triangle.cpp",
    "work/02_triangles/../../etc.cpp",
    "work\\02_triangles\\ray_triangle.cpp",
    "work/02_triangles/ray_triangle.cpp\u0000.txt",
    "work/02_triangles/ray_triangle.hpp",
    "work/02_triangles/deep/er.cpp",
    "work/__proto__/x.cpp",
    "work/02_triangles/__proto__.cpp",
    "exercises/02_triangles/ray_triangle/ray_triangle.cpp",
    "notes.txt",
  ];
  const files = Object.fromEntries(names.map((name) => [name, "hostile"]));
  const store = empty();
  const imported = importWork(
    zip({ "contact-submission.json": ABOUT, [`work/${PLANE}.cpp`]: "good", ...files }),
    store,
  );
  assert.deepEqual(store.ids(), [PLANE]);
  assert.deepEqual([...imported.ignored].sort(), [...names].sort());
});

test("a file larger than any solution is not unpacked", () => {
  const bytes = zip({
    "contact-submission.json": ABOUT,
    [`work/${RAY}.cpp`]: " ".repeat(2 << 20),
    [`work/${PLANE}.cpp`]: "good",
  });
  assert.ok(bytes.length < 10_000);
  const store = empty();
  assert.deepEqual(importWork(bytes, store).ignored, [`work/${RAY}.cpp`]);
  assert.deepEqual(store.ids(), [PLANE]);
});

test("many files that unpack to too much are refused, and nothing changes", () => {
  const store = empty();
  const large = new Uint8Array(1 << 20);
  const many = Object.fromEntries(
    Array.from({ length: 21 }, (_, i) => [`work/02_triangles/large_${i}.cpp`, large]),
  );
  const bytes = zip({ "contact-submission.json": ABOUT, ...many });
  assert.ok(bytes.length < 100_000);
  assert.throws(() => importWork(bytes, store), ArchiveError);
  assert.deepEqual(store.ids(), []);
});

test("an archive without code or without progress is taken as it is", () => {
  const store = empty();
  store.setProgress(progress({ [RAY]: { attempts: 1 } }));
  importWork(zip({ "contact-submission.json": ABOUT }), store);
  assert.deepEqual(store.progress(), progress({ [RAY]: { attempts: 1 } }));
  assert.deepEqual(store.ids(), []);
});

test("progress merges to the best points, the earliest pass and the most attempts", () => {
  const ours = {
    attempts: 5,
    best_points: 7,
    max_points: 10,
    last_checked: "2026-03-01T00:00:00Z",
    passed: "2026-02-02T00:00:00Z",
    hints_shown: 1,
    tests: { a: "passed" },
    ours: 1,
  };
  const theirs = {
    attempts: 3,
    best_points: 12,
    max_points: 12,
    last_checked: "2026-04-01T00:00:00Z",
    passed: "2026-02-01T00:00:00Z",
    hints_shown: 4,
    solution_shown: true,
    tests: { b: "failed" },
    theirs: 2,
  };
  const merged = {
    attempts: 5,
    best_points: 12,
    max_points: 12,
    last_checked: "2026-04-01T00:00:00Z",
    passed: "2026-02-01T00:00:00Z",
    hints_shown: 4,
    solution_shown: true,
    tests: { b: "failed" },
    ours: 1,
    theirs: 2,
  };
  assert.deepEqual(
    mergeProgress(progress({ [RAY]: ours }), progress({ [RAY]: theirs })),
    progress({ [RAY]: merged }),
  );
  assert.deepEqual(
    mergeProgress(progress({ [RAY]: theirs }), progress({ [RAY]: ours })),
    progress({ [RAY]: merged }),
  );
});

test("progress of one side alone stays, and invents nothing", () => {
  const one = progress({ [RAY]: { attempts: 2 } });
  const other = progress({ [PLANE]: { hints_shown: 1 }, "../x": { attempts: 9 } });
  assert.deepEqual(
    mergeProgress(one, other),
    progress({ [RAY]: { attempts: 2 }, [PLANE]: { hints_shown: 1 } }),
  );
});

test("an entry or a member of a wrong kind is passed over", () => {
  const odd = { attempts: "9", best_points: -3, passed: "yesterday", tests: [], stars: 3 };
  const merged = mergeProgress(
    progress({ [RAY]: { attempts: 1, passed: "2026-02-01T00:00:00Z" } }),
    progress({ [RAY]: odd, [PLANE]: 3, __proto__: { attempts: 1 } }),
  );
  const entry = { attempts: 1, best_points: 0, passed: "2026-02-01T00:00:00Z", stars: 3 };
  assert.deepEqual(merged, progress({ [RAY]: entry }));
});

test("the book's own beginning does not take the place of what a reader wrote", () => {
  const store = empty();
  store.save(RAY, "mine", `${fingerprint("the stub")}-${fingerprint("the contract")}`);
  const bytes = zip({ "contact-submission.json": ABOUT, [`work/${RAY}.cpp`]: "the stub" });
  assert.deepEqual(importWork(bytes, store).yours, [RAY]);
  assert.equal(store.code(RAY).text, "mine");
  assert.deepEqual(store.versions(RAY), []);
});

test("never passed, or an empty time, does not hide a pass", () => {
  const passed = { passed: "2026-02-01T00:00:00Z" };
  const never = { passed: "", attempts: 1 };
  for (const [a, b] of [
    [passed, never],
    [never, passed],
  ])
    assert.equal(
      mergeProgress(progress({ [RAY]: a }), progress({ [RAY]: b })).exercises[RAY].passed,
      passed.passed,
    );
});

test("when the browser has no room for the import, it says so", () => {
  const full = {
    length: 0,
    key: () => null,
    getItem: () => null,
    removeItem: () => {},
    setItem: () => {
      throw new Error("QuotaExceededError");
    },
  };
  const store = new WorkStore(full);
  const bytes = zip({ "contact-submission.json": ABOUT, [`work/${RAY}.cpp`]: "theirs" });
  assert.match(importWork(bytes, store).problem, /no more room/);
  assert.equal(store.code(RAY).text, "theirs");
});

test("answers to questions go with the work, and the later one stays", () => {
  const kept = new Map();
  globalThis.localStorage = /** @type {any} */ ({
    getItem: (/** @type {string} */ key) => kept.get(key) ?? null,
    setItem: (/** @type {string} */ key, /** @type {string} */ value) => kept.set(key, value),
  });
  const KEY = "contact-hours/1/questions";
  const answers = () => JSON.parse(kept.get(KEY));
  /** @param {string} answer @param {string} at @param {number} tries */
  const given = (answer, at, tries) => ({ kind: "predict", answer, right: false, tries, at });
  const [early, late] = ["2026-01-01T00:00:00.5Z", "2026-01-02T00:00:00Z"];
  try {
    const why = { kind: "say-why", answer: "so", right: false, tries: 1, at: late, marks: [true] };
    kept.set(KEY, JSON.stringify({ "01_planes/a": given("1", early, 3), "01_planes/why": why }));
    const store = empty();
    const bytes = exportWork(store);
    const record = JSON.parse(strFromU8(unzipSync(bytes)["work/progress.json"]));
    assert.deepEqual(record.questions, answers());

    const theirs = {
      "01_planes/a": given("2", late, 1),
      "01_planes/why": { ...why, answer: "older", at: early },
      "01_planes/new": given("3", early, 1),
      "../a": given("4", late, 1),
      "01_planes/broken": { ...given("5", late, 1), at: "yesterday" },
      "01_planes/long": given("x".repeat(30_000), late, 1),
    };
    const file = { "contact-submission.json": ABOUT };
    const work = { ...progress({}), questions: theirs };
    importWork(zip({ ...file, "work/progress.json": work }), store);
    assert.deepEqual(answers(), {
      "01_planes/a": given("2", late, 3),
      "01_planes/why": why,
      "01_planes/new": given("3", early, 1),
    });
    assert.equal(store.progress().questions, undefined);
  } finally {
    // @ts-expect-error: Node has none
    delete globalThis.localStorage;
  }
});
