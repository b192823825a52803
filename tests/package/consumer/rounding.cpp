// Whether two numbers that are rounded to float stay rounded: GCC 12 leaves it out at -O2.
#include <contact/vector.hpp>
#include <iostream>

namespace {

struct Pair {
  double one, two;
};

[[gnu::noinline]] Pair rounded(const double* x) {
  const float one = static_cast<float>(x[0]);
  const float two = static_cast<float>(x[1]);
  return {static_cast<double>(one), static_cast<double>(two)};
}

}  // namespace

int main(int argc, char**) {
  const double numbers[] = {argc * 0.1, argc * 0.3};  // not known to the compiler
  const Pair pair = rounded(numbers);
  const bool both = pair.one != numbers[0] && pair.two != numbers[1];
  std::cout << (both ? "rounded" : "not rounded") << '\n';
}
