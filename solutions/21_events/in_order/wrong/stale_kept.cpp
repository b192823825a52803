// misconception: stale-meetings-kept
// caught by: a chain of three
// seen: https://github.com/hannorein/rebound/issues/440
//   entries of a list of collisions become outdated by earlier ones
#include "in_order.hpp"

namespace exercise {

std::vector<Meeting> meetings(const std::vector<Bead>& beads, double until) {
  std::vector<Bead> now = beads;  // where each would have been at time 0
  std::vector<Meeting> queue;
  std::vector<Meeting> list;
  double clock = 0;
  const auto look = [&](int left) {
    const auto i = static_cast<std::size_t>(left);
    if (left < 0 || i + 1 >= now.size()) return;
    const double closing = now[i].velocity - now[i + 1].velocity;
    if (!(closing > 0)) return;
    const double time = (now[i + 1].position - now[i].position) / closing;
    queue.push_back({std::max(clock, time), left});
  };
  for (int i = 0; i + 1 < static_cast<int>(now.size()); ++i) look(i);
  while (!queue.empty() && list.size() < 1000) {
    const auto next =
        std::min_element(queue.begin(), queue.end(), [](const auto& a, const auto& b) {
          return a.time < b.time || (a.time == b.time && a.left < b.left);
        });
    const Meeting meeting = *next;
    queue.erase(next);
    if (meeting.time > until) break;
    clock = meeting.time;
    const auto i = static_cast<std::size_t>(meeting.left);
    std::swap(now[i], now[i + 1]);
    list.push_back(meeting);
    look(meeting.left - 1);
    look(meeting.left + 1);
  }
  return list;
}

}  // namespace exercise
