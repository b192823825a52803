// The spacing of numbers at positions and times that occur in scenes.
#include <contact/error_free.hpp>
#include <cstdio>

int main() {
  const auto line = [](const char* what, double x, const char* unit) {
    std::printf("%-22s float %-9.3g double %-9.3g %s\n", what,
                double(contact::ulp(static_cast<float>(x))), contact::ulp(x), unit);
  };
  line("1 m", 1, "m");
  line("10 km", 10000, "m");
  line("round the Earth", 4.0e7, "m");
  line("an hour", 3600, "s");
  line("a day", 86400, "s");

  // A single-precision clock that advances in steps of 1/60 s.
  float by_steps = 0;
  const int steps = 60 * 3600;
  for (int i = 0; i < steps; ++i) by_steps += 1.0f / 60.0f;
  const float at_once = static_cast<float>(steps) / 60.0f;
  std::printf("an hour of steps: %.1f s added up, %.1f s multiplied\n", double(by_steps),
              double(at_once));
}
