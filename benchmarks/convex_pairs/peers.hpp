/// @file
/// Other programs' tests and distances of two convex bodies, each behind one function. Their
/// headers stay in their own files.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace peers {

using Numbers = std::array<double, 3>;
using Points = std::vector<Numbers>;

/// The kinds of body, in the order of tests/09_separating_planes/pair_bodies.hpp.
enum class Kind { sphere, capsule, lozenge, box, triangle, hull, cylinder, ellipsoid };

/// A body by its frame. A sphere has a radius; a capsule and a cylinder have their core along the
/// third axis, half_lengths[2] long; a lozenge has its rectangle along the first two. A triangle
/// and a hull have points in the world.
struct Shape {
  Kind kind = Kind::sphere;
  Numbers centre{};
  std::array<Numbers, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Numbers half_lengths{};
  double radius = 0;
  Points points;
};

/// 1 where the two bodies of a pair meet, 0 where the program says that they are apart.
using Answers = std::vector<char>;
/// A signed distance and its direction from the second body to the first.
struct Witness {
  bool found = false;
  double distance = 0;
  Numbers normal{};
};
using Witnesses = std::vector<Witness>;

using Pairs = std::vector<std::array<Shape, 2>>;
/// A program's answers: given all pairs once, before the clock starts, it keeps them in its own
/// types, and answers as often as it is asked.
struct PairTest {
  std::string name;
  std::function<bool(Kind, Kind)> takes;
  std::function<std::function<void(Answers&)>(const Pairs&)> prepare;
  /// The signed distance, if the program gives it.
  std::function<std::function<void(Witnesses&)>(const Pairs&)> measure;
};

std::vector<PairTest> coal_pairs();
std::vector<PairTest> fcl_pairs();
std::vector<PairTest> ccd_pairs();
std::vector<PairTest> bullet_pairs();
std::vector<PairTest> ode_pairs();
std::vector<PairTest> box3d_pairs();

namespace detail {

template <class Answer, class Convert, class Ask>
auto asking(Convert convert, Ask ask) {
  return [convert, ask](const Pairs& pairs) {
    using Kept = decltype(convert(pairs.front()[0]));
    auto kept = std::make_shared<std::vector<std::pair<Kept, Kept>>>();
    for (const auto& [first, second] : pairs) {
      kept->emplace_back(convert(first), convert(second));
    }
    return std::function<void(std::vector<Answer>&)>([kept, ask](std::vector<Answer>& answers) {
      for (std::size_t i = 0; i < kept->size(); ++i) {
        answers[i] = ask((*kept)[i].first, (*kept)[i].second);
      }
    });
  };
}

}  // namespace detail

/// A test that keeps each body as `convert` makes it, and asks `meet` of two.
template <class Takes, class Convert, class Meet>
PairTest pair_test(std::string name, Takes takes, Convert convert, Meet meet) {
  return {std::move(name),
          takes,
          detail::asking<char>(convert,
                               [meet](const auto& a, const auto& b) {
                                 return static_cast<char>(meet(a, b) ? 1 : 0);
                               }),
          {}};
}
/// The same with a signed distance.
template <class Takes, class Convert, class Meet, class Measure>
PairTest pair_test(std::string name, Takes takes, Convert convert, Meet meet, Measure measure) {
  PairTest test = pair_test(std::move(name), takes, convert, meet);
  test.measure = detail::asking<Witness>(convert, measure);
  return test;
}

}  // namespace peers
