// Elastic balls on a line, on a table or in a box, simulated by one of the ladder's methods and, as
// the truth, from event to event in double-double arithmetic.
#include "compared_balls.hpp"

#include <algorithm>
#include <contact/figure.hpp>

using contact::DoubleDouble;
using contact::HardSphereEffects;
using Vector = contact::Vector3<double>;

inline constexpr std::size_t most = 9;

struct Input {
  double motion;  // 0: five balls on a line; 1: nine on a table; 2: eight in a box, with gravity
  double method;  // 0, 1: tests at the end of steps of 1/60 s and 1/240 s; 2, 3: events by a plain
                  // loop, float and double; 4: events with all effects on; 5: as planned
  std::array<std::array<double, 6>, most> balls;  // of each the centre, m, and the velocity, m/s
  double at;                                      // the time that is shown, s
};

inline constexpr std::size_t samples = 61;
inline constexpr double rate = 60;        // samples a second
inline constexpr double rounding = 1e-6;  // of a time in single precision, at most, s

struct Output {
  double problem;
  double count, room, seconds;  // balls, m, s
  // Both coordinates of each ball at each sample: x and y, of a box x and z.
  std::array<std::array<double, 2 * most>, samples> got, right;
  std::array<double, samples> apart;   // the largest distance of a ball from where it should be, m
  double read;                         // the same at the time
  double hits, right_hits;             // in all
  double at_the_end;                   // the largest distance at the end, m
  double overlap;                      // the deepest that occurred, m
  double energy_change, right_change;  // relative
};

namespace {

using Places = std::array<Vector, most>;
using Course = compared_balls::Course;

/// Where the balls are at each sample: `watch` of a plain loop or of steps.
template <class S>
class Sampler {
 public:
  Sampler(const compared_balls::Setting& setting, std::array<Places, samples>& places)
      : setting_(&setting), places_(&places) {}

  void operator()(const compared_balls::Balls<S>& all, const S& left, const S& flight) const {
    const double now = setting_->time - compared_balls::as_double(left);
    const double until = now + compared_balls::as_double(flight);
    for (std::size_t k = 0; k < samples; ++k) {
      const double time = static_cast<double>(k) / rate;
      if (time > until + rounding || time < now - rounding) continue;
      compared_balls::Balls<S> then = all;
      const double rest = std::max(0.0, time - now);
      if (rest > rounding) compared_balls::fly(then, *setting_, S(rest));
      for (std::size_t i = 0; i < then.size(); ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          (*places_)[k][i](static_cast<Eigen::Index>(axis)) =
              compared_balls::as_double(then[i].x[axis]);
        }
      }
    }
  }

 private:
  const compared_balls::Setting* setting_;
  std::array<Places, samples>* places_;
};

template <HardSphereEffects E>
void sample_composed(const compared_balls::Setting& setting, std::array<Places, samples>& places) {
  contact::HardSpheres<E> run(setting.setup);
  for (std::size_t k = 0; k < samples; ++k) {
    const double time = static_cast<double>(k) / rate;
    if (time > setting.time + rounding) break;
    run.advance(std::min(time, setting.time));
    for (std::size_t i = 0; i < run.moving(); ++i) places[k][i] = run.position(i);
  }
}

Course simulated(const compared_balls::Setting& setting, int method,
                 std::array<Places, samples>& places) {
  switch (method) {
    case 0:
    case 1:
      Sampler<double>(setting, places)(compared_balls::start<double>(setting), setting.time, 0);
      return compared_balls::in_steps(setting, method == 0 ? 60 : 240,
                                      Sampler<double>(setting, places));
    case 2:
      return compared_balls::plain_loop<float>(setting, Sampler<float>(setting, places));
    case 3:
      return compared_balls::plain_loop<double>(setting, Sampler<double>(setting, places));
    default:
      break;
  }
  // With all effects and as planned the bits are the same.
  sample_composed<HardSphereEffects{}>(setting, places);
  return method == 4 ? compared_balls::composed<HardSphereEffects{}>(setting)
                     : compared_balls::planned(setting);
}

/// Whether the balls are between the walls and do not overlap.
bool apart_at_first(const compared_balls::Setting& setting, Eigen::Index dimension) {
  const auto& balls = setting.setup.balls;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    for (Eigen::Index k = 0; k < dimension; ++k) {
      const double x = balls[i].position(k);
      if (!(x >= compared_balls::radius && x <= setting.room - compared_balls::radius))
        return false;
    }
    for (std::size_t k = 0; k < i; ++k) {
      if ((balls[i].position - balls[k].position).norm() < 2 * compared_balls::radius) return false;
    }
  }
  return true;
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  const auto choice = static_cast<int>(std::nearbyint(std::clamp(in.motion, 0.0, 2.0)));
  const auto motion = static_cast<compared_balls::Motion>(choice);
  compared_balls::Setting setting = compared_balls::empty_room(motion);
  const Eigen::Index dimension = choice + 1;
  const std::size_t count = choice == 0 ? 5 : choice == 1 ? 9 : 8;
  for (std::size_t i = 0; i < count; ++i) {
    contact::HardBall ball;
    ball.radius = compared_balls::radius;
    ball.mass = 1;
    for (Eigen::Index k = 0; k < dimension; ++k) {
      ball.position(k) = in.balls[i][static_cast<std::size_t>(k)];
      ball.velocity(k) = in.balls[i][static_cast<std::size_t>(k + 3)];
    }
    if (ball.velocity.cwiseAbs().maxCoeff() > 20) out.problem = contact::figure::too_large;
    setting.setup.balls.push_back(ball);
  }
  if (out.problem == 0 && !apart_at_first(setting, dimension))
    out.problem = contact::figure::coincident_points;
  if (out.problem != 0) return out;

  out.count = static_cast<double>(count);
  out.room = setting.room;
  out.seconds = setting.time;
  std::array<Places, samples> got{};
  std::array<Places, samples> right{};
  const auto method = static_cast<int>(std::nearbyint(std::clamp(in.method, 0.0, 5.0)));
  const Course truth =
      compared_balls::plain_loop<DoubleDouble>(setting, Sampler<DoubleDouble>(setting, right));
  const Course course = simulated(setting, method, got);
  const auto last = static_cast<std::size_t>(std::nearbyint(setting.time * rate));
  const Eigen::Index up = choice == 2 ? 2 : 1;
  for (std::size_t k = 0; k < samples; ++k) {
    const std::size_t from = std::min(k, last);
    for (std::size_t i = 0; i < count; ++i) {
      out.got[k][2 * i] = got[from][i].x();
      out.got[k][2 * i + 1] = got[from][i](up);
      out.right[k][2 * i] = right[from][i].x();
      out.right[k][2 * i + 1] = right[from][i](up);
      out.apart[k] = std::max(out.apart[k], (got[from][i] - right[from][i]).norm());
    }
  }
  out.read = out.apart[static_cast<std::size_t>(
      std::nearbyint(std::clamp(in.at, 0.0, setting.time) * rate))];
  out.hits = course.hits;
  out.right_hits = truth.hits;
  for (std::size_t i = 0; i < count; ++i)
    out.at_the_end = std::max(out.at_the_end, (course.positions[i] - truth.positions[i]).norm());
  out.overlap = course.overlap;
  out.energy_change = course.energy_change;
  out.right_change = truth.energy_change;
  return out;
}

FIGURE(Input, FIELDS(motion, method, balls, at), Output,
       FIELDS(problem, count, room, seconds, got, right, apart, read, hits, right_hits, at_the_end,
              overlap, energy_change, right_change))
