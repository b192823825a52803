#include "support/questions.hpp"

#include <cmath>
#include <contact/events/hard_spheres.hpp>

#define CONTACT_FIGURE_NO_MAIN
#include <contact/figure.hpp>
#include "figures/four_posts.hpp"
namespace divergence {
#include "figures/divergence.cpp"
}

namespace questions_test {

KEY("hits-to-the-horizon") {
  double error = 1e-16;
  int hits = 0;
  for (; error <= 1e-3; ++hits) error *= 1 + 2 * 1.0 / 0.1;
  return static_cast<double>(hits);
}

KEY("one-more-digit") {
  const auto hits_from = [](double digits) {
    double hits = 0;
    for (double lost = 0; lost < digits; lost += std::log10(21.0)) ++hits;
    return hits;
  };
  const double factor = hits_from(100) / hits_from(16);
  return factor > 5 && factor < 9 ? 0 : factor < 1.1 ? 2 : 1;
}

KEY("diverge-quickly") {
  const auto with_aim = [](double x, double y) {
    divergence::Input in;
    in.from = {0.5, 1.6};
    in.to = {x, y};
    in.digits = 15;
    in.post = 0.3;
    in.shown = 40;
    return divergence::compute(in).quick;
  };
  double winning = 0;
  for (int k = 0; k < 40 && winning == 0; ++k) winning = with_aim(0.6 + 0.08 * k, 2.2);
  return questions::Construct{winning, with_aim(2.4, 2.6)};
}

}  // namespace questions_test
