// Penalty forces against impulses: how high a ball bounces, by springs of three stiffnesses in
// steps of several schemes and lengths, and by an impulse in steps or at the exact time; how long
// and how deep a contact is, by formulas that fail near critical damping, and by one that does not;
// how long elastic balls touch, by quadrature, steps and series.
#include <support/ladder.hpp>

#include <16_penalty/measured_bounce.hpp>
#include <16_penalty/measured_contact.hpp>
#include <16_penalty/measured_hertz.hpp>

namespace {

ladder::Parts experiment() {
  ladder::Parts parts("Penalty forces: how high is the bounce, and how long the contact?");
  parts.add(measured_bounce::experiment());
  parts.add(measured_contact::experiment());
  parts.add(measured_hertz::experiment());
  return parts;
}

}  // namespace

LADDER(experiment)
