// Two readings of one formula for the time of a collision; their units distinguish them.
#include <cstdio>

int main() {
  const double start = 2;                           // m
  const double velocity = 12;                       // m/s
  const double step = 0.5;                          // s
  const double distance = 3;                        // m to the wall
  const double travelled = velocity * step;         // m
  const double fraction = distance / travelled;     // no unit
  const double time = distance * step / travelled;  // s
  std::printf("fraction of the step %.2f, time %.2f s\n", fraction, time);
  std::printf("start + velocity * time     = %.2f m\n", start + velocity * time);
  std::printf("start + velocity * fraction = %.2f m: m/s added to m\n",
              start + velocity * fraction);
}
