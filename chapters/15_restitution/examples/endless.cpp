// A ball dropped from 1 m with k = 0.8: infinitely many bounces in four seconds.
#include <contact/bouncing.hpp>
#include <cstdio>

int main() {
  const auto ball = contact::bouncing_ball(1.0, 0.0, 9.81, 0.8);
  std::printf("first impact after %.4f s at %.4f m/s\n", contact::first_impact_time(ball),
              contact::impact_speed(ball));
  for (const long long n : {1, 2, 3, 4, 5, 10, 20, 40}) {
    const double after = contact::impact_time(ball, n);
    std::printf(
        "impact %2lld after %.6f s, then up to %.3g mm\n", n, after,
        1000 * contact::bounce_at(ball, (after + contact::impact_time(ball, n + 1)) / 2).height);
  }
  const double end = contact::rest_time(ball);
  std::printf("at rest after %.6f s\n", end);
  for (const double before : {1.0, 0.1, 0.01, 0.001, 0.000001}) {
    std::printf("%g s before the end: %g impacts so far\n", before,
                contact::bounces_by(ball, end - before));
  }
}
