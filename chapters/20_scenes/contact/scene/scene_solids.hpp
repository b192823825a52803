/// @file
/// The matter of a scene's shapes: volume, inertia, how far they reach, and the gap between two.
#pragma once

#include <optional>
#include <vector>

#include <contact/inertia.hpp>
#include <contact/scene/scene.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// Mass properties of the hull of points with a density of 1; nothing if they lie in a plane.
std::optional<MassProperties<double>> hull_matter(const std::vector<Vector3<double>>& points);

}  // namespace detail

/// How much room a shape takes.
/// @return m³; 0 for a half-space and for a hull whose points lie in a plane. Off by a few u, for a
/// hull as mesh_mass()
/// @throws std::invalid_argument if a point of a hull is not finite
double solid_volume(const SceneShape& shape);

/// The inertia tensor of a shape filled evenly, about its origin and in its axes.
/// @param shape its sizes finite and greater than 0
/// @param mass kg, finite and greater than 0
/// @return kg·m²; zero for a half-space and for a hull whose points lie in a plane. Off by a few u,
/// for a hull as mesh_mass()
/// @throws std::invalid_argument naming a size or the mass, and its value
Matrix3<double> solid_inertia(const SceneShape& shape, double mass);

/// The radius of a ball about a body's origin that holds all of it.
/// @return m, rounded; infinity for a half-space
double bounding_radius(const SceneShape& shape);

/// The gap between two bodies as they lie: less than 0 if they overlap, by as much as one has to be
/// moved to be free.
///
/// Decides every pair but two half-spaces. The same, bit for bit, if a and b change places.
/// @return m, off by a few u of the coordinates and sizes; nothing for two half-spaces
std::optional<double> starting_gap(const SceneBody& a, const SceneBody& b);

/// How deep two bodies may lie in each other and still count as touching: 16 u of their coordinates
/// and sizes, which is more than writing them down in binary changes. Three balls that touch each
/// other cannot be written without.
double touching_slack(const SceneBody& a, const SceneBody& b);

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/scene_solids.cpp"
#endif
