"""How long a lesson takes, by the rule that the pages and `dev check` share."""

from __future__ import annotations

import json
import subprocess
import sys

import pytest
from lesson_minutes import Lesson, lesson_of, words_of
from sample_book import ROOT, Sample

SLUG = "01_lines"


def count(sample: Sample, text: str, recall: int = 0) -> Lesson:
    (sample.root / "chapters" / SLUG / "lesson.md").write_text(text, encoding="utf-8")
    said = {"recall": ["01_lines/touch"] * recall}
    return lesson_of(sample.root, SLUG, said)


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("Two words", 2),
        ("## A heading", 2),
        ("(anchor)=", 0),
        ("% a comment", 0),
        ("{.in-short}", 0),
        ("|---|:--:|", 0),
        ("| a cell | 2 |", 3),
        ("see {doc}`/chapters/00_numbers` and [the link](#far-away) – there", 6),
        ("**bold**, _slanted_ `code`", 3),
        (r"$n \cdot x = k$", 5),
        (r"\begin{gathered} a = b, \\[0.6ex] c = d \end{gathered}", 6),
    ],
)
def test_words(line: str, words: int) -> None:
    assert words_of(line) == words


def test_everything_on_the_page_counts(sample: Sample) -> None:
    lesson = count(
        sample,
        """\
# One two

:::{live-figure} point_line
A caption of five words.
:::

:::{recall}
:::

:::{question} steps
:::

:::{code} contact/line.hpp line
:option: 3
:::

```cpp
int a = 1;

int b = 2;
```

:::{measured} peers
near
:::

::::{note}
Three words here.

:::{ladder}
:::
::::

:::{exercise} distance
:::
""",
        recall=2,
    )
    lines = {listing.name: listing.lines for listing in lesson.main.listings}
    assert lines == {
        "code contact/line.hpp line": 10,
        "the listing 'int a = 1;'": 3,
        "measured peers": lines["measured peers"],
    }
    assert (lesson.main.words, lesson.main.questions, lesson.main.figures) == (10, 3, 2)
    assert lesson.main.minutes == pytest.approx(10 / 200 + lesson.main.lines / 12 + 3 + 4)
    assert lesson.deeper.minutes == 0


def test_what_an_exercise_compares_with_its_figure_is_no_text(sample: Sample) -> None:
    lesson = count(
        sample,
        """\
# One two

:::{exercise} distance
:figure: point_line
signed distance, m: mine = distance
:::
""",
    )
    assert lesson.main.words == 2


def test_a_deeper_box_is_counted_separately(sample: Sample) -> None:
    lesson = count(
        sample,
        """\
# One

:::::{deeper} Two three
Four.

:::{example} far
:::

:::{question} steps
:::
:::::

Five six.
""",
    )
    assert (lesson.main.words, lesson.main.lines, lesson.main.questions) == (3, 0, 0)
    assert (lesson.deeper.words, lesson.deeper.questions) == (3, 1)
    folder = sample.root / "chapters/01_lines/examples"
    shown = [(folder / f"far.{end}").read_text().count("\n") for end in ("cpp", "out")]
    assert [listing.lines for listing in lesson.deeper.listings] == shown


def test_of_files_with_one_name_the_lesson_s_own_counts(sample: Sample) -> None:
    for slug, lines in (("00_numbers", 7), ("01_lines", 2)):
        folder = sample.root / "chapters" / slug / "examples"
        folder.mkdir(exist_ok=True)
        (folder / "same.out").write_text("a line\n" * lines, encoding="utf-8")
    lesson = count(sample, "# One\n\n:::{code} examples/same.out\n:::\n")
    assert lesson.main.lines == 2


def test_too_long(sample: Sample) -> None:
    listing = "```cpp\n" + "int a;\n" * 26 + "```\n"
    text = "# One\n\n" + "word " * 9000 + "\n\n" + listing
    problems = count(sample, text).problems
    assert len(problems) == 2
    assert "the listing 'int a;' shows 26 lines, and a listing may have 25" in problems[0]
    assert "it takes 47.2 minutes, and may take 45: 9,001 words, 26 lines of code" in problems[1]
    boxed = f"# One\n\n::::{{deeper}} Long\n{listing}::::\n"
    assert count(sample, boxed).problems == []
    # What is in the box has no limit of its own.
    assert count(sample, boxed.replace("::::\n", "word " * 9000 + "\n::::\n")).problems == []


def test_the_command_says_the_minutes_and_what_cannot_be_counted(sample: Sample) -> None:
    def run(*words: str) -> subprocess.CompletedProcess[str]:
        program = ROOT / "grading/book/lesson_minutes.py"
        command = [sys.executable, str(program), "--root", str(sample.root), *words]
        return subprocess.run(command, capture_output=True, text=True, check=False)

    done = run()
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stdout.startswith("01_lines: 1")
    assert "in Deeper boxes" in done.stdout
    sample.edit("chapters/01_lines/lesson.md", "contact/line.hpp line", "contact/line.hpp lime")
    done = run("--json", "01")
    assert done.returncode == 1
    [lesson] = json.loads(done.stdout)
    where = "chapters/01_lines/contact/line.hpp"
    assert lesson["problems"] == [f"unknown region 'lime' in {where}; there is: line, second"]
