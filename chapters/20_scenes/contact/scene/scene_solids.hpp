/// @file
/// The solids of a scene's shapes: volume, inertia, bounding radius, and the distance between two.
#pragma once

#include <optional>
#include <vector>

#include <contact/inertia.hpp>
#include <contact/scene/scene.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// Mass properties of the hull of points with a density of 1; empty if they lie in a plane.
std::optional<MassProperties<double>> hull_matter(const std::vector<Vector3<double>>& points);

/// The signed distance between the origin and the convex hull of points, m: inside, minus the
/// distance of the nearest face.
double origin_gap(const std::vector<Vector3<double>>& points);

}  // namespace detail

/// The volume of a shape.
/// @return m³; 0 for a half-space and for a hull whose points lie in a plane. Off by a few u, for a
/// hull as mesh_mass()
/// @throws std::invalid_argument if a point of a hull is not finite
double solid_volume(const SceneShape& shape);

/// The inertia tensor of a shape of uniform density, about its origin and in its axes.
/// @param shape its sizes finite and greater than 0
/// @param mass kg, finite and greater than 0
/// @return kg·m²; zero for a half-space and for a hull whose points lie in a plane. Off by a few u,
/// for a hull as mesh_mass()
/// @throws std::invalid_argument naming a size or the mass, and its value
Matrix3<double> solid_inertia(const SceneShape& shape, double mass);

/// The radius of a ball about a body's origin that contains the body.
/// @return m, rounded; infinity for a half-space
double bounding_radius(const SceneShape& shape);

/// The signed distance of two bodies in their poses: negative if they overlap, by the depth by
/// which one has to be moved to separate them.
///
/// Defined for every pair but two half-spaces. Symmetric in a and b, bit for bit.
/// @return m, off by a few u of the coordinates and sizes; empty for two half-spaces
std::optional<double> starting_gap(const SceneBody& a, const SceneBody& b);

/// The largest overlap of two bodies that still counts as touching: 16 u of their coordinates and
/// sizes, which is more than rounding them to binary changes. Three balls that touch each other
/// have no exact binary coordinates in general.
double touching_slack(const SceneBody& a, const SceneBody& b);

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/scene_solids.cpp"
#endif
