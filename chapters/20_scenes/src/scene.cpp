#include <contact/scene/scene.hpp>

#include <contact/scene/compiled.hpp>

namespace contact {

CONTACT_SCENES_INLINE PairMaterial pair_material(const SceneMaterial& a, const SceneMaterial& b) {
  PairMaterial pair;
  pair.restitution = a.restitution < b.restitution ? a.restitution : b.restitution;
  pair.friction = a.friction < b.friction ? a.friction : b.friction;
  pair.damping = a.damping + b.damping;
  if (a.stiffness && b.stiffness)
    pair.stiffness = *a.stiffness * *b.stiffness / (*a.stiffness + *b.stiffness);
  else if (a.stiffness)
    pair.stiffness = a.stiffness;
  else
    pair.stiffness = b.stiffness;
  return pair;
}

}  // namespace contact
