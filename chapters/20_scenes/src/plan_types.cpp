#include <contact/plan/plan_types.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <contact/scene/compiled.hpp>

namespace contact {

CONTACT_SCENES_INLINE std::string_view effect_name(Effect effect) {
  constexpr std::array<std::string_view, 17> names{
      "gravity",          "rotation",         "gyroscopic-term",
      "friction",         "restitution",      "continuous-detection",
      "broad-phase",      "several-contacts", "resting",
      "sleeping",         "penalty-contact",  "third-dimension",
      "second-dimension", "double-precision", "event-driven",
      "step-size",        "horizon"};
  return names[static_cast<std::size_t>(effect)];
}

// [holds]
CONTACT_SCENES_INLINE bool holds(const Inequality& condition) {
  switch (condition.relation) {
    case Relation::less:
      return condition.left < condition.right;
    case Relation::at_most:
      return condition.left <= condition.right;
    default:
      return condition.left == condition.right;
  }
}
// [/holds]

CONTACT_SCENES_INLINE bool is_proven(const Proof& proof) {
  if (proof.conditions.empty()) return false;
  for (const Inequality& condition : proof.conditions) {
    if (!holds(condition)) return false;
  }
  return true;
}

/// Makes a decision from a rule's proofs: the first proof that holds switches the effect off.
///
/// If none holds the effect stays on, and the decision contains the first failed condition of each
/// proof. So a rule that can prove nothing is never wrong; it only costs time.
/// @param not_proven what to say if none holds
// [decide]
CONTACT_SCENES_INLINE Decision decide(Effect effect, std::vector<Proof> proofs,
                                      const std::string& not_proven) {
  Decision decision;
  decision.effect = effect;
  decision.tried = std::move(proofs);
  for (const Proof& proof : decision.tried) {
    if (!is_proven(proof)) continue;
    decision.on = decision.planned = false;
    decision.proven = true;
    decision.why = proof.why;
    decision.because = proof.conditions;
    decision.error = proof.error;
    decision.error_is = proof.error_is;
    return decision;
  }
  decision.why = not_proven;
  for (const Proof& proof : decision.tried) {
    for (const Inequality& condition : proof.conditions) {
      if (holds(condition)) continue;
      decision.because.push_back(condition);
      break;
    }
  }
  return decision;
}
// [/decide]

}  // namespace contact
