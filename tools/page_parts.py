"""What one run of the checks compiles for the page: figures, ladders and exercises go by turns.

A turn takes a third of the chapters with their figures and ladder, and a third of the exercises;
what the change touches and what tests name is in every turn. The pages are built with what there
is, as they are while `./contact serve` builds: the other figures say that they are not built yet.
CONTACT_ALL takes everything.
"""

from __future__ import annotations

import os
import re

import steps
from sample import chapters_asked_for, sample
from steps import ROOT

# The chapter whose scenes the page's player plays, and its name in page/wasm/build.mjs.
SCENES = "20_scenes"
PLAYER = f"{SCENES}/scene_player"
# The book's answers on the page "Ask the engines", which also asks the player.
ENGINES = "engines/queries"

FIGURES = [f"{file.parts[-3]}/{file.stem}" for file in ROOT.glob("chapters/*/figures/*.cpp")]
LADDERS = [file.parent.name for file in ROOT.glob("chapters/*/ladder.cpp")]
# As tests/browser/sample.mjs has them.
WITH_PARTS = sorted({*LADDERS, *(name.split("/")[0] for name in FIGURES)})
EXERCISES = sorted(
    f"{file.parts[-3]}/{file.parts[-2]}" for file in ROOT.glob("exercises/*/*/exercise.toml")
)


def named_by_tests() -> set[str]:
    """Names like 02_triangles/ray_triangle, of figures and exercises, in the tests of the page."""
    patterns = ("tests/browser/*.mjs", "page/web/test/**/*.mjs", "page/wasm/*.test.mjs")
    tests = [file.read_text("utf-8") for pattern in patterns for file in ROOT.glob(pattern)]
    named = {name for text in tests for name in re.findall(r"\b\d\d_\w+/\w+", text)}
    for folder in ("tests/browser/endings", "tests/grading/mistakes"):
        named |= {"/".join(one.parts[-2:]) for one in (ROOT / folder).glob("*/*")}
    return named


def exercises() -> list[str]:
    """A third, the same as the tests in a browser take, and those that tests of the page name.

    One chapter alone needs none of the latter.
    """
    taken = sample(EXERCISES, 3, "exercises compiled for the page", kind="exercises")
    if chapters_asked_for():
        return taken
    return sorted({*taken, *(named_by_tests() & set(EXERCISES))})


def chapters_of(kind: str, what: str = "") -> list[str]:
    """The chapters whose figures (or ladders, or pages) this run tests."""
    return sample(WITH_PARTS, 3, what, kind=kind)


def chapters() -> list[str]:
    """Those whose figures and ladder are compiled: a page's questions use its figures."""
    what = "chapters whose figures and ladders are compiled for the page"
    return sorted({*chapters_of("figures", what), *chapters_of("ladder"), *chapters_of("page")})


def player_is_tested() -> bool:
    return SCENES in chapters_of("figures")


def figures_named() -> list[str]:
    """Single figures of other chapters that tests name; one chapter alone needs none of them."""
    if chapters_asked_for():
        return []
    return sorted(named_by_tests() & set(FIGURES))


def figures_and_ladders() -> list[steps.Step]:
    """Of the others, what is in the cache is taken too, and what is out of date is removed.

    Beside the chapters that are asked for, the rest of the book stays as it is.
    """
    if everything():
        return [steps.FIGURES_AND_LADDERS]
    taken = chapters()
    narrowed = [word for name in (*taken, *figures_named()) for word in ("--only", name)]
    if not narrowed:
        return []
    if player_is_tested():
        narrowed += ["--only", ENGINES]
    if not chapters_asked_for():
        narrowed.append("--drop-outdated")
    what = f"the figures' and the ladders' C++ of {len(taken)} chapters for the page"
    command = ("wasm/build.mjs", "figures", "ladders", *narrowed)
    return [steps.Step(what, steps.node("book-figures", *command))]


def scripts() -> steps.Step:
    if everything():
        return steps.SCRIPTS
    return steps.Step(
        "the page's scripts, and the pictures of what is built",
        steps.node("book-web", "web/build.mjs", "--of-built"),
    )


def with_ebook() -> bool:
    """In every third turn, and where what all pages are made with is touched.

    One chapter alone leaves the e-book as it is.
    """
    if chapters_asked_for():
        return steps.EBOOK.exists()
    return bool(sample(["the whole book"], 3, "e-books", kind="page"))


def pages() -> steps.Step:
    ebook = with_ebook()
    if not ebook:
        # One of another turn is not what is tested.
        steps.EBOOK.unlink(missing_ok=True)
    return steps.Step(
        "the pages with all that", lambda: steps.build_book(figures=everything(), ebook=ebook)
    )


def ebook() -> list[steps.Step]:
    if not with_ebook():
        return []
    return [steps.Step("the e-book", lambda: steps.build_ebook(figures=everything()))]


def native_figures() -> steps.Step:
    """The native programs of the figures and ladders that tests compare with WebAssembly."""

    def build() -> steps.Done:
        prefixes = [f"figure_{slug}_" for slug in chapters_of("figures")]
        targets = steps.native_targets(prefixes) if prefixes else []
        return steps.build_native([*targets, *ladder_targets()], "native-figures")

    return steps.Step("native programs of figures and ladders", build)


def ladder_targets() -> list[str]:
    """Of the native build, the ladders of the chapters that this run tests."""
    return [f"ladder_{slug}" for slug in chapters_of("ladder") if slug in LADDERS]


def everything() -> bool:
    return "CONTACT_ALL" in os.environ


def compiler_and_exercises() -> list[steps.Step]:
    names = exercises()
    # A chapter alone may have none; then nothing is compiled in the page either.
    if not names:
        return []
    what = "the compiler and exercises for the page"
    return [steps.Step(what, lambda: steps.page_exercises(*names))]
