// misconception: separation-without-sign
// caught by: nobody passes through
#include "did_they_stick.hpp"

namespace exercise {

Report report(const Before& before, double second_after) {
  const double first_after = before.first_velocity + before.second_mass *
                                                         (before.second_velocity - second_after) /
                                                         before.first_mass;
  const double restitution =
      std::abs(second_after - first_after) / (before.first_velocity - before.second_velocity);
  Kind kind = Kind::inelastic;
  if (restitution < 0) kind = Kind::passed_through;
  if (restitution == 0) kind = Kind::together;
  if (restitution == 1) kind = Kind::elastic;
  if (restitution > 1) kind = Kind::energy_gained;
  return {first_after, restitution, kind};
}

}  // namespace exercise
