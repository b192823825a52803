// Three events at one time, added in every order; then one of the bodies is hit before that time.
#include <algorithm>
#include <array>
#include <contact/event_queue.hpp>
#include <cstdio>

int main() {
  struct Meeting {
    int first, second;
  };
  std::array<Meeting, 3> meetings{{{0, 1}, {2, -1}, {2, 3}}};
  std::array<int, 3> order{0, 1, 2};
  do {
    contact::EventQueue<double> queue(4);
    for (const int i : order) {
      const Meeting m = meetings[static_cast<std::size_t>(i)];
      queue.push(1.5, m.first, m.second);
    }
    std::printf("in: %d %d %d   out:", order[0], order[1], order[2]);
    while (const auto next = queue.pop()) std::printf("  %d with %d", next->first, next->second);
    std::printf("\n");
  } while (std::next_permutation(order.begin(), order.end()));

  contact::EventQueue<double> queue(4);
  for (const Meeting m : meetings) queue.push(1.5, m.first, m.second);
  queue.invalidate(2);
  queue.push(1.75, 2, 3);
  std::printf("body 2 is hit earlier:");
  while (const auto next = queue.pop()) {
    std::printf("  %d with %d at %.2f s", next->first, next->second, next->time);
  }
  std::printf("\n");
}
