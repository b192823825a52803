// misconception: none
// caught by: the scene may end before the ball rests
#include "events_or_steps.hpp"

namespace exercise {

Run plan_run(const Ball& ball, double duration, double tolerance, int budget) {
  const Run steps{false, 0, 0, 0};
  Run run{true, 0, 0, 0};
  double impact = std::sqrt(2 * ball.drop / ball.gravity);
  double flight = 2 * ball.k * impact;          // of the bounce that begins there
  double height = ball.k * ball.k * ball.drop;  // of that bounce
  while (impact < duration) {
    if (run.impacts == budget) return steps;
    ++run.impacts;
    if (height <= tolerance) {
      run.error = height;
      run.early = flight / (1 - ball.k);
      return run;
    }
    impact += flight;
    flight *= ball.k;
    height *= ball.k * ball.k;
  }
  return run;
}

}  // namespace exercise
