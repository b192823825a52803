// Heights of a drop, and the coefficient of restitution that they give.
#include <contact/bouncing.hpp>
#include <contact/restitution.hpp>
#include <cstdio>

int main() {
  // The rules of tennis: dropped from 254 cm on a hard floor, a ball comes back to 135 to 147 cm.
  for (const double rebound : {1.35, 1.47}) {
    std::printf("from 2.54 m to %.2f m: k = %.3f (ratio of heights %.3f)\n", rebound,
                contact::restitution_from_heights(2.54, rebound), rebound / 2.54);
  }
  // Several bounces measure it better than one: the n-th height is k^(2n) of the first.
  const double k = contact::restitution_from_heights(2.54, 1.41);
  const auto ball = contact::bouncing_ball(2.54, 0.0, 9.81, k);
  std::printf("k = %.3f:", k);
  for (long long n = 1; n <= 5; ++n) {
    const double top = (contact::impact_time(ball, n) + contact::impact_time(ball, n + 1)) / 2;
    std::printf(" %.2f m", contact::bounce_at(ball, top).height);
  }
  std::printf("\n");
}
