/// @file
/// Other programs' times of impact of two moving boxes, each behind one function. Their headers
/// stay in their own files.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace peers {

using Numbers = std::array<double, 3>;

/// A box that translates and turns. In the plane it turns about z, and its third half length does
/// not count.
struct Box {
  Numbers centre{};                                                ///< at the start, m
  std::array<Numbers, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< at the start
  Numbers half_lengths{};                                          ///< m
  Numbers displacement{};                                          ///< of the centre in the step, m
  Numbers turn{};  ///< axis times angle in the step, rad
  std::array<Numbers, 3> end_axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< at the end
  double angle = 0;  ///< about z at the start, rad
};
using Pairs = std::vector<std::array<Box, 2>>;

/// What a program says of a pair.
struct Answer {
  bool hit = false;     ///< whether they touch in the step
  double t = 0;         ///< fraction of the step
  bool failed = false;  ///< whether it says that it does not know
};
using Answers = std::vector<Answer>;

/// How a program turns a box from its pose at the start to that at the end.
enum class Motion {
  constant_rate,        ///< at a constant angular velocity
  between_quaternions,  ///< linearly between two quaternions, normalised then
  between_directions    ///< in the plane, linearly between two directions, normalised then
};

/// A program's answers: given all pairs once, before the clock starts, it keeps them in its own
/// types, and answers as often as it is asked.
struct Caster {
  std::string name;
  bool turns = true;      ///< whether it takes boxes that turn
  bool in_plane = false;  ///< whether it knows the plane only
  Motion motion = Motion::constant_rate;
  std::function<std::function<void(Answers&)>(const Pairs&)> prepare;
};

std::vector<Caster> fcl_casters();
std::vector<Caster> bullet_casters();
std::vector<Caster> box2d_casters();
std::vector<Caster> box2d_v3_casters();
std::vector<Caster> box3d_casters();

/// The kinds of convex body that translate.
enum class Kind { sphere, capsule, box, triangle, hull };

/// A convex body that translates, by its frame. A capsule has its core along the third axis, twice
/// half_lengths[2] long; a triangle and a hull have points in the world.
struct Body {
  Kind kind = Kind::sphere;
  Numbers centre{};
  std::array<Numbers, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Numbers half_lengths{};
  double radius = 0;
  std::vector<Numbers> points;
  Numbers displacement{};
};
using BodyPairs = std::vector<std::array<Body, 2>>;

/// As Caster, for convex bodies that translate.
struct BodyCaster {
  std::string name;
  std::function<bool(Kind)> takes;
  std::function<std::function<void(Answers&)>(const BodyPairs&)> prepare;
};
std::vector<BodyCaster> fcl_body_casters();
std::vector<BodyCaster> bullet_body_casters();

/// A caster that keeps each box or body as `convert` makes it, and asks `cast` of two.
template <class Convert, class Cast>
auto asking(Convert convert, Cast cast) {
  return [convert, cast](const auto& pairs) {
    using Kept = decltype(convert(pairs.front()[0]));
    auto kept = std::make_shared<std::vector<std::pair<Kept, Kept>>>();
    for (const auto& [first, second] : pairs) kept->emplace_back(convert(first), convert(second));
    return std::function<void(Answers&)>([kept, cast](Answers& answers) {
      for (std::size_t i = 0; i < kept->size(); ++i) {
        answers[i] = cast((*kept)[i].first, (*kept)[i].second);
      }
    });
  };
}

}  // namespace peers
