#include "throwing.hpp"

namespace exercise {

double after_exchange(double mass, double velocity, double mass_change, double matter_velocity) {
  //? Momentum is conserved: body and matter together. Solved for the change, it is the relative
  //? velocity times the share of the matter in the new mass.
  //? gap: matter_velocity - velocity
  //? gap: (mass + mass_change)
  return velocity + (matter_velocity - velocity) * mass_change / (mass + mass_change);
}

double after_throws(double thrower, const std::vector<double>& stones, double velocity,
                    double relative) {
  //? After the last throw only the thrower is left; the mass before each throw is one stone more.
  // From the last stone backwards, the total mass grows by one stone each.
  double whole = thrower;
  //? The gains of all throws are summed.
  double gained = 0;
  //? From the last stone backwards, the total mass grows by one stone each.
  //? gap: stones.rbegin()
  for (auto stone = stones.rbegin(); stone != stones.rend(); ++stone) {
    //? Before the throw the stone is still part of the mass.
    whole += *stone;
    //? By conservation of momentum the thrower changes velocity by the stone's share of the whole
    //? mass, against the throw.
    //? gap: relative * *stone / whole
    gained -= relative * *stone / whole;
  }
  //? The gains add to the velocity at the start.
  return velocity + gained;
}

}  // namespace exercise
