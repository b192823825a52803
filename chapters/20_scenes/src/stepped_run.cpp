#include <contact/stepped/stepped_run.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <contact/aabb.hpp>
#include <contact/contact_manifold.hpp>
#include <contact/contact_solver.hpp>
#include <contact/contact_world.hpp>
#include <contact/convex_shapes.hpp>
#include <contact/gap.hpp>
#include <contact/grid_pairs.hpp>
#include <contact/inertia.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/plan/plan_bounds.hpp>
#include <contact/plan/plan_rules.hpp>
#include <contact/plan/plan_types.hpp>
#include <contact/rigid_impulse.hpp>
#include <contact/rotation.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_run.hpp>
#include <contact/spring_damper.hpp>
#include <contact/stepped/stage_contacts.hpp>
#include <contact/stepped/stage_forces.hpp>
#include <contact/stepped/stage_impacts.hpp>
#include <contact/stepped/stage_motion.hpp>
#include <contact/stepped/stage_pairs.hpp>
#include <contact/stepped/stage_sleep.hpp>
#include <contact/stepped/stage_time_of_impact.hpp>
#include <contact/stepped/stepped_state.hpp>
#include <contact/vector.hpp>

namespace contact {

// [stepped-refusal]
CONTACT_SCENES_INLINE std::optional<std::string> stepped_refusal(const Scene& scene,
                                                                 const Plan& plan) {
  if (plan.pairs == 0) return std::nullopt;
  std::size_t hull = scene.bodies.size();
  std::size_t bounded = 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const SceneShape& shape = scene.bodies[i].shape;
    if (std::holds_alternative<HalfSpaceShape>(shape)) continue;
    ++bounded;
    if (std::holds_alternative<HullShape>(shape) && hull == scene.bodies.size()) hull = i;
  }
  if (hull == scene.bodies.size() || bounded < 2) return std::nullopt;
  return "bodies[" + std::to_string(hull) + "].shape (" + scene.bodies[hull].name +
         ") is a convex hull and may meet other bodies: hulls meet half-spaces only; spheres, "
         "boxes and capsules meet all but hulls";
}
// [/stepped-refusal]

namespace detail {

/// A stage, and what it is called.
struct NamedStage {
  SceneStage is;
  StepStage run = nullptr;
};

/// The stages of each part of a step, in their order, and those after a step.
struct StepPipeline {
  std::vector<NamedStage> part;
  std::vector<NamedStage> after;
};

/// How long a step is: the plan's, or a frame where the plan goes from event to event.
CONTACT_SCENES_INLINE double step_of(const Scene& scene, const Plan& plan) {
  if (plan.step > 0) return plan.step;
  double h = std::min(1.0 / 60, scene.duration);
  if (scene.output.every > 0) h = std::min(h, scene.output.every);
  return h;
}

// [kept-axes]
/// Across which axes the scene is its own mirror image. What a mirror forbids, rounding may not do:
/// along such an axis nothing moves, and nothing spins about another one.
CONTACT_SCENES_INLINE std::array<bool, 3> proven_mirrors(const PlanQuestion& q) {
  std::array<bool, 3> mirrors{};
  for (int axis = 0; axis < 3; ++axis)
    mirrors[static_cast<std::size_t>(axis)] = is_proven(plane_motion(q, axis));
  return mirrors;
}

/// The coordinates that change. If a dimension is off, a mirror image has no number along its axis;
/// if it is on though a mirror is proven, it has one that stays as it is.
CONTACT_SCENES_INLINE KeptAxes kept_axes(const Plan& plan, const PlanQuestion& q,
                                         const std::array<bool, 3>& mirrors) {
  KeptAxes kept;
  const std::size_t least = is_on(plan, Effect::third_dimension)    ? 3
                            : is_on(plan, Effect::second_dimension) ? 2
                                                                    : 1;
  std::array<bool, 3> dropped{};
  for (std::size_t axis = 3; axis-- > 0 && kept.count > least;) {
    dropped[axis] = mirrors[axis];
    if (mirrors[axis]) --kept.count;
  }
  std::stable_partition(kept.axes.begin(), kept.axes.end(),
                        [&](int axis) { return !dropped[static_cast<std::size_t>(axis)]; });
  for (std::size_t k = 0; k < kept.count; ++k)
    kept.held[k] = mirrors[static_cast<std::size_t>(kept.axes[k])] && kept.axes[k] != q.table;
  return kept;
}

/// The coordinates of spins that change: what moves in a plane turns about the axis across it. A
/// smooth ball may spin about another, and goes on with that.
CONTACT_SCENES_INLINE KeptAxes kept_spin_axes(const Scene& scene, const KeptAxes& kept,
                                              const std::array<bool, 3>& mirrors) {
  KeptAxes spins;
  std::array<bool, 3> forbidden{};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t axis = 0; axis < 3; ++axis)
      forbidden[k] = forbidden[k] || (mirrors[axis] && axis != k);
  for (const SceneBody& body : scene.bodies)
    for (std::size_t k = 0; k < 3; ++k)
      if (body.moves && forbidden[k] && body.spin(static_cast<int>(k)) != 0) return spins;
  if (kept.count < 3) {
    spins.count = 3 - kept.count;
    std::rotate_copy(kept.axes.begin(), kept.axes.begin() + static_cast<std::ptrdiff_t>(kept.count),
                     kept.axes.end(), spins.axes.begin());
  }
  for (std::size_t k = 0; k < spins.count; ++k)
    spins.held[k] = forbidden[static_cast<std::size_t>(spins.axes[k])];
  return spins;
}
// [/kept-axes]

// [stepped-setup]
/// What a plan makes of a scene. An effect that is off is taken out of the materials too: without
/// friction all are smooth, without restitution nothing bounces, without penalty contact all are
/// hard.
CONTACT_SCENES_INLINE SteppedSetup stepped_setup(const Scene& scene, const Plan& plan) {
  SteppedSetup setup;
  setup.scene = scene;
  setup.place.resize(scene.bodies.size());
  for (const int kind : {0, 1, 2}) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const SceneBody& body = scene.bodies[i];
      const bool plane = std::holds_alternative<HalfSpaceShape>(body.shape);
      if ((plane ? 2 : body.moves ? 0 : 1) != kind) continue;
      setup.place[i] = setup.bodies.size();
      setup.bodies.push_back(stepped_body(body, i));
    }
    if (kind == 0) setup.movers = setup.bodies.size();
    if (kind == 1) setup.bounded = setup.bodies.size();
  }
  // The gyroscopic term changes spins: it brings them along.
  setup.gyroscopic = is_on(plan, Effect::gyroscopic_term);
  setup.rotation = is_on(plan, Effect::rotation) || setup.gyroscopic;
  setup.continuous = is_on(plan, Effect::continuous_detection);
  setup.one_by_one = setup.movers <= most_one_by_one || plan.pairs == 0;
  const PlanQuestion q = plan_question(scene);
  const std::array<bool, 3> mirrors = proven_mirrors(q);
  setup.line = proven_line(q).has_value();
  setup.thinnest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < setup.bounded; ++i) {
    setup.thinnest = std::min(setup.thinnest, 2 * setup.bodies[i].core);
    setup.edges = setup.edges || (i < setup.movers && !setup.line && setup.bodies[i].spin_arm > 0);
  }
  setup.most_impacts = most_impacts(setup.movers, setup.rotation && setup.edges);
  setup.together = is_on(plan, Effect::several_contacts);
  if (!is_on(plan, Effect::gravity)) setup.scene.gravity.setZero();
  setup.step = step_of(scene, plan);
  setup.kept = kept_axes(plan, q, mirrors);
  setup.kept_spins = kept_spin_axes(scene, setup.kept, mirrors);
  setup.turns.fill(false);
  for (std::size_t k = 0; k < setup.kept_spins.count; ++k)
    setup.turns[static_cast<std::size_t>(setup.kept_spins.axes[k])] = !setup.kept_spins.held[k];

  double lightness = 0;
  for (std::size_t i = 0; i < setup.movers; ++i)
    lightness = std::max(lightness, 1 / setup.bodies[i].mass);
  double stiffest = 0;
  setup.smooth = true;
  for (const SceneMaterial& a : scene.materials) {
    for (const SceneMaterial& b : scene.materials) {
      PairMaterial pair = pair_material(a, b);
      if (!is_on(plan, Effect::friction)) pair.friction = 0;
      if (!is_on(plan, Effect::restitution)) pair.restitution = 0;
      if (!is_on(plan, Effect::penalty_contact)) pair.stiffness.reset();
      if (pair.stiffness) stiffest = std::max(stiffest, *pair.stiffness);
      setup.smooth = setup.smooth && pair.friction == 0;
      setup.material.push_back(pair);
    }
  }
  setup.spring_part = setup.step;
  if (stiffest > 0)
    setup.spring_part = std::min(setup.step, 1 / (128 * std::sqrt(stiffest * 2 * lightness)));

  if (plan.spring_part > 0) setup.spring_part = std::min(setup.spring_part, plan.spring_part);
  // Their shares of the tolerance are the plan's business.
  setup.rest_height = plan.rest_height;
  const double g = size_of(setup.scene.gravity);
  const double hop = std::min(g * setup.step / 2, std::sqrt(2 * g * setup.rest_height));
  setup.slow_speed = std::max(hop * 0x1p-20, 1e-11);
  setup.sleep_speed = plan.sleep_speed;
  // What the sweeps leave is a millionth of what would come to half the tolerance in the whole
  // time.
  const double far = scene.tolerance.position.value_or(1e-6) / 2;
  const double slow = far / std::max(scene.duration, scene.duration * scene.duration / sleep_after);
  const double left = std::clamp(slow * 1e-6, 1e-13, 1e-9);
  setup.sweeps =
      setup.one_by_one ? SweepLimits<double>{400, left, 1.5} : SweepLimits<double>{400, 1e-7, 1.0};
  return setup;
}
// [/stepped-setup]

// [pipeline]
/// The stages that a plan calls for. Without a pair that may meet there are no contacts at all.
CONTACT_SCENES_INLINE StepPipeline step_pipeline(const Plan& plan, const SteppedSetup& setup) {
  StepPipeline line;
  const auto add = [&](std::vector<NamedStage>& to, std::string name, std::string detail,
                       StepStage run) {
    to.push_back({{std::move(name), std::move(detail)}, run});
  };
  const bool meet = plan.pairs > 0;
  const bool cells = is_on(plan, Effect::broad_phase);
  const bool springs = is_on(plan, Effect::penalty_contact);
  const bool sleep = is_on(plan, Effect::sleeping);
  const bool forces = is_on(plan, Effect::resting) || !setup.one_by_one;
  const std::string sweeps = setup.together ? "a body's all together" : "each on its own";
  if (meet) {
    if (cells)
      add(line.part, "broad phase", "cells", sort_into_cells);
    else
      add(line.part, "pairs", "each with each", compare_all_pairs);
    add(line.part, "contacts", "gaps and the points that touch", find_touching_pairs);
    if (sleep) add(line.part, "waking", "what something fast touches", wake_bodies);
    if (setup.one_by_one) add(line.part, "impacts", sweeps, solve_impacts);
    if (springs) add(line.part, "springs", "leapfrog, dampers implicit", push_springs);
  }
  if (is_on(plan, Effect::gravity)) add(line.part, "gravity", "even", add_gravity);
  if (meet) {
    // Where nothing rests it still stops approaches that rounding leaves.
    add(line.part, forces ? "contact forces" : "impacts left over",
        forces ? sweeps : "rounding, and a step with too many to take one by one", solve_forces);
    if (setup.continuous && setup.one_by_one)
      add(line.part, "time of impact", "by the gap's closing time", find_first_impact);
  }
  const bool bounce = meet && is_on(plan, Effect::restitution);
  if (bounce) add(line.part, "bounces", "of impacts that are taken at once", solve_bounces);
  add(line.part, "motion", "exact for even accelerations", move_bodies);
  if (setup.gyroscopic)
    add(line.part, "rotation", "with the gyroscopic term", turn_with_gyroscopic_term);
  else if (setup.rotation)
    add(line.part, "rotation", "even spins", turn_bodies);
  if (meet) {
    if (bounce) add(line.part, "leaving", "what has bounced", leave_bounced);
    // A ball's impacts are found to the last bit however it turns; an edge's are not.
    if ((setup.rotation && setup.edges) || !setup.one_by_one)
      add(line.part, "pushing out", "overlaps, half by half", push_out);
    if (sleep) add(line.after, "sleep", "groups that are slow", put_to_sleep);
  }
  return line;
}
// [/pipeline]

}  // namespace detail

// [stepped-run]
/// A scene, step by step.
class SteppedRun final : public SceneRun {
 public:
  /// @throws std::invalid_argument with what stepped_refusal() says
  SteppedRun(const Scene& scene, const Plan& plan) {
    if (const auto refusal = stepped_refusal(scene, plan))
      throw_invalid_argument("scene", scene.name, *refusal);
    setup_ = detail::stepped_setup(scene, plan);
    line_ = detail::step_pipeline(plan, setup_);
    state_.position = state_.velocity = KeptVectors(setup_.kept);
    state_.spin = KeptVectors(setup_.kept_spins);
    for (std::size_t i = 0; i < setup_.movers; ++i) {
      const SceneBody& body = scene.bodies[setup_.bodies[i].body];
      const Vector3<double> zero = Vector3<double>::Zero();  // + 0: no −0 is kept
      state_.position.push_back(body.position);
      state_.velocity.push_back(body.velocity + zero);
      if (!setup_.rotation) continue;
      state_.orientation.push_back(body.orientation);
      state_.spin.push_back(body.spin + zero);
    }
    if (plan.pairs > 0 && detail::is_on(plan, Effect::sleeping)) {
      state_.slow_since.assign(setup_.movers, 0);
      state_.sleeps_with.assign(setup_.movers, -1);
    }
  }

  /// @cond
  using SceneRun::advance;
  /// @endcond
  bool event_driven() const override { return false; }
  double step() const override { return setup_.step; }
  std::vector<SceneStage> stages() const override {
    std::vector<SceneStage> stages;
    for (const auto* list : {&line_.part, &line_.after})
      for (const detail::NamedStage& stage : *list) stages.push_back(stage.is);
    return stages;
  }

  // [advance-steps]
  /// Whole steps as long as they fit; then, on a copy, the part of a step that is left. So where a
  /// caller looks changes nothing.
  SceneRunEnd advance(double until, std::uint64_t budget, SceneObserver* observer) override {
    if (!(until > now_)) return SceneRunEnd::reached;
    shown_.reset();
    now_ = time_of(state_.step);
    while (time_of(state_.step + 1) <= until) {
      if (budget == 0) return SceneRunEnd::out_of_budget;
      --budget;
      step_once(state_, setup_.step);
      now_ = time_of(state_.step);
      bool go_on = true;
      if (observer != nullptr)
        for (const SceneHit& hit : part_.hits) go_on = observer->on_hit(hit) && go_on;
      if (!go_on) return SceneRunEnd::stopped;
    }
    if (now_ < until) {
      shown_ = state_;
      step_once(*shown_, until - now_);
      now_ = until;
    }
    return SceneRunEnd::reached;
  }
  // [/advance-steps]

  void tell_unfinished(SceneObserver& observer) const override {
    if (!shown_) return;
    for (const SceneHit& hit : part_.hits) observer.on_hit(hit);
  }

  double now() const override { return now_; }
  Vector3<double> position(std::size_t body) const override {
    return position_of(setup_, seen(), setup_.place[body]);
  }
  Rotor<double> orientation(std::size_t body) const override {
    return orientation_of(setup_, seen(), setup_.place[body]);
  }
  Vector3<double> velocity(std::size_t body) const override {
    return velocity_of(setup_, seen(), setup_.place[body]);
  }
  Vector3<double> spin(std::size_t body) const override {
    const std::size_t place = setup_.place[body];
    return setup_.rotation ? spin_of(seen(), place) : setup_.scene.bodies[body].spin;
  }
  double energy() const override { return detail::energy_of_run(setup_.scene, *this); }
  SceneRunCounts counts() const override {
    SceneRunCounts counts = seen().counts;
    if (setup_.one_by_one) counts.most_impacts = static_cast<std::uint64_t>(setup_.most_impacts);
    return counts;
  }

  std::size_t bytes() const override {
    const auto of = [](const auto& list) { return list.capacity() * sizeof(list[0]); };
    const auto state = [&](const SteppedState& s) {
      return s.position.bytes() + s.velocity.bytes() + of(s.orientation) + s.spin.bytes() +
             of(s.slow_since) + of(s.sleeps_with) + of(s.touched) + of(s.pushed);
    };
    return state(state_) + (shown_ ? state(*shown_) : 0) + of(setup_.bodies) + of(setup_.place) +
           of(setup_.material) + of(part_.pairs) + of(part_.shapes) + part_.end_velocity.bytes() +
           part_.end_spin.bytes() + of(part_.hits) + of(part_.bounces) + of(part_.bounced) +
           part_.free_velocity.bytes() + part_.free_spin.bytes() + of(part_.flung) + of(part_.even);
  }
  std::size_t bytes_per_body() const override {
    std::size_t bytes = 2 * setup_.kept.count * sizeof(double);
    if (!state_.orientation.empty())
      bytes += sizeof(Rotor<double>) + setup_.kept_spins.count * sizeof(double);
    if (!state_.slow_since.empty()) bytes += sizeof(double) + sizeof(std::int32_t);
    return bytes;
  }

  SceneCheckpoint checkpoint() const override;
  void restore(const SceneCheckpoint& from) override;

 private:
  const SteppedState& seen() const { return shown_ ? *shown_ : state_; }
  double time_of(std::uint64_t step) const { return static_cast<double>(step) * setup_.step; }

  // [use-up-the-step]
  /// A step, or a part of one: stages work on what is left of it until nothing is left. An impact
  /// ends a part; after too many of them what is left is solved at once. A crowd's step has four
  /// parts of few sweeps each: shorter parts help a heap more than more sweeps.
  void step_once(SteppedState& state, double length) {
    part_.whole = part_.left = length;
    part_.cuts = 0;
    part_.hits.clear();
    // An impact cuts twice: a part ends where it is found, and one without length solves it.
    const int most_cuts = 2 * setup_.most_impacts;
    bool crowded = false;
    double longest = length;
    int anew = 0;  // so often in a row
    while (part_.left > 0) {
      if (anew == 0) part_.flung.clear();
      bool again = false;
      part_.planned = part_.length = part_.left;
      part_.at_once = !setup_.one_by_one || part_.cuts > most_cuts;
      const double piece = length / crowd_parts;
      if (part_.at_once && part_.left > 1.5 * piece) part_.planned = part_.length = piece;
      part_.planned = part_.length = std::min(part_.length, longest);
      longest = length;
      crowded = crowded || (setup_.one_by_one && part_.at_once);
      part_.pairs.clear();
      part_.bounces.clear();
      part_.bounced.clear();
      part_.end_velocity = state.velocity;
      part_.end_spin = state.spin;
      part_.at_start.assign(setup_.movers, false);
      part_.even.clear();
      part_.pushed.assign(setup_.movers, false);
      ++state.counts.parts;
      const std::size_t hits = part_.hits.size();
      for (const detail::NamedStage& stage : line_.part) {
        stage.run(setup_, state, part_);
        if (!(part_.length > 0)) break;
        if (!part_.at_once || stage.run != solve_forces) continue;
        // Who has been hit may turn too far in such a part, or fly at somebody who was not near:
        // then all of it anew, in a shorter one or with more pairs.
        const double turn = std::max(longest_turn(setup_, part_), length * 0x1p-12);
        const bool turns = turn < part_.planned / 2;
        const bool flies = setup_.continuous && anew < most_anew &&
                           flung_at_others(setup_, state, part_, line_.part.front().run);
        if (!turns && !flies) continue;
        longest = turns ? turn : part_.planned;
        again = true;
        part_.length = 0;
        state.counts.hits -= part_.hits.size() - hits;
        part_.hits.resize(hits);
        break;
      }
      part_.left -= part_.length;
      anew = again ? anew + 1 : 0;
    }
    part_.planned = part_.length = length;
    for (const detail::NamedStage& stage : line_.after) stage.run(setup_, state, part_);
    ++state.step;
    ++state.counts.steps;
    if (crowded) ++state.counts.crowded_steps;
  }
  // [/use-up-the-step]

  SteppedSetup setup_;
  detail::StepPipeline line_;
  SteppedState state_;                 // after whole steps
  std::optional<SteppedState> shown_;  // at a time between two of them
  StepPart part_;
  double now_ = 0;
};
// [/stepped-run]

CONTACT_SCENES_INLINE SceneCheckpoint SteppedRun::checkpoint() const {
  SceneCheckpoint to;
  to.kind = "stepped";
  to.now = now_;
  to.counts = state_.counts;
  const auto add = [&](const Vector3<double>& v) {
    for (int k = 0; k < 3; ++k) to.numbers.push_back(v(k));
  };
  for (std::size_t i = 0; i < setup_.movers; ++i) add(position_of(setup_, state_, i));
  for (std::size_t i = 0; i < setup_.movers; ++i) add(state_.velocity[i]);
  for (const auto& q : state_.orientation) {
    to.numbers.push_back(q.w);
    add(q.v);
  }
  for (std::size_t i = 0; i < state_.spin.size(); ++i) add(state_.spin[i]);
  for (const double t : state_.slow_since) to.numbers.push_back(t);
  to.integers.push_back(static_cast<std::int64_t>(state_.step));
  for (const std::int32_t group : state_.sleeps_with) to.integers.push_back(group);
  for (std::size_t i = 0; i < state_.touched.size(); ++i) {
    to.integers.push_back(state_.touched[i].a);
    to.integers.push_back(state_.touched[i].b);
    add(state_.touched[i].point);
    to.numbers.push_back(state_.pushed[i].normal);
    add(state_.pushed[i].tangential);
  }
  return to;
}

CONTACT_SCENES_INLINE void SteppedRun::restore(const SceneCheckpoint& from) {
  const std::size_t movers = setup_.movers;
  const std::size_t numbers = 6 * movers + 7 * state_.orientation.size() + state_.slow_since.size();
  const std::size_t whole = 1 + state_.sleeps_with.size();
  const std::size_t contacts =
      from.integers.size() < whole ? 0 : (from.integers.size() - whole) / 2;
  if (from.kind != "stepped" || from.integers.size() != whole + 2 * contacts ||
      from.numbers.size() != numbers + 7 * contacts) {
    throw_invalid_argument("from", "a checkpoint of kind " + from.kind,
                           "must be one of this run step by step");
  }
  std::size_t at = 0;
  const auto vector = [&] {
    const Vector3<double> v(from.numbers[at], from.numbers[at + 1], from.numbers[at + 2]);
    at += 3;
    return v;
  };
  for (std::size_t i = 0; i < movers; ++i) state_.position.set(i, vector());
  for (std::size_t i = 0; i < movers; ++i) state_.velocity.set(i, vector());
  for (auto& q : state_.orientation) {
    q.w = from.numbers[at++];
    q.v = vector();
  }
  for (std::size_t i = 0; i < state_.spin.size(); ++i) state_.spin.set(i, vector());
  for (double& t : state_.slow_since) t = from.numbers[at++];
  state_.step = static_cast<std::uint64_t>(from.integers[0]);
  for (std::size_t i = 0; i < state_.sleeps_with.size(); ++i)
    state_.sleeps_with[i] = static_cast<std::int32_t>(from.integers[1 + i]);
  state_.touched.assign(contacts, {});
  state_.pushed.assign(contacts, {});
  for (std::size_t i = 0; i < contacts; ++i) {
    state_.touched[i].a = static_cast<int>(from.integers[whole + 2 * i]);
    state_.touched[i].b = static_cast<int>(from.integers[whole + 2 * i + 1]);
    state_.touched[i].point = vector();
    state_.pushed[i].normal = from.numbers[at++];
    state_.pushed[i].tangential = vector();
  }
  state_.counts = from.counts;
  shown_.reset();
  now_ = time_of(state_.step);
  advance(from.now);
}

CONTACT_SCENES_INLINE std::unique_ptr<SceneRun> make_stepped_run(const Scene& scene,
                                                                 const Plan& plan) {
  return std::make_unique<SteppedRun>(scene, plan);
}

}  // namespace contact
