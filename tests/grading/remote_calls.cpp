// Asks a far side that sends back what it is given, many times, and prints the median time of a
// call in microseconds.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include <contact/prelude.hpp>
#include <contact/remote.hpp>

namespace contact {
void todo() { std::abort(); }
}  // namespace contact

int main() {
  constexpr contact::remote::Contract contract{"specimen", 42};
  std::array<double, 20'001> times;
  for (double& time : times) {
    const auto start = std::chrono::steady_clock::now();
    contact::remote::call<double>(contract, 0, 1.5);
    time =
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
  }
  std::sort(times.begin(), times.end());
  std::printf("%.2f\n", times[times.size() / 2]);
}
