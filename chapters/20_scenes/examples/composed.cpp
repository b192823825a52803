// A gas of 512 balls, simulated with the effects that it needs and with all of them: the same bits
// at different costs.
#include <contact/events/hard_spheres.hpp>
#include <cstdio>

namespace {

// [run]
constexpr contact::HardSphereEffects all;
constexpr contact::HardSphereEffects needed{.gravity = false, .sizes = false, .restitution = false};

template <contact::HardSphereEffects E>
contact::HardSphereCheckpoint run(const char* name, const contact::HardSphereSetup& setup) {
  contact::HardSpheres<E> balls(setup);
  balls.advance(5);
  const contact::HardSphereCounts did = balls.counts();
  std::printf("%-8s %3zu bytes of state a ball, %d hits, largest overlap %.0e m, energy %.17g J\n",
              name, balls.bytes_per_state(), static_cast<int>(did.hits), did.largest_overlap,
              balls.energy());
  return balls.checkpoint();
}
// [/run]

}  // namespace

int main() {
  const contact::HardSphereSetup setup = contact::dilute_gas(512, 1);
  const contact::HardSphereCheckpoint least = run<needed>("planned", setup);
  const contact::HardSphereCheckpoint most = run<all>("all", setup);
  bool same = true;
  for (std::size_t i = 0; i < least.balls.size(); ++i) {
    same = same && least.balls[i].position == most.balls[i].position &&
           least.balls[i].velocity == most.balls[i].velocity;
  }
  std::printf("%s\n", same ? "the same bits" : "different bits");
}
