"""Prints the hostile submissions as a table: name, what it tries, what it gets.

python tests/grade/hostile_table.py > table.md

What it gets is what its header says; test_hostile.py proves that it does.
"""

from __future__ import annotations

from hostile_archives import PACKED
from hostile_corpus import NO_COMPILE, Specimen, corpus


def gets(specimen: Specimen) -> str:
    points = f"{specimen.points:g} of {specimen.max_points:g}"
    if specimen.tests == NO_COMPILE:
        return f"{points}: does not compile"
    if specimen.earns_all:
        return f"{points}, honestly: it got nothing else"
    said = f" ({' or '.join(specimen.says)})" if specimen.says else ""
    return f"{points}: {specimen.tests}{said}"


def main() -> None:
    print("| Submission | What it tries | What it gets |")
    print("|---|---|---|")
    for specimen in corpus():
        notes = f". Elsewhere: {specimen.ordinary}" if specimen.ordinary else ""
        weak = f". Reduced level: {specimen.reduced}" if specimen.reduced else ""
        tries = specimen.tries.replace("|", "\\|")
        print(f"| {specimen.name} | {tries}{notes} | {gets(specimen)}{weak} |")
    for packed in PACKED:
        print(f"| {packed.name} | {packed.tries} | refused; the twin passes |")
    recorded = "answers from a record of a run under another seed"
    print(f"| recorded_answers | {recorded} | 6 of 8: all but the random questions |")


if __name__ == "__main__":
    main()
