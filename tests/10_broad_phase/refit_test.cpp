// What is right is computed from the bodies below each node. The first questions of a test each
// bring one mistake to light that no question before did, so that the mistake is known by it.
#include "refit.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

#include <10_broad_phase/trees_with_mistakes.hpp>

namespace {

using namespace contact::testing;
using exercise::Box;
using exercise::Node;
using trees_with_mistakes::Boxes;
using trees_with_mistakes::Decide;
using trees_with_mistakes::Fit;
using trees_with_mistakes::Nodes;
using trees_with_mistakes::Sum;

void check_refit(const Nodes& nodes, const Boxes& boxes, const Boxes& bodies) {
  const auto with = [&](Fit fit) {
    return [&, fit] { return trees_with_mistakes::refit(nodes, boxes, bodies, fit); };
  };
  ask("Which boxes have the nodes now?")
      .given("nodes", nodes)
      .given("boxes", boxes)
      .given("bodies", bodies)
      .suspect("inner-nodes-not-refitted", with(Fit::leaves_alone))
      .suspect("parents-before-children", with(Fit::parents_first))
      .suspect("children-assumed-later", with(Fit::later_first))
      .suspect("grows-but-never-shrinks", with(Fit::grown))
      .suspect("box-of-all-for-each", with(Fit::overall))
      .suspect("box-with-the-origin", with(Fit::origin))
      .suspect("bodies-in-order-of-leaves", with(Fit::counted))
      .answer([&] { return exercise::refit(nodes, boxes, bodies); })
      .equals(trees_with_mistakes::refit(nodes, boxes, bodies));
}

void check_cost(const Nodes& nodes, const Boxes& boxes) {
  const auto with = [&](Sum sum) {
    return [&, sum] { return trees_with_mistakes::cost(nodes, boxes, sum); };
  };
  const double right = trees_with_mistakes::cost(nodes, boxes);
  ask("What does a search of the tree cost?")
      .given("nodes", nodes)
      .given("boxes", boxes)
      .suspect("leaves-visited-too", with(Sum::with_leaves))
      .suspect("area-for-perimeter", with(Sum::areas))
      .suspect("sum-not-divided", with(Sum::undivided))
      .suspect("root-not-visited", with(Sum::without_root))
      .suspect("point-divided-by-zero", with(Sum::point_divided))
      .answer([&] { return exercise::cost(nodes, boxes); })
      .close_to(right, within(1e-12 * right));
}

void check_rebuild(const Nodes& nodes, const Boxes& built, const Boxes& now) {
  const auto with = [&](Decide decide) {
    return [&, decide] { return trees_with_mistakes::needs_rebuild(nodes, built, now, decide); };
  };
  ask("Should the tree be built again?")
      .given("nodes", nodes)
      .given("built", built)
      .given("now", now)
      .suspect("root-alone-decides", with(Decide::root_alone))
      .suspect("size-for-quality", with(Decide::undivided))
      .suspect("rebuilt-at-twice", with(Decide::at_twice))
      .answer([&] { return exercise::needs_rebuild(nodes, built, now); })
      .equals(trees_with_mistakes::needs_rebuild(nodes, built, now));
}

Boxes fitted(const Nodes& nodes, const Boxes& bodies) {
  return trees_with_mistakes::refit(nodes, Boxes(nodes.size(), {{0, 0}, {0, 0}}), bodies);
}

/// Children have larger numbers than their parent.
Nodes four() {
  return {{1, 2, -1}, {3, 4, -1}, {5, 6, -1}, {-1, -1, 2}, {-1, -1, 0}, {-1, -1, 3}, {-1, -1, 1}};
}

/// A parent has a larger number than one child, and a smaller one than the other.
Nodes mixed() {
  return {{4, 3, -1}, {6, 5, -1}, {-1, -1, 1}, {-1, -1, 3}, {1, 2, -1}, {-1, -1, 0}, {-1, -1, 2}};
}

/// Eight leaves, the bodies in the order of the list.
Nodes eight() {
  Nodes nodes;
  for (int i = 0; i < 7; ++i) nodes.push_back({2 * i + 1, 2 * i + 2, -1});
  for (int i = 0; i < 8; ++i) nodes.push_back({-1, -1, i});
  return nodes;
}

/// A square of one edge at each x.
Boxes squares(const std::vector<double>& xs, double edge) {
  Boxes boxes;
  for (const double x : xs) boxes.push_back({{x, 7}, {x + edge, 7 + edge}});
  return boxes;
}

/// Each inner node has a leaf and the next inner node.
Nodes chain(int leaves) {
  Nodes nodes;
  for (int i = 0; i + 1 < leaves; ++i) {
    nodes.push_back({2 * i + 1, 2 * i + 2, -1});
    nodes.push_back({-1, -1, i});
  }
  nodes.push_back({-1, -1, leaves - 1});
  return nodes;
}

Boxes random_boxes(generators::Random& random, int count, int range) {
  Boxes boxes;
  for (int i = 0; i < count; ++i) {
    const double x = random.integer(-range, range), y = random.integer(-range, range);
    const double width = random.integer(0, 9), height = random.integer(0, 9);
    boxes.push_back({{x, y}, {x + width, y + height}});
  }
  return boxes;
}

/// A tree in which numbers say nothing about parents and children.
Nodes random_tree(generators::Random& random, int leaves) {
  const int count = 2 * leaves - 1;
  std::vector<int> number;
  for (int i = 0; i < count; ++i) number.push_back(i);
  for (int i = count - 1; i > 1; --i)
    std::swap(number[static_cast<std::size_t>(i)],
              number[static_cast<std::size_t>(random.integer(1, i))]);
  Nodes nodes(static_cast<std::size_t>(count), Node{-1, -1, -1});
  std::vector<int> open{0};
  int next = 1;
  while (next < count) {
    const auto chosen = open.begin() + random.integer(0, static_cast<int>(open.size()) - 1);
    const int parent = *chosen, left = number[static_cast<std::size_t>(next)],
              right = number[static_cast<std::size_t>(next) + 1];
    open.erase(chosen);
    nodes[static_cast<std::size_t>(parent)] = {left, right, -1};
    open.push_back(left);
    open.push_back(right);
    next += 2;
  }
  int body = 0;
  for (const int leaf : open) nodes[static_cast<std::size_t>(leaf)].body = body++;
  return nodes;
}

}  // namespace

TEST_CASE("each box encloses those of its children") {
  const Boxes before{
      {{11, 9}, {13, 12}}, {{28, 2}, {31, 6}}, {{17, 14}, {18, 22}}, {{43, 18}, {47, 20}}};
  const Boxes after{
      {{10, 10}, {12, 13}}, {{30, 5}, {33, 9}}, {{14, 11}, {15, 19}}, {{40, 20}, {44, 22}}};
  check_refit(four(), fitted(four(), before), after);
  check_refit(four(), fitted(four(), after), before);
  check_refit(four(), fitted(four(), before), before);
}

TEST_CASE("children may have smaller numbers than their parent") {
  const Boxes before{
      {{11, 9}, {13, 12}}, {{28, 2}, {31, 6}}, {{17, 14}, {18, 22}}, {{43, 18}, {47, 20}}};
  const Boxes after{
      {{-10, 10}, {-2, 13}}, {{30, -5}, {33, 9}}, {{14, 11}, {15, 99}}, {{40, 20}, {44, 22}}};
  check_refit(mixed(), fitted(mixed(), before), after);
  check_refit(mixed(), fitted(mixed(), after), before);
}

TEST_CASE("a tree may be a leaf or a long chain") {
  check_refit({{-1, -1, 0}}, {{{0, 0}, {1, 1}}}, {{{-5, 3}, {-5, 4}}});
  // The same under each seed: one tree is no more than one question.
  generators::Random random(60);
  const Boxes before = random_boxes(random, 60, 100000 - 9), after = random_boxes(random, 60, 50);
  check_refit(chain(60), fitted(chain(60), before), after);
}

TEST_CASE("the cost is how many inner nodes a line meets") {
  check_cost(four(), fitted(four(), {{{10, 10}, {12, 13}},
                                     {{30, 5}, {33, 9}},
                                     {{14, 11}, {15, 19}},
                                     {{40, 20}, {44, 22}}}));
  check_cost(
      mixed(),
      fitted(mixed(), {{{0, 0}, {2, 0}}, {{3, 0}, {5, 0}}, {{7, 0}, {9, 0}}, {{1, 0}, {4, 0}}}));
  check_cost(eight(), fitted(eight(), squares({0, 1, 2, 3, 4, 5, 6, 7}, 1)));
  check_cost(chain(30), fitted(chain(30), squares(std::vector<double>(30, 4), 2)));
}

TEST_CASE("the cost of a point is zero") {
  check_cost(eight(), fitted(eight(), squares({0, 2, 4, 6, 8, 10, 12, 14}, 1)));
  check_cost(eight(), fitted(eight(), squares(std::vector<double>(8, 4), 0)));
  check_cost({{-1, -1, 0}}, {{{3, 3}, {3, 3}}});
  check_cost({{-1, -1, 0}}, {{{3, 3}, {5, 8}}});
}

TEST_CASE("a tree is built again if its cost has more than doubled") {
  const Nodes nodes = eight();
  const Boxes built = fitted(nodes, squares({0, 10, 100, 110, 1000, 1010, 1100, 1110}, 1));
  check_rebuild(nodes, built, fitted(nodes, squares({0, 1100, 100, 1010, 10, 1110, 110, 1000}, 1)));
  check_rebuild(nodes, built, fitted(nodes, squares({0, 70, 700, 770, 7000, 7070, 7700, 7770}, 7)));
  // One line with all bodies in one point but the last: each inner node on the way to it has the
  // root's box.
  const Nodes three = chain(3);
  check_rebuild(three, fitted(three, {{{0, 0}, {8, 8}}, {{0, 0}, {0, 0}}, {{0, 0}, {0, 0}}}),
                fitted(three, {{{0, 0}, {8, 8}}, {{0, 0}, {0, 0}}, {{8, 8}, {8, 8}}}));
  check_rebuild(nodes, built, built);
  check_rebuild(nodes, built, fitted(nodes, squares(std::vector<double>(8, 3), 0)));
  check_rebuild(nodes, built, fitted(nodes, squares({0, 1, 2, 3, 4, 5, 6, 7}, 1)));
}

TEST_CASE("random trees agree with the bodies below each node") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 60; ++asked) {
    const int leaves = random.integer(1, asked % 3 == 0 ? 40 : 5);
    const int range = asked % 2 == 0 ? 20 : 90000;
    const Nodes nodes = random_tree(random, leaves);
    const Boxes before = random_boxes(random, leaves, range);
    const Boxes after = random_boxes(random, leaves, range);
    const Boxes built = fitted(nodes, before), now = fitted(nodes, after);
    check_refit(nodes, built, after);
    check_cost(nodes, now);
    const double twice = 2 * trees_with_mistakes::cost(nodes, built);
    if (std::abs(trees_with_mistakes::cost(nodes, now) - twice) > 1e-6)
      check_rebuild(nodes, built, now);
  }
}
