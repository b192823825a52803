#include <contact/events/hard_sphere_make.hpp>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include <contact/events/hard_sphere_compose.hpp>
#include <contact/events/hard_sphere_run.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/scene/compiled.hpp>

namespace contact {

namespace detail {

/// All compositions, numbered.
constexpr std::size_t hard_sphere_compositions = 48;

}  // namespace detail

CONTACT_SCENES_INLINE std::unique_ptr<HardSphereRun> make_hard_spheres(
    const HardSphereSetup& setup, const HardSphereComposition& composition) {
  constexpr auto all = detail::makers(std::make_index_sequence<detail::hard_sphere_compositions>());
  for (std::size_t number = 0; number < all.size(); ++number)
    if (detail::numbered_effects(number) == composition.effects)
      return all[number](setup, composition.axes);
  throw_invalid_argument("dimension", std::to_string(composition.effects.dimension),
                         "must be 1, 2 or 3");
}

CONTACT_SCENES_INLINE std::unique_ptr<HardSphereRun> make_hard_spheres(
    const HardSphereSetup& setup) {
  return make_hard_spheres(setup, compose_hard_spheres(setup));
}

}  // namespace contact
