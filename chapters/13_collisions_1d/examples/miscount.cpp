// How many close cases each method miscounts: mass ratios within 2 ulp of cot²(π/n), for every
// tenth n up to 5000.
#include <contact/block_count.hpp>
#include <cstdio>

int main() {
  int asked = 0;
  int formula = 0;
  int textbook = 0;
  int book = 0;
  int more_digits = 0;
  for (int n = 10; n <= 5000; n += 10) {
    for (int ulps = -2; ulps <= 2; ++ulps) {
      const double ratio = contact::close_call(n, ulps);
      const auto right = contact::count_collisions(ratio);
      ++asked;
      formula += contact::count_by_formula(ratio) != right;
      textbook += contact::count_by_textbook(ratio) != right;
      book += contact::count_by_colliding(ratio) != right;
      more_digits += contact::count_by_formula(contact::DoubleDouble(ratio)) != right;
    }
  }
  const auto share = [asked](int wrong) { return 100.0 * wrong / asked; };
  std::printf("of %d close cases, miscounted\n", asked);
  std::printf("  by the formula in double            %4d, %4.1f %%\n", formula, share(formula));
  std::printf("  simulation, textbook formulas       %4d, %4.1f %%\n", textbook, share(textbook));
  std::printf("  simulation, the book's formulas     %4d, %4.1f %%\n", book, share(book));
  std::printf("  by the formula with twice the bits  %4d\n", more_digits);
}
