/// @file
/// Scenes as texts, and whether two are the same.
#pragma once

#include <bit>
#include <contact/scene/scene.hpp>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support/generators.hpp"

namespace scene_texts {

using contact::Scene;
using contact::SceneBody;
using contact::SceneExpectation;
using contact::SceneMaterial;
using contact::Vector3;
using generators::Random;
namespace fs = std::filesystem;

inline constexpr double unit_roundoff = 0x1p-53;
inline const fs::path root = CONTACT_SOURCE_DIR;

inline std::string text_in(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

inline bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

template <class Derived>
bool same(const Eigen::MatrixBase<Derived>& a, const Eigen::MatrixBase<Derived>& b) {
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    if (!same(a.derived().coeff(i % a.rows(), i / a.rows()),
              b.derived().coeff(i % a.rows(), i / a.rows())))
      return false;
  }
  return true;
}

inline bool same(const std::optional<double>& a, const std::optional<double>& b) {
  return a.has_value() == b.has_value() && (!a || same(*a, *b));
}

inline bool same(const contact::SceneShape& a, const contact::SceneShape& b) {
  if (a.index() != b.index()) return false;
  if (const auto* ball = std::get_if<contact::BallShape>(&a))
    return same(ball->radius, std::get<contact::BallShape>(b).radius);
  if (const auto* box = std::get_if<contact::BoxShape>(&a))
    return same(box->half_lengths, std::get<contact::BoxShape>(b).half_lengths);
  if (const auto* capsule = std::get_if<contact::CapsuleShape>(&a))
    return same(capsule->radius, std::get<contact::CapsuleShape>(b).radius) &&
           same(capsule->half_length, std::get<contact::CapsuleShape>(b).half_length);
  if (const auto* hull = std::get_if<contact::HullShape>(&a)) {
    const auto& other = std::get<contact::HullShape>(b);
    if (hull->points.size() != other.points.size()) return false;
    for (std::size_t i = 0; i < hull->points.size(); ++i) {
      if (!same(hull->points[i], other.points[i])) return false;
    }
    return true;
  }
  const auto& ground = std::get<contact::HalfSpaceShape>(a);
  const auto& other = std::get<contact::HalfSpaceShape>(b);
  return same(ground.normal, other.normal) && same(ground.offset, other.offset);
}

inline bool same(const SceneBody& a, const SceneBody& b) {
  return a.name == b.name && same(a.shape, b.shape) && a.material == b.material &&
         a.moves == b.moves && same(a.mass, b.mass) && same(a.inertia, b.inertia) &&
         same(a.position, b.position) && same(a.orientation.w, b.orientation.w) &&
         same(a.orientation.v, b.orientation.v) && same(a.velocity, b.velocity) &&
         same(a.angular_velocity, b.angular_velocity);
}

inline bool same(const SceneMaterial& a, const SceneMaterial& b) {
  return a.name == b.name && same(a.restitution, b.restitution) && same(a.friction, b.friction) &&
         same(a.stiffness, b.stiffness) && same(a.damping, b.damping);
}

inline bool same(const SceneExpectation& a, const SceneExpectation& b) {
  return a.quantity == b.quantity && a.body == b.body && same(a.time, b.time) &&
         same(a.value, b.value) && same(a.within, b.within) && a.why == b.why;
}

template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!same(a[i], b[i])) return false;
  }
  return true;
}

inline bool same(const Scene& a, const Scene& b) {
  return a.name == b.name && a.about == b.about && same(a.gravity, b.gravity) &&
         same(a.materials, b.materials) && same(a.bodies, b.bodies) &&
         same(a.duration, b.duration) && same(a.tolerance.position, b.tolerance.position) &&
         a.tolerance.event_order == b.tolerance.event_order &&
         same(a.output.every, b.output.every) && a.output.velocities == b.output.velocities &&
         a.output.events == b.output.events && same(a.expect, b.expect);
}

inline Vector3<double> vector_of_any(Random& random) {
  const double x = random.magnitude(-30, 30);
  const double y = random.magnitude(-30, 30);
  return {x, y, random.magnitude(-30, 30)};
}

}  // namespace scene_texts
