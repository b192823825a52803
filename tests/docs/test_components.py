"""The HTML of each directive: the element for the page, and a fallback that needs no script."""

from __future__ import annotations

import csv
import io
import json
import re

import pytest
from bs4 import BeautifulSoup, Tag
from sample_book import Sample


@pytest.fixture(scope="module")
def lesson(built: Sample) -> BeautifulSoup:
    return BeautifulSoup(built.page("chapters/01_lines.html"), "html.parser")


def one(page: BeautifulSoup | Tag, selector: str) -> Tag:
    found = page.select(selector)
    assert len(found) == 1, f"{len(found)} of {selector}"
    return found[0]


def data(element: Tag) -> dict[str, object]:
    """The JSON an element carries."""
    script = one(element, 'script[type="application/json"]')
    loaded = json.loads(script.get_text())
    assert isinstance(loaded, dict)
    return loaded


def without_scripts(element: Tag) -> str:
    """The words a reader sees when nothing runs."""
    copy = BeautifulSoup(str(element), "html.parser")
    for hidden in copy.select("script, template"):
        hidden.decompose()
    return re.sub(r"\s+", " ", copy.get_text(" "))


def test_a_figure_has_a_picture_with_words_inside_the_element(lesson: BeautifulSoup) -> None:
    element = one(lesson, "figure.live > contact-figure")
    assert element["name"] == "01_lines/point_line"
    assert element["base"] == "../_static/contact/"
    picture = one(element, "img")
    assert picture["src"] == "../_static/contact/figures/01_lines/point_line.svg"
    assert picture["alt"] == "The point is 2 m in front of the line."
    assert (picture["width"], picture["height"]) == ("400", "240")
    assert "Drag the point" in one(lesson, "figure.live > figcaption").get_text()


def test_a_scene_player_names_the_scenes_over_a_picture(lesson: BeautifulSoup) -> None:
    element = one(lesson, "figure.live > contact-player")
    assert element["name"] == "01_lines"
    assert element["base"] == "../_static/contact/"
    assert data(element) == {
        "first": "two_balls",
        "scenes": [
            {"name": "one_ball", "about": "A ball & nothing <else>."},
            {"name": "two_balls", "about": "Two balls."},
        ],
    }
    picture = one(element, "img")
    assert picture["src"] == "../_static/contact/scenes/first.svg"
    assert picture["alt"] == "Two balls, after 3 hits."
    assert (picture["width"], picture["height"]) == ("600", "400")
    words = one(element, "noscript").get_text()
    assert "2 scenes" in words
    assert "./contact simulate two_balls" in words


def test_the_picture_and_the_script_are_where_the_page_looks(built: Sample) -> None:
    static = built.site / "_static" / "contact"
    assert (static / "figures" / "01_lines" / "point_line.svg").is_file()
    assert 'type="module"' in built.page("chapters/01_lines.html")
    assert "contact.js" not in built.page("api/01_lines.html")


def test_a_choice_carries_its_key_and_finds_its_words_beside_it(lesson: BeautifulSoup) -> None:
    element = one(lesson, "#question-side")
    question = data(element)
    assert question["id"] == "01_lines/side"
    assert question["kind"] == "choose"
    assert question["answer"] == 0
    assert element.select("div.question > ul > li")[0].select(".katex")
    assert not {"text", "options", "explain"} & set(question)
    wrong = question["wrong"]
    assert wrong == [{"answer": 2, "why": "<span>Look at the <strong>sign</strong>.</span>"}]


def test_no_text_of_a_question_can_end_its_script(lesson: BeautifulSoup) -> None:
    script = one(lesson, "#question-side > script")
    assert "<" not in script.get_text()


def for_the_script(element: Tag) -> BeautifulSoup:
    """What the element's template holds, which no browser shows."""
    return BeautifulSoup(one(element, "template").decode_contents(), "html.parser")


ALL = ["side", "how-far", "steps", "touch", "fill", "fill-table", "why-sign"]


@pytest.mark.parametrize("name", ALL)
def test_without_a_script_the_answer_is_on_another_page_linked_both_ways(
    built: Sample, lesson: BeautifulSoup, name: str
) -> None:
    element = one(lesson, f"#question-{name}")
    explanation = one(for_the_script(element), ".explain").get_text().strip()
    assert explanation
    assert explanation not in without_scripts(element)
    link = one(element, "div.question .to-answer a")["href"]
    assert link == f"../answers.html#answer-01_lines-{name}"
    answers = BeautifulSoup(built.page("answers.html"), "html.parser")
    answer = one(answers, f"#answer-01_lines-{name}")
    assert one(answer, ".explain").get_text().strip() == explanation
    assert one(answer, ".to-answer a")["href"] == f"chapters/01_lines.html#question-{name}"


@pytest.fixture(scope="module")
def answers(built: Sample) -> BeautifulSoup:
    return BeautifulSoup(built.page("answers.html"), "html.parser")


def test_the_answers_of_a_chapter_are_a_section(answers: BeautifulSoup) -> None:
    assert [head.get_text().rstrip("#") for head in answers.select("h2")] == ["Lines"]
    assert len(answers.select("section section .question")) == len(ALL)


def test_a_predicted_number_keeps_unit_and_tolerance(
    lesson: BeautifulSoup, answers: BeautifulSoup
) -> None:
    element = one(lesson, "#question-how-far")
    question = data(element)
    assert (question["answer"], question["unit"], question["tolerance"]) == (2.0, "m", 0.01)
    assert one(answers, "#answer-01_lines-how-far .key > p + p").get_text() == "2 m"
    assert "2 m" not in without_scripts(element)


def test_steps_are_shown_as_asked_and_put_right_in_the_answer(
    lesson: BeautifulSoup, answers: BeautifulSoup
) -> None:
    element = one(lesson, "#question-steps")
    asked = [item.get_text() for item in element.select("div.question > ul > li")]
    assert asked[0] == "compare with 0"
    right = [item.get_text() for item in answers.select("#answer-01_lines-steps .key > ol > li")]
    assert right[1] == "compare with 0"


def test_gaps_are_named_in_their_lines_and_filled_in_the_answer(
    lesson: BeautifulSoup, answers: BeautifulSoup
) -> None:
    element = one(lesson, "#question-fill")
    steps = element.select("div.question > ol.lines > li")
    assert len(steps) == 2
    assert one(steps[0], ".gap")["class"] == ["gap", "gap-square"]
    assert "______, from" in steps[0].get_text()
    gaps = data(element)["gaps"]
    assert isinstance(gaps, list)
    first, second = gaps
    assert (first["id"], first["answer"], first["unit"]) == ("square", 25.0, "m²")
    assert first["wrong"] == [
        {"answer": 49.0, "why": "<span>Square <em>before</em> you add.</span>"}
    ]
    assert (second["id"], second["label"], second["wrong"]) == ("length", "distance", [])
    shown = answers.select("#answer-01_lines-fill .key > ol > li")
    assert [item.get_text() for item in shown] == ["square of the length: 25 m²", "distance: 5 m"]


def test_a_table_to_complete_has_heads(lesson: BeautifulSoup) -> None:
    table = one(lesson, "#question-fill-table table.lines")
    assert [head.get_text() for head in table.select("thead th")] == ["point", "value"]
    gaps = [gap["class"][1] for gap in table.select("tbody td > .gap")]
    assert gaps == ["gap-in-front", "gap-behind"]


def test_a_model_answer_comes_with_its_criteria(
    lesson: BeautifulSoup, answers: BeautifulSoup
) -> None:
    element = one(lesson, "#question-why-sign")
    assert set(data(element)) == {"id", "kind", "objective", "wrong"}
    criteria = for_the_script(element).select("ul.criteria > li")
    assert len(criteria) == 3
    assert criteria[1].select("strong")
    assert len(answers.select("#answer-01_lines-why-sign .key > ul > li")) == 3


def test_a_construction_names_its_figure_and_goal(lesson: BeautifulSoup) -> None:
    question = data(one(lesson, "#question-touch"))
    assert (question["figure"], question["goal"]) == ("01_lines/point_line", "on")


def test_the_ladder_has_its_picture_and_where_it_was_measured(
    lesson: BeautifulSoup,
) -> None:
    element = one(lesson, "contact-ladder")
    assert data(element)["ladder"] == "01_lines"
    cells = [cell.get_text() for cell in element.select(".picture td[data-family]")]
    assert cells == ["1.2", "0"]
    assert "never wrong" in one(element, ".picture .proven").get_text()
    assert not element.select("button")
    assert not one(element, "details").has_attr("open")
    words = without_scripts(element)
    assert "Some CPU" in words
    assert "quick run" in words


def test_failing_inputs_are_a_file_of_their_own(built: Sample, lesson: BeautifulSoup) -> None:
    element = one(lesson, "contact-ladder")
    rows = json.loads(one(element, 'script[type="application/json"]').get_text())["results"]
    assert [row.get("fails") for row in rows] == [True, None]
    assert not any("failure" in row for row in rows)
    file = built.site / "chapters" / str(element["failures"])
    failing = json.loads(file.read_text(encoding="utf-8"))
    assert list(failing) == ["random float"]
    assert failing["random float"]["input"] == 3


def test_the_numbers_of_a_ladder_can_be_had_as_csv(built: Sample, lesson: BeautifulSoup) -> None:
    link = one(lesson, "contact-ladder details a[download]")
    assert link["download"] == "01_lines.csv"
    text = (built.site / "chapters" / str(link["href"])).read_text(encoding="utf-8")
    rows = list(csv.DictReader(io.StringIO(text, newline="")))
    assert [(row["inputs"], row["method"], row["wrong"], row["ns_q3"]) for row in rows] == [
        ("random points", "plain", "12", "1.6"),
        ("random points", "exact", "0", "41"),
    ]


def test_hard_cases_show_each_method_right_or_wrong(lesson: BeautifulSoup) -> None:
    table = one(lesson, "table.hard-cases")
    assert one(table, ".verdict.wrong").get_text() == "wrong"
    assert one(table, ".verdict.right").get_text() == "right"
    caption = one(table, "caption").get_text()
    assert caption.startswith("which side: 1 hard case; 1 of 2 answers are wrong")


def test_each_table_of_hard_cases_has_a_name_of_its_own(sample: Sample) -> None:
    both = ":::{hard-cases}\n:::\n\n:::{hard-cases}\n:::\n"
    sample.edit("chapters/01_lines/lesson.md", ":::{hard-cases}\n:::\n", both)
    made = sample.make()
    assert made.returncode == 0, made.stdout + made.stderr
    page = BeautifulSoup(sample.page("chapters/01_lines.html"), "html.parser")
    names = [region["aria-label"] for region in page.select('[role="region"]:has(.hard-cases)')]
    assert len(names) == 2
    assert len(set(names)) == 2


def test_a_page_shows_its_own_chapters_file_and_a_link_in_a_caption(sample: Sample) -> None:
    other = sample.root / "chapters/00_numbers/examples/far.out"
    other.parent.mkdir()
    other.write_text("3 m\n")
    lesson = "chapters/01_lines/lesson.md"
    sample.edit(
        lesson, ":::{example} far\n", ":::{code} examples/far.out\n:::\n\n:::{example} far\n"
    )
    sample.edit(lesson, "changes sign as it crosses.", "changes sign: see [below](#the-player).")
    made = sample.make()
    assert made.returncode == 0, made.stdout + made.stderr
    page = BeautifulSoup(sample.page("chapters/01_lines.html"), "html.parser")
    shown = [box.get_text() for box in page.select(".listing") if "2 m" in box.get_text()]
    assert shown
    assert "3 m" not in page.get_text()
    assert one(page, "figcaption a:not(.embed-link)")["href"] == "#the-player"


def test_an_exercise_shows_contract_points_commands_and_folded_hints(lesson: BeautifulSoup) -> None:
    section = one(lesson, "section.exercise")
    words = section.get_text()
    assert "double distance(double a, double b, double c, double x, double y);" in words
    assert "./contact start 01_lines/distance" in words
    assert "5 points" in words
    assert len(section.select("table.points tbody tr")) == 2
    assert "Divide by the length" in one(section, ".hints details details").get_text()
    assert not section.select("button")


def test_code_comes_from_its_region_and_examples_show_their_output(lesson: BeautifulSoup) -> None:
    listing = lesson.select(".literal-block-wrapper")[0].get_text()
    assert "struct Line" in listing
    assert "[second]" not in listing
    assert "pragma" not in listing
    example = one(lesson, "div.example").get_text()
    assert "printf" in example
    assert "prints" in example


def test_a_name_before_a_component_is_an_anchor(lesson: BeautifulSoup) -> None:
    assert one(lesson, "#the-player").find_next("contact-player")
    assert one(lesson, 'a[href="#the-player"]').get_text() == "The player"


def test_a_measurement_shows_where_it_is_from_and_what_is_asked_for(lesson: BeautifulSoup) -> None:
    shown = [box.get_text() for box in lesson.select(".literal-block-wrapper")]
    [measured] = [text for text in shown if "results/peers" in text]
    assert "benchmarks/results/peers.small.txt" in measured
    assert "one core, 2026-01-02" in measured
    assert "9.00" in measured
    assert "far lines" not in measured


def test_the_head_says_time_what_it_builds_on_and_objectives(lesson: BeautifulSoup) -> None:
    head = one(lesson, ".chapter-head")
    assert head.find_previous_sibling().name == "h1"  # type: ignore[union-attr]
    assert "About 15 minutes, and 10 minutes of exercises" in head.get_text()
    assert "Optional: 1 minute of Deeper boxes" in head.get_text()
    assert one(head, 'a[href="../api/00_numbers.html"]').get_text() == "Numbers"
    assert len(head.select(".objectives li")) == 2
    assert "lines & planes" in one(lesson, ".chapter-foot").get_text()


def test_the_map_links_lessons_and_shows_the_rest_as_code(built: Sample) -> None:
    home = BeautifulSoup(built.page("index.html"), "html.parser")
    boxes = one(home, "nav.chapter-map[aria-label]").select("li.box")
    assert [one(box, "a")["href"] for box in boxes] == [
        "api/00_numbers.html",
        "chapters/01_lines.html",
    ]
    assert "code-only" in boxes[0]["class"]
    assert "code only, every chapter stands on it" in boxes[0].get_text()
    assert "builds on Numbers" in boxes[1].get_text()
    assert boxes[1]["title"]


def test_the_cards_say_what_each_chapter_is_about(built: Sample) -> None:
    home = BeautifulSoup(built.page("index.html"), "html.parser")
    cards = home.select(".chapter-cards li.card")
    assert [one(card, "a")["href"] for card in cards] == [
        "api/00_numbers.html",
        "chapters/01_lines.html",
    ]
    assert "code only" in cards[0].get_text()
    assert "builds on Numbers" in cards[1].get_text()


def test_an_api_page_has_every_declaration_in_its_namespace(built: Sample) -> None:
    page = BeautifulSoup(built.page("api/01_lines.html"), "html.parser")
    names = [str(entry.get("id", "")) for entry in page.select("dt.sig")]
    assert any("N7contact4LineE" in name for name in names)
    assert any("N7contact4sideE" in name for name in names)
    numbers = built.page("api/00_numbers.html")
    assert "std" in numbers
    assert "floating_point" in numbers
