"""The pages: a student reads the next steps, a teacher the results of the class, and the class page
names no student."""

from __future__ import annotations

import itertools
import json
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from bs4 import BeautifulSoup, Tag

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(HERE), str(ROOT / "grading")]

import outputs_class as made  # noqa: E402
from reports.__main__ import main  # noqa: E402
from reports.class_page import histogram  # noqa: E402
from reports.mistakes import MISTAKES  # noqa: E402

Json = dict[str, Any]

EXERCISE = "02_triangles/ray_triangle"
TITLE = "A ray and a triangle"
BELIEF = "absolute-epsilon"


def listed(*visibility: str) -> Json:
    tests = [
        {"name": f"test number {n}", "points": 1.0, "visibility": kind}
        for n, kind in enumerate(visibility or ("shown", "shown"), start=1)
    ]
    return {
        "id": EXERCISE,
        "title": TITLE,
        "objective": "say where a ray meets a triangle",
        "max_points": float(len(tests)),
        "tests": tests,
    }


def graded(id_: str, *statuses: str, name: str = "", belief: str = "", output: str = "") -> Json:
    """A submission of one exercise, whose tests ended so."""
    tests = []
    for number, status in enumerate(statuses, start=1):
        test: Json = {
            "name": f"test number {number}",
            "status": status,
            "points": float(status == "passed"),
            "max_points": 1.0,
        }
        if status in ("failed", "stopped"):
            test["failure"] = {"asked": "Where?", "got": f"answer-of-{id_}"}
            if belief:
                test["failure"] |= {"misconceptions": [belief], "hint": "Compare with zero itself."}
        tests.append(test)
    points = sum(test["points"] for test in tests)
    passed = all(status == "passed" for status in statuses)
    verdict = {
        "verdict": "passed" if passed else "failed",
        "points": points,
        "max_points": float(len(tests)),
        "tests": tests,
        "output": output,
    }
    return made.submission(id_, [made.unit(EXERCISE, verdict)], name=name)


def broken(id_: str, mistake: str, words: str = "identifier_of_mine is unknown") -> Json:
    """A submission of one exercise that does not compile."""
    remark = {"line": 7, "column": 3, "severity": "error", "message": words, "words": words}
    verdict = {
        "verdict": "does_not_compile",
        "points": 0.0,
        "max_points": 2.0,
        "tests": [],
        "diagnostics": [{**remark, "mistake": mistake}] if mistake else [remark],
        "compile_error": {"line": 7, "column": 3, "message": words, "explanation": words},
    }
    return made.submission(id_, [made.unit(EXERCISE, verdict)])


def pages(folder: Path, document: Json, *words: str) -> dict[str, BeautifulSoup]:
    """The pages, by the student's id or "class"."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "results.json").write_text(json.dumps(document))
    assert main([str(folder), "--formats", "html,class", *words]) == 0
    files = {"class": folder / "class.html"} | {
        file.parent.name: file for file in folder.glob("students/*/report.html")
    }
    return {name: BeautifulSoup(file.read_text(), "html.parser") for name, file in files.items()}


def text(soup: Tag) -> str:
    return re.sub(r"\s+", " ", soup.get_text(" "))


def section(soup: BeautifulSoup, title: str) -> str:
    """The text below a heading, up to the next of its level."""
    heading = next(found for found in soup.find_all("h2") if title in found.get_text())
    parts = []
    for sibling in heading.find_next_siblings():
        if sibling.name == "h2":
            break
        parts.append(sibling.get_text(" "))
    return re.sub(r"\s+", " ", " ".join(parts))


# ---- The class -----------------------------------------------------------------------------------


def test_no_name_no_id_and_no_code_is_on_the_class_page(tmp_path: Path) -> None:
    whole = made.made_up_class(made.exercises(), made.verdicts(), students=40)
    for one in whole["submissions"]:
        one["ignored"] = [f"notes-of-{one['id']}.txt"]
        for unit in one["exercises"]:
            if verdict := unit.get("verdict"):
                verdict["output"] = f"printed by {one['id']}"
                verdict["warnings"] = [f"unused variable '{one['id']}_value'"]
                for remark in verdict["diagnostics"]:
                    remark["words"] += f" near {one['id']}_value"
    whole["submissions"].append(
        made.submission("zq999kx", [], name="Xaverine Whoever", problem="zq999kx.zip holds a link")
    )
    (tmp_path / "results.json").write_text(json.dumps(whole))
    assert main([str(tmp_path)]) == 0
    page = (tmp_path / "class.html").read_text()
    for one in whole["submissions"]:
        assert one["id"] not in page
        for part in one["name"].split():
            assert part not in page
    assert "nmae_of_nobody" not in page, "a name from the code"
    assert "holds a link" not in page


def test_each_test_says_how_many_pass(tmp_path: Path) -> None:
    class_ = made.document(
        [listed()],
        [
            graded("a", "passed", "passed"),
            graded("b", "passed", "failed"),
            graded("c", "passed", "stopped"),
            graded("d", "not_attempted", "not_attempted"),
            broken("e", "missing-semicolon"),
        ],
    )
    rows = pages(tmp_path, class_)["class"].select("section.exercise li.row")
    assert [text(row).strip() for row in rows] == [
        "test number 1 3 of 5 pass",
        "test number 2 1 of 5 pass",
    ]
    bar = rows[1].select(".track span")
    shares = [re.search(r"width:([0-9.]+)%", str(part["style"])) for part in bar]
    assert [float(found[1]) for found in shares if found] == [20.0, 40.0, 40.0]


def test_the_commonest_misconception_stands_first_with_the_hint_given(tmp_path: Path) -> None:
    class_ = made.document(
        [listed()],
        [
            *(graded(f"a{n}", "failed", "failed", belief="direction-normalised") for n in range(2)),
            *(graded(f"b{n}", "passed", "failed", belief=BELIEF) for n in range(3)),
            graded("c", "passed", "passed"),
        ],
    )
    page = pages(tmp_path, class_)["class"]
    believed = section(page, "Commonest misconceptions")
    assert believed.index("Compares with a fixed tolerance") < believed.index("Normalises the")
    assert (
        "Your answer would be right if something small in this test were exactly zero" in believed
    )
    # A student who shows it in two tests counts once.
    assert " 3 Compares" in believed
    assert " 2 Normalises" in believed
    trouble = page.select("ol.troubles > li")[0]
    assert "5 of 6" in text(trouble)
    assert "test number 2" in text(trouble)
    assert "Most often (3 of 5)" in text(trouble)


def test_what_does_not_compile_is_grouped_by_mistake(tmp_path: Path) -> None:
    class_ = made.document(
        [listed()],
        [
            *(broken(f"a{n}", "missing-semicolon") for n in range(3)),
            broken("b", "unknown-name"),
            *(broken(f"c{n}", "") for n in range(4)),
            graded("d", "passed", "passed"),
        ],
    )
    said = section(pages(tmp_path, class_)["class"], "What does not compile")
    assert "3 A semicolon ; is missing" in said
    assert "1 A name that is not declared" in said
    assert said.index("is not declared") < said.index("4 Another mistake"), "the unknown stand last"
    assert "identifier_of_mine" not in said


def legend(page: BeautifulSoup, title: str) -> dict[str, str]:
    """What a legend says of each fill, by the fill's class."""
    heading = next(found for found in page.find_all("h2") if title in found.get_text())
    below = heading.find_next("ul", class_="legend")
    assert isinstance(below, Tag)
    return {str(one["class"][0]): text(one.parent) for one in below.select("i") if one.parent}


def test_a_refused_file_is_not_said_to_compile_or_not_to(tmp_path: Path) -> None:
    one = made.submission("x", [made.absent(listed(), "refused", "it is too large")])
    page = pages(tmp_path / "refused", made.document([listed()], [one]))["class"]
    (track,) = page.select(".brief .track")
    (fill,) = [str(part["class"][0]) for part in track.select("span")]
    fills = legend(page, "Exercises, weakest first")
    assert fills[fill] == "refused"
    assert fills["fill-warn"] == "does not compile"
    assert "1 refused" in section(page, "Exercises, weakest first"), "also without the picture"
    tests = legend(page, "Exercise by exercise")
    assert tests["fill-none"] == "not tried, did not compile, or refused"
    said = section(page, "What does not compile").strip()
    assert said == "Everything that was taken in compiles. What was refused was never compiled."

    whole = made.submission("x", [], problem="x.zip holds a link")
    page = pages(tmp_path / "whole", made.document([listed()], [whole]))["class"]
    assert section(page, "What does not compile").strip() == said

    taken = graded("x", "passed", "passed")
    page = pages(tmp_path / "taken", made.document([listed()], [taken]))["class"]
    said = section(page, "What does not compile").strip()
    assert said == "Everything that was handed in compiles."


def test_every_known_mistake_has_words_for_the_class() -> None:
    known: set[str] = set()
    for file in (ROOT / "grading" / "diagnosis").rglob("*.cpp"):
        source = file.read_text()
        known |= set(re.findall(r'"([a-z]+(?:-[a-z]+)+)"', source))
    for shared in (ROOT / "tests").rglob("*mistakes*"):
        if shared.suffix in (".json", ".toml"):
            known |= set(re.findall(r'"([a-z]+(?:-[a-z]+)+)"', shared.read_text()))
    known -= {"contact-explain"}  # A program, not a mistake.
    assert len(known) >= 40
    assert known - set(MISTAKES) == set()
    assert set(MISTAKES) - known == set()


def test_hidden_tests_are_on_the_projected_page_in_sum_only(tmp_path: Path) -> None:
    class_ = made.document(
        [listed("shown", "hidden", "after_due")],
        [
            graded("a", "passed", "passed", "passed", belief=BELIEF),
            graded("b", "passed", "failed", "failed", belief=BELIEF),
        ],
    )
    page = text(pages(tmp_path, class_)["class"])
    assert "test number 2" not in page
    assert "Hidden tests, in sum 50 % of points" in page
    assert "test number 3 after the due date" in page
    assert "fixed tolerance" not in page, "what a hidden test recognises is hidden too"


def test_the_distribution_counts_everybody_once(tmp_path: Path) -> None:
    statuses = [("passed",) * n + ("failed",) * (10 - n) for n in range(11)]
    class_ = made.document(
        [listed(*["shown"] * 10)], [graded(f"s{n}", *one) for n, one in enumerate(statuses)]
    )
    page = pages(tmp_path, class_)["class"]
    picture = page.select_one("svg.histogram")
    assert picture is not None
    counts = [int(found.get_text()) for found in picture.select("text.count")]
    assert counts == [1] * 9 + [2]
    cells = [int(cell.get_text()) for cell in page.select("details table td.number")]
    assert cells == counts
    assert "Median mark 50 %" in text(page)


def test_a_class_of_nobody_is_a_page_too(tmp_path: Path) -> None:
    page = pages(tmp_path, made.document([listed()], []))["class"]
    assert "Submissions 0" in text(page)
    assert "0 of 0 pass" not in text(page)


def test_the_picture_is_well_formed() -> None:
    soup = BeautifulSoup(str(histogram([0, 3, 0, 7, 1, 0, 0, 0, 0, 2])), "html.parser")
    assert [found.get_text() for found in soup.select("text.count")] == ["3", "7", "1", "2"]
    heights = [float(str(bar["height"])) for bar in soup.select("rect")]
    assert max(heights) == heights[1]


# ---- A student -----------------------------------------------------------------------------------


def test_what_to_do_next_comes_first_and_is_the_cheapest(tmp_path: Path) -> None:
    second = {**listed(), "id": "01_planes/sphere_plane", "title": "A sphere and a plane"}
    third = {**listed(), "id": "01_planes/segment_plane", "title": "A segment and a plane"}
    failing = graded("x", "passed", "failed", belief=BELIEF)["exercises"][0]
    one = made.submission(
        "x",
        [
            made.absent({**third}, "missing"),
            failing,
            {
                **broken("x", "missing-semicolon", "A semicolon is missing.")["exercises"][0],
                "id": second["id"],
            },
        ],
        name="Somebody Real",
    )
    page = pages(tmp_path, made.document([third, listed(), second], [one]))["x"]
    steps = [text(step).strip() for step in page.select(".next li")]
    assert steps[0] == "Make “A sphere and a plane” compile Line 7: A semicolon is missing."
    assert steps[1].startswith(
        f"Repair “{TITLE}” Not yet: test number 2. Compare with zero itself."
    )
    assert steps[2].startswith("Begin “A segment and a plane”")
    headings = [found.get_text() for found in page.find_all("h2")]
    assert headings[0] == "What to do next"
    for link in page.select("a[href^='#']"):
        assert page.find(id=str(link["href"])[1:]), "each step leads to its exercise"
    assert "Somebody Real" in text(page)


def test_who_has_all_reads_that_nothing_is_left(tmp_path: Path) -> None:
    class_ = made.document([listed()], [graded("x", "passed", "passed")])
    page = text(pages(tmp_path, class_)["x"])
    assert "Nothing is left to do" in page
    assert "2 of 2 points" in page


def test_who_fails_hidden_tests_only_reads_that_there_is_something_left(tmp_path: Path) -> None:
    class_ = made.document([listed("shown", "hidden")], [graded("x", "passed", "failed")])
    page = pages(tmp_path, class_)["x"]
    assert "Every test that is shown passes, and not every hidden one." in text(page)
    assert "Nothing is left to do" not in text(page)


def test_a_refused_submission_reads_why(tmp_path: Path) -> None:
    one = made.submission("x", [made.absent(listed(), "refused")], problem="it holds a link")
    page = text(pages(tmp_path, made.document([listed()], [one]))["x"])
    assert "This could not be graded" in page
    assert "it holds a link" in page


@pytest.mark.parametrize("name", ["class", "x"])
def test_pages_stand_alone_and_can_be_read_aloud(tmp_path: Path, name: str) -> None:
    one = graded("x", "passed", "failed", belief=BELIEF, output="hello")
    page = pages(tmp_path, made.document([listed()], [one]))[name]
    assert page.find("html")["lang"] == "en"  # type: ignore[index]
    assert page.find("script") is None
    assert not page.select("link, img, iframe, object, [src], [onclick]")
    policy = page.find("meta", attrs={"http-equiv": "Content-Security-Policy"})
    assert policy is not None
    assert "default-src 'none'" in str(policy)
    ids = [str(found["id"]) for found in page.select("[id]")]
    assert len(ids) == len(set(ids))
    for found in page.select("[aria-labelledby]"):
        assert page.find(id=str(found["aria-labelledby"]))
    levels = [int(found.name[1]) for found in page.find_all(["h1", "h2", "h3"])]
    assert levels[0] == 1
    assert all(after - before <= 1 for before, after in itertools.pairwise(levels))
    assert page.find("main")
    # Colour and signs are never all that says how a test ended.
    if name == "x":
        assert [text(found).strip() for found in page.select(".tests .nothing")] == [
            "passed:",
            "failed:",
        ]


def test_a_browser_finds_nothing_wrong_with_the_pages(tmp_path: Path) -> None:
    """Contrast, names and roles for screen readers, both colour modes, a phone's width."""
    wide = "x" * 3000
    one = graded("x", "passed", "failed", "stopped", "skipped", belief=BELIEF, output=wide)
    one["exercises"][0]["verdict"]["tests"][1]["failure"]["got"] = f"<b>{wide}"
    class_ = made.document(
        [listed("shown", "shown", "shown", "shown", "hidden", "after_due")],
        [
            one,
            broken("y", "missing-semicolon", wide),
            graded("z", *["passed"] * 6, name=wide),
            made.submission("r", [made.absent(listed(), "refused", wide)]),
        ],
        level="reduced",
    )
    pages(tmp_path, class_)
    files = [tmp_path / "class.html", *sorted(tmp_path.glob("students/*/report.html"))]
    assert len(files) == 5
    done = subprocess.run(
        ["node", str(HERE / "outputs_pages.mjs"), *map(str, files)],
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    if done.stdout.strip() == "no browser":
        pytest.skip("no Chromium found (set CHROMIUM to one)")
    assert json.loads(done.stdout) == {str(file): [] for file in files}
