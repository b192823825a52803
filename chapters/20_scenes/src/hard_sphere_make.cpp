#include <contact/events/hard_sphere_make.hpp>

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include <contact/events/hard_sphere_compose.hpp>
#include <contact/events/hard_sphere_run.hpp>
#include <contact/events/hard_spheres.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/scene/compiled.hpp>

namespace contact {

namespace detail {

constexpr HardSphereEffects numbered_effects(std::size_t number) {
  return {static_cast<int>(number / 16) + 1, (number & 1) != 0, (number & 2) != 0,
          (number & 4) != 0, (number & 8) != 0};
}

template <std::size_t Number>
std::unique_ptr<HardSphereRun> make_numbered(const HardSphereSetup& setup,
                                             const std::array<int, 3>& axes) {
  return std::make_unique<HardSpheres<numbered_effects(Number)>>(setup, axes);
}

template <std::size_t... Number>
constexpr auto makers(std::index_sequence<Number...> /*numbers*/) {
  return std::array{&make_numbered<Number>...};
}

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
