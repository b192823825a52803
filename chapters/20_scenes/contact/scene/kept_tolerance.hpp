/// @file
/// What a run that has ended is known to be worth: until when its positions are within the
/// tolerance, and by what.
#pragma once

#include <string>

#include <contact/plan/plan_types.hpp>
#include <contact/scene/scene_run.hpp>

namespace contact {

/// How the first part of a run is known to be within the tolerance.
enum class KeptBy {
  not_asked,  ///< the scene has no tolerance of positions
  proof,      ///< every error has a proven bound
  estimate,   ///< no force varies within a step, and the horizon is estimated
  nothing     ///< there is no such part
};

/// The part of a run that is within the tolerance, from its start.
struct KeptTolerance {
  double asked = 0;               ///< m; 0: none
  double until = 0;               ///< s; after that no error is known
  double end = 0;                 ///< s; until when the run has gone
  KeptBy by = KeptBy::not_asked;  ///< of the part until then
  std::string why;                ///< what has no bound after that; empty if the part is all
  bool whole() const { return why.empty(); }  ///< whether the part is the whole run
};

/// Until when a run is known to be within its tolerance.
///
/// The plan bounds what it leaves out. What it cannot foresee the run records as doubts. From
/// the first of them on nothing is known, unless the plan has a bound for it. A run in steps has
/// constant forces in a substep, which end where these change. So before the first force that
/// varies within a substep, and before the horizon, only rounding errors remain: an estimate.
/// Errors spread by hits, so without a hit a run in steps is before its horizon. A part that a run
/// from event to event went on with in steps is not judged.
/// @param plan of the run
/// @param run at its end
KeptTolerance kept_tolerance(const Plan& plan, const SceneRun& run);

/// "proven", "estimated", "not known" or "not asked".
std::string kept_by_text(KeptBy by);

/// The same as one sentence.
std::string kept_tolerance_text(const KeptTolerance& kept);

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/kept_tolerance.cpp"
#endif
