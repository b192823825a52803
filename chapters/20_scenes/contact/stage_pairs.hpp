/// @file
/// A stage: which pairs may touch in what is left of the step; each is compared with each.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <variant>
#include <vector>

#include <contact/aabb.hpp>
#include <contact/box_pairs.hpp>
#include <contact/stepped_state.hpp>

namespace contact {

namespace detail {

inline Aabb<double> box_of(const Sphere<double>& shape, const Vector3<double>& x,
                           const Matrix3<double>&, double) {
  return aabb_of_sphere<double>({x, shape.radius});
}
inline Aabb<double> box_of(const Capsule<double>& shape, const Vector3<double>& x,
                           const Matrix3<double>& turn, double) {
  return enclosing_box(
      aabb_of_sphere<double>({Vector3<double>(x + turn * shape.core.start), shape.radius}),
      aabb_of_sphere<double>({Vector3<double>(x + turn * shape.core.end), shape.radius}));
}
inline Aabb<double> box_of(const OrientedBox<double>& shape, const Vector3<double>& x,
                           const Matrix3<double>& turn, double) {
  CoordinateFrame<double> frame;
  frame.origin = x;
  frame.axes = turn;
  return aabb_of_turned_box(frame, shape.half_lengths);
}
template <class Shape>
Aabb<double> box_of(const Shape&, const Vector3<double>& x, const Matrix3<double>&, double reach) {
  return aabb_of_sphere<double>({x, reach});
}

}  // namespace detail

// [sweeping-room]
/// How far off its straight way a mover may come in what is left of the step, m: by gravity and by
/// turning. A little is added, so that what lies still has some room too.
inline double room_of_sweep(const SteppedSetup& setup, const SteppedState& state,
                            const StepPart& part, std::size_t place) {
  const double t = part.left;
  const double turned = size_of(spin_of(state, place)) * setup.bodies[place].spin_arm * t;
  const double size =
      position_of(setup, state, place).cwiseAbs().maxCoeff() + setup.bodies[place].reach;
  return size_of(setup.scene.gravity) * t * t + turned + 0x1p-30 * size;
}

/// A box that holds a body at every moment of what is left of the step.
inline Aabb<double> swept_box(const SteppedSetup& setup, const SteppedState& state,
                              const StepPart& part, std::size_t place) {
  const Vector3<double> x = position_of(setup, state, place);
  const Matrix3<double> turn = matrix_of(orientation_of(setup, state, place));
  const double reach = setup.bodies[place].reach;
  const Aabb<double> box =
      std::visit([&](const auto& shape) { return detail::box_of(shape, x, turn, reach); },
                 setup.bodies[place].shape);
  if (place >= setup.movers) return box;
  return aabb_of_swept_box<double>(box, velocity_of(setup, state, place) * part.left,
                                   room_of_sweep(setup, state, part, place));
}
// [/sweeping-room]

namespace detail {

/// Notes the pairs of a search, and those of movers that may come to a half-space.
inline void note_pairs(const SteppedSetup& setup, const SteppedState& state, StepPart& part,
                       std::span<const Aabb<double>> boxes, std::vector<BoxPair> found) {
  for (std::size_t k = setup.bounded; k < setup.bodies.size(); ++k) {
    const auto& wall = std::get<HalfSpace<double>>(setup.bodies[k].shape).boundary;
    for (std::size_t i = 0; i < setup.movers; ++i) {
      double lowest = -wall.offset;  // of the box's corners
      for (int axis = 0; axis < 3; ++axis) {
        const double n = wall.normal(axis);
        lowest += n * (n > 0 ? boxes[i].low(axis) : boxes[i].high(axis));
      }
      if (lowest <= 0)
        found.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k)});
    }
  }
  std::sort(found.begin(), found.end());
  part.pairs.clear();
  for (const BoxPair& pair : found) {
    const bool still = pair.b >= setup.movers || sleeps(state, pair.b);
    if (pair.a >= setup.movers || (sleeps(state, pair.a) && still)) continue;
    NearPair near;
    near.a = pair.a;
    near.b = pair.b;
    near.material = setup.material[setup.bodies[pair.a].material * setup.scene.materials.size() +
                                   setup.bodies[pair.b].material];
    part.pairs.push_back(near);
  }
}

template <class Search>
void find_near_pairs(const SteppedSetup& setup, SteppedState& state, StepPart& part,
                     const Search& search) {
  std::vector<Aabb<double>> boxes;
  boxes.reserve(setup.bounded);
  for (std::size_t i = 0; i < setup.bounded; ++i) boxes.push_back(swept_box(setup, state, part, i));
  const std::span<const Aabb<double>> all(boxes);
  note_pairs(setup, state, part, all, search(all).pairs);
  state.counts.pairs += part.pairs.size();
}

}  // namespace detail

// [pairs-stage]
/// The stage without a broad phase: the box of each is compared with the box of each.
inline void compare_all_pairs(const SteppedSetup& setup, SteppedState& state, StepPart& part) {
  detail::find_near_pairs(setup, state, part,
                          [](std::span<const Aabb<double>> boxes) { return all_pairs(boxes); });
}
// [/pairs-stage]

}  // namespace contact
