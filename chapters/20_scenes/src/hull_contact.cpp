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

/// The part of a core that is farthest along the z axis of a frame to a share of its size, in its
/// coordinates: a convex polygon, counter-clockwise, a segment or a point.
CONTACT_SCENES_INLINE std::vector<Vector3<double>> farthest_part(
    const std::vector<Vector3<double>>& vertices, const CoordinateFrame<double>& frame, double side,
    double share) {
  std::vector<Vector3<double>> points;
  double top = -std::numeric_limits<double>::infinity(), size = 0;
  for (const Vector3<double>& vertex : vertices) {
    points.push_back(position_in_frame(frame, vertex));
    top = std::max(top, side * points.back().z());
    size = std::max(size, points.back().cwiseAbs().maxCoeff());
  }
  std::erase_if(points,
                [&](const Vector3<double>& p) { return side * p.z() < top - share * size; });
  const auto before = [](const Vector3<double>& p, const Vector3<double>& q) {
    return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y();
  };
  std::sort(points.begin(), points.end(), before);
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
  auto above = detail::farthest_part(a, frame, -1, level);
  auto below = detail::farthest_part(b, frame, 1, level);
  const bool clip_above = below.size() > 2;
  if (clip_above) {
    above = detail::farthest_part(a, frame, -1, tilted);
  } else {
    below = detail::farthest_part(b, frame, 1, tilted);
  }
  const auto& window = clip_above ? below : above;
  double size = 0;
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
    }
    for (auto& point : manifold.points) point.point = position_in_world(frame, point.point);
  }
  if (manifold.points.empty()) manifold.points = {{middle, gap.distance}};
  return manifold;
}

}  // namespace contact
