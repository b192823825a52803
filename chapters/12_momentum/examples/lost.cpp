// A million small impulses and four sums.
#include <cmath>
#include <contact/impulse_sum.hpp>
#include <cstdio>

template <class S>
void show(const char* type, const std::vector<S>& impulses) {
  contact::Exact sum;
  double size = 0;
  for (const S x : impulses) {
    sum += contact::Exact(double(x));
    size += std::abs(double(x));
  }
  const auto error = [&](S got) {
    const auto off = rounded<double>(contact::Exact(double(got)) - sum);
    return std::abs(off) / size;
  };
  std::printf("%-6s recursive %.0e, pairwise %.0e, compensated %.0e, exact %.0e\n", type,
              error(contact::total_recursive(impulses)), error(contact::total_pairwise(impulses)),
              error(contact::total_compensated(impulses)), error(contact::total_exactly(impulses)));
}

int main() {
  std::printf("a million impulses of 0.1 N s: error relative to the sum of their sizes\n");
  show("float", std::vector<float>(1000000, 0.1f));
  show("double", std::vector<double>(1000000, 0.1));
}
