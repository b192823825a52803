/// @file
/// The parts of a plan: effects, inequalities, proofs and decisions. Plain data, the same for a
/// page, a program and a test.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace contact {

/// The effects of a simulation. Each can be left out, or is a value that must be chosen.
enum class Effect {
  gravity,               ///< the acceleration of free flight
  rotation,              ///< orientations and angular velocities as state
  gyroscopic_term,       ///< ω × I ω in Euler's equations of rotation
  friction,              ///< tangential impulses
  restitution,           ///< rebound: the speed after an impact
  continuous_detection,  ///< finding impacts between two steps
  broad_phase,           ///< sorting out pairs before they are tested
  several_contacts,      ///< a body with more than one contact at a time
  resting,               ///< contacts that last and carry a force
  sleeping,              ///< bodies at rest that are skipped
  penalty_contact,       ///< contacts that are compliant, like springs
  third_dimension,       ///< motion out of a plane
  second_dimension,      ///< motion off a line
  double_precision,      ///< double instead of float
  event_driven,          ///< from impact to impact instead of step by step
  step_size,             ///< length of a step
  horizon                ///< until when positions can be predicted
};

/// Every effect, in the order of a plan.
inline constexpr std::array<Effect, 17> all_effects{
    Effect::gravity,          Effect::rotation,         Effect::gyroscopic_term,
    Effect::friction,         Effect::restitution,      Effect::continuous_detection,
    Effect::broad_phase,      Effect::several_contacts, Effect::resting,
    Effect::sleeping,         Effect::penalty_contact,  Effect::third_dimension,
    Effect::second_dimension, Effect::double_precision, Effect::event_driven,
    Effect::step_size,        Effect::horizon};

/// The name of an effect: "gyroscopic-term".
std::string_view effect_name(Effect effect);

/// The effect of that name; nothing if there is none.
inline std::optional<Effect> effect_named(std::string_view name) {
  for (const Effect effect : all_effects) {
    if (effect_name(effect) == name) return effect;
  }
  return std::nullopt;
}

/// Whether an effect can be on or off. The other two are values: step size and horizon.
inline bool can_be_switched(Effect effect) {
  return effect != Effect::step_size && effect != Effect::horizon;
}

/// How long a body must be slow before it may sleep, s.
inline constexpr double sleep_after = 0.5;

/// How the two sides of an inequality are compared.
enum class Relation {
  less,     ///< left < right
  at_most,  ///< left ≤ right
  equal     ///< left = right
};

/// One condition of a proof: two numbers, what each of them is, and how they are compared. Bounds
/// are rounded away from the side where the condition holds, so that a condition that holds also
/// holds without rounding.
struct Inequality {
  std::string left_is;                    ///< what the left side is, in words
  double left = 0;                        ///< in `unit`
  Relation relation = Relation::at_most;  ///< how the sides are compared
  double right = 0;                       ///< in `unit`
  std::string right_is;                   ///< what the right side is, in words
  std::string unit;                       ///< of both sides; empty for counts and ratios
  /// The id in plan_hypotheses.hpp; empty for a condition that is not one of these hypotheses.
  std::string_view hypothesis = {};
};

/// Whether the condition holds. A side that is not a number proves nothing.
bool holds(const Inequality& condition);

/// One proof that an effect cannot matter, or matters less than the tolerance.
struct Proof {
  std::string why;                     ///< the theorem, one sentence
  std::vector<Inequality> conditions;  ///< all must hold
  double error = 0;                    ///< position error accepted, m; 0: none
  std::string error_is = "none";       ///< the same in words
};

/// Whether every condition holds. A proof without conditions proves nothing.
bool is_proven(const Proof& proof);

/// The cost of an effect, estimated before the run. The unit is an instruction of the book's own
/// code, optimised (-O2), on x86-64: contact/plan_costs.hpp has the unit costs, and how they were
/// counted.
struct Saving {
  /// How many more instructions the whole run takes with the effect than without it: what leaving
  /// it out saves. Negative if the effect saves instructions.
  double instructions = 0;
  std::string is;  ///< what was counted

  /// The same, with more words.
  Saving and_more(const std::string& words) const { return {instructions, is + "; " + words}; }
};

/// What a plan says about one effect.
struct Decision {
  Effect effect = Effect::gravity;  ///< which effect
  bool on = true;                   ///< whether the simulation has it
  bool planned = true;              ///< the same before an override
  bool overridden = false;          ///< whether it was overridden
  bool proven = false;              ///< by `because`; else "not proven": the safe choice
  std::string why;                  ///< the theorem that decided, or why none did
  std::vector<Inequality> because;  ///< its numbers; the failed conditions if nothing is proven
  double error = 0;                 ///< position error accepted, m
  std::string error_is = "none";    ///< the same in words
  Saving saving;                    ///< what leaving it out saves, estimated
  /// Why the run stays the same when the effect is switched, or was by an override; empty if it
  /// does not, or may not
  std::string changes_nothing;
  std::optional<double> value;  ///< of a step size (s) or a horizon (s)
  std::vector<Proof> tried;     ///< every proof that the rule tried, in order
};

/// Makes a decision from a rule's proofs.
/// @param not_proven what to say if none holds
Decision decide(Effect effect, std::vector<Proof> proofs, const std::string& not_proven);

/// Effects that are forced on or off, whatever the plan says.
struct Overrides {
  std::vector<Effect> with;     ///< forced on
  std::vector<Effect> without;  ///< forced off
};

/// Options of a plan.
struct PlanOptions {
  std::optional<double> step;  ///< s, greater than 0; without it the tolerance chooses
  Overrides overrides;         ///< the last word on what is on
  /// For tests and searches only: ids of hypotheses (plan_hypotheses.hpp) that proofs leave out.
  /// With one of them a plan may say "proven" where it is wrong.
  std::vector<std::string> dropped;
};

/// The decisions on a scene, one for each effect in the order of all_effects, and notices for the
/// reader.
struct Plan {
  std::vector<Decision> decisions;   ///< as many as there are effects
  std::vector<std::string> notices;  ///< sentences, such as that the tolerance outlives the horizon
  double tolerance = 0;              ///< of a position, m; 0: no error is accepted
  /// m; sum of the errors that decisions accept; ∞ if one has no bound, or if an effect is forced
  /// off that the plan has on
  double error = 0;
  double speed = 0;  ///< no centre of mass is ever faster, m/s
  double step = 0;   ///< s; 0: no steps, from event to event
  /// s; shorter bounces of a ball on its floor are left out; 0: none that makes an error
  double cutoff = 0;
  double rest_height = 0;     ///< bounces no higher than this are left out in steps, m; 0: none is
  double sleep_speed = 0;     ///< bodies that are slower for a while may sleep in steps, m/s
  double spring_substep = 0;  ///< s; longest substep while a spring may push; 0: none does
  std::size_t pairs = 0;      ///< of bodies that may meet; a crowd counts all its pairs
};

/// The decision on an effect.
inline const Decision& decision_on(const Plan& plan, Effect effect) {
  return plan.decisions[static_cast<std::size_t>(effect)];
}

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/plan_types.cpp"
#endif
