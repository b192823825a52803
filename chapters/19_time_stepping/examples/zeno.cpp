// A ball dropped from 1 m with k = 0.8 and g = 9.81, in one step of 5 s: what ends the advance, and
// when.
#include <contact/advance.hpp>
#include <contact/bouncing.hpp>
#include <cstdio>

int main() {
  using Vector = contact::Vector3<double>;
  const contact::Plane<double> floor{Vector(0, 0, 1), 0};
  const auto ball = contact::bouncing_ball(1.0, 0.0, 9.81, 0.8);
  std::printf("all impacts are over after %.6f s\n", contact::rest_time(ball));
  const auto show = [&](double rest_speed, int most) {
    const auto end = contact::advance_ballistic<double>(
        {Vector(0, 0, 1), Vector(0, 0, 0)}, Vector(0, 0, -9.81), 0.0, 5.0, {floor},
        contact::impact_rules(0.8, rest_speed, most));
    std::printf("rest speed %.3f m/s, at most %4d: %4d impacts, %s after %.6f s\n", rest_speed,
                most, end.impacts, end.end == contact::AdvanceEnd::rests ? "rests" : "stops",
                5 - end.time_left);
  };
  show(0.0, 10);
  show(0.0, 100);
  show(contact::rest_speed(0.001, 9.81), 1000);
  show(contact::rest_speed(0.000001, 9.81), 1000);
}
