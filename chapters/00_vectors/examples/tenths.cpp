// Why 0.1 + 0.2 is not 0.3: the three numbers as they are stored, to their last digit.
#include <contact/error_free.hpp>
#include <cstdio>

int main() {
  std::printf("0.1 is %.55f\n", 0.1);
  std::printf("0.2 is %.54f\n", 0.2);
  std::printf("0.3 is %.54f\n", 0.3);
  const auto sum = contact::two_sum(0.1, 0.2);
  std::printf("sum    %.54f\n", sum.value);
  std::printf("rounded by %.17g, which is %g ulp\n", -sum.error,
              -sum.error / contact::ulp(sum.value));
  std::printf("0.1 + 0.2 == 0.3 is %s\n", 0.1 + 0.2 == 0.3 ? "true" : "false");
  std::printf("0.1f + 0.2f == 0.3f is %s\n", 0.1f + 0.2f == 0.3f ? "true" : "false");
}
