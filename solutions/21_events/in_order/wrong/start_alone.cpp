// misconception: from-the-start-alone
// caught by: a chain of three
// seen: https://github.com/hannorein/rebound/issues/440
//   all collisions are listed before the first is resolved
#include "in_order.hpp"

namespace exercise {

std::vector<Meeting> meetings(const std::vector<Bead>& beads, double until) {
  std::vector<Meeting> list;
  for (std::size_t i = 0; i + 1 < beads.size(); ++i) {
    const double closing = beads[i].velocity - beads[i + 1].velocity;
    if (!(closing > 0)) continue;
    const double time = (beads[i + 1].position - beads[i].position) / closing;
    if (time <= until) list.push_back({time, static_cast<int>(i)});
  }
  std::stable_sort(list.begin(), list.end(),
                   [](const Meeting& a, const Meeting& b) { return a.time < b.time; });
  return list;
}

}  // namespace exercise
