#include "drop_test.hpp"

namespace exercise {

double restitution(double drop, double rebound) {
  // The speed at the floor is √(2gh).
  //? In the ratio of rebound to impact 2g cancels, and the root of the ratio of heights is left.
  //? gap: rebound / drop
  return std::sqrt(rebound / drop);
}

double height_after(double drop, double k, int bounces) {
  //? Each bounce multiplies the speed by k and therefore the height by k².
  //? gap: k * k
  for (; bounces > 0; --bounces) drop *= k * k;
  //? After the last bounce this is the height.
  return drop;
}

}  // namespace exercise
