#include "did_they_stick.hpp"

namespace exercise {

namespace {

[[maybe_unused]] Kind kind_of(double restitution) {
  if (restitution < 0) return Kind::passed_through;
  if (restitution == 0) return Kind::together;
  if (restitution == 1) return Kind::elastic;
  return restitution < 1 ? Kind::inelastic : Kind::energy_gained;
}

}  // namespace

Report report(const Before& /*before*/, double /*second_after*/) {
  // Complete: the velocity of the first body afterwards, from the total momentum; then the
  // coefficient of restitution. End with `return {first_after, restitution,
  // kind_of(restitution)};`.
  contact::todo();
}

}  // namespace exercise
