#include <contact/stepped/stage_contact_events.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <variant>

#include <contact/contact_solver.hpp>
#include <contact/contact_world.hpp>
#include <contact/convex_shapes.hpp>
#include <contact/quaternion.hpp>
#include <contact/rotation.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/scene_run.hpp>
#include <contact/signed_distance.hpp>
#include <contact/stepped/stage_contacts.hpp>
#include <contact/stepped/stepped_state.hpp>
#include <contact/stepped/substep_motion.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// The tangential relative velocity at a contact: when the substep starts, and when it ends.
struct Slide {
  Vector3<double> first = Vector3<double>::Zero();
  Vector3<double> last = Vector3<double>::Zero();
};

CONTACT_SCENES_INLINE Slide slide_of(const SteppedSetup& setup, const SteppedState& state,
                                     const Substep& substep, const BodyContact<double>& contact) {
  Slide slide;
  double sign = 1;
  for (const int body : {contact.a, contact.b}) {
    const std::size_t slot = index(body);
    slide.first += sign * point_velocity(setup, state, slot, contact.point);
    if (slot < setup.movers && !sleeps(state, slot)) {
      slide.last += sign * substep.end_velocity[slot];
      if (rotated_by_contacts(setup, slot)) {
        const Vector3<double> lever_arm = contact.point - position_of(setup, state, slot);
        const Vector3<double> turned = substep.end_angular_velocity[slot].cross(lever_arm);
        slide.last += sign * turned;
      }
    }
    sign = -1;
  }
  const Vector3<double>& n = contact.normal;
  slide.first -= n * n.dot(slide.first);
  slide.last -= n * n.dot(slide.last);
  return slide;
}

/// A rotation of a contact normal that rounding does not cause.
inline constexpr double turned_normal = 0x1p-30;

CONTACT_SCENES_INLINE bool is_round(const SteppedBody& body) {
  return std::holds_alternative<Sphere<double>>(body.shape) ||
         std::holds_alternative<Capsule<double>>(body.shape);
}

CONTACT_SCENES_INLINE bool has_edges(const SteppedBody& body) {
  return std::holds_alternative<OrientedBox<double>>(body.shape) ||
         std::holds_alternative<HullVertices>(body.shape);
}

/// Whether one is a ball or a capsule, the other has edges, and they touch.
CONTACT_SCENES_INLINE bool may_pass_an_edge(const SteppedSetup& setup, const NearPair& pair) {
  if (!pair.touching || pair.leaving || pair.material.stiffness) return false;
  const SteppedBody& a = setup.bodies[pair.a];
  const SteppedBody& b = setup.bodies[pair.b];
  return (is_round(a) && has_edges(b)) || (is_round(b) && has_edges(a));
}

/// When the contact normal of a pair begins to rotate. `at_once`: it rotates from the beginning.
struct EndOfFace {
  bool at_once = false;
  std::optional<double> time;
};

/// @param gap_at the signed distance after a time
/// @param length the longest time, s
template <class GapAt>
EndOfFace end_of_face(const GapAt& gap_at, double length) {
  const Vector3<double> normal = gap_at(0).normal;
  const auto turned = [&](double t) { return size_of(gap_at(t).normal - normal); };
  EndOfFace end;
  if (!(turned(length) > turned_normal)) return end;
  double before = 0;
  double after = length;
  while (after - before > length * 0x1p-48) {
    const double middle = before + (after - before) / 2;
    (turned(middle) > turned_normal ? after : before) = middle;
  }
  // Where it rotates from the beginning, it has rotated half as far in half the time.
  end.at_once = !(after > length * 0x1p-30) || turned(after / 2) > turned_normal / 8;
  if (!end.at_once) end.time = after;
  return end;
}

}  // namespace detail

// [end-of-sliding]
CONTACT_SCENES_INLINE void find_end_of_sliding(const SteppedSetup& setup, SteppedState& state,
                                               Substep& substep) {
  SlideSearch& search = substep.slide_search;
  if (substep.simultaneous || search.stage == SlideSearch::Stage::found) {
    search = {};
    return;
  }
  bool ends = false;
  double first = std::numeric_limits<double>::infinity();
  for (const StepBounce& push : substep.pushing) {
    const BodyContact<double>& contact = push.contact;
    if (!(contact.friction > 0)) continue;
    const detail::Slide slide = detail::slide_of(setup, state, substep, contact);
    if (!(size_of(slide.first) * setup.step > min_error(setup))) continue;
    const double before = slide.first.dot(slide.first);
    const double after = slide.first.dot(slide.last);
    if (after <= before * 0x1p-20)
      ends = true;
    else if (after < before)
      first = std::min(first, substep.planned * (before / (before - after)));
  }
  if (search.stage == SlideSearch::Stage::none) {
    if (!ends) return;
    if (substep.events >= max_contact_events(setup)) {
      state.counts.doubts.add(RunDoubt::late_event, time_of_substep(setup, state, substep));
      return;
    }
    search.stage = SlideSearch::Stage::shorter;
    search.too_long = substep.planned;
    substep.repeat_with = substep.planned / 16;
  } else if (ends && substep.planned > setup.step * 0x1p-40) {
    search.too_long = substep.planned;
    substep.repeat_with = substep.planned / 16;
  } else {
    search.stage = SlideSearch::Stage::found;
    ++substep.events;
    substep.repeat_with = std::min(std::max(first, substep.planned), search.too_long);
  }
}
// [/end-of-sliding]

CONTACT_SCENES_INLINE bool passes_edges(const SteppedSetup& setup) {
  return std::any_of(setup.bodies.begin(), setup.bodies.end(), detail::is_round) &&
         std::any_of(setup.bodies.begin(), setup.bodies.end(), detail::has_edges);
}

// [end-of-support]
CONTACT_SCENES_INLINE double falling_away(const SteppedSetup& setup, const SteppedState& state,
                                          const Substep& substep, const NearPair& pair) {
  if (substep.simultaneous || !detail::may_pass_an_edge(setup, pair)) return 0;
  const auto shape_at = [&](std::size_t slot, double t) {
    Quaternion<double> q = orientation_of(setup, state, slot);
    const Vector3<double> turns = angular_velocity_of(state, slot);
    if (setup.bodies[slot].rotation_radius > 0 && turns != Vector3<double>::Zero())
      q = normalised(exponential_step(q, turns, t));
    const Vector3<double> moved = velocity_of(setup, state, slot) * t;
    return shape_in_world(setup.bodies[slot],
                          Vector3<double>(position_of(setup, state, slot) + moved), q);
  };
  const auto gap_at = [&](double t) {
    return signed_distance_of_shapes(shape_at(pair.a, t), shape_at(pair.b, t));
  };
  const double h = substep.planned;
  if (!detail::end_of_face(gap_at, h).at_once) return 0;
  const Vector3<double> apart =
      velocity_of(setup, state, pair.a) - velocity_of(setup, state, pair.b);
  const SignedDistance<double> now = gap_at(0);
  const double away = gap_at(h).distance - now.distance - now.normal.dot(apart) * h;
  return away > pair.touch ? away : 0;
}

CONTACT_SCENES_INLINE void find_end_of_support(const SteppedSetup& setup, SteppedState& state,
                                               Substep& substep) {
  if (substep.simultaneous) return;
  for (const NearPair& pair : substep.pairs) {
    if (!detail::may_pass_an_edge(setup, pair)) continue;
    const auto a = detail::substep_motion(setup, state, substep, pair.a);
    const auto b = detail::substep_motion(setup, state, substep, pair.b);
    const auto gap_at = [&](double t) {
      return signed_distance_of_shapes(
          detail::moved_body(setup, state, substep, pair.a, a, t).shape,
          detail::moved_body(setup, state, substep, pair.b, b, t).shape);
    };
    const auto end = detail::end_of_face(gap_at, substep.length);
    if (!end.time || !(*end.time < substep.length)) continue;
    if (substep.events >= max_contact_events(setup)) {
      state.counts.doubts.add(RunDoubt::late_event, time_of_substep(setup, state, substep));
      return;
    }
    substep.length = *end.time;
    ++substep.events;
  }
}
// [/end-of-support]

namespace detail {

/// Whether a force at a contact may vary in the substep by so much that it matters.
CONTACT_SCENES_INLINE bool force_varies(const SteppedSetup& setup, const SteppedState& state,
                                        const Substep& substep, const StepBounce& push) {
  const BodyContact<double>& contact = push.contact;
  const double least = min_error(setup);
  double lightness = 0;
  bool round = false;
  for (const int body : {contact.a, contact.b}) {
    const std::size_t slot = index(body);
    round = round || is_round(setup.bodies[slot]);
    if (slot >= setup.movers || sleeps(state, slot)) continue;
    lightness = std::max(lightness, 1 / setup.bodies[slot].mass);
    if (slot >= substep.end_angular_velocity.size()) continue;
    const double turns = std::max(size_of(state.angular_velocity[slot]),
                                  size_of(substep.end_angular_velocity[slot]));
    if (turns * setup.bodies[slot].rotation_radius * setup.step > least) return true;
  }
  const Slide slide = slide_of(setup, state, substep, contact);
  const double speed = std::max(size_of(slide.first), size_of(slide.last));
  if (contact.friction > 0 && speed * setup.step > least) {
    const double aside = size_of(Vector3<double>(slide.first.cross(slide.last))) / speed;
    if (aside * setup.step > least) return true;
  }
  // Only between a ball or a capsule and a bounded body a normal rotates that no rotation moves.
  if (!round || index(contact.b) >= setup.bounded) return false;
  const auto shape_at = [&](int body) {
    const std::size_t slot = index(body);
    const auto motion = substep_motion(setup, state, substep, slot);
    return moved_body(setup, state, substep, slot, motion, substep.length).shape;
  };
  const auto later = signed_distance_of_shapes(shape_at(contact.a), shape_at(contact.b)).normal;
  return size_of(Vector3<double>(later - contact.normal)) * push.stop.normal * lightness *
             setup.step >
         least;
}

}  // namespace detail

CONTACT_SCENES_INLINE void note_varying_forces(const SteppedSetup& setup, SteppedState& state,
                                               Substep& substep) {
  if (substep.pushing.empty()) return;
  RunDoubts& doubts = state.counts.doubts;
  const double now = time_of_substep(setup, state, substep);
  doubts.add(RunDoubt::contact, now);
  if (substep.simultaneous) {
    doubts.add(RunDoubt::crowd, now);
    return;
  }
  if (doubts.since(RunDoubt::varying) <= now) return;
  for (const StepBounce& push : substep.pushing) {
    if (!detail::force_varies(setup, state, substep, push)) continue;
    // A body that begins to rotate here may have begun in the step before.
    doubts.add(RunDoubt::varying, std::max(0.0, now - setup.step));
    return;
  }
}

CONTACT_SCENES_INLINE void note_slow_impact(const SteppedSetup& setup, SteppedState& state,
                                            const Substep& substep, const NearPair& pair,
                                            double speed) {
  if (!(speed * setup.step > min_error(setup))) return;
  bool varies = detail::is_round(setup.bodies[pair.a]) && detail::is_round(setup.bodies[pair.b]);
  for (const std::size_t slot : {pair.a, pair.b}) {
    const double turns = size_of(angular_velocity_of(state, slot));
    varies = varies || (slot < setup.movers &&
                        turns * setup.bodies[slot].rotation_radius * setup.step > min_error(setup));
  }
  if (!varies && !(falling_away(setup, state, substep, pair) > 0)) return;
  const double now = time_of_substep(setup, state, substep);
  state.counts.doubts.add(RunDoubt::contact, now);
  state.counts.doubts.add(RunDoubt::varying, std::max(0.0, now - setup.step));
}

}  // namespace contact
