// The number of collisions of the blocks. At powers of 100 it has the digits of π; elsewhere not.
#include <contact/block_count.hpp>
#include <cstdio>

int main() {
  double ratio = 1;
  for (int k = 0; k <= 12; k += 2, ratio *= 1e4) {
    std::printf("M/m = 1e%-3d %14lld\n", 2 * k,
                static_cast<long long>(*contact::count_collisions(ratio)));
  }
  for (const double other : {2.0, 16.0, 50.0, 1000.0}) {
    std::printf("M/m = %-5g %14lld\n", other,
                static_cast<long long>(*contact::count_collisions(other)));
  }
}
