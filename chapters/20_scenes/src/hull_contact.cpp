#include <contact/stepped/hull_contact.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <contact/contact_manifold.hpp>
#include <contact/frame.hpp>
#include <contact/oriented_box.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/signed_distance.hpp>
#include <contact/vector.hpp>

namespace contact {

CONTACT_SCENES_INLINE std::vector<Vector3<double>> core_vertices(const OrientedBox<double>& body) {
  std::vector<Vector3<double>> corners;
  for (int k = 0; k < 8; ++k) corners.push_back(box_corner(body, k));
  return corners;
}

namespace detail {

/// The part of a core that comes first against the z axis of a frame (side −1) or along it (side
/// 1), in its coordinates: a face that rises by at most `steepest` of its length, a convex polygon,
/// counter-clockwise; if there is none, such an edge, or else the first vertex.
///
/// Of the edges at the lowest vertex, the one that rises least for its length is taken. The plane
/// through it that is level in the direction perpendicular to it has no vertex below it: a plane
/// through the lowest vertex and along one of its edges is below the core, and between two edges a
/// unit vector rises at least as much as along the flatter one. Rotated about the edge until it
/// meets a vertex, to the side on which that takes less, the plane is that of a face. Lengths below
/// 2^-20 of the core's size count as 0.
CONTACT_SCENES_INLINE std::vector<Vector3<double>> first_part(
    const std::vector<Vector3<double>>& vertices, const CoordinateFrame<double>& frame, double side,
    double steepest) {
  std::vector<Vector3<double>> points;
  for (const Vector3<double>& vertex : vertices) points.push_back(position_in_frame(frame, vertex));
  const auto below = [&](const Vector3<double>& p, const Vector3<double>& q) {
    return side * p.z() > side * q.z();
  };
  const Vector3<double> lowest = *std::min_element(points.begin(), points.end(), below);
  double size = 0;
  for (const Vector3<double>& p : points) size = std::max(size, (p - lowest).cwiseAbs().maxCoeff());
  const double nothing = 0x1p-20 * size;
  const auto height = [&](const Vector3<double>& p) { return side * (lowest.z() - p.z()); };

  double slope = std::numeric_limits<double>::infinity();
  Vector3<double> along = Vector3<double>::UnitX();  // the edge, seen along z
  for (const Vector3<double>& p : points) {
    const Vector3<double> d(p.x() - lowest.x(), p.y() - lowest.y(), 0);
    const double length = std::sqrt(d.x() * d.x() + d.y() * d.y());
    if (!(length > nothing && height(p) < slope * length)) continue;
    slope = height(p) / length;
    along = d / length;
  }
  if (!(slope <= steepest)) return {lowest};
  const auto across = [&](const Vector3<double>& p) {
    return along.x() * (p.y() - lowest.y()) - along.y() * (p.x() - lowest.x());
  };
  const auto above_edge = [&](const Vector3<double>& p) {
    return height(p) -
           slope * (along.x() * (p.x() - lowest.x()) + along.y() * (p.y() - lowest.y()));
  };
  double least = std::numeric_limits<double>::infinity(), tilt = 0;
  for (const Vector3<double>& p : points) {
    const double beside = std::abs(across(p));
    if (!(beside > nothing && above_edge(p) < least * beside)) continue;
    least = above_edge(p) / beside;
    tilt = across(p) > 0 ? least : -least;
  }
  const bool is_face = least <= steepest;
  if (!is_face) tilt = 0;
  std::erase_if(points, [&](const Vector3<double>& p) {
    return above_edge(p) - tilt * across(p) > nothing ||
           (!is_face && std::abs(across(p)) > nothing);
  });
  // Of two vertices at one position the lower counts.
  const auto before = [&](const Vector3<double>& p, const Vector3<double>& q) {
    if (p.x() != q.x()) return p.x() < q.x();
    return p.y() != q.y() ? p.y() < q.y() : below(p, q);
  };
  const auto at_one_position = [](const Vector3<double>& p, const Vector3<double>& q) {
    return p.x() == q.x() && p.y() == q.y();
  };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end(), at_one_position), points.end());
  if (points.size() < 3) return points;
  const auto turn = [](const Vector3<double>& p, const Vector3<double>& q,
                       const Vector3<double>& r) {
    return (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
  };
  // The lower and the upper chain (Andrew's monotone chain).
  std::vector<Vector3<double>> hull;
  for (int chain = 0; chain < 2; ++chain) {
    const std::size_t first = hull.size();
    for (const Vector3<double>& p : points) {
      while (hull.size() >= first + 2 &&
             !(turn(hull[hull.size() - 2], hull.back(), p) > 0x1p-40 * size * size)) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

/// The part of a polygon or a segment that projects into a convex polygon (Sutherland and
/// Hodgman). Heights are interpolated.
CONTACT_SCENES_INLINE std::vector<Vector3<double>> clipped_part(
    std::vector<Vector3<double>> part, const std::vector<Vector3<double>>& window) {
  for (std::size_t k = 0; k < window.size() && !part.empty(); ++k) {
    const Vector3<double>& from = window[k];
    const Vector3<double> along = window[(k + 1) % window.size()] - from;
    const auto inside = [&](const Vector3<double>& p) {
      return along.x() * (p.y() - from.y()) - along.y() * (p.x() - from.x());
    };
    std::vector<Vector3<double>> kept;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Vector3<double>& p = part[i];
      const Vector3<double>& q = part[(i + 1) % part.size()];
      const double at_p = inside(p), at_q = inside(q);
      if (at_p >= 0) kept.push_back(p);
      if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) {
        kept.emplace_back(p + (q - p) * (at_p / (at_p - at_q)));
      }
    }
    part = kept;
  }
  return part;
}

/// The height above a position of the plane through a polygon: through its widest triangle with the
/// first vertex.
CONTACT_SCENES_INLINE double height_at(const std::vector<Vector3<double>>& polygon,
                                       const Vector3<double>& p) {
  Vector3<double> normal = Vector3<double>::Zero();
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Vector3<double> other = Vector3<double>(polygon[i - 1] - polygon[0])
                                      .cross(Vector3<double>(polygon[i] - polygon[0]));
    if (other.z() > normal.z()) normal = other;
  }
  if (!(normal.z() > 0)) return polygon[0].z();
  const Vector3<double> d = p - polygon[0];
  return polygon[0].z() - (normal.x() * d.x() + normal.y() * d.y()) / normal.z();
}

}  // namespace detail

CONTACT_SCENES_INLINE ContactManifold<double> face_contact(const std::vector<Vector3<double>>& a,
                                                           const std::vector<Vector3<double>>& b,
                                                           double radius,
                                                           const SignedDistance<double>& gap,
                                                           double margin) {
  ContactManifold<double> manifold{gap.normal, {}};
  if (!(gap.distance <= margin) || gap.normal == Vector3<double>::Zero()) return manifold;
  const Vector3<double> middle = (gap.on_a + gap.on_b) / 2;
  const auto frame = frame_on_normal<double>(middle, gap.normal);
  // The window is a face; what is clipped by it may be tilted a little, as a body that rocks.
  constexpr double level = 0x1p-20, tilted = 0x1p-3;
  auto above = detail::first_part(a, frame, -1, level);
  auto below = detail::first_part(b, frame, 1, level);
  const bool clip_above = below.size() > 2;
  if (clip_above) {
    above = detail::first_part(a, frame, -1, tilted);
  } else {
    below = detail::first_part(b, frame, 1, tilted);
  }
  const auto& window = clip_above ? below : above;
  double size = 0, deepest = std::numeric_limits<double>::infinity();
  for (const Vector3<double>& p : window) size = std::max(size, p.cwiseAbs().maxCoeff());
  if (window.size() > 2 && above.size() > 1 && below.size() > 1) {
    for (const Vector3<double>& p : detail::clipped_part(clip_above ? above : below, window)) {
      const double other = detail::height_at(window, p);
      const double distance = (clip_above ? p.z() - other : other - p.z()) - radius;
      if (!(distance <= margin)) continue;
      const Vector3<double> position(p.x(), p.y(), 0);
      // An edge of a segment is clipped once in each direction.
      const auto same = [&](const auto& point) {
        return (point.point - position).norm() <= 0x1p-30 * size;
      };
      if (std::any_of(manifold.points.begin(), manifold.points.end(), same)) continue;
      manifold.points.push_back({position, distance});
      deepest = std::min(deepest, distance);
    }
    for (auto& point : manifold.points) point.point = position_in_world(frame, point.point);
  }
  // Where rounding or a bent face has cut off the closest points, they are added.
  if (gap.distance < deepest - 0x1p-40 * size) manifold.points.push_back({middle, gap.distance});
  return manifold;
}

}  // namespace contact
