// Right answers are trapezoids without rounding, rounded once. Every test asks for at least two
// different answers, so that no constant passes one.
#include "force_curve.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::ForceEffect;
using exercise::Sample;
using Samples = std::vector<Sample>;

ForceEffect exact_push(const Samples& samples, double mass, double velocity) {
  Exact twice;  // the area
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    twice += (Exact(samples[i + 1].time) - Exact(samples[i].time)) *
             (Exact(samples[i].force) + Exact(samples[i + 1].force));
  }
  const Exact duration = Exact(samples.back().time) - Exact(samples.front().time);
  const Exact two(2.0);
  return {quotient<double>(twice, two), quotient<double>(twice, two * duration),
          quotient<double>(two * Exact(mass) * Exact(velocity) + twice, two * Exact(mass))};
}

double duration_of(const Samples& samples) { return samples.back().time - samples.front().time; }

enum class Mistake {
  peak,
  rectangles,
  right_rectangles,
  mean,
  equal_steps,
  without_sign,
  without_sign_of_pieces,
  not_divided
};

ForceEffect mistaken(const Samples& samples, double mass, double velocity, Mistake mistake) {
  const double duration = duration_of(samples);
  double impulse = 0;
  double peak = 0;
  double sum = 0;
  for (const Sample& sample : samples) {
    if (std::abs(sample.force) > std::abs(peak)) peak = sample.force;
    sum += sample.force;
  }
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    double width = samples[i + 1].time - samples[i].time;
    const double first = samples[i].force;
    const double second = samples[i + 1].force;
    double mean = (first + second) / 2;
    if (mistake == Mistake::rectangles) mean = first;
    if (mistake == Mistake::right_rectangles) mean = second;
    if (mistake == Mistake::without_sign) mean = (std::abs(first) + std::abs(second)) / 2;
    if (mistake == Mistake::without_sign_of_pieces) mean = std::abs(mean);
    if (mistake == Mistake::equal_steps) width = duration / double(samples.size() - 1);
    impulse += width * mean;
  }
  if (mistake == Mistake::peak) impulse = peak * duration;
  if (mistake == Mistake::mean) impulse = sum / double(samples.size()) * duration;
  const double after = mistake == Mistake::not_divided ? impulse : impulse / mass;
  return {impulse, impulse / duration, velocity + after};
}

/// Each piece has four roundings, then one for each sum; the quotients and the last sum add three,
/// and the oracle one.
ForceEffect bound(const Samples& samples, double mass, double velocity) {
  double size = 0;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    size += (samples[i + 1].time - samples[i].time) *
            (std::abs(samples[i].force) + std::abs(samples[i + 1].force)) / 2;
  }
  const double impulse = 0x1p-53 * (static_cast<double>(samples.size()) + 8) * size;
  return {impulse, impulse / duration_of(samples),
          impulse / mass + 2 * 0x1p-53 * std::abs(velocity)};
}

void check(const Samples& samples, double mass, double velocity) {
  constexpr std::pair<std::string_view, Mistake> kMistakes[] = {
      {"impulse-for-velocity", Mistake::not_divided},
      {"area-without-sign", Mistake::without_sign},
      {"area-without-sign", Mistake::without_sign_of_pieces},
      {"rectangles-for-trapezoids", Mistake::rectangles},
      {"rectangles-for-trapezoids", Mistake::right_rectangles},
      {"mean-of-samples", Mistake::mean},
      {"mean-of-samples", Mistake::equal_steps},
      {"peak-force", Mistake::peak},
  };
  std::vector<Suspect<ForceEffect>> suspects;
  for (const auto& [id, mistake] : kMistakes) {
    suspects.push_back(
        {id, [&, mistake = mistake] { return mistaken(samples, mass, velocity, mistake); }});
  }
  ask("What are the impulse, the average force and the velocity afterwards?")
      .given("samples", samples)
      .given("mass", mass)
      .given("velocity", velocity)
      .suspects(std::move(suspects))
      .answer([&] { return exercise::apply_force(samples, mass, velocity); })
      .close_to(exact_push(samples, mass, velocity), within(bound(samples, mass, velocity)));
}

}  // namespace

TEST_CASE("under a constant force the area is a rectangle") {
  check({{0, 6}, {2, 6}}, 1, 0);
  check({{1, -4}, {1.5, -4}, {2, -4}}, 1, 0);
}

TEST_CASE("the area under a rising and falling force is that of trapezoids") {
  check({{0, 0}, {1, 10}, {2, 0}}, 1, 0);
  check({{0, 2}, {1, 10}}, 1, 0);
  check({{3, 8}, {4, 4}, {5, 16}, {6, 1}}, 1, 0);
}

TEST_CASE("samples need not be equally spaced") {
  check({{0, 8}, {1, 4}, {4, 2}}, 1, 0);
  check({{0, 2}, {0.5, 4}, {0.75, 8}, {8, 0}}, 1, 0);
}

TEST_CASE("a force that reverses has negative area") {
  check({{0, 8}, {1, -6}, {2, -4}}, 1, 0);
  check({{0, -2}, {1, -4}, {2, -4}}, 1, 0);
  check({{0, 5}, {2, -5}}, 1, 0);
}

TEST_CASE("the velocity changes by impulse over mass") {
  check({{0, 6}, {2, 6}}, 4, 0);
  check({{0, 6}, {2, 6}}, 4, -3);
  check({{0, 0}, {1, 10}, {2, 0}}, 0.5, -8);
}

TEST_CASE("random curves agree with exact arithmetic") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 300; ++asked) {
    Samples samples;
    double time = random.uniform(-2, 2);
    for (int n = random.integer(2, 12); n > 0; --n) {
      samples.push_back({time, random.uniform(-9, 9)});
      time += random.uniform(0.01, 1);
    }
    const double mass = random.uniform(0.2, 5);
    check(samples, mass, random.uniform(-9, 9));
  }
}
