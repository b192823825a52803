"""JUnit XML, as in Jenkins' junit-10.xsd: one suite per exercise, one case per test.

Texts come from `text.clean`, so no character is left that XML 1.0 forbids; ElementTree escapes the
rest. Time is what may be told of what the exercise took, as visibility.py says, and is left out of
what is compared between runs.
"""

from __future__ import annotations

from xml.etree.ElementTree import Element, SubElement, indent, tostring

from reports.visibility import (
    NOT_GRADED,
    OUTPUT_WITHHELD,
    SeenSubmission,
    SeenTest,
    SeenUnit,
    machine_sentence,
)
from reports.words import (
    HIDDEN_NAME,
    HIDDEN_WORDS,
    LATER_NAME,
    LATER_WORDS,
    NOT_GRADED_WORDS,
    REFUSED_NAME,
    UNIT_WORDS,
    hint_line,
    points_text,
    sum_text,
    test_text,
    unit_problem,
)


def junit(submission: SeenSubmission) -> str:
    """The whole document."""
    root = Element("testsuites", name=f"contact grade: {submission.id}")
    if submission.problem:
        _refusal(root, submission)
    for unit in submission.units:
        _suite(root, submission, unit)
    for key in ("tests", "failures", "errors"):
        root.set(key, str(sum(int(suite.get(key, "0")) for suite in root)))
    indent(root)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + tostring(root, encoding="unicode") + "\n"


def _refusal(root: Element, submission: SeenSubmission) -> None:
    counts = {"tests": "1", "failures": "0", "errors": "1", "skipped": "0"}
    suite = SubElement(root, "testsuite", {"name": "submission", **counts})
    properties = SubElement(suite, "properties")
    for what in submission.not_enforced:
        SubElement(properties, "property", name="not_enforced", value=what)
    case = SubElement(suite, "testcase", classname="submission", name=REFUSED_NAME)
    first = submission.problem.partition("\n")[0]
    SubElement(case, "error", type="refused", message=first).text = submission.problem


def _suite(root: Element, submission: SeenSubmission, unit: SeenUnit) -> None:
    suite = SubElement(root, "testsuite", name=unit.exercise.id)
    properties = SubElement(suite, "properties")
    told = {} if unit.told_points is None else {"points": points_text(unit.told_points)}
    facts = {
        **told,
        "max_points": points_text(unit.max_points),
        "gradable": "true" if unit.gradable else "false",
    }
    for name, value in facts.items():
        SubElement(properties, "property", name=name, value=value)
    for what in submission.not_enforced:
        SubElement(properties, "property", name="not_enforced", value=what)
    problem = submission.problem or unit_problem(unit)
    if unit.status == NOT_GRADED:
        case = _bare_case(suite, unit, UNIT_WORDS[NOT_GRADED])
        SubElement(case, "error", type=NOT_GRADED, message=NOT_GRADED_WORDS)
    for test in unit.tests:
        _case(suite, unit, test, problem)
    if unit.hidden:
        case = _bare_case(suite, unit, HIDDEN_NAME.lower())
        short = unit.hidden.points < unit.hidden.max_points
        if short:
            SubElement(case, "failure", type="hidden", message=f"{sum_text(unit.hidden)} points")
        SubElement(case, "system-out").text = HIDDEN_WORDS
    if unit.later:
        case = _bare_case(suite, unit, LATER_NAME.lower())
        SubElement(case, "skipped", message=LATER_WORDS)
    said = [unit.output or (OUTPUT_WITHHELD if unit.output_withheld else "")]
    said.append(machine_sentence(submission.not_enforced))
    if text := "\n".join(part for part in said if part):
        SubElement(suite, "system-out").text = text
    cases = suite.findall("testcase")
    suite.set("tests", str(len(cases)))
    suite.set("failures", str(sum(case.find("failure") is not None for case in cases)))
    suite.set("errors", str(sum(case.find("error") is not None for case in cases)))
    suite.set("skipped", str(sum(case.find("skipped") is not None for case in cases)))
    suite.set("time", f"{unit.seconds:.3f}")


def _bare_case(suite: Element, unit: SeenUnit, name: str) -> Element:
    classname = unit.exercise.id.replace("/", ".")
    return SubElement(suite, "testcase", classname=classname, name=name)


def _case(suite: Element, unit: SeenUnit, test: SeenTest, problem: str) -> None:
    case = _bare_case(suite, unit, test.name)
    if test.status is None:
        SubElement(case, "skipped", message=LATER_WORDS)
    elif problem:
        kind = unit.outcome if unit.status == "graded" else unit.status
        first = problem.partition("\n")[0]
        SubElement(case, "error", type=kind or "refused", message=first).text = problem
    elif test.status in ("not_attempted", "skipped"):
        reason = test.failure.reason if test.failure else "not attempted"
        SubElement(case, "skipped", message=reason)
    elif test.status != "passed":
        text = test_text(test)
        tag = "error" if test.status == "stopped" else "failure"
        message = _message(test)
        SubElement(case, tag, type=test.status, message=message).text = text


def _message(test: SeenTest) -> str:
    if test.failure is None:
        return test.status or ""
    failure = test.failure
    text = failure.reason or hint_line(failure) or failure.asked or (test.status or "")
    return text.partition("\n")[0]
