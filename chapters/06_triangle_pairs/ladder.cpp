// What does it cost to know whether two triangles meet, and which triangles of two meshes do? Each
// method of the chapter in float and in double, on random pairs and on those that are hard to
// decide.
#include <support/ladder.hpp>

#include <05_meshes/families.hpp>
#include <06_triangle_pairs/pair_families.hpp>
#include <06_triangle_pairs/pair_truth.hpp>
#include <contact/mesh_pairs.hpp>
#include <contact/mesh_shapes.hpp>
#include <contact/mesh_tree.hpp>
#include <contact/pair_methods.hpp>
#include <contact/pair_orientations.hpp>
#include <contact/triangles_meet.hpp>
#include <memory>
#include <optional>
#include <vector>

namespace {

using contact::Mesh;
using contact::MeshTree;
using contact::Triangle;
using contact::TrianglePair;
using Point = contact::Vector3<double>;

ladder::Method plain(const char* id, const char* in, const char* title, const char* scalar) {
  return {.id = std::string(id) + in, .title = title, .scalar = scalar, .exact = false};
}
ladder::Method exact(const char* id, const char* title, const char* scalar) {
  return {.id = id, .title = title, .scalar = scalar, .exact = true};
}

namespace pairs {

/// The same numbers in float and in double: the conversion is not timed.
struct Input {
  Triangle<float> first, second;
  Triangle<double> first_in_double, second_in_double;
  bool right;
};

struct Answer {
  bool meet = false;
  bool undecided = false;  ///< the lecture's steps have no answer in one plane
};

ladder::Verdict judge(const Answer& got, const Answer& right) {
  ladder::Verdict verdict;
  verdict.undecided = got.undecided;
  verdict.wrong = !got.undecided && got.meet != right.meet;
  return verdict;
}

using Family = pair_families::Family;
using Pair = pair_families::Pair<float>;

Input both_types(const Pair& pair, bool right) {
  const auto in_doubles = pair_families::in<double>(pair);
  return {pair.first, pair.second, in_doubles.first, in_doubles.second, right};
}
/// The largest coordinate of a pair, by its absolute value.
double size_of(const Input& input) {
  double size = 0;
  for (const Triangle<double>* t : {&input.first_in_double, &input.second_in_double}) {
    for (const Point* p : {&t->a, &t->b, &t->c}) size = std::max(size, p->cwiseAbs().maxCoeff());
  }
  return size;
}

ladder::Example shown(const Input& input, const Answer& got, const Answer& right,
                      const ladder::Method& method) {
  const auto words = [](const Answer& answer) { return answer.meet ? "meet" : "apart"; };
  ladder::Example example;
  const Triangle<float>&t = input.first, &u = input.second;
  example.facts = {ladder::numbers("first triangle, a", t.a),
                   ladder::numbers("first triangle, b", t.b),
                   ladder::numbers("first triangle, c", t.c),
                   ladder::numbers("second triangle, a", u.a),
                   ladder::numbers("second triangle, b", u.b),
                   ladder::numbers("second triangle, c", u.c),
                   {"this method", words(got)},
                   {"exact", words(right)}};
  if (method.id.starts_with("intervals") && !method.id.starts_with("intervals-epsilon")) {
    example.note = "The figure has this method with ε only.";
    return example;
  }
  const double size = size_of(input);
  if (size < 0x1p-4) {
    example.note = "The figure would show triangles as small as these as points.";
    return example;
  }
  // The scale is a power of two, so that nothing is rounded. A method with an ε depends on it.
  const double scale = size > 4 ? std::ldexp(1.0, 1 - std::ilogb(size)) : 1;
  if (method.id.starts_with("intervals") && scale != 1) {
    example.note = "The figure would show smaller triangles, for which ε is another length.";
    return example;
  }
  const Triangle<double>&v = input.first_in_double, &w = input.second_in_double;
  const Point low = v.a.cwiseMin(v.b).cwiseMin(v.c).cwiseMin(w.a).cwiseMin(w.b).cwiseMin(w.c);
  const Point high = v.a.cwiseMax(v.b).cwiseMax(v.c).cwiseMax(w.a).cwiseMax(w.b).cwiseMax(w.c);
  if ((high - low).maxCoeff() < size / 16) {
    example.note = "So far from the origin, the figure would show both as one point.";
    return example;
  }
  const auto at = [scale](const Point& p) { return Point(p * scale); };
  example.figure = "steps";
  example.fields = {ladder::field("u0", at(v.a)),
                    ladder::field("u1", at(v.b)),
                    ladder::field("u2", at(v.c)),
                    ladder::field("v0", at(w.a)),
                    ladder::field("v1", at(w.b)),
                    ladder::field("v2", at(w.c)),
                    {"single", {method.scalar == "float" ? 1.0 : 0.0}},
                    {"divided", {1}}};
  if (scale != 1) example.note = "All coordinates are divided by a power of two.";
  return example;
}

template <class S>
Answer by_steps(const Triangle<S>& first, const Triangle<S>& second) {
  const contact::PairBySteps<S> steps = contact::meet_by_steps(first, second);
  return {steps.meet, steps.coplanar};
}

/// A pair of one of these families, times a power of two: of about a metre, but for far ones.
template <std::size_t n>
Input whole_pair(generators::Random& random, const std::array<Family, n>& families, int smaller) {
  const Family family = families[static_cast<std::size_t>(random.integer(0, int{n} - 1))];
  const Pair pair = pair_families::pair<float>(random, family);
  const bool right = pair_truth::meet_in_integers(pair.first, pair.second);
  if (family == Family::far) return both_types(pair_families::scaled(pair, -6), right);
  const double size = size_of(both_types(pair, right));
  const int exponent = size > 0 ? -std::ilogb(size) - smaller : 0;
  return both_types(pair_families::scaled(pair, exponent), right);
}

ladder::Ladder<Input, Answer> experiment() {
  ladder::Ladder<Input, Answer> ladder(
      "Do the two triangles meet?", [](const Input& input) { return Answer{input.right}; }, judge);
  const auto family = [&ladder](const char* id, const char* title, auto families, int smaller = 0) {
    ladder.family(id, title, [families, smaller](generators::Random& random) {
      return whole_pair(random, families, smaller);
    });
  };
  family("pair-random", "random", std::array{Family::random});
  family("pair-touching", "touching",
         std::array{Family::vertex_on_vertex, Family::vertex_on_edge, Family::vertex_on_face,
                    Family::edge_on_edge});
  family("pair-shared", "a shared edge", std::array{Family::shared_edge});
  family("pair-coplanar", "in one plane",
         std::array{Family::coplanar_overlapping, Family::coplanar_apart, Family::coplanar_inside});
  family("pair-step", "one step off touching", std::array{Family::one_step});
  family("pair-degenerate", "segments and points", std::array{Family::degenerate});
  family("pair-far", "far from the origin", std::array{Family::far});
  family("pair-small", "random, of 4 mm", std::array{Family::random, Family::near}, 8);

  const auto in_both = [&ladder](const char* id, const char* title, auto method) {
    ladder.method(plain(id, "-float", title, "float"), [method](const Input& input) {
      return Answer{method(input.first, input.second)};
    });
    ladder.method(plain(id, "-double", title, "double"), [method](const Input& input) {
      return Answer{method(input.first_in_double, input.second_in_double)};
    });
  };
  in_both("steps", "the lecture's four steps",
          [](const auto& a, const auto& b) { return by_steps(a, b); });
  in_both("intervals", "intervals, without ε",
          [](const auto& a, const auto& b) { return contact::meet_by_intervals(a, b); });
  in_both("intervals-epsilon", "intervals, ε = 10⁻⁶", [](const auto& a, const auto& b) {
    using S = std::decay_t<decltype(a.a.x())>;
    return contact::meet_by_intervals(a, b, S(1e-6));
  });
  in_both("edges", "six edges, Möller–Trumbore",
          [](const auto& a, const auto& b) { return contact::meet_by_edges(a, b); });
  in_both("orientations", "Guigue–Devillers",
          [](const auto& a, const auto& b) { return contact::meet_by_orientations(a, b); });
  ladder.method(
      exact("meet", "orientations, filtered", "double, then exact"), [](const Input& input) {
        return Answer{contact::triangles_meet(input.first_in_double, input.second_in_double)};
      });
  ladder.method(
      exact("meet-unfiltered", "orientations, no filter", "exact"), [](const Input& input) {
        return Answer{
            contact::triangles_meet_unfiltered(input.first_in_double, input.second_in_double)};
      });
  const auto peer = [&ladder](const char* id, const char* title) {
    ladder.peer(
        {.id = id, .title = title, .scalar = "JavaScript", .asks = 18, .tells = 1},
        [](const Input& input, std::vector<double>& to) {
          for (const Triangle<double>* t : {&input.first_in_double, &input.second_in_double})
            for (const Point* p : {&t->a, &t->b, &t->c}) to.insert(to.end(), p->begin(), p->end());
        },
        [](const double* told, const Answer&) { return Answer{told[0] != 0}; });
  };
  peer("bvh-triangles", "three-mesh-bvh");
  peer("fast-triangles", "fast-triangle-triangle-intersection");
  ladder.recommend("meet");
  ladder.show(shown);
  return ladder;
}

}  // namespace pairs

namespace meshes {

/// Two meshes, and what is built once over them.
struct Input {
  Mesh<float> first, second;
  Mesh<double> first_in_double, second_in_double;
  std::optional<MeshTree<double>> first_tree, second_tree;
  std::vector<TrianglePair> right;
};
using Asked = std::shared_ptr<const Input>;
using Answer = std::vector<TrianglePair>;

/// Each with each, meshes have a hundred thousand pairs of triangles.
constexpr std::size_t max_inputs = 60;

std::pair<int, int> numbers(const TrianglePair& pair) { return {pair.of_first, pair.of_second}; }

/// Wrong is a list that lacks a pair or has one too many.
ladder::Verdict judge(const Answer& got, const Answer& right) {
  ladder::Verdict verdict;
  verdict.wrong =
      !std::equal(got.begin(), got.end(), right.begin(), right.end(),
                  [](const auto& x, const auto& y) { return numbers(x) == numbers(y); });
  return verdict;
}

/// Calls each(i, j) for all pairs of triangles.
template <class S, class Each>
void each_pair(const Mesh<S>& first, const Mesh<S>& second, const Each& each) {
  for (std::size_t i = 0; i < first.triangles.size(); ++i) {
    for (std::size_t j = 0; j < second.triangles.size(); ++j) each(i, j);
  }
}
template <class S, class Meet>
Answer each_with_each(const Mesh<S>& first, const Mesh<S>& second, const Meet& meet) {
  Answer answer;
  each_pair(first, second, [&](std::size_t i, std::size_t j) {
    if (meet(contact::triangle_of(first, i), contact::triangle_of(second, j))) {
      answer.push_back({static_cast<int>(i), static_cast<int>(j)});
    }
  });
  return answer;
}

/// A tree of the second mesh, asked about the box of each triangle of the first.
Answer by_one_tree(const Mesh<double>& first, const MeshTree<double>& second) {
  Answer answer;
  for (std::size_t i = 0; i < first.triangles.size(); ++i) {
    const Triangle<double> t = contact::triangle_of(first, i);
    const contact::Aabb<double> box{t.a.cwiseMin(t.b).cwiseMin(t.c),
                                    t.a.cwiseMax(t.b).cwiseMax(t.c)};
    const auto start = static_cast<std::ptrdiff_t>(answer.size());
    second.visit(
        [&box](const contact::Aabb<double>& other) { return contact::boxes_touch(box, other); },
        [&](int j, const Triangle<double>& u) {
          if (contact::triangles_meet(t, u)) answer.push_back({static_cast<int>(i), j});
          return false;
        });
    std::sort(answer.begin() + start, answer.end(),
              [](const auto& x, const auto& y) { return x.of_second < y.of_second; });
  }
  return answer;
}

/// In steps of 2^-22, of which all coordinates are whole multiples.
Triangle<double> times(const Triangle<double>& t) {
  return {t.a * 0x1p22, t.b * 0x1p22, t.c * 0x1p22};
}

Asked made(const Mesh<double>& first, const Mesh<double>& second) {
  auto input = std::make_shared<Input>();
  const mesh_families::Body a = mesh_families::rounded(first), b = mesh_families::rounded(second);
  input->first = a.in_float;
  input->second = b.in_float;
  input->first_in_double = a.in_double;
  input->second_in_double = b.in_double;
  input->first_tree.emplace(a.in_double);
  input->second_tree.emplace(b.in_double);
  input->right = each_with_each(a.in_double, b.in_double, [](const auto& t, const auto& u) {
    return pair_truth::meet_in_integers(times(t), times(u));
  });
  return input;
}

/// A multiple of 2^-20 in each coordinate, up to `most`.
Point offset(generators::Random& random, double most) {
  Point by{random.uniform(-most, most), random.uniform(-most, most), random.uniform(-most, most)};
  for (double& x : by) x = std::ldexp(std::round(std::ldexp(x, 20)), -20);
  return by;
}
const Mesh<double>& any_of(generators::Random& random, const mesh_families::Bodies& bodies) {
  return mesh_families::any(random, bodies).in_double;
}

/// Meshes of 320 triangles: balls with each vertex moved to a random distance, and tori.
const std::vector<Mesh<double>>& bodies() {
  static const std::vector<Mesh<double>> all = [] {
    generators::Random random(1);
    std::vector<Mesh<double>> made{contact::torus_mesh(0.7, 0.3, 16, 10),
                                   contact::torus_mesh(0.6, 0.15, 20, 8)};
    for (int i = 0; i < 4; ++i) {
      made.push_back(contact::ball_mesh(1, 2));
      for (Point& v : made.back().vertices) v *= random.uniform(0.6, 1);
    }
    for (Mesh<double>& mesh : made) mesh = mesh_families::on_lattice(mesh);
    return made;
  }();
  return all;
}
const Mesh<double>& any_body(generators::Random& random) {
  return bodies()[static_cast<std::size_t>(
      random.integer(0, static_cast<int>(bodies().size()) - 1))];
}

/// Meshes that cross, most of them.
Asked crossing(generators::Random& random) {
  const Mesh<double>& first = any_body(random);
  const Mesh<double>& second = any_body(random);
  return made(first, contact::translated<double>(second, offset(random, 0.7)));
}
/// Boxes, octahedra and prisms at whole numbers: on one another, side by side, within another.
Asked whole(generators::Random& random) {
  const Mesh<double>& first = any_of(random, mesh_families::whole());
  const Mesh<double>& second = any_of(random, mesh_families::whole());
  const Point by{double(random.integer(-3, 3)), double(random.integer(-3, 3)),
                 double(random.integer(-3, 3))};
  return made(first, contact::translated<double>(second, by));
}
/// A mesh and the same one, or one that has a vertex of the other's as its own.
Asked touching(generators::Random& random) {
  const Mesh<double>& first = any_body(random);
  if (random.chance(0.25)) return made(first, first);
  const Mesh<double>& second = any_body(random);
  const Point at = mesh_families::any_vertex(random, first);
  return made(first,
              contact::translated<double>(second, at - mesh_families::any_vertex(random, second)));
}
/// A mesh and the same one up to a micrometre beside.
Asked close(generators::Random& random) {
  const Mesh<double>& first = any_body(random);
  return made(first, contact::translated<double>(first, offset(random, 0x1p-18)));
}
/// Half a million metres away, where floats are a thirty-second apart, and eight times as large.
Asked far_away(generators::Random& random) {
  Mesh<double> first = any_body(random);
  for (Point& v : first.vertices) v = 8 * v + Point::Constant(0x1.8p18);
  const Mesh<double> rounded = mesh_families::rounded(first).in_double;
  const Point by{double(random.integer(-3, 3)), double(random.integer(-3, 3)),
                 double(random.integer(-3, 3))};
  return made(rounded, contact::translated<double>(rounded, by));
}

ladder::Example shown(const Asked& input, const Answer& got, const Answer& right,
                      const ladder::Method&) {
  ladder::Example example;
  const auto count = [](std::size_t number) { return static_cast<double>(number); };
  example.facts = {ladder::number("triangles of the first", count(input->first.triangles.size())),
                   ladder::number("triangles of the second", count(input->second.triangles.size())),
                   ladder::number("pairs, this method", count(got.size())),
                   ladder::number("pairs, exact", count(right.size()))};
  for (const bool missed : {true, false}) {
    const Answer &from = missed ? right : got, &in = missed ? got : right;
    const auto lacks = [&in](const TrianglePair& pair) {
      return std::none_of(in.begin(), in.end(),
                          [&](const TrianglePair& x) { return numbers(x) == numbers(pair); });
    };
    const auto pair = std::find_if(from.begin(), from.end(), lacks);
    if (pair == from.end()) continue;
    example.facts.push_back(
        {missed ? "a pair that it misses" : "a pair that it invents",
         std::to_string(pair->of_first) + " and " + std::to_string(pair->of_second)});
  }
  example.note = "The figures show other meshes.";
  return example;
}

ladder::Ladder<Asked, Answer> experiment() {
  ladder::Ladder<Asked, Answer> ladder(
      "Which triangles of two meshes meet?", [](const Asked& input) { return input->right; },
      judge);
  ladder.at_most(max_inputs);
  const auto family = [&ladder](const char* id, const char* title, auto generator) {
    ladder.family(id, title, generator);
  };
  family("mesh-crossing", "crossing", crossing);
  family("mesh-whole", "whole numbers", whole);
  family("mesh-touching", "with a common vertex", touching);
  family("mesh-close", "nearly the same mesh", close);
  family("mesh-far", "far from the origin", far_away);

  ladder.method(plain("all-intervals", "", "each with each, intervals, ε = 10⁻⁶", "float"),
                [](const Asked& input) {
                  return each_with_each(input->first, input->second,
                                        [](const auto& t, const auto& u) {
                                          return contact::meet_by_intervals(t, u, 1e-6F);
                                        });
                });
  ladder.method(plain("all-orientations", "", "each with each, Guigue–Devillers", "double"),
                [](const Asked& input) {
                  return each_with_each(input->first_in_double, input->second_in_double,
                                        [](const auto& t, const auto& u) {
                                          return contact::meet_by_orientations(t, u);
                                        });
                });
  ladder.method(exact("all-meet", "each with each, filtered", "double, then exact"),
                [](const Asked& input) {
                  return each_with_each(
                      input->first_in_double, input->second_in_double,
                      [](const auto& t, const auto& u) { return contact::triangles_meet(t, u); });
                });
  ladder.method(
      exact("boxes", "boxes first, filtered", "double, then exact"), [](const Asked& input) {
        return contact::meeting_triangles(input->first_in_double, input->second_in_double);
      });
  ladder.method(
      exact("one-tree", "one tree of boxes, filtered", "double, then exact"),
      [](const Asked& input) { return by_one_tree(input->first_in_double, *input->second_tree); });
  ladder.method(exact("two-trees", "two trees of boxes, filtered", "double, then exact"),
                [](const Asked& input) {
                  return contact::meeting_triangles(*input->first_tree, *input->second_tree);
                });
  ladder.recommend("two-trees");
  ladder.show(shown);
  return ladder;
}

}  // namespace meshes

ladder::Parts experiment() {
  ladder::Parts parts("Triangles and meshes in pairs");
  parts.add(pairs::experiment());
  parts.add(meshes::experiment());
  return parts;
}

}  // namespace

LADDER(experiment)
