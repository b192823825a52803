#include "in_order.hpp"

namespace exercise {

std::vector<Meeting> meetings(const std::vector<Bead>& beads, double until) {
  std::vector<Bead> now = beads;
  std::vector<double> since(beads.size(), 0.0);  // when each bead was at its position
  std::vector<Meeting> list;
  double clock = 0;
  // Each exchange removes one inversion of the velocities, so this ends.
  while (true) {
    Meeting next{std::numeric_limits<double>::infinity(), -1};
    for (std::size_t i = 0; i + 1 < now.size(); ++i) {
      const double closing = now[i].velocity - now[i + 1].velocity;
      if (!(closing > 0)) continue;
      const auto position_of = [&](std::size_t j) {
        return now[j].position + now[j].velocity * (clock - since[j]);
      };
      const double time = clock + std::max(0.0, position_of(i + 1) - position_of(i)) / closing;
      if (time < next.time) next = {time, static_cast<int>(i)};
    }
    if (next.left < 0 || next.time > until) break;
    clock = next.time;
    const auto i = static_cast<std::size_t>(next.left);
    for (const std::size_t j : {i, i + 1}) {
      now[j].position += now[j].velocity * (clock - since[j]);
      since[j] = clock;
    }
    now[i + 1].position = now[i].position;
    std::swap(now[i].velocity, now[i + 1].velocity);
    list.push_back(next);
  }
  return list;
}

}  // namespace exercise
