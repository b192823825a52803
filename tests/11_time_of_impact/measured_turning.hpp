/// @file
/// Methods for the time at which two boxes that turn meet, as the ladder measures them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/conservative_advancement.hpp>
#include <contact/oriented_box.hpp>
#include <contact/quaternion.hpp>
#include <contact/turning_impact.hpp>
#include <cstddef>
#include <string>
#include <utility>

#include "families_turning.hpp"
#include "measured_impact.hpp"

namespace measured_turning {

using contact::ConservativeEnd;
using measured_impact::Answer;
using measured_impact::hit_at;
using measured_impact::judge;
using measured_impact::rounded;
using Vector = contact::Vector3<double>;
using Box = contact::RotatingBox<double>;

struct Input {
  Box a, b;
  contact::OrientedBox<double> a_at_start, b_at_start;
  contact::TurningMotion<double> motion_a, motion_b;
};

inline Input made(const families::TurningBoxes& pair) {
  Input input;
  const auto rotating = [&pair](std::size_t k) {
    return Box{pair.position[k],
               contact::normalised(contact::exponential<double>(pair.rotation[k])),
               pair.half_lengths[k], pair.displacement[k], pair.angular_displacement[k]};
  };
  const auto at_start = [](const Box& box) {
    return contact::OrientedBox<double>{box.position, contact::matrix_of(box.orientation),
                                        box.half_lengths};
  };
  const auto motion = [](const Box& box) {
    return contact::TurningMotion<double>{box.position, box.velocity, box.angular_velocity};
  };
  input.a = rotating(0);
  input.b = rotating(1);
  input.a_at_start = at_start(input.a);
  input.b_at_start = at_start(input.b);
  input.motion_a = motion(input.a);
  input.motion_b = motion(input.b);
  return input;
}

/// The largest gap on one of the fifteen axes at a time; negative if the boxes overlap.
inline double gap_at(const Input& input, double t) {
  return contact::axis_distance<double>(contact::frame_at(input.a, t), input.a.half_lengths,
                                        contact::frame_at(input.b, t), input.b.half_lengths);
}

/// Advanced to 0.1 µm; a touch if the boxes overlap soon after. Else nothing is known: they pass at
/// such a distance, or nearly so.
inline Answer truth(const Input& input) {
  constexpr int many = 50000;
  const auto found = contact::rotating_boxes_impact<double>(input.a, input.b, 1, 1e-7, many);
  if (found.end == ConservativeEnd::clear) return {};
  for (int k = 0; k <= 20; ++k) {
    const double after = std::min(1.0, found.t + std::ldexp(1e-8, k));
    if (found.end == ConservativeEnd::impact && gap_at(input, after) < 0) return hit_at(found.t);
  }
  return {true, found.t, true};
}

inline Answer sliced(const Input& input, int slices, int halvings = 0) {
  const auto overlap = [&input](double t) { return gap_at(input, t) <= 0; };
  return measured_impact::by_slices(overlap, slices, halvings);
}

/// With the bound on the speed of approach that holds in every direction.
inline Answer advanced(const Input& input, double tolerance) {
  const auto found = contact::rotating_boxes_impact<double>(input.a, input.b, 1, tolerance, 5000);
  if (found.end == ConservativeEnd::clear) return {};
  return {true, found.t, found.end == ConservativeEnd::gave_up};
}

/// From plane to plane, with the bound of each plane's normal.
inline Answer by_planes(const Input& input, double tolerance) {
  const auto found = contact::turning_impact(input.a_at_start, input.motion_a, input.b_at_start,
                                             input.motion_b, tolerance, 5000);
  if (found.end == ConservativeEnd::clear) return {};
  return {true, found.t, found.end == ConservativeEnd::gave_up};
}

inline ladder::Example shown(const Input& input, const Answer& got, const Answer& right,
                             const ladder::Method&) {
  ladder::Example example;
  for (const auto& [name, box] : {std::pair("first", &input.a), std::pair("second", &input.b)}) {
    const std::string of = name;
    example.facts.push_back(ladder::numbers(of + " centre", box->position));
    example.facts.push_back(ladder::numbers(
        of + " orientation, w x y z", std::array{box->orientation.w, box->orientation.v.x(),
                                                 box->orientation.v.y(), box->orientation.v.z()}));
    example.facts.push_back(ladder::numbers(of + " half lengths", box->half_lengths));
    example.facts.push_back(ladder::numbers(of + " displacement", box->velocity));
    example.facts.push_back(ladder::numbers(of + " rotation in the step", box->angular_velocity));
  }
  example.facts.push_back(measured_impact::told("this method", got));
  example.facts.push_back(measured_impact::told("to 0.1 µm", right));
  example.note = "The figures show discs and rods in the plane.";
  return example;
}

inline ladder::Ladder<Input, Answer> experiment() {
  ladder::Ladder<Input, Answer> ladder("When do two turning boxes meet?", truth, judge);
  ladder.at_most(300);
  const auto family = [&ladder](const char* id, const char* title, families::Turning kind) {
    ladder.family(id, title, [kind](generators::Random& random) {
      for (;;) {
        const Input input = made(families::turning_boxes(random, kind));
        // Only questions whose answer is known.
        if (!truth(input).unknown) return input;
      }
    });
  };
  family("turn-random", "random", families::Turning::random);
  family("turn-rods", "rods", families::Turning::rods);
  family("turn-plates", "plates that turn fast", families::Turning::plates);
  family("turn-spinning", "about half a turn, at rest", families::Turning::spinning);
  family("turn-graze", "a vertex passes close to a face", families::Turning::graze);
  family("turn-bullet", "a bullet and a thin plate", families::Turning::bullet);

  ladder.method(rounded("turn-slices-3", "3 slices", "double"),
                [](const Input& input) { return sliced(input, 3); });
  ladder.method(rounded("turn-slices-100", "100 slices", "double"),
                [](const Input& input) { return sliced(input, 100); });
  ladder.method(rounded("turn-bisection", "100 slices, then 20 halvings", "double"),
                [](const Input& input) { return sliced(input, 100, 20); });
  ladder.method(rounded("turn-advance", "advancement by speed, to 0.1 mm", "double"),
                [](const Input& input) { return advanced(input, 1e-4); });
  ladder.method(rounded("turn-planes", "advancement by planes, to 0.1 mm", "double"),
                [](const Input& input) { return by_planes(input, 1e-4); });
  ladder.recommend("turn-planes");
  ladder.show(shown);
  return ladder;
}

}  // namespace measured_turning
