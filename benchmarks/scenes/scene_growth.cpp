// How hard balls grow: a dilute gas of n balls for some seconds, in events, bytes and time.
// usage: scene_growth N [seconds]
//
// Instructions are counted by valgrind, of the run alone and not of what sets it up:
//   valgrind --tool=callgrind --callgrind-out-file=/dev/null --collect-atstart=no
//            --toggle-collect=run_gas build/release/bin/scene_growth 1000
#include <chrono>
#include <contact/hard_spheres.hpp>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace {

using Gas = contact::HardSpheres<contact::HardSphereEffects{3, false, false, false, false, true}>;

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

/// What is counted; its name is how valgrind finds it.
extern "C" void run_gas(void* gas, double seconds);
extern "C" [[gnu::noinline]] void run_gas(void* gas, double seconds) {
  static_cast<Gas*>(gas)->advance(seconds);
}

int main(int argc, char** argv) {
  const long n = argc > 1 ? std::atol(argv[1]) : 0;
  const double seconds = argc > 2 ? std::atof(argv[2]) : 10;
  if (n < 1 || !(seconds > 0)) {
    std::fprintf(stderr, "usage: scene_growth N [seconds]\n");
    return 2;
  }
  Gas gas(contact::dilute_gas(static_cast<std::size_t>(n), 6));
  const double energy = gas.energy();
  const auto start = std::chrono::steady_clock::now();
  const double processor = processor_seconds();
  run_gas(&gas, seconds);
  const double busy = processor_seconds() - processor;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  const contact::HardSphereCounts counts = gas.counts();
  std::printf(
      "%ld balls, %g s: %llu hits, %llu cells crossed, %zu bytes, %.3f s of processor, "
      "%.3f s on the clock, energy change %+.1e, largest overlap %.1e m\n",
      n, seconds, static_cast<unsigned long long>(counts.hits),
      static_cast<unsigned long long>(counts.crossings), gas.bytes(), busy, elapsed.count(),
      gas.energy() / energy - 1, counts.largest_overlap);
}
