// misconception: energy-ratio-for-restitution
// caught by: the truck and the parked car
#include "did_they_stick.hpp"

namespace exercise {

Report report(const Before& before, double second_after) {
  const double first_after = before.first_velocity + before.second_mass *
                                                         (before.second_velocity - second_after) /
                                                         before.first_mass;
  const auto energy = [&before](double v1, double v2) {
    return before.first_mass * v1 * v1 + before.second_mass * v2 * v2;
  };
  const double restitution =
      energy(first_after, second_after) / energy(before.first_velocity, before.second_velocity);
  Kind kind = Kind::inelastic;
  if (restitution < 0) kind = Kind::passed_through;
  if (restitution == 0) kind = Kind::together;
  if (restitution == 1) kind = Kind::elastic;
  if (restitution > 1) kind = Kind::energy_gained;
  return {first_after, restitution, kind};
}

}  // namespace exercise
