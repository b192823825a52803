#include <text/near_names.hpp>

#include <string>
#include <vector>

#include <catch2/catch_test_macros.hpp>

namespace {

using contact::grading::edit_distance;
using contact::grading::max_near_name;
using contact::grading::nearest;
using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("letters that are added, dropped or changed are counted") {
  CHECK(edit_distance("", "") == 0);
  CHECK(edit_distance("", "abc") == 3);
  CHECK(edit_distance("plane", "plane") == 0);
  CHECK(edit_distance("plane", "plain") == 2);
  CHECK(edit_distance("triangel", "triangle") == 2);
  CHECK(edit_distance("hull", "hulls") == edit_distance("hulls", "hull"));
}

TEST_CASE("misspelt names are near, the nearest first") {
  const Names names{"ray_triangle", "orientation", "hull_2d", "hull_3d"};
  CHECK(nearest("ray_triangel", names) == Names{"ray_triangle"});
  CHECK(nearest("hull_3", names) == Names{"hull_3d", "hull_2d"});
  CHECK(nearest("wrap_step", names) == Names{});
}

TEST_CASE("of a short name at most half of the letters are wrong") {
  CHECK(nearest("turn", {"hull", "tern", "tarp"}) == Names{"tern", "tarp"});
  CHECK(nearest("ab", {"ac", "cd"}) == Names{"ac"});
  CHECK(nearest("a", {"a", "b"}) == Names{"a"});
}

TEST_CASE("of a long name at most a third of the letters are wrong") {
  CHECK(nearest("orientates", {"orientation"}) == Names{"orientation"});
  CHECK(nearest("oriented", {"orientation"}) == Names{});
}

TEST_CASE("at most three are named") {
  CHECK(nearest("plane", {"planes", "plank", "plant", "plan"}).size() == 3);
}

TEST_CASE("each part of a path must be near") {
  const Names ids{"08_convex_hull/hull_2d", "08_convex_hull/wrap_step", "02_triangles/turn"};
  CHECK(nearest("08_convex_hull/turn", ids) == Names{});
  CHECK(nearest("08_convex_hul/hull2d", ids) == Names{"08_convex_hull/hull_2d"});
  CHECK(nearest("08_convex_hull", ids) == Names{});
  CHECK(nearest("08_convex_hull/hull_2d/x", ids) == Names{});
  CHECK(nearest("hull_2d", ids) == Names{});
}

TEST_CASE("long names are near to none") {
  const std::string longest(max_near_name, 'a');
  CHECK(nearest(longest, {longest}) == Names{longest});
  CHECK(nearest(longest + "a", {longest}) == Names{});
}
