// Close cases of the count of collisions: mass ratios within two ulps of cot²(π/n), and which
// methods are right.
#include <contact/block_count.hpp>
#include <contact/figure.hpp>

struct Input {
  double n;  // n θ is nearly π
};

struct Output {
  double problem;
  std::array<double, 5> ratio;       // M/m at -2 to 2 ulps
  std::array<double, 5> right;       // the certain count
  std::array<double, 5> by_formula;  // and by three methods that round
  std::array<double, 5> by_textbook;
  std::array<double, 5> by_book;
  std::array<double, 3> wrong;  // counts of these three that are wrong, for n and the next nine
  double asked;                 // out of this many
};

Output compute(const Input& in) {
  Output out{};
  if (!(in.n >= 5)) out.problem = contact::figure::too_small;
  if (in.n > 5000) out.problem = contact::figure::too_large;
  if (out.problem != 0) return out;
  const int first = static_cast<int>(in.n);
  for (int n = first; n < first + 10; ++n) {
    for (int ulps = -2; ulps <= 2; ++ulps) {
      const double ratio = contact::close_call(n, ulps);
      const auto right = static_cast<double>(contact::count_collisions(ratio).value_or(-1));
      const std::array<double, 3> counted{static_cast<double>(contact::count_by_formula(ratio)),
                                          static_cast<double>(contact::count_by_textbook(ratio)),
                                          static_cast<double>(contact::count_by_colliding(ratio))};
      if (n == first) {
        const auto i = static_cast<std::size_t>(ulps + 2);
        out.ratio[i] = ratio;
        out.right[i] = right;
        out.by_formula[i] = counted[0];
        out.by_textbook[i] = counted[1];
        out.by_book[i] = counted[2];
      }
      for (std::size_t way = 0; way < 3; ++way) out.wrong[way] += counted[way] != right ? 1 : 0;
      out.asked += 1;
    }
  }
  return out;
}

FIGURE(Input, FIELDS(n), Output,
       FIELDS(problem, ratio, right, by_formula, by_textbook, by_book, wrong, asked))
