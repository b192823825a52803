#include "support/questions.hpp"

#include <algorithm>
#include <contact/event_queue.hpp>
#include <contact/events/earliest_queue.hpp>
#include <contact/events/hard_spheres.hpp>
#include <contact/plan/plan.hpp>
#include <contact/plan/plan_rules.hpp>
#include <tuple>
#include <vector>

#define CONTACT_FIGURE_NO_MAIN
#include <contact/figure.hpp>
namespace queue {
#include "figures/queue.cpp"
}

namespace questions_test {

KEY("stale-event") {
  // A, B, C are 0, 1, 2; the wall is −1. The events that are missing afterwards were stale.
  contact::EventQueue<double> queue(3);
  queue.push(1, 0, 1);
  queue.push(2, 1, 2);
  queue.push(3, 2, -1);
  const auto event = queue.pop();
  queue.invalidate(event->first);
  queue.invalidate(event->second);
  bool ball = false;
  bool wall = false;
  while (const auto next = queue.pop()) (next->second == -1 ? wall : ball) = true;
  return ball && wall ? 0 : wall ? 1 : ball ? 2 : 3;
}

KEY("two-at-once") {
  // A and B hit each other; C above A and D below B would hit them later.
  queue::Input in;
  in.position_a = {1, 1.5};
  in.velocity_a = {1, 0};
  in.position_b = {2, 1.5};
  in.velocity_b = {-1, 0};
  in.position_c = {1, 2.3};
  in.velocity_c = {1, -0.5};
  in.position_d = {2, 0.7};
  in.velocity_d = {-1, 0.5};
  in.position_e = {3.5, 2.5};
  in.position_f = {3.5, 1.5};
  in.position_g = {3.5, 0.5};
  in.velocity_e = in.velocity_f = in.velocity_g = {0, 0};
  const auto won = [&in] {
    double best = 0;
    for (in.event = 0; in.event <= 10; ++in.event)
      best = std::max(best, queue::compute(in).two_at_once);
    return best;
  };
  const double winning = won();
  // Aimed past them, C and D have predicted nothing about A and B.
  in.velocity_c = {-1, 0};
  in.velocity_d = {1, 0};
  return questions::Construct{winning, won()};
}

KEY("shortest-bounce") {
  // The cutoff leaves out bounces of half of the tolerance.
  return 1000 * contact::contact_time_cutoff(0.001, 10);
}

KEY("comparisons") {
  constexpr std::size_t slots = 1024;
  std::vector<double> time(slots);
  for (std::size_t i = 0; i < slots; ++i) time[i] = 10 + static_cast<double>(i);
  contact::EarliestQueue queue(slots);
  int count = 0;
  const auto before = [&](std::size_t i, std::size_t k) {
    ++count;
    return time[i] < time[k];
  };
  queue.play_all(before);
  int most = 0;
  for (std::size_t i = 0; i < slots; ++i) {
    count = 0;
    time[i] = -static_cast<double>(i) - 1;  // a new winner goes all the way up
    queue.update(i, before);
    most = std::max(most, count);
  }
  return static_cast<double>(most);
}

KEY("which-to-compute-anew") {
  // A third ball had planned to hit one of the two. If it were predicted anew at once, no plan
  // would ever be found stale.
  contact::HardSphereSetup setup;
  const auto add = [&setup](double x, double y, double vx, double vy) {
    contact::HardBall one;
    one.radius = 0.5;
    one.mass = 1;
    one.position = {x, y, 0};
    one.velocity = {vx, vy, 0};
    setup.balls.push_back(one);
  };
  add(0, 0, 1, 0);
  add(2, 0, 0, 0);
  add(2, 4, 0, -1);
  constexpr contact::HardSphereEffects plane{
      .dimension = 2, .gravity = false, .sizes = false, .restitution = false, .grid = false};
  contact::HardSpheres<plane> run(setup);
  run.advance(2);
  const auto early = run.counts();
  run.advance(4);
  const auto late = run.counts();
  return early.hits == 1 && early.stale == 0 && late.stale > 0 ? 1 : 2;
}

}  // namespace questions_test
