// A dilute gas of N hard balls for some seconds: its events, bytes and times, as JSON.
// usage: scene_growth N [seconds]
//
// benchmarks/scene_growth.py runs it for growing N and counts the instructions of run_gas().
#include <chrono>
#include <contact/events/hard_spheres.hpp>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace {

using Gas = contact::HardSpheres<contact::HardSphereEffects{3, false, false, false, true}>;

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
      "{\"balls\": %ld, \"seconds\": %g, \"hits\": %llu, \"cells_crossed\": %llu, \"bytes\": %zu, "
      "\"processor_s\": %.4f, \"clock_s\": %.4f, \"energy_change\": %.1e, \"overlap_m\": %.1e}\n",
      n, seconds, static_cast<unsigned long long>(counts.hits),
      static_cast<unsigned long long>(counts.crossings), gas.bytes(), busy, elapsed.count(),
      gas.energy() / energy - 1, counts.largest_overlap);
}
