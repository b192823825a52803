#include <contact/stepped/stepped_run.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <contact/invalid_argument.hpp>
#include <contact/plan/plan_rules.hpp>
#include <contact/plan/plan_types.hpp>
#include <contact/quaternion.hpp>
#include <contact/rotation.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_run.hpp>
#include <contact/signed_distance.hpp>
#include <contact/stepped/stage_contacts.hpp>
#include <contact/stepped/stage_forces.hpp>
#include <contact/stepped/stage_pairs.hpp>
#include <contact/stepped/stepped_state.hpp>
#include <contact/vector.hpp>

#include "stepped_setup.hpp"

namespace contact {

// [stepped-run]
/// A scene, step by step.
class SteppedRun final : public SceneRun {
 public:
  SteppedRun(const Scene& scene, const Plan& plan) {
    setup_ = detail::stepped_setup(scene, plan);
    line_ = detail::step_pipeline(plan, setup_);
    state_.position = state_.velocity = ActiveVectors(setup_.active);
    state_.angular_velocity = ActiveVectors(setup_.active_rotation);
    for (std::size_t i = 0; i < setup_.movers; ++i) {
      const SceneBody& body = scene.bodies[setup_.bodies[i].body];
      const Vector3<double> zero = Vector3<double>::Zero();  // + 0: no −0 is kept
      state_.position.push_back(body.position);
      state_.velocity.push_back(body.velocity + zero);
      if (!setup_.rotation) continue;
      state_.orientation.push_back(body.orientation);
      state_.angular_velocity.push_back(body.angular_velocity + zero);
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
    for (const auto* list : {&line_.substep, &line_.after})
      for (const detail::NamedStage& stage : *list) stages.push_back(stage.is);
    return stages;
  }

  // [advance-steps]
  /// Whole steps as long as they fit; then, on a copy, the remaining part of a step. So stopping at
  /// a time changes nothing.
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
        for (const SceneHit& hit : substep_.hits) go_on = observer->on_hit(hit) && go_on;
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

  void report_unfinished(SceneObserver& observer) const override {
    if (!shown_) return;
    for (const SceneHit& hit : substep_.hits) observer.on_hit(hit);
  }

  double now() const override { return now_; }
  Vector3<double> position(std::size_t body) const override {
    return position_of(setup_, seen(), setup_.slot_of[body]);
  }
  Quaternion<double> orientation(std::size_t body) const override {
    return orientation_of(setup_, seen(), setup_.slot_of[body]);
  }
  Vector3<double> velocity(std::size_t body) const override {
    return velocity_of(setup_, seen(), setup_.slot_of[body]);
  }
  Vector3<double> angular_velocity(std::size_t body) const override {
    const std::size_t slot = setup_.slot_of[body];
    return setup_.rotation ? angular_velocity_of(seen(), slot)
                           : setup_.scene.bodies[body].angular_velocity;
  }
  double energy() const override { return detail::energy_of_run(setup_.scene, *this); }
  SceneRunCounts counts() const override {
    SceneRunCounts counts = seen().counts;
    if (setup_.one_by_one) counts.max_impacts = static_cast<std::uint64_t>(setup_.max_impacts);
    return counts;
  }

  std::size_t bytes() const override {
    const auto of = [](const auto& list) { return list.capacity() * sizeof(list[0]); };
    const auto state = [&](const SteppedState& s) {
      return s.position.bytes() + s.velocity.bytes() + of(s.orientation) +
             s.angular_velocity.bytes() + of(s.slow_since) + of(s.sleeps_with) + of(s.touched) +
             of(s.last_impulses);
    };
    return state(state_) + (shown_ ? state(*shown_) : 0) + of(setup_.bodies) + of(setup_.slot_of) +
           of(setup_.material) + of(substep_.pairs) + of(substep_.shapes) +
           substep_.end_velocity.bytes() + substep_.end_angular_velocity.bytes() +
           of(substep_.hits) + of(substep_.pushing) + of(substep_.bounces) + of(substep_.bounced) +
           substep_.free_velocity.bytes() + substep_.free_angular_velocity.bytes() +
           of(substep_.deflection) + of(substep_.even);
  }
  std::size_t bytes_per_body() const override {
    std::size_t bytes = 2 * setup_.active.count * sizeof(double);
    if (!state_.orientation.empty())
      bytes += sizeof(Quaternion<double>) + setup_.active_rotation.count * sizeof(double);
    if (!state_.slow_since.empty()) bytes += sizeof(double) + sizeof(std::int32_t);
    return bytes;
  }

  SceneCheckpoint checkpoint() const override;
  void restore(const SceneCheckpoint& from) override;

 private:
  const SteppedState& seen() const { return shown_ ? *shown_ : state_; }
  double time_of(std::uint64_t step) const { return static_cast<double>(step) * setup_.step; }

  // [use-up-the-step]
  /// A step, or a part of one: stages process what is left of it until nothing is left. An impact
  /// ends a substep; after too many of them the rest is solved at once. A crowd's step has four
  /// substeps of few iterations each: shorter substeps help a heap more than more iterations.
  void step_once(SteppedState& state, double length) {
    substep_.whole = substep_.left = length;
    substep_.cuts = substep_.events = 0;
    substep_.slide_search = {};
    substep_.hits.clear();
    // An impact divides twice: a substep ends where it is found, and one of length zero solves it.
    const int max_cuts = 2 * setup_.max_impacts;
    bool crowded = false;
    double longest = length;
    int anew = 0;  // repetitions in a row
    while (substep_.left > 0) {
      if (anew == 0) substep_.deflection.clear();
      bool again = false;
      substep_.planned = substep_.length = substep_.left;
      substep_.simultaneous = !setup_.one_by_one || substep_.cuts > max_cuts;
      const double piece = length / crowd_substeps;
      if (substep_.simultaneous && substep_.left > 1.5 * piece)
        substep_.planned = substep_.length = piece;
      substep_.planned = substep_.length = std::min(substep_.length, longest);
      longest = length;
      crowded = crowded || (setup_.one_by_one && substep_.simultaneous);
      substep_.repeat_with = 0;
      substep_.pairs.clear();
      substep_.pushing.clear();
      substep_.bounces.clear();
      substep_.bounced.clear();
      substep_.end_velocity = state.velocity;
      substep_.end_angular_velocity = state.angular_velocity;
      substep_.at_start.assign(setup_.movers, false);
      substep_.even.clear();
      substep_.contacted.assign(setup_.movers, false);
      ++state.counts.substeps;
      const std::size_t hits = substep_.hits.size();
      for (const detail::NamedStage& stage : line_.substep) {
        stage.run(setup_, state, substep_);
        if (!(substep_.length > 0)) break;
        if (substep_.repeat_with > 0) {
          longest = substep_.repeat_with;
          again = true;
          substep_.length = 0;
          break;
        }
        if (!substep_.simultaneous || stage.run != solve_forces) continue;
        // A body that was hit may rotate too far in such a substep, or fly at a body that was not
        // near: then it is repeated, shorter or with more pairs.
        const double turn = std::max(longest_rotation(setup_, substep_), length * 0x1p-12);
        const bool turns = turn < substep_.planned / 2;
        const bool flies =
            setup_.continuous && anew < max_retries && deflected_at_others(setup_, state, substep_);
        if (!turns && !flies) continue;
        longest = turns ? turn : substep_.planned;
        again = true;
        substep_.length = 0;
        state.counts.hits -= substep_.hits.size() - hits;
        substep_.hits.resize(hits);
        break;
      }
      substep_.left -= substep_.length;
      anew = again ? anew + 1 : 0;
    }
    substep_.planned = substep_.length = length;
    for (const detail::NamedStage& stage : line_.after) stage.run(setup_, state, substep_);
    ++state.step;
    ++state.counts.steps;
    if (crowded) ++state.counts.crowded_steps;
  }
  // [/use-up-the-step]

  SteppedSetup setup_;
  detail::StepPipeline line_;
  SteppedState state_;                 // after whole steps
  std::optional<SteppedState> shown_;  // at a time between two of them
  Substep substep_;
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
  for (std::size_t i = 0; i < state_.angular_velocity.size(); ++i) add(state_.angular_velocity[i]);
  for (const double t : state_.slow_since) to.numbers.push_back(t);
  to.integers.push_back(static_cast<std::int64_t>(state_.step));
  for (const std::int32_t group : state_.sleeps_with) to.integers.push_back(group);
  for (std::size_t i = 0; i < state_.touched.size(); ++i) {
    to.integers.push_back(state_.touched[i].a);
    to.integers.push_back(state_.touched[i].b);
    add(state_.touched[i].point);
    to.numbers.push_back(state_.last_impulses[i].normal);
    add(state_.last_impulses[i].tangential);
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
  for (std::size_t i = 0; i < state_.angular_velocity.size(); ++i)
    state_.angular_velocity.set(i, vector());
  for (double& t : state_.slow_since) t = from.numbers[at++];
  state_.step = static_cast<std::uint64_t>(from.integers[0]);
  for (std::size_t i = 0; i < state_.sleeps_with.size(); ++i)
    state_.sleeps_with[i] = static_cast<std::int32_t>(from.integers[1 + i]);
  state_.touched.assign(contacts, {});
  state_.last_impulses.assign(contacts, {});
  for (std::size_t i = 0; i < contacts; ++i) {
    state_.touched[i].a = static_cast<int>(from.integers[whole + 2 * i]);
    state_.touched[i].b = static_cast<int>(from.integers[whole + 2 * i + 1]);
    state_.touched[i].point = vector();
    state_.last_impulses[i].normal = from.numbers[at++];
    state_.last_impulses[i].tangential = vector();
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
