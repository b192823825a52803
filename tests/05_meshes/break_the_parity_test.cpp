// What is right is decided in integers, or by signs that are exact.
#include "break_the_parity.hpp"
#include "inside_by_parity.hpp"

#include <support/break_it.hpp>

#include <05_meshes/solids.hpp>
#include <contact/orientation.hpp>

namespace {

using namespace contact::testing;
using solids::Mesh;
using solids::Point;
using solids::Triangle;

/// How the ray from a point in +x meets a mesh: the triangles that it meets, and whether it meets
/// an edge or a vertex.
struct Met {
  int triangles = 0;
  bool an_edge = false;
};

Met met_by_whole(const Mesh& mesh, const Point& p) {
  Met met;
  for (const Triangle& t : solids::triangles(mesh)) {
    const auto meeting = solids::meet(t, p, {{1, 0, 0}});
    met.triangles += meeting ? 1 : 0;
    met.an_edge = met.an_edge || (meeting && meeting->at_border);
  }
  return met;
}

std::string name(bool inside) { return inside ? "inside" : "outside"; }

Judged judged(const Mesh& mesh, const Point& p, bool right, std::string difference) {
  const bool given = given::inside_by_parity(mesh, p);
  return {given != right, name(given), name(right), std::move(difference)};
}

BreakIt<Point> question(std::string_view text, double limit) {
  return break_it<Point>(text).rule(
      "every coordinate is from " + contact::text_of(-limit) + " to " + contact::text_of(limit),
      [limit](const Point& p) { return all_within(p, limit); });
}

BreakIt<Point> whole_question(std::string_view text, const Mesh& mesh) {
  return question(text, 100)
      .rule("every coordinate is a whole number", [](const Point& p) { return all_whole(p); })
      .rule("the point is not on the surface",
            [mesh](const Point& p) { return !solids::on_surface(mesh, p); });
}

std::string counted(const Mesh& mesh, const Point& p) {
  return "The given code counts " + contact::text_of(given::count_met(mesh, p)) + " triangles.";
}

// The rest is about the shard, which has no face or edge along x.

/// Positive if the projection of p along x is to the left of the edge from a to b, exactly.
int orientation(const Point& a, const Point& b, const Point& p) {
  const auto along_x = [](const Point& v) { return contact::Vector2<double>(v.y(), v.z()); };
  return contact::orient_2d(along_x(a), along_x(b), along_x(p));
}

bool line_meets_edge(const Point& a, const Point& b, const Point& p) {
  const auto between = [](double x, double y, double z) {
    return std::min(x, y) <= z && z <= std::max(x, y);
  };
  return orientation(a, b, p) == 0 && between(a.y(), b.y(), p.y()) && between(a.z(), b.z(), p.z());
}

bool line_meets_an_edge(const Point& p) {
  const std::vector<Triangle> all = solids::triangles(given::shard());
  return std::any_of(all.begin(), all.end(), [&](const Triangle& t) {
    return line_meets_edge(t.a, t.b, p) || line_meets_edge(t.b, t.c, p) ||
           line_meets_edge(t.c, t.a, p);
  });
}

/// Whether the line along x meets the triangle, none of whose edges it meets.
bool line_meets(const Triangle& t, const Point& p) {
  const int side = orientation(t.a, t.b, p);
  return side == orientation(t.b, t.c, p) && side == orientation(t.c, t.a, p);
}

/// The same for the ray from p in +x; p is not on the triangle.
bool ray_meets(const Triangle& t, const Point& p) {
  return line_meets(t, p) && contact::orient_3d(t.a, t.b, t.c, p) != orientation(t.a, t.b, t.c);
}

bool on_shard(const Point& p) {
  const std::vector<Triangle> all = solids::triangles(given::shard());
  return std::any_of(all.begin(), all.end(), [&](const Triangle& t) {
    return line_meets(t, p) && contact::orient_3d(t.a, t.b, t.c, p) == 0;
  });
}

int count_exactly(const Point& p) {
  const std::vector<Triangle> all = solids::triangles(given::shard());
  return static_cast<int>(
      std::count_if(all.begin(), all.end(), [&](const Triangle& t) { return ray_meets(t, p); }));
}

int count_misjudged(const Point& p) {
  const std::vector<Triangle> all = solids::triangles(given::shard());
  return static_cast<int>(std::count_if(all.begin(), all.end(), [&](const Triangle& t) {
    return given::meets(p, t) != ray_meets(t, p);
  }));
}

}  // namespace

TEST_CASE("a point inside the octahedron is taken for outside") {
  const Mesh mesh = given::octahedron();
  whole_question("For which point inside the octahedron is the given code wrong?", mesh)
      .rule("the point is inside", [&](const Point& p) { return solids::is_inside(mesh, p); })
      .suspect_if("break-no-edge-is-met",
                  [&](const Point& p) { return !met_by_whole(mesh, p).an_edge; })
      .suspect_if("break-count-is-right", [](const Point&) { return true; })
      .input("point", [] { return exercise::inside_the_octahedron(); })
      .judge([&](const Point& p) { return judged(mesh, p, true, counted(mesh, p)); });
}

TEST_CASE("a point left of the house is taken for inside") {
  const Mesh mesh = given::house();
  whole_question("For which point left of the house is the given code wrong?", mesh)
      .rule("x is negative", [](const Point& p) { return p.x() < 0; })
      .suspect_if("break-ray-meets-nothing",
                  [&](const Point& p) { return met_by_whole(mesh, p).triangles == 0; })
      .suspect_if("break-no-edge-is-met",
                  [&](const Point& p) { return !met_by_whole(mesh, p).an_edge; })
      .suspect_if("break-count-is-right", [](const Point&) { return true; })
      .input("point", [] { return exercise::left_of_the_house(); })
      .judge([&](const Point& p) { return judged(mesh, p, false, counted(mesh, p)); });
}

TEST_CASE("a point whose ray meets no edge is judged wrongly") {
  const Mesh mesh = given::shard();
  question("For which point is the given code wrong about the shard?", 100)
      .rule("the line through the point along x meets no edge and no vertex",
            [](const Point& p) { return !line_meets_an_edge(p); })
      .rule("the point is not on the surface", [](const Point& p) { return !on_shard(p); })
      .suspect_if("break-no-triangle-is-misjudged",
                  [](const Point& p) { return count_misjudged(p) == 0; })
      .suspect_if("break-errors-cancel", [](const Point&) { return true; })
      .input("point", [] { return exercise::past_every_edge(); })
      .judge([&](const Point& p) {
        return judged(
            mesh, p, count_exactly(p) % 2 == 1,
            counted(mesh, p) + " The ray meets " + contact::text_of(count_exactly(p)) + ".");
      });
}
