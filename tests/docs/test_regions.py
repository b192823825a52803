"""Regions of source files, as the prose shows them."""

from __future__ import annotations

import pytest
from contact_book.errors import BookError
from regions import find_regions, region, without_inline_macro, without_markers

TEXT = """\
// [outer]
  int a;
  // [inner]
  int b;
  // [/inner]
  int c;
// [/outer]
"""


def test_the_macro_of_an_inline_function_is_not_shown() -> None:
    text = (
        "CONTACT_SCENES_INLINE double area(double width,\n"
        "                                  double height) {\n"
        "  return product_of_two_numbers(width,\n"
        "                                height);\n"
        "}\n"
        "CONTACT_SCENES_INLINE Room room_of(\n"
        "    const Scene& scene) {}\n"
    )
    assert without_inline_macro(text) == (
        "double area(double width,\n"
        "            double height) {\n"
        "  return product_of_two_numbers(width,\n"
        "                                height);\n"
        "}\n"
        "Room room_of(\n"
        "    const Scene& scene) {}\n"
    )


def test_a_region_is_what_stands_between_its_markers_dedented() -> None:
    assert region(TEXT, "inner", "x.hpp").text == "int b;\n"


def test_markers_of_nested_regions_are_not_shown() -> None:
    assert region(TEXT, "outer", "x.hpp").text == "int a;\nint b;\nint c;\n"


def test_an_unknown_region_is_an_error_that_lists_those_there_are() -> None:
    with pytest.raises(BookError, match=r"unknown region 'none' in x\.hpp; there is: inner, outer"):
        region(TEXT, "none", "x.hpp")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("// [a]\nint x;\n", r"x\.hpp:1: region 'a' is never closed"),
        ("int x;\n// [/a]\n", r"x\.hpp:2: region 'a' is closed but was never opened"),
        ("// [a]\nint x;\n// [/a]\n// [a]\n", r"x\.hpp:4: region 'a' is opened twice"),
        ("// [a]\n\n// [/a]\n", r"x\.hpp:2: region 'a' is empty"),
    ],
)
def test_broken_markers_are_errors_with_their_line(text: str, message: str) -> None:
    with pytest.raises(BookError, match=message):
        find_regions(text, "x.hpp")


def test_a_subscript_in_a_comment_is_not_a_marker() -> None:
    assert find_regions("// see a[i] and [this] too\n", "x.hpp") == {}


def test_a_whole_file_is_shown_without_markers() -> None:
    assert without_markers(TEXT) == "  int a;\n  int b;\n  int c;\n"
