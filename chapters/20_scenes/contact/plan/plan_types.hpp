/// @file
/// What a plan is made of: effects, inequalities, proofs and decisions. Plain data, so that a page,
/// a program and a test read the same.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace contact {

/// What a simulation of a scene may need. Each can be left out, or is a value that must be chosen.
enum class Effect {
  gravity,               ///< the acceleration of free flight
  rotation,              ///< orientations and spins as state
  gyroscopic_term,       ///< ω × I ω in the change of a spin
  friction,              ///< impulses along a surface
  restitution,           ///< bouncing: what comes back of an approach
  continuous_detection,  ///< looking for impacts between two steps
  broad_phase,           ///< sorting out pairs before they are tested
  several_contacts,      ///< a body with more than one contact at a time
  resting,               ///< contacts that last and carry a force
  sleeping,              ///< bodies at rest that are left alone
  penalty_contact,       ///< contacts that give way like springs
  third_dimension,       ///< motion out of a plane
  second_dimension,      ///< motion off a line
  double_precision,      ///< double in place of float
  event_driven,          ///< from impact to impact in place of step by step
  step_size,             ///< how long a step is
  horizon                ///< until when places can be predicted
};

/// Every effect, in the order of a plan.
inline constexpr std::array<Effect, 17> all_effects{
    Effect::gravity,          Effect::rotation,         Effect::gyroscopic_term,
    Effect::friction,         Effect::restitution,      Effect::continuous_detection,
    Effect::broad_phase,      Effect::several_contacts, Effect::resting,
    Effect::sleeping,         Effect::penalty_contact,  Effect::third_dimension,
    Effect::second_dimension, Effect::double_precision, Effect::event_driven,
    Effect::step_size,        Effect::horizon};

/// The name by which an effect is asked for: "gyroscopic-term".
std::string_view effect_name(Effect effect);

/// The effect of that name; nothing if there is none.
inline std::optional<Effect> effect_named(std::string_view name) {
  for (const Effect effect : all_effects) {
    if (effect_name(effect) == name) return effect;
  }
  return std::nullopt;
}

/// Whether an effect is switched on or off. The other two are values: step size and horizon.
inline bool can_be_switched(Effect effect) {
  return effect != Effect::step_size && effect != Effect::horizon;
}

/// How long a body is slow before it may sleep, s.
inline constexpr double sleep_after = 0.5;

/// How the two sides of an inequality are compared.
enum class Relation {
  less,     ///< left < right
  at_most,  ///< left ≤ right
  equal     ///< left = right
};

/// One condition of a proof: two numbers, what each of them is, and how they are compared. A bound
/// is rounded away from the comparison's holding, so that what holds here holds without rounding.
struct Inequality {
  std::string left_is;                    ///< what the left side is, in words
  double left = 0;                        ///< in `unit`
  Relation relation = Relation::at_most;  ///< how the sides are compared
  double right = 0;                       ///< in `unit`
  std::string right_is;                   ///< what the right side is, in words
  std::string unit;                       ///< of both sides; empty for counts and ratios
};

/// Whether the condition holds. A side that is not a number proves nothing.
bool holds(const Inequality& condition);

/// One way to show that an effect cannot matter, or matters less than the tolerance.
struct Proof {
  std::string why;                     ///< the theorem, one sentence
  std::vector<Inequality> conditions;  ///< all must hold
  double error = 0;                    ///< position error accepted, m; 0: none
  std::string error_is = "none";       ///< the same in words
};

/// Whether every condition holds. A proof without conditions proves nothing.
bool is_proven(const Proof& proof);

/// What an effect costs, by an estimate that is made before the run. The unit is an instruction of
/// the book's own code, optimised (-O2), as x86-64 has it: contact/plan_costs.hpp says what one of
/// each thing takes, and how that was counted.
struct Saving {
  /// How many more the whole run takes with the effect than without it: what leaving it out saves.
  /// Less than 0: so many are saved by having it.
  double instructions = 0;
  std::string is;  ///< what was counted

  /// The same, with something said beside it.
  Saving and_more(const std::string& words) const { return {instructions, is + "; " + words}; }
};

/// What a plan says of one effect.
struct Decision {
  Effect effect = Effect::gravity;  ///< which effect
  bool on = true;                   ///< whether the simulation has it
  bool planned = true;              ///< the same before anybody overrode it
  bool overridden = false;          ///< whether somebody did
  bool proven = false;              ///< by `because`; else "not proven": the safe choice
  std::string why;                  ///< the theorem that decided, or why none did
  std::vector<Inequality> because;  ///< with what numbers; failed ones if nothing is proven
  double error = 0;                 ///< position error accepted, m
  std::string error_is = "none";    ///< the same in words
  Saving saving;                    ///< what leaving it out saves, estimated
  std::optional<double> value;      ///< of a step size (s) or a horizon (s)
  std::vector<Proof> tried;         ///< every proof that the rule tried, in order
};

/// The decision that a rule's proofs make.
/// @param not_proven what to say then
Decision decide(Effect effect, std::vector<Proof> proofs, const std::string& not_proven);

/// Effects that somebody forces on or off, whatever the plan says.
struct Overrides {
  std::vector<Effect> with;     ///< forced on
  std::vector<Effect> without;  ///< forced off
};

/// What a plan is asked with.
struct PlanOptions {
  std::optional<double> step;  ///< s, greater than 0; without it the tolerance chooses
  Overrides overrides;         ///< last word on what is on
};

/// The decisions on a scene, one for each effect in the order of all_effects, and what a reader
/// must know beside them.
struct Plan {
  std::vector<Decision> decisions;   ///< as many as there are effects
  std::vector<std::string> notices;  ///< sentences, such as that the tolerance outlives the horizon
  double tolerance = 0;              ///< of a place, m; 0: no error is accepted
  /// m; of the errors that decisions accept, all together; ∞ if one has no bound, or if an effect
  /// is forced off that the plan has on
  double error = 0;
  double speed = 0;  ///< no centre of mass is ever faster, m/s
  double step = 0;   ///< s; 0: no steps, from event to event
  /// s; shorter hops of a ball on its floor are left out; 0: none that an error would tell
  double cutoff = 0;
  double rest_height = 0;  ///< hops no higher than this are left out in steps, m; 0: none is
  double sleep_speed = 0;  ///< what is slower for a while may sleep in steps, m/s
  double spring_part = 0;  ///< s; no part of a step is longer while a spring may push; 0: none does
  std::size_t pairs = 0;   ///< of bodies that may meet; a crowd counts all its pairs
};

/// The decision on an effect.
inline const Decision& decision_on(const Plan& plan, Effect effect) {
  return plan.decisions[static_cast<std::size_t>(effect)];
}

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/plan_types.cpp"
#endif
