// Newton's cradle by pairs, with springs, and as elastic spheres. Then a row in which the order of
// the pairs matters.
#include <contact/cradle.hpp>
#include <cstdio>

namespace {

void print(const char* how, const contact::RowOutcome<double>& outcome) {
  std::printf("%-22s", how);
  for (const double v : outcome.velocities) std::printf(" %6.3f", v + 0.0);
  std::printf("\n");
}

}  // namespace

int main() {
  using contact::PairOrder;
  const std::vector<contact::LineBody<double>> cradle{{1, 1}, {1, 0}, {1, 0}, {1, 0}, {1, 0}};
  print("pairs", contact::collide_row(cradle, 1.0, PairOrder::fastest_first, 100));
  print("springs", contact::row_on_springs(cradle, contact::ContactSpring::linear, 4000));
  print("elastic spheres", contact::row_on_springs(cradle, contact::ContactSpring::hertz, 4000));

  const std::vector<contact::LineBody<double>> row{{4, 1}, {1, 0}, {2, -0.5}};
  std::printf("4 kg at 1 m/s, 1 kg at rest, 2 kg at -0.5 m/s, pairs with e = 0.5:\n");
  print("pairs, from the left", contact::collide_row(row, 0.5, PairOrder::left_to_right, 100));
  print("pairs, from the right", contact::collide_row(row, 0.5, PairOrder::right_to_left, 100));
  print("springs (e = 1)", contact::row_on_springs(row, contact::ContactSpring::linear, 4000));
}
