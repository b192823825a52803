#include "events_or_steps.hpp"

namespace exercise {

Run plan_run(const Ball& ball, double duration, double tolerance, int budget) {
  //? This is the answer whenever events are too many.
  const Run steps{false, 0, 0, 0};
  //? The run by events is counted until something speaks against it.
  Run run{true, 0, 0, 0};
  //? The first impact follows from h = gt²/2.
  //? gap: 2 * ball.drop / ball.gravity
  double impact = std::sqrt(2 * ball.drop / ball.gravity);
  //? With k times the speed the ball flies up and down, and reaches k² times the height.
  //? gap: 2 * ball.k * impact
  //? gap: ball.k * ball.k * ball.drop
  double flight = 2 * ball.k * impact;          // of the bounce that begins there
  double height = ball.k * ball.k * ball.drop;  // of that bounce
  //? Only impacts within the duration count.
  //? gap: impact <= duration
  while (impact <= duration) {
    //? One more impact would exceed the budget.
    //? gap: run.impacts == budget
    if (run.impacts == budget) return steps;
    //? The impact happens.
    ++run.impacts;
    //? A bounce below the tolerance may be left out: the ball rests from here on. The error is the
    //? height of that bounce, and all flights left out are a geometric series.
    //? gap: height <= tolerance
    //? gap: flight / (1 - ball.k)
    if (height <= tolerance) {
      run.error = height;
      run.early = flight / (1 - ball.k);
      return run;
    }
    //? The next bounce has k times the time and k² times the height.
    //? gap: flight *= ball.k
    impact += flight;
    flight *= ball.k;
    height *= ball.k * ball.k;
  }
  //? The duration ended before the bounces did.
  return run;
}

}  // namespace exercise
