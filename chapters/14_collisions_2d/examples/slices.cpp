// The lecture's slices: a step of one second in three, so that two discs with crossing paths are
// sampled four times. At the first overlap the position of the sample before is taken.
#include <contact/billiard_table.hpp>
#include <cstdio>

int main() {
  for (const double speed : {0.6, 1.0, 2.4}) {
    std::vector<contact::Disc<double>> discs{contact::disc<double>(1, 0.1, {-0.6, 0}, {speed, 0}),
                                             contact::disc<double>(1, 0.1, {0, -0.6}, {0, speed})};
    const auto right = contact::time_to_touch(discs[0], discs[1]);
    std::printf("%.1f m/s: touch at %.3f s\n", speed, *right);
    bool found = false;
    for (int look = 0; look <= 3 && !found; ++look) {
      if (look > 0) contact::move_on(discs, 1.0 / 3);
      const double gap = (discs[0].centre - discs[1].centre).norm() - 0.2;
      found = gap <= 0;
      std::printf("  sample at %.2f s: gap %+.3f m\n", look / 3.0, gap);
      if (found) std::printf("  found, and moved back to %.2f s\n", (look - 1) / 3.0);
    }
    if (!found) std::printf("  not found\n");
  }
}
