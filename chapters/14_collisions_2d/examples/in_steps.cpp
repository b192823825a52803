// The same shot on the same table, in time steps and event-driven: the position of B after a
// second.
#include <contact/billiard_table.hpp>
#include <cstdio>

using Vector = contact::Vector2<double>;

std::vector<contact::Disc<double>> start() {
  return {contact::disc<double>(1, 0.1, {0.25, 0.4}, {1.5, 0.3}),
          contact::disc<double>(1, 0.1, {0.9, 0.65}, {0, 0})};
}

int main() {
  const contact::Table<double> table{1.6, 1.6, 1, 1};
  auto discs = start();
  std::printf("event-driven:\n");
  contact::play(table, discs, 1.0, 20, [](const auto& event, const auto& now) {
    if (event.second < 0) return;
    const Vector axis = now[1].centre - now[0].centre;
    std::printf("  touch at %.6f s, axis (%.3f, %.3f)\n", event.time, axis.x() / axis.norm(),
                axis.y() / axis.norm());
  });
  const Vector right = discs[1].centre;
  std::printf("  B is at (%.4f, %.4f)\n", right.x(), right.y());
  std::printf("step       B is off by\n");
  for (const int parts : {7, 20, 60, 200, 700, 2000, 7000}) {
    discs = start();
    contact::play_in_steps(table, discs, 1.0, 1.0 / parts, [](double, const auto&) {});
    std::printf("1/%-4d s   %.1e m\n", parts, (discs[1].centre - right).norm());
  }
}
