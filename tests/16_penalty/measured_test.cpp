// What the ladder of the chapter says: where penalty forces become more accurate than impulses in
// steps, and that its truths are right where they are known.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/hertz.hpp>
#include <vector>

#include "measured_bounce.hpp"
#include "measured_contact.hpp"
#include "measured_hertz.hpp"
#include "support/generators.hpp"

namespace {

using contact::PenaltyScheme;
using contact::StepRule;
using measured_bounce::Input;
using measured_bounce::Setting;

/// As many in every build: medians of fewer depend on where the steps fall.
std::vector<Input> drops(double least, double most, int count = 160) {
  generators::Random random(1);
  std::vector<Input> all;
  for (int i = 0; i < count; ++i) {
    all.push_back(measured_bounce::drop(random, -1, 2, least, most));
  }
  return all;
}

template <class Method>
double median_error(const std::vector<Input>& inputs, const Method& method) {
  std::vector<double> errors;
  for (const Input& input : inputs) {
    errors.push_back(std::abs(method(input) - measured_bounce::truth(input)));
  }
  return ladder::spread(std::move(errors)).median;
}

double of_penalty(const std::vector<Input>& inputs, PenaltyScheme scheme, double step) {
  const Setting setting{"", "", scheme, measured_bounce::medium, step};
  return median_error(
      inputs, [&setting](const Input& input) { return measured_bounce::in_steps(input, setting); });
}

double of_impulses(const std::vector<Input>& inputs, double step) {
  return median_error(inputs, [step](const Input& input) {
    return measured_bounce::impulse_in_steps(input, StepRule::new_velocity, step);
  });
}

}  // namespace

TEST_CASE("without loss, at equal steps a spring overtakes impulses at about 1/10,000 s") {
  const std::vector<Input> inputs = drops(1, 1, 2000);
  const double longer = 1.0 / 8000, shorter = 1.0 / 12500;
  const double in_longer = of_impulses(inputs, longer), in_shorter = of_impulses(inputs, shorter);
  for (const auto scheme : {PenaltyScheme::semi_implicit_euler, PenaltyScheme::velocity_verlet}) {
    CHECK(of_penalty(inputs, scheme, longer) > 1.1 * in_longer);
    CHECK(of_penalty(inputs, scheme, shorter) < in_shorter / 1.1);
  }
}

TEST_CASE(
    "without loss, half the step halves the error of impulses and quarters that of a spring") {
  const std::vector<Input> inputs = drops(1, 1, 2000);
  const auto between = [](double ratio, double low, double high) {
    return low < ratio && ratio < high;
  };
  for (const double step : {1.0 / 1500, 1.0 / 4000}) {
    CHECK(between(of_impulses(inputs, step) / of_impulses(inputs, step / 2), 1.7, 2.3));
    const auto scheme = PenaltyScheme::semi_implicit_euler;
    CHECK(
        between(of_penalty(inputs, scheme, step) / of_penalty(inputs, scheme, step / 2), 3.4, 4.6));
  }
}

// Times are not measured here. In the measurements of the ladder a step of the loop took 3 to 6
// times as long as one of the spring, so in equal time its steps are as many times longer.
TEST_CASE("without loss, at equal time a spring overtakes impulses from 1/1,500 to 1/5,000 s") {
  const std::vector<Input> inputs = drops(1, 1, 2000);
  const double longer = 1.0 / 1500, shorter = 1.0 / 5000;
  for (const double time_of_step : {3.0, 6.0}) {
    CHECK(of_penalty(inputs, PenaltyScheme::semi_implicit_euler, longer) >
          of_impulses(inputs, time_of_step * longer));
    CHECK(of_penalty(inputs, PenaltyScheme::semi_implicit_euler, shorter) <
          of_impulses(inputs, time_of_step * shorter));
  }
}

TEST_CASE("with a damper, gravity and the overlap at release keep penalty forces from overtaking") {
  const std::vector<Input> inputs = drops(0.5, 0.95);
  const double step = 1.0 / 8000;
  const double impulses = of_impulses(inputs, step);
  for (const auto scheme : {PenaltyScheme::semi_implicit_euler, PenaltyScheme::velocity_verlet,
                            PenaltyScheme::runge_kutta_4}) {
    CHECK(of_penalty(inputs, scheme, step) > 5 * impulses);
    CHECK(of_penalty(inputs, scheme, step / 4) > 5 * impulses);
  }
  // At equal time too.
  for (const double long_or_short : {1.0 / 1000, 1.0 / 8000, 1.0 / 32000}) {
    CHECK(of_penalty(inputs, PenaltyScheme::semi_implicit_euler, long_or_short) >
          1.5 * of_impulses(inputs, 6 * long_or_short));
  }
}

TEST_CASE("an impulse at the exact time needs no steps, and nothing is more accurate") {
  for (const Input& input : drops(0.05, 1)) {
    const double error = std::abs(measured_bounce::impulse(input) - measured_bounce::truth(input));
    CHECK(error <= 0x1p-50);
  }
}

TEST_CASE("the ladder's wide contact is right where its size is known") {
  using measured_contact::Impact;
  constexpr double pi = 3.141592653589793, inverse_of_e = 0.36787944117144233;
  const auto free = measured_contact::wide(Impact<double>{{4, 0}, 1, 3});
  CHECK(std::abs(free.duration - pi / 2) <= 0x1p-52);
  CHECK(free.depth == 1.5);
  const auto critical = measured_contact::wide(Impact<double>{{4, 4}, 1, 3});
  CHECK(critical.duration == 1);
  CHECK(std::abs(critical.depth - 1.5 * inverse_of_e) <= 0x1p-53);
}

TEST_CASE("the ladder's wide duration of Hertz's contact scales, and has the book's constant") {
  // With 5/4 m v² = κ the depth is 1.
  const double half = measured_hertz::wide_half_duration().high();
  CHECK(std::abs(measured_hertz::wide({{5}, 4, 1}) - 2 * half) <= 0x1p-51);
  CHECK(std::abs(2 * half - contact::hertz_duration_factor()) <= 0x1p-49);
  // 32 times the mass is 4 times as deep.
  CHECK(measured_hertz::wide({{5}, 128, 1}) == 4 * measured_hertz::wide({{5}, 4, 1}));
  // The midpoints after the substitution have no pole, so their error is small at once.
  CHECK(std::abs(measured_hertz::substituted({{5}, 4, 1}, 4000) - 2 * half) <= 1e-7);
}
