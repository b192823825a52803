/// @file
/// The planner's proofs and their hypotheses in one table: what each hypothesis says, why the proof
/// needs it, and a scene that refutes the proof without it. The rules make their conditions from
/// this table, the lesson shows it, and a test runs each scene.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <contact/plan/plan_types.hpp>

namespace contact {

/// A theorem of the planner.
struct ProofClaim {
  std::string_view id;     ///< "elastic-balls"
  std::string_view claim;  ///< one sentence
};

/// A hypothesis of a proof: one condition, or for two mirrors one of each.
struct Hypothesis {
  std::string_view id;         ///< "elastic-balls/no-springs": the proof, and which hypothesis
  std::string_view condition;  ///< what the left side of its inequality is, in words
  Relation relation = Relation::equal;  ///< how it is compared with the right side
  std::string_view right_is;            ///< what the right side is, in words
  std::string_view unit;                ///< of both sides; empty for counts and ratios
  std::string_view why;                 ///< what happens in a scene without it, one sentence
  /// The scene in tests/20_scenes/scenes/ that refutes the proof without this hypothesis.
  /// Empty if there is none in this model: then `why` says so.
  std::string_view scene;
};

/// The proofs, in the order of the lesson's table.
std::span<const ProofClaim> proof_claims();

/// The hypotheses of all proofs, in the order of proof_claims().
std::span<const Hypothesis> proof_hypotheses();

/// The claim of a proof.
/// @throws std::invalid_argument for an unknown id
std::string proof_claim(std::string_view id);

/// The hypothesis of that id.
/// @throws std::invalid_argument for an unknown id
const Hypothesis& proof_hypothesis(std::string_view id);

/// The condition that a hypothesis holds in a scene.
/// @param left, right the two sides in this scene, in the hypothesis's unit
/// @param dropped ids of hypotheses that are left out: their conditions hold whatever the scene
/// @throws std::invalid_argument for an unknown id
Inequality required(std::string_view id, double left, double right,
                    const std::vector<std::string>& dropped);

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/plan_hypotheses.cpp"
#endif
