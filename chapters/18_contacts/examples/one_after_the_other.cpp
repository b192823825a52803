// A box that falls flat, without loss: the corners one after the other, in both orders, and both at
// once.
#include <contact/two_contacts.hpp>
#include <cstdio>

namespace {

constexpr double mass = 1, width = 2, height = 1;  // kg, m
constexpr double inertia = mass * (width * width + height * height) / 12;

/// How the box moves: its centre upwards, m/s, and counter-clockwise, rad/s.
struct Motion {
  double velocity = -1;
  double angular_velocity = 0;
};

Motion after_impulse(Motion motion, double lever_arm, double impulse) {
  motion.velocity += impulse / mass;
  motion.angular_velocity += lever_arm * impulse / inertia;
  return motion;
}

/// The corner with this lever arm leaves as fast as it arrives.
Motion after_corner(const Motion& motion, double lever_arm) {
  const double velocity = motion.velocity + motion.angular_velocity * lever_arm;
  if (velocity >= 0) return motion;
  return after_impulse(motion, lever_arm,
                       -2 * velocity / (1 / mass + lever_arm * lever_arm / inertia));
}

void print(const char* name, const Motion& m) {
  const double energy =
      (mass * m.velocity * m.velocity + inertia * m.angular_velocity * m.angular_velocity) / 2;
  std::printf("%-22s %7.4f m/s  %8.4f rad/s  energy %.2f J\n", name, m.velocity, m.angular_velocity,
              energy);
}

}  // namespace

int main() {
  const double left = -width / 2, right = width / 2;
  print("before", Motion{});
  print("left, then right", after_corner(after_corner(Motion{}, left), right));
  print("right, then left", after_corner(after_corner(Motion{}, right), left));
  const double itself = 1 / mass + right * right / inertia;
  const double other = 1 / mass + left * right / inertia;
  const auto x = contact::solve_two_contacts<double>({itself, other, itself}, -2, -2);
  print("both at once", after_impulse(after_impulse(Motion{}, left, x->first), right, x->second));
}
