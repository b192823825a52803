"""Messages to an author: the file, the line, and what exists instead."""

from __future__ import annotations

import pytest
from sample_book import Sample

LESSON = "chapters/01_lines/lesson.md"


# What an author might write instead of what the sample says, the line, and what the build answers.
MISTAKES = [
    (
        ":::{live-figure} point_line",
        ":::{live-figure} circle",
        3,
        "unknown figure 'circle' in chapters/01_lines/figures; there is: point_line",
    ),
    (
        ":::{code} contact/line.hpp line",
        ":::{code} contact/line.hpp lin",
        16,
        "unknown region 'lin' in chapters/01_lines/contact/line.hpp; there is: line, second",
    ),
    (":::{example} far", ":::{example} near", 19, "unknown example 'near'"),
    (
        ":::{question} how-far",
        ":::{question} how-deep",
        22,
        "unknown question 'how-deep' in chapters/01_lines/questions.toml; "
        "there is: fill, fill-table, how-far, side, steps, touch, why-sign",
    ),
    (
        "{question} 01_lines/touch",
        "{question} 03_none/touch",
        28,
        "unknown chapter '03_none'",
    ),
    (
        ":::{exercise} distance",
        ":::{exercise} area",
        52,
        "unknown exercise 'area' in exercises/01_lines; there is: distance",
    ),
    (
        ":::{measured} peers\nnear",
        ":::{measured} peers\nafar",
        55,
        "unknown paragraph 'afar' in benchmarks/results/peers.small.txt; "
        "there is: far lines: ms each, near lines: ms each",
    ),
    (
        ":first: two_balls",
        ":first: three_balls",
        63,
        "unknown scene 'three_balls' in chapters/01_lines/lesson.md, :first:; "
        "there is: one_ball, two_balls",
    ),
    ("\\norm{n}", "\\nrm{n}", 12, "mathematics: KaTeX parse error"),
]


@pytest.fixture(scope="module")
def answers(tmp_path_factory: pytest.TempPathFactory) -> str:
    """One build with every mistake in the lesson at once."""
    sample = Sample(tmp_path_factory.mktemp("mistakes"))
    for old, new in {old: new for old, new, _, _ in MISTAKES}.items():
        sample.edit(LESSON, old, new)
    made = sample.make("--skip-api")
    assert made.returncode != 0
    return made.stderr


@pytest.mark.parametrize(("line", "message"), [(line, words) for _, _, line, words in MISTAKES])
def test_a_wrong_name_is_an_error_at_its_line(answers: str, line: int, message: str) -> None:
    said = [words for words in answers.splitlines() if message in words]
    assert said, answers
    assert said[0].startswith(f"{LESSON}:{line}:")


@pytest.mark.parametrize(
    ("name", "old", "new", "message"),
    [
        (
            "chapters/01_lines/questions.toml",
            'objective = "distance"',
            'objective = "length"',
            "unknown objective 'length' in chapters/01_lines/questions.toml: question 'how-far'",
        ),
        (
            "chapters/01_lines/questions.toml",
            "answer = [1, 0]",
            "answer = [1, 1]",
            "question 'steps': answer must order the items 0 to 1",
        ),
        (
            "exercises/01_lines/distance/exercise.toml",
            'kind = "blank"',
            'kind = "hard"',
            "unknown kind of exercise 'hard'",
        ),
        (
            "exercises/01_lines/distance/exercise.toml",
            "misconceptions =",
            "misconception =",
            "unknown key 'misconception'; there is: breaks, brief, hints, inputs, kind, minutes, ",
        ),
        (
            LESSON,
            ":first: two_balls",
            ":first: one_ball",
            "the page opens with one_ball, but its picture is of two_balls",
        ),
    ],
)
def test_a_wrong_table_is_an_error_that_names_its_file(
    sample: Sample, name: str, old: str, new: str, message: str
) -> None:
    sample.edit(name, old, new)
    made = sample.make("--skip-api")
    assert made.returncode != 0
    assert message in made.stderr
    assert name in made.stderr


def test_an_unknown_header_lists_those_there_are(sample: Sample) -> None:
    sample.edit(LESSON, "contact/line.hpp line", "contact/lime.hpp line")
    made = sample.make("--skip-api")
    assert made.returncode != 0
    assert "unknown file 'contact/lime.hpp'" in made.stderr
    assert "contact/line.hpp, contact/number.hpp" in made.stderr


def test_a_chapter_without_status_stops_the_build_in_words(sample: Sample) -> None:
    sample.edit("chapters/01_lines/chapter.toml", 'status = "lesson"\n', "")
    made = sample.make("--skip-api")
    assert made.returncode == 1
    assert "chapters/01_lines/chapter.toml: 'status' is missing" in made.stderr


def test_a_missing_picture_is_an_error_only_when_all_must_be_there(sample: Sample) -> None:
    (sample.root / "web" / "figures" / "01_lines" / "point_line.svg").unlink()
    made = sample.make("--skip-api")
    assert made.returncode == 0, made.stderr
    assert "still being built" in sample.page("chapters/01_lines.html")
    strict = sample.make("--skip-api", "--complete")
    assert strict.returncode != 0
    assert "the picture of figure 01_lines/point_line is not built" in strict.stderr


def test_of_figures_some_may_be_there_and_of_the_rest_all(sample: Sample) -> None:
    (sample.root / "web" / "figures" / "01_lines" / "point_line.svg").unlink()
    some = ("--skip-api", "--complete", "--some-figures")
    made = sample.make(*some)
    assert made.returncode == 0, made.stderr
    assert "still being built" in sample.page("chapters/01_lines.html")
    # What was built so does not pass for complete.
    assert sample.make("--skip-api", "--complete").returncode != 0
    (sample.build / "docs-data" / "ladders" / "01_lines.json").unlink()
    strict = sample.make(*some)
    assert strict.returncode != 0
    assert "ladder_01_lines has not run" in strict.stderr


def test_what_is_undocumented_stops_a_complete_build(sample: Sample) -> None:
    sample.edit("chapters/01_lines/contact/line.hpp", "  /// The offset.\n", "")
    made = sample.make("--complete")
    assert made.returncode == 1
    assert "chapters/01_lines/contact/line.hpp:" in made.stderr
    assert "c (variable) of struct contact::Line is not documented" in made.stderr
