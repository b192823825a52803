/// @file
/// Contact points of bodies of several convex pieces: all pairs of pieces, without contacts on the
/// inner faces between pieces.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <contact/convex_bodies.hpp>
#include <contact/convex_pieces.hpp>
#include <contact/facing_part.hpp>
#include <contact/hull_manifold.hpp>
#include <contact/manifold_point.hpp>
#include <contact/mesh.hpp>
#include <contact/shapes.hpp>
#include <contact/signed_distance.hpp>
#include <contact/support.hpp>
#include <contact/vector.hpp>

namespace contact {

// [compound-body]
/// A body of convex pieces. Pieces may touch and overlap; an inner face is where two touch.
template <Ring S>
struct CompoundBody {
  std::vector<ConvexHull<S>> pieces;  ///< m
};

/// The contact points of a piece of A and a piece of B.
template <Ring S>
struct PieceManifold {
  int piece_a = 0;              ///< of A
  int piece_b = 0;              ///< of B
  ContactManifold<S> manifold;  ///< its features are those of the pieces
};
// [/compound-body]

/// A solid as a compound body: its convex pieces, cut exactly, with each vertex rounded once.
/// @param mesh closed, m
/// @throws std::invalid_argument if the mesh is not closed and oriented, or not finite
inline CompoundBody<double> compound_from_mesh(const Mesh<double>& mesh) {
  CompoundBody<double> body;
  for (const ConvexPiece& piece : convex_pieces(mesh)) {
    ConvexHull<double> hull;
    for (const HomogeneousPoint& vertex : piece.vertices) hull.vertices.push_back(nearest(vertex));
    body.pieces.push_back(hull);
  }
  return body;
}

namespace detail {

/// The largest extent of a piece, m.
template <std::floating_point S>
S largest_piece(const CompoundBody<S>& body) {
  S largest(0);
  for (const ConvexHull<S>& piece : body.pieces) {
    if (!piece.vertices.empty()) largest = std::max(largest, core_extent(piece));
  }
  return largest;
}

template <std::floating_point S>
S distance_to_piece(const Vector3<S>& p, const ConvexHull<S>& piece) {
  if (piece.vertices.empty()) return std::numeric_limits<S>::infinity();
  return signed_distance(Sphere<S>{p, S(0)}, piece).distance;
}

// [inner-face]
/// Whether another piece of the body covers the surface of a piece at p: it contains the point a
/// little farther out, or has it on its surface: where a side is exactly over a joint, the contact
/// with the inner face is an edge of both pieces.
/// @param outward unit vector, out of the piece
/// @param step how far out, m
template <std::floating_point S>
bool is_covered(const CompoundBody<S>& body, int piece, const Vector3<S>& p,
                const Vector3<S>& outward, const S& step) {
  const Vector3<S> out = p + outward * step;
  for (int i = 0; i < int(body.pieces.size()); ++i) {
    if (i != piece && distance_to_piece<S>(out, body.pieces[std::size_t(i)]) < step / S(2)) {
      return true;
    }
  }
  return false;
}
// [/inner-face]

// [inner-edge]
/// The other pieces that touch a piece at p and go on beyond its plane of support there. At an edge
/// or a vertex of the piece, `outward` is then no outward direction of the whole body: the edge is
/// where two pieces touch, and another piece is closer.
/// @return none if `outward` is the normal of a face of the piece
template <std::floating_point S>
std::vector<int> pieces_beyond(const CompoundBody<S>& body, int piece, const Vector3<S>& p,
                               const Vector3<S>& outward, const S& step) {
  std::vector<int> beyond;
  const ConvexHull<S>& own = body.pieces[std::size_t(piece)];
  if (facing_part(own, outward, flatness<S>).vertices.size() > 2) return beyond;
  for (int i = 0; i < int(body.pieces.size()); ++i) {
    const ConvexHull<S>& other = body.pieces[std::size_t(i)];
    if (i == piece || !(distance_to_piece<S>(p, other) <= step)) continue;
    const Vector3<S> farthest = support(other, outward) + outward * other.radius;
    if (outward.dot(Vector3<S>(farthest - p)) > step) beyond.push_back(i);
  }
  return beyond;
}
// [/inner-edge]

/// A point of a manifold on one of the two surfaces.
template <std::floating_point S>
Vector3<S> point_on(const ContactManifold<S>& manifold, const ManifoldPoint<S>& p, bool of_a) {
  return p.point + manifold.normal * ((of_a ? p.distance : -p.distance) / S(2));
}

/// The mean of a manifold's points on one surface.
template <std::floating_point S>
Vector3<S> middle_on(const ContactManifold<S>& manifold, bool of_a) {
  const S count = S(manifold.points.size());
  Vector3<S> mean = Vector3<S>::Zero();
  for (const ManifoldPoint<S>& p : manifold.points) mean += point_on(manifold, p, of_a) / count;
  return mean;
}

template <std::floating_point S>
S min_distance(const ContactManifold<S>& manifold) {
  S least = std::numeric_limits<S>::infinity();
  for (const ManifoldPoint<S>& p : manifold.points) least = std::min(least, p.distance);
  return least;
}

/// The points of a manifold that no kept one has with the same normal.
template <std::floating_point S>
ContactManifold<S> without_known(const std::vector<PieceManifold<S>>& kept,
                                 ContactManifold<S> manifold, const S& step) {
  const auto is_known = [&](const ManifoldPoint<S>& p) {
    for (const PieceManifold<S>& pair : kept) {
      const Vector3<S> off = pair.manifold.normal - manifold.normal;
      if (!(off.dot(off) <= flatness<S>)) continue;
      for (const ManifoldPoint<S>& q : pair.manifold.points) {
        const Vector3<S> between = p.point - q.point;
        if (between.cwiseAbs().maxCoeff() <= step) return true;
      }
    }
    return false;
  };
  std::erase_if(manifold.points, is_known);
  return manifold;
}

// [compound-pairs]
/// The manifolds of all pairs of pieces, in the order of the pieces, without those on inner faces
/// and edges. The closest or deepest pair is taken first.
template <std::floating_point S>
std::vector<PieceManifold<S>> outer_manifolds(const CompoundBody<S>& a, const CompoundBody<S>& b,
                                              std::vector<PieceManifold<S>> pairs, const S& step) {
  // In units of rounding, so that it does not change the order of pairs that rest. A ball closer to
  // a joint than the step is as close to both pieces.
  const auto level = [&step](const PieceManifold<S>& pair) {
    return std::floor(min_distance(pair.manifold) / (step * flatness<S>));
  };
  std::stable_sort(pairs.begin(), pairs.end(),
                   [&level](const auto& p, const auto& q) { return level(p) < level(q); });
  std::vector<PieceManifold<S>> kept;
  const auto is_kept = [&kept](int piece_a, int piece_b) {
    return std::any_of(kept.begin(), kept.end(),
                       [&](const auto& p) { return p.piece_a == piece_a && p.piece_b == piece_b; });
  };
  for (const PieceManifold<S>& pair : pairs) {
    const Vector3<S> up = pair.manifold.normal, down = -up;
    const bool inside = std::all_of(
        pair.manifold.points.begin(), pair.manifold.points.end(), [&](const ManifoldPoint<S>& p) {
          return is_covered<S>(a, pair.piece_a, point_on(pair.manifold, p, true), down, step) ||
                 is_covered<S>(b, pair.piece_b, point_on(pair.manifold, p, false), up, step);
        });
    if (inside) continue;
    const Vector3<S> on_a = middle_on(pair.manifold, true), on_b = middle_on(pair.manifold, false);
    bool at_inner_edge = false;
    for (const int i : pieces_beyond<S>(a, pair.piece_a, on_a, down, step)) {
      at_inner_edge = at_inner_edge || is_kept(i, pair.piece_b);
    }
    for (const int i : pieces_beyond<S>(b, pair.piece_b, on_b, up, step)) {
      at_inner_edge = at_inner_edge || is_kept(pair.piece_a, i);
    }
    if (at_inner_edge) continue;
    ContactManifold<S> manifold = without_known<S>(kept, pair.manifold, step);
    if (manifold.points.empty()) continue;
    kept.push_back({pair.piece_a, pair.piece_b, std::move(manifold)});
  }
  if (kept.empty() && !pairs.empty()) kept.push_back(pairs[0]);
  std::sort(kept.begin(), kept.end(), [](const auto& p, const auto& q) {
    return p.piece_a != q.piece_a ? p.piece_a < q.piece_a : p.piece_b < q.piece_b;
  });
  return kept;
}
// [/compound-pairs]

/// Whether B is taken before A, as is_second() of single bodies: by the means of the pieces.
template <std::floating_point S>
bool is_second(const CompoundBody<S>& a, const CompoundBody<S>& b) {
  ConvexHull<S> centre_a, centre_b;
  for (const ConvexHull<S>& p : a.pieces) {
    if (!p.vertices.empty()) centre_a.vertices.push_back(inner_point(p));
  }
  for (const ConvexHull<S>& p : b.pieces) {
    if (!p.vertices.empty()) centre_b.vertices.push_back(inner_point(p));
  }
  if (centre_a.vertices.empty() || centre_b.vertices.empty()) return false;
  return is_second(centre_a, centre_b);
}

}  // namespace detail

// [compound-contacts]
/// The contact points of two bodies of convex pieces: one manifold for each pair of pieces that has
/// points, in the order of the pieces of that body which comes first along the coordinate in which
/// the centres differ most. Two bodies may have many points with different normals, as a box in the
/// inner corner of an L.
///
/// Left out are:
/// - a pair whose contact is on an inner face: another piece of the same body covers each of its
///   points;
/// - a pair at an edge or a vertex where another piece goes on beyond the plane of support, if that
///   piece has points with the same piece of the other body: a ball that rolls over the joint of
///   two boxes does not hit the edges inside;
/// - a point that a closer pair has with the same normal, such as those on the joint.
///
/// If all pairs are left out, the closest or deepest is the contact, so bodies that have points
/// with the same margin by pieces never pass through each other for want of a contact. A body that
/// penetrates deeper than a piece is thick can get that piece's normal.
///
/// Lengths below 2^-20 (float: 2^-12) of the largest piece count as 0. Exchanging the bodies gives
/// the opposite normals and the same points.
/// @param margin bodies at most this far apart are in contact, m; not negative
/// @return nothing for pieces that are not finite
template <FloatOrDouble S>
std::vector<PieceManifold<S>> compound_contacts(const CompoundBody<S>& a, const CompoundBody<S>& b,
                                                const S& margin) {
  if (detail::is_second(a, b)) {
    std::vector<PieceManifold<S>> found = compound_contacts(b, a, margin);
    for (PieceManifold<S>& pair : found) {
      std::swap(pair.piece_a, pair.piece_b);
      pair.manifold = exchanged(pair.manifold);
    }
    return found;
  }
  std::vector<PieceManifold<S>> pairs;
  for (int i = 0; i < int(a.pieces.size()); ++i) {
    for (int k = 0; k < int(b.pieces.size()); ++k) {
      PieceManifold<S> pair{
          i, k, contact_manifold(a.pieces[std::size_t(i)], b.pieces[std::size_t(k)], margin)};
      if (!pair.manifold.points.empty()) pairs.push_back(std::move(pair));
    }
  }
  const S step = detail::flatness<S> * std::max(detail::largest_piece(a), detail::largest_piece(b));
  return detail::outer_manifolds<S>(a, b, std::move(pairs), step);
}
// [/compound-contacts]

/// The contact points of a body of convex pieces and a half-space: the vertices of all pieces
/// within the margin, those of several pieces at one position once.
/// @param margin m, not negative
template <FloatOrDouble S>
std::vector<PieceManifold<S>> compound_contacts(const CompoundBody<S>& a, const HalfSpace<S>& b,
                                                const S& margin) {
  std::vector<PieceManifold<S>> kept;
  const S step = detail::flatness<S> * detail::largest_piece(a);
  for (int i = 0; i < int(a.pieces.size()); ++i) {
    ContactManifold<S> manifold =
        detail::without_known<S>(kept, contact_manifold(a.pieces[std::size_t(i)], b, margin), step);
    if (!manifold.points.empty()) kept.push_back({i, 0, std::move(manifold)});
  }
  return kept;
}

}  // namespace contact
