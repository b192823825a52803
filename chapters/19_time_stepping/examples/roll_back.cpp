// A ball dropped from 1 m in a step of 0.6 s: how closely slices and bisection find its impact, and
// with how many overlap tests.
#include <contact/bouncing.hpp>
#include <contact/rollback.hpp>
#include <cstdio>

int main() {
  const auto ball = contact::bouncing_ball(1.0, 0.0, 9.81, 0.8);
  const double impact = contact::first_impact_time(ball);
  const auto is_free = [&](double t) { return !(1.0 - 9.81 * t * t / 2 < 0); };
  std::printf("impact at %.9f s\n", impact);
  for (const int slices : {3, 30, 300}) {
    const auto found = *contact::last_free_slice(is_free, 0.6, slices);
    std::printf("%4d slices        free until %.9f s, %.1e s too early, %3d tests\n", slices,
                found.free, impact - found.free, found.tests);
  }
  for (const double width : {1e-2, 1e-4, 1e-8, 0.0}) {
    auto found = *contact::last_free_slice(is_free, 0.6, 1);
    found = contact::bisected(is_free, found, width);
    std::printf("halved to %5.0e s  free until %.9f s, %.1e s too early, %3d tests\n", width,
                found.free, impact - found.free, found.tests);
  }
  // A ball at 30 m/s and a pole of 5 cm in its path, in a step of 1/60 s.
  const auto past_pole = [](double t) { return 30 * t < 0.2 || 30 * t > 0.25; };
  for (const int slices : {1, 3, 5, 7, 10}) {
    const auto found = contact::last_free_slice(past_pole, 1.0 / 60, slices);
    std::printf("pole, %2d slices: %s\n", slices, found ? "found" : "missed");
  }
}
