// When two moving bodies first touch: spheres by tests at the ends of slices, by bisection, by the
// quadratic as textbooks solve it, and exactly; boxes by slices, by what they sweep, by swept axes
// in float and double, by conservative advancement, and exactly; boxes that turn.
#include <support/ladder.hpp>

#include <11_time_of_impact/measured_boxes.hpp>
#include <11_time_of_impact/measured_spheres.hpp>
#include <11_time_of_impact/measured_turning.hpp>

namespace {

ladder::Parts experiment() {
  ladder::Parts parts("Time of impact: when do two moving bodies first touch?");
  parts.add(measured_spheres::experiment());
  parts.add(measured_boxes::experiment());
  parts.add(measured_turning::experiment());
  return parts;
}

}  // namespace

LADDER(experiment)
