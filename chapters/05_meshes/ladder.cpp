// What does it cost to know where a segment first meets a mesh, and whether a point is inside? Each
// method of the chapter in float and in double, on random inputs and on those that are hard to
// decide.
#include <support/ladder.hpp>

#include <05_meshes/families.hpp>
#include <05_meshes/mesh_truth.hpp>
#include <algorithm>
#include <contact/mesh_columns.hpp>
#include <contact/mesh_hits.hpp>
#include <contact/mesh_tree.hpp>
#include <contact/point_in_polyhedron.hpp>
#include <contact/watertight.hpp>
#include <map>
#include <memory>

namespace {

using contact::Mesh;
using contact::MeshColumns;
using contact::MeshTree;
using contact::Segment;
using contact::Triangle;
using contact::TriangleHit;
using contact::Where;
using mesh_families::Body;
using Point = contact::Vector3<double>;

/// A body, and what is built once over it.
struct Built {
  const Body* body;
  MeshTree<double> tree;
  MeshColumns<double> columns;
  std::vector<mesh_truth::Around> around;

  explicit Built(const Body& of)
      : body(&of),
        tree(of.in_double),
        columns(of.in_double),
        around(mesh_truth::around_triangles(of.in_double)) {}
};

/// Of a body that lives as long as the program.
const Built* built(const Body& body) {
  static std::map<const Body*, std::unique_ptr<Built>> all;
  std::unique_ptr<Built>& found = all[&body];
  if (!found) found = std::make_unique<Built>(body);
  return found.get();
}

ladder::Method plain(const char* id, const char* in, const char* title, const char* scalar) {
  return {.id = std::string(id) + in, .title = title, .scalar = scalar, .exact = false};
}
ladder::Method exact(const char* id, const char* title, const char* scalar) {
  return {.id = id, .title = title, .scalar = scalar, .exact = true};
}

/// All bodies that segments are aimed at.
const std::vector<const Body*>& targets() {
  static const std::vector<const Body*> all = [] {
    std::vector<const Body*> bodies;
    for (const mesh_families::Bodies* some : {&mesh_families::usual(), &mesh_families::whole(),
                                              &mesh_families::thin(), &mesh_families::small()}) {
      for (const Body& body : *some) bodies.push_back(&body);
    }
    return bodies;
  }();
  return all;
}

/// The targets as a peer gets them, one after the other: the numbers of vertices and of triangles,
/// the coordinates, and the triangles.
std::vector<double> targets_in_numbers() {
  std::vector<double> to;
  for (const Body* body : targets()) {
    const Mesh<double>& mesh = body->in_double;
    to.push_back(static_cast<double>(mesh.vertices.size()));
    to.push_back(static_cast<double>(mesh.triangles.size()));
    for (const Point& v : mesh.vertices) to.insert(to.end(), v.begin(), v.end());
    for (const auto& triangle : mesh.triangles)
      to.insert(to.end(), triangle.begin(), triangle.end());
  }
  return to;
}

/// The meshes of the figures are others.
constexpr const char* no_figure = "The figures show other meshes.";

namespace segments {

/// The same numbers in float and in double: the conversion is not timed.
struct Input {
  const Built* at;
  Segment<float> segment;
  Segment<double> segment_in_double;
};

struct Answer {
  int triangle = -1;  ///< that is met first; −1: none
  double t = std::nan("");
  const Mesh<double>* mesh = nullptr;  ///< in the true answer
};

Input both_types(const mesh_families::SegmentAt& aimed) {
  return {built(*aimed.body),
          aimed.segment,
          {aimed.segment.start.cast<double>(), aimed.segment.end.cast<double>()}};
}

Answer truth(const Input& input) {
  const Mesh<double>& mesh = input.at->body->in_double;
  const auto [triangle, t] = mesh_truth::first(input.segment_in_double, mesh, input.at->around);
  return {triangle, t, &mesh};
}

/// Wrong is a hit where there is none, none where there is one, and a triangle that has no vertex
/// in common with the one that is met first: then something else was met. The error is that of t.
ladder::Verdict judge(const Answer& got, const Answer& right) {
  ladder::Verdict verdict;
  if (got.triangle < 0 || right.triangle < 0) {
    verdict.wrong = got.triangle != right.triangle;
    return verdict;
  }
  verdict.wrong = !mesh_truth::share_a_vertex(*right.mesh, got.triangle, right.triangle);
  verdict.error = std::abs(got.t - right.t);
  return verdict;
}

/// The least t of all triangles, each asked on its own.
template <class S, class Meet>
Answer least(const Mesh<S>& mesh, const Meet& meet) {
  Answer answer;
  S t = std::numeric_limits<S>::infinity();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::optional<TriangleHit<S>> hit = meet(contact::triangle_of(mesh, i));
    if (!hit || !(hit->t < t)) continue;
    t = hit->t;
    answer.triangle = static_cast<int>(i);
  }
  answer.t = static_cast<double>(t);
  return answer;
}

/// Möller and Trumbore's, with the ε of their paper: a triangle counts as parallel to the segment
/// if the determinant is less than a millionth, whatever its size.
template <class S>
std::optional<TriangleHit<S>> with_epsilon(const Segment<S>& segment, const Triangle<S>& triangle) {
  const contact::Vector3<S> p = (segment.end - segment.start).cross(triangle.c - triangle.a);
  if (std::abs((triangle.b - triangle.a).dot(p)) < S(1e-6)) return std::nullopt;
  return contact::intersect_moller_trumbore(segment, triangle);
}

Answer named(const std::optional<contact::MeshHit<double>>& hit) {
  return hit ? Answer{hit->triangle, hit->hit.t} : Answer{};
}

ladder::Example shown(const Input& input, const Answer& got, const Answer& right,
                      const ladder::Method&) {
  const auto words = [](const Answer& answer) {
    return answer.triangle < 0 ? std::string("no hit")
                               : "triangle " + std::to_string(answer.triangle);
  };
  const Mesh<float>& mesh = input.at->body->in_float;
  ladder::Example example;
  example.facts = {
      ladder::number("triangles of the mesh", static_cast<double>(mesh.triangles.size())),
      ladder::numbers("start", input.segment.start), ladder::numbers("end", input.segment.end)};
  const int of = right.triangle >= 0 ? right.triangle : got.triangle;
  if (of >= 0) {
    const Triangle<float> triangle = contact::triangle_of(mesh, static_cast<std::size_t>(of));
    const std::string name = "triangle " + std::to_string(of) + ", ";
    example.facts.push_back(ladder::numbers(name + "a", triangle.a));
    example.facts.push_back(ladder::numbers(name + "b", triangle.b));
    example.facts.push_back(ladder::numbers(name + "c", triangle.c));
  }
  example.facts.push_back({"this method", words(got)});
  example.facts.push_back({"exact", words(right)});
  example.note = no_figure;
  return example;
}

ladder::Ladder<Input, Answer> experiment() {
  ladder::Ladder<Input, Answer> ladder("Where does the segment first meet the mesh?", truth, judge);
  const auto family = [&ladder](const char* id, const char* title, auto generator) {
    ladder.family(id, title, [generator](generators::Random& random) {
      return both_types(generator(random));
    });
  };
  family("segment-random", "random", mesh_families::segment_random);
  family("segment-edge", "at edges", mesh_families::segment_at_edge);
  family("segment-vertex", "at vertices", mesh_families::segment_at_vertex);
  family("segment-face", "in planes of faces", mesh_families::segment_in_face);
  family("segment-far", "at edges, from far away", mesh_families::segment_far);
  family("segment-thin", "at thin triangles", mesh_families::segment_thin);
  family("segment-small", "meshes of 4 mm", mesh_families::segment_small);

  const auto in_both = [&ladder](const char* id, const char* title, auto method) {
    ladder.method(plain(id, "-float", title, "float"), [method](const Input& input) {
      return method(input.segment, input.at->body->in_float);
    });
    ladder.method(plain(id, "-double", title, "double"), [method](const Input& input) {
      return method(input.segment_in_double, input.at->body->in_double);
    });
  };
  in_both("each", "Möller–Trumbore, each triangle", [](const auto& segment, const auto& mesh) {
    return least(mesh, [&](const auto& triangle) {
      return contact::intersect_moller_trumbore(segment, triangle);
    });
  });
  in_both("epsilon", "Möller–Trumbore, ε = 10⁻⁶", [](const auto& segment, const auto& mesh) {
    return least(mesh, [&](const auto& triangle) { return with_epsilon(segment, triangle); });
  });
  in_both("watertight", "watertight, each triangle", [](const auto& segment, const auto& mesh) {
    using S = std::decay_t<decltype(segment.start.x())>;
    const contact::WatertightRay<S> ray(segment.start, segment.end - segment.start);
    return least(mesh, [&](const auto& triangle) { return ray.meet(triangle, S(1)); });
  });
  ladder.method(
      exact("first", "each triangle, filtered", "double, then exact"), [](const Input& input) {
        return named(contact::first_mesh_hit(input.segment_in_double, input.at->body->in_double));
      });
  ladder.method(
      exact("tree", "tree of boxes, filtered", "double, then exact"),
      [](const Input& input) { return named(input.at->tree.first(input.segment_in_double)); });
  ladder.method(exact("first-unfiltered", "each triangle near the line, no filter", "exact"),
                truth);
  ladder.peer(
      {.id = "bvh-meshes",
       .title = "three-mesh-bvh",
       .scalar = "JavaScript",
       .asks = 7,
       .tells = 2},
      [](const Input& input, std::vector<double>& to) {
        const auto at = std::find(targets().begin(), targets().end(), input.at->body);
        to.push_back(static_cast<double>(at - targets().begin()));
        for (const Point& end : {input.segment_in_double.start, input.segment_in_double.end}) {
          to.insert(to.end(), end.begin(), end.end());
        }
      },
      [](const double* told, const Answer&) {
        return Answer{static_cast<int>(told[0]), told[1]};
      },
      targets_in_numbers);
  ladder.recommend("tree");
  ladder.show(shown);
  return ladder;
}

}  // namespace segments

namespace points {

struct Input {
  const Built* at;
  contact::Vector3<float> p;
  Point p_in_double;
};

struct Answer {
  Where where = Where::outside;
  bool two_answers = false;  ///< whether the method cannot say `on`
};

Input both_types(const mesh_families::PointAt& near) {
  return {built(*near.body), near.point, near.point.cast<double>()};
}

Answer truth(const Input& input) {
  const int where = mesh_truth::where(input.p_in_double, input.at->body->in_double);
  return {where > 0 ? Where::inside : where == 0 ? Where::on : Where::outside};
}

/// A method with two answers is not wrong on the surface.
ladder::Verdict judge(const Answer& got, const Answer& right) {
  ladder::Verdict verdict;
  verdict.wrong = got.where != right.where && !(got.two_answers && right.where == Where::on);
  return verdict;
}

ladder::Example shown(const Input& input, const Answer& got, const Answer& right,
                      const ladder::Method&) {
  const auto words = [](Where where) {
    return where == Where::on ? "on" : where == Where::inside ? "inside" : "outside";
  };
  const Mesh<float>& mesh = input.at->body->in_float;
  ladder::Example example;
  example.facts = {
      ladder::number("triangles of the mesh", static_cast<double>(mesh.triangles.size())),
      ladder::numbers("p", input.p),
      {"this method", words(got.where)},
      {"exact", words(right.where)}};
  example.note = no_figure;
  return example;
}

ladder::Ladder<Input, Answer> experiment() {
  ladder::Ladder<Input, Answer> ladder("Is the point inside?", truth, judge);
  const auto family = [&ladder](const char* id, const char* title, auto generator) {
    ladder.family(id, title, [generator](generators::Random& random) {
      return both_types(generator(random));
    });
  };
  family("point-random", "random", mesh_families::point_random);
  family("point-convex", "convex meshes", mesh_families::point_convex);
  family("point-level", "level with vertices", mesh_families::point_level);
  family("point-under", "under edges", mesh_families::point_under_edge);
  family("point-surface", "on the surface, rounded", mesh_families::point_on_surface);
  family("point-near", "one float from that", mesh_families::point_near_surface);
  family("point-far", "far from the origin", mesh_families::point_far);

  const auto in_both = [&ladder](const char* id, const char* title, bool two_answers, auto method) {
    ladder.method(plain(id, "-float", title, "float"), [=](const Input& input) {
      return Answer{method(input.p, input.at->body->in_float), two_answers};
    });
    ladder.method(plain(id, "-double", title, "double"), [=](const Input& input) {
      return Answer{method(input.p_in_double, input.at->body->in_double), two_answers};
    });
  };
  in_both("parity", "parity of one ray", true,
          [](const auto& p, const auto& mesh) { return contact::in_by_parity(p, mesh); });
  in_both("rays", "random rays, retried", true, [](const auto& p, const auto& mesh) {
    return contact::in_by_random_rays(p, mesh).where;
  });
  in_both("angles", "solid angles", true,
          [](const auto& p, const auto& mesh) { return contact::where_by_solid_angles(p, mesh); });
  in_both("planes", "planes, for convex meshes", false,
          [](const auto& p, const auto& mesh) { return contact::in_convex_by_planes(p, mesh); });

  const auto decided = [&ladder](const ladder::Method& about, auto method) {
    ladder.method(about, [method](const Input& input) { return Answer{method(input)}; });
  };
  ladder::Method for_convex =
      exact("in-convex", "planes, filtered, for convex meshes", "double, then exact");
  for_convex.exact = false;  // of a concave mesh
  decided(for_convex, [](const Input& input) {
    return contact::in_convex(input.p_in_double, input.at->body->in_double);
  });
  decided(exact("locate", "each triangle, filtered", "double, then exact"), [](const Input& input) {
    return contact::locate_in_mesh(input.p_in_double, input.at->body->in_double).where;
  });
  decided(exact("locate-tree", "tree of boxes, filtered", "double, then exact"),
          [](const Input& input) {
            return contact::locate_in_mesh(input.p_in_double, input.at->tree).where;
          });
  decided(exact("locate-columns", "columns, filtered", "double, then exact"),
          [](const Input& input) {
            return contact::locate_in_mesh(input.p_in_double, input.at->columns).where;
          });
  ladder.method(exact("locate-unfiltered", "each triangle, no filter", "exact"), truth);
  ladder.recommend("locate-tree");
  ladder.show(shown);
  return ladder;
}

}  // namespace points

ladder::Parts experiment() {
  ladder::Parts parts("Segments and points at meshes");
  parts.add(segments::experiment());
  parts.add(points::experiment());
  return parts;
}

}  // namespace

LADDER(experiment)
