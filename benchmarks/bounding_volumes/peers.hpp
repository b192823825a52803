/// @file
/// Other programs' bounding volumes, and their tests of two volumes, each behind one function.
/// Their headers stay in their own files.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace peers {

using Numbers = std::array<double, 3>;
using Points = std::vector<Numbers>;
using Sets = std::vector<Points>;

struct Ball {
  Numbers centre{};
  double radius = 0;
};
/// All centre + Σ xᵢ axesᵢ with |xᵢ| ≤ half_lengthsᵢ.
struct Box {
  Numbers centre{};
  std::array<Numbers, 3> axes{};
  Numbers half_lengths{};
};
struct Limits {
  Numbers low{}, high{};
};

/// A way to bound sets of points: given all sets once, before the clock starts, it keeps them in
/// the other program's types, and makes a volume of each as often as it is asked.
template <class Volume>
using Make = std::function<void(std::vector<Volume>&)>;
template <class Volume>
struct Fit {
  std::string name;
  std::function<Make<Volume>(const Sets&)> prepare;
  std::size_t max_points = std::numeric_limits<std::size_t>::max();  ///< of a set
};

/// The smallest sphere: Min_sphere_d and Min_sphere_of_spheres_d, in exact numbers and in double.
/// Centre and squared radius are rounded to double at the end.
std::vector<Fit<Ball>> cgal_balls();
/// oriented_bounding_box, with its corners.
std::vector<Fit<Box>> cgal_boxes();
/// The box along the principal axes of the points.
std::vector<Fit<Box>> coal_boxes();
/// Of a convex hull shape without a margin.
std::vector<Fit<Ball>> bullet_balls();
std::vector<Fit<Limits>> bullet_limits();

/// 1 where the two volumes of a pair may meet, 0 where the program says that they are apart.
using Answers = std::vector<char>;
using Ask = std::function<void(Answers&)>;
/// A test of two volumes.
template <class Volume>
struct PairTest {
  std::string name;
  std::function<Ask(const std::vector<std::array<Volume, 2>>&)> prepare;
};

std::vector<PairTest<Limits>> bullet_limits_pairs();
std::vector<PairTest<Limits>> coal_limits_pairs();
std::vector<PairTest<Box>> coal_box_pairs();
/// k-DOPs of the points: 16, 18 and 24.
std::vector<PairTest<Points>> coal_kdop_pairs();

/// A way that keeps each set as `convert` makes it, and makes a volume of it by `make`.
template <class Volume, class Convert, class MakeOne>
Fit<Volume> fit(std::string name, Convert convert, MakeOne make,
                std::size_t max_points = std::numeric_limits<std::size_t>::max()) {
  return {std::move(name),
          [convert, make](const Sets& sets) {
            using Kept = decltype(convert(sets.front()));
            auto kept = std::make_shared<std::vector<Kept>>();
            for (const Points& points : sets) kept->push_back(convert(points));
            return Make<Volume>([kept, make](std::vector<Volume>& volumes) {
              for (std::size_t i = 0; i < kept->size(); ++i) volumes[i] = make((*kept)[i]);
            });
          },
          max_points};
}

/// A test that keeps each volume as `convert` makes it, and asks `meet` of two.
template <class Volume, class Convert, class Meet>
PairTest<Volume> pair_test(std::string name, Convert convert, Meet meet) {
  return {std::move(name), [convert, meet](const std::vector<std::array<Volume, 2>>& pairs) {
            using Kept = decltype(convert(pairs.front()[0]));
            auto kept = std::make_shared<std::vector<std::pair<Kept, Kept>>>();
            for (const auto& [first, second] : pairs) {
              kept->emplace_back(convert(first), convert(second));
            }
            return Ask([kept, meet](Answers& answers) {
              for (std::size_t i = 0; i < kept->size(); ++i) {
                answers[i] = meet((*kept)[i].first, (*kept)[i].second) ? 1 : 0;
              }
            });
          }};
}

}  // namespace peers
