"""ask: the questions of a chapter in the terminal."""

from __future__ import annotations

import json
import re
import signal
import subprocess
import time
import tomllib
from collections.abc import Callable
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "build" / "dev" / "bin" / "contact"
HERE = Path(__file__).resolve().parent
CASES = json.loads((HERE / "support" / "quantities.json").read_text(encoding="utf-8"))
CHAPTERS = sorted(path.parent.name for path in (ROOT / "chapters").glob("*/questions.toml"))

Ask = Callable[..., subprocess.CompletedProcess[str]]

QUESTIONS = """
[[question]]
id = "speed"
kind = "predict"
objective = "aim"
text = "How *fast* is $v_1$?"
answer = 1.5
unit = "m/s"
tolerance = 0.01
wrong = [{ answer = 3.0, why = "That is $2 v_1$." }]
explain = "It is $\\\\tfrac32$ m/s."

[[question]]
id = "which"
kind = "choose"
objective = "aim"
text = "Which?"
options = ["this", "that", "none"]
answer = 1
wrong = [{ answer = 0, why = "Not this." }]
explain = "That one."

[[question]]
id = "steps"
kind = "order"
objective = "aim"
text = "In which order?"
items = ["second", "third", "first"]
answer = [2, 0, 1]
explain = "One after another."

[[question]]
id = "drag"
kind = "construct"
objective = "aim"
figure = "01_own/picture"
goal = "done"
text = "Drag it."
explain = "Far enough."

[[question]]
id = "gaps"
kind = "complete"
objective = "aim"
text = "Complete it."
lines = ["Half of 8 is {{half}}.", "In metres, 50 cm are {{metres}}."]
explain = "Both are halves."
[[question.gaps]]
id = "half"
label = "half"
answer = 4.0
unit = ""
tolerance = 0.1
wrong = [{ answer = 16.0, why = "That is twice." }]
[[question.gaps]]
id = "metres"
label = "length"
answer = 0.5
unit = "m"
tolerance = 0.01

[[question]]
id = "reason"
kind = "say-why"
objective = "aim"
text = "Why?"
model = "Because."
criteria = ["It says a.", "It says b.", "It says c."]
"""


def write_book(root: Path, questions: str) -> None:
    """A book of one chapter, with these questions."""
    (root / "exercises").mkdir(parents=True)
    (root / "grading" / "text").mkdir(parents=True)
    units = "grading/text/units.json"
    (root / units).write_text((ROOT / units).read_text(encoding="utf-8"), encoding="utf-8")
    chapter = root / "chapters" / "01_own"
    chapter.mkdir(parents=True)
    (chapter / "chapter.toml").write_text(
        'title = "Own"\npart = 1\nstatus = "lesson"\nbuilds_on = []\nexercises = []\n'
        '[[objectives]]\nid = "aim"\ntext = "an aim"\n',
        encoding="utf-8",
    )
    (chapter / "questions.toml").write_text(questions, encoding="utf-8")


@pytest.fixture
def ask(environment: dict[str, str], tmp_path: Path) -> Ask:
    """Asks the questions of a book of its own; each argument `typed` is a line."""
    root = tmp_path / "own"
    write_book(root, QUESTIONS)

    def run(*words: str, typed: list[str], root: Path = root) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [str(PROGRAM), "ask", *words],
            input="".join(f"{line}\n" for line in typed),
            capture_output=True,
            text=True,
            env={**environment, "CONTACT_ROOT": str(root)},
            timeout=60,
            check=False,
        )

    return run


def record(work: Path) -> dict[str, dict[str, object]]:
    """The answers in the record of progress."""
    kept = json.loads((work / "progress.json").read_text(encoding="utf-8"))["questions"]
    assert isinstance(kept, dict)
    return kept


def test_a_number_is_checked_with_its_unit_and_a_known_mistake_gets_its_words(
    ask: Ask, work: Path
) -> None:
    typed = ["fast", "1.5", "3 m/s", "2 kg", "150 cm/s"]
    done = ask("own", "--id", "speed", typed=typed)
    assert done.returncode == 0
    said = [
        "Begin with a number",
        "Give the unit too.",
        "Not yet. That is 2v₁.",
        "Not yet. The unit kg does not measure what is asked.",
        "Right. It is 1.5 m/s.",
        "It is (3/2) m/s.",
    ]
    at = [done.stdout.find(words) for words in said[:5]]
    assert -1 not in at, done.stdout
    assert at == sorted(at)
    assert "How fast is v₁?" in done.stdout
    assert "1 right" in done.stdout
    kept = record(work)["01_own/speed"]
    assert (kept["kind"], kept["answer"], kept["right"], kept["tries"]) == (
        "predict",
        "150 cm/s",
        True,
        3,
    )
    assert re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ", str(kept["at"]))


def test_a_choice_is_named_by_its_letter(ask: Ask, work: Path) -> None:
    done = ask("own", "--id", "which", typed=["x", "a", "3", "b"])
    assert "Choose one of a to c." in done.stdout
    assert "Not yet. Not this." in done.stdout
    assert "Not yet. Another one is right." in done.stdout
    assert "Right." in done.stdout
    assert "That one." in done.stdout
    assert done.returncode == 0
    assert record(work)["01_own/which"]["answer"] == 1


def test_steps_are_named_in_order(ask: Ask, work: Path) -> None:
    done = ask("own", "--id", "steps", typed=["c a", "c c a", "c b a", "cab"])
    assert done.stdout.count("Name each step from a to c once") == 2
    assert "The first step is right; then comes another." in done.stdout
    assert done.returncode == 0
    assert record(work)["01_own/steps"]["answer"] == [2, 0, 1]


def test_a_gap_is_asked_until_it_is_right_and_then_stands_in_its_line(ask: Ask, work: Path) -> None:
    done = ask("own", "--id", "gaps", typed=["16", "4", "50", "50 cm"])
    assert "1. Half of 8 is (1)____." in done.stdout
    assert "Not yet. That is twice." in done.stdout
    assert "Give the unit too." in done.stdout
    assert "2. In metres, 50 cm are 50 cm." in done.stdout
    assert done.returncode == 0
    kept = record(work)["01_own/gaps"]
    assert (kept["answer"], kept["right"]) == (["4", "50 cm"], True)


def test_a_gap_that_was_shown_makes_the_whole_not_right(ask: Ask, work: Path) -> None:
    done = ask("own", "--id", "gaps", typed=["", "0.5 m"])
    assert "The answer: 4" in done.stdout
    assert done.returncode == 1
    assert not (work / "progress.json").exists()


def test_only_the_reader_judges_why(ask: Ask, work: Path) -> None:
    typed = ["since a", "and c", "", "y", "perhaps", "n", "yes"]
    done = ask("own", "--id", "reason", typed=typed)
    assert done.returncode == 0
    assert done.stdout.index("A model answer: Because.") < done.stdout.index("It says a.")
    assert "Right." not in done.stdout
    kept = record(work)["01_own/reason"]
    assert (kept["answer"], kept["right"]) == ("since a\nand c", False)
    assert (kept["marks"], kept["tries"]) == ([True, False, True], 1)


def test_a_construction_is_named_with_the_page_that_has_it(ask: Ask) -> None:
    done = ask("own", "--id", "drag", typed=[])
    assert "01_own/picture" in done.stdout
    assert "chapters/01_own.html#question-drag" in re.sub(r"\s+", " ", done.stdout)
    assert "1 for the page" in done.stdout
    assert done.returncode == 0


def test_an_empty_line_shows_the_answer_and_the_explanation(ask: Ask, work: Path) -> None:
    done = ask("own", "--id", "steps", typed=[""])
    assert "The answer: c a b" in done.stdout
    assert "One after another." in done.stdout
    assert "1 shown" in done.stdout
    assert done.returncode == 1
    assert not (work / "progress.json").exists()


def test_the_end_of_the_input_ends_with_a_summary(ask: Ask) -> None:
    done = ask("own", typed=["1.5 m/s"])
    assert "1 of 6" in done.stdout
    assert "1 right, 5 not answered" in done.stdout
    assert done.returncode == 1
    assert ask("own", typed=["q"]).stdout.rstrip().endswith("0 right, 5 not answered")


def test_what_was_answered_is_asked_again_with_all_only(ask: Ask) -> None:
    ask("own", "--id", "speed", typed=["1.5 m/s"])
    ask("own", "--id", "reason", typed=["because of a", "", "n", "n", "n"])
    assert "Own: 4 questions" in ask("own", typed=[]).stdout
    assert "Own: 6 questions" in ask("01_own", "--all", typed=[]).stdout


def test_unknown_names_are_answered_with_near_ones(ask: Ask) -> None:
    done = ask("01_owm", typed=[])
    assert done.returncode == 2
    assert "Did you mean 01_own?" in done.stderr
    done = ask("own", "--id", "sped", typed=[])
    assert done.returncode == 2
    assert "Did you mean speed" in done.stderr


def test_a_fault_of_the_file_is_named(ask: Ask, tmp_path: Path) -> None:
    root = tmp_path / "faulty"
    write_book(root, QUESTIONS.replace('kind = "order"', 'kind = "sort"'))
    done = ask("own", typed=[], root=root)
    assert done.returncode == 3
    assert "questions.toml:23: question steps: there is no kind 'sort'" in done.stderr


def test_ctrl_c_ends_with_130_and_keeps_what_was_answered(
    ask: Ask, environment: dict[str, str], tmp_path: Path, work: Path
) -> None:
    asking = subprocess.Popen(
        [str(PROGRAM), "ask", "own"],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        env={**environment, "CONTACT_ROOT": str(tmp_path / "own")},
    )
    assert asking.stdin is not None
    asking.stdin.write(b"1.5 m/s\n")
    asking.stdin.flush()
    deadline = time.monotonic() + 30
    while not (work / "progress.json").exists() and time.monotonic() < deadline:
        time.sleep(0.05)
    asking.send_signal(signal.SIGINT)
    assert asking.wait(timeout=30) == 130
    asking.stdin.close()
    assert record(work)["01_own/speed"]["right"] is True


def test_answers_move_with_an_archive_and_the_later_one_stays(
    ask: Ask, environment: dict[str, str], tmp_path: Path, work: Path
) -> None:
    ask("own", "--id", "speed", typed=["1 m/s", "1.5 m/s"])
    given = record(work)["01_own/speed"]
    other = tmp_path / "other"

    def contact(command: str, folder: Path) -> None:
        subprocess.run(
            [str(PROGRAM), command, str(tmp_path / "work.zip")],
            env={**environment, "CONTACT_ROOT": str(tmp_path / "own"), "CONTACT_WORK": str(folder)},
            check=True,
            capture_output=True,
            timeout=60,
        )

    contact("export", work)
    contact("import", other)
    assert record(other) == {"01_own/speed": given}

    def keep(at: str) -> None:
        document = json.loads((other / "progress.json").read_text(encoding="utf-8"))
        mine = {**given, "answer": "2 m/s", "right": False, "tries": 9, "at": at}
        document["questions"] = {"01_own/speed": mine}
        (other / "progress.json").write_text(json.dumps(document), encoding="utf-8")

    keep("2020-01-01T00:00:00Z")
    contact("import", other)
    assert record(other) == {"01_own/speed": {**given, "tries": 9}}
    keep("2999-01-01T00:00:00Z")
    contact("import", other)
    assert record(other)["01_own/speed"]["answer"] == "2 m/s"


def number_question(name: str, value: float, unit: str, extra: str = "") -> str:
    return (
        f'[[question]]\nid = "{name}"\nkind = "predict"\nobjective = "aim"\ntext = "asked"\n'
        f"answer = {value!r}\nunit = {json.dumps(unit, ensure_ascii=False)}\n"
        f'tolerance = {max(abs(value) * 1e-12, 1e-300)!r}\nexplain = "so"\n{extra}\n'
    )


@pytest.mark.parametrize(
    ("text", "value", "unit"),
    [(it["text"], it["value"], it.get("unit", "")) for it in CASES["quantities"]],
)
def test_quantities_are_read_as_in_the_page(
    ask: Ask, tmp_path: Path, text: str, value: float | None, unit: str
) -> None:
    root = tmp_path / "cases"
    write_book(root, number_question("it", 1.0 if value is None else float(value), unit))
    said = ask("own", typed=[text], root=root).stdout
    if text == "":
        assert "The answer: 1" in said
    else:
        assert ("Begin with a number" in said) == (value is None), said
        assert ("Right." in said) == (value is not None), said


@pytest.mark.parametrize("case", CASES["units"], ids=lambda case: f"{case['one']}, {case['other']}")
def test_units_are_compared_as_in_the_page(
    ask: Ask, tmp_path: Path, case: dict[str, object]
) -> None:
    root = tmp_path / "cases"
    write_book(root, number_question("it", 1.0, str(case["other"]), "convert = false"))
    said = ask("own", typed=[f"1.0 {case['one']}"], root=root).stdout
    assert ("Right." in said) == case["same"], said


@pytest.mark.parametrize(
    "case", CASES["conversions"], ids=lambda it: f"{it['text']} in {it['unit']}"
)
def test_units_are_converted_as_in_the_page(
    ask: Ask, tmp_path: Path, case: dict[str, object]
) -> None:
    root = tmp_path / "cases"
    value = case["value"]
    key = 1.0 if value is None else float(str(value))
    write_book(root, number_question("it", key, str(case["unit"])))
    said = ask("own", typed=[str(case["text"])], root=root).stdout
    assert ("Right." in said) == (value is not None), said
    assert ("Not yet." in said) == (value is None), said


@pytest.mark.parametrize("slug", CHAPTERS)
def test_every_question_of_the_book_is_readable_in_a_terminal(ask: Ask, slug: str) -> None:
    done = ask(slug, "--all", typed=[""] * 200, root=ROOT)
    assert done.stderr == ""
    outside_code = re.sub(r"`[^`]*`", "", done.stdout)
    assert not re.findall(r"[\\${}]|\*\*|\]\(", outside_code)
    text = (ROOT / "chapters" / slug / "questions.toml").read_text(encoding="utf-8")
    questions = tomllib.loads(text)["question"]
    for question in questions:
        assert f"  {question['id']}\n" in done.stdout
    assert f"{len(questions)} of {len(questions)}" in done.stdout
