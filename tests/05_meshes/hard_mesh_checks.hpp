/// @file
/// The hard cases of triangulation and of the mesh check: questions and methods.
#pragma once

#include <05_meshes/hard_mesh.hpp>
#include <05_meshes/mesh_check_truth.hpp>
#include <05_meshes/triangulate_truth.hpp>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <contact/mesh_check.hpp>
#include <contact/triangulate.hpp>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <support/hard_cases.hpp>
#include <utility>
#include <vector>

namespace hard_mesh_checks {

using contact::Mesh;
using contact::Vector2;
using contact::Vector3;
using hard_cases::Case;
using hard_cases::Json;
using hard_mesh::mesh_of;
using oracle::Rational;
using triangulate_truth::Rings;
using triangulate_truth::Triangles;

// ---------------------------------------------------------------- input

/// The numbers of vertices of the rings, and all vertices, x and y.
inline Rings rings_of(const Case& c) {
  const std::vector<double> sizes = c.numbers("sizes"), points = c.numbers("points");
  Rings rings;
  std::size_t next = 0;
  for (const double size : sizes) {
    rings.emplace_back();
    for (int i = 0; i < static_cast<int>(size); ++i, next += 2) {
      rings.back().push_back({points.at(next), points.at(next + 1)});
    }
  }
  return rings;
}

/// Triangles with vertices of their own.
inline Mesh<double> soup_of(const Case& c) {
  Mesh<double> soup = contact::triangle_soup(mesh_of(c));
  for (const double triangle : c.numbers("negative_zeros")) {
    for (const int v : soup.triangles[static_cast<std::size_t>(triangle)]) {
      for (double& x : soup.vertices[static_cast<std::size_t>(v)]) {
        if (x == 0) x = -0.0;
      }
    }
  }
  return soup;
}

// ---------------------------------------------------------------- triangulations as they are often
// written

/// The orientation of three points as a method sees it.
using Side = int (*)(const Vector2<double>&, const Vector2<double>&, const Vector2<double>&);

inline int rounded_side(const Vector2<double>& a, const Vector2<double>& b,
                        const Vector2<double>& c) {
  const double x = contact::orientation_expanded<double>(a, b, c);
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

/// Ear clipping without a check of the rings. A hole is joined by the shortest bridge between a
/// vertex of it and one of the chain, whatever is between them.
class Ears {
 public:
  Ears(const Rings& rings, Side side, bool tests_border)
      : side_(side), tests_border_(tests_border) {
    std::vector<int> holes;
    for (const contact::Polygon<double>& ring : rings) {
      std::vector<int> indices;
      for (const Vector2<double>& v : ring) {
        indices.push_back(static_cast<int>(points_.size()));
        points_.push_back(v);
      }
      const bool outer = &ring == &rings.front();
      if ((contact::doubled_area<double>(ring) > 0) != outer) {
        std::reverse(indices.begin(), indices.end());
      }
      if (outer) {
        chain_ = indices;
      } else {
        join(indices);
      }
    }
  }

  std::optional<Triangles> clip() {
    Triangles triangles;
    while (chain_.size() > 3) {
      const std::size_t n = chain_.size();
      std::size_t i = 0;
      while (i < n && !is_ear(i)) ++i;
      if (i == n) return std::nullopt;
      triangles.push_back({chain_[(i + n - 1) % n], chain_[i], chain_[(i + 1) % n]});
      chain_.erase(chain_.begin() + static_cast<std::ptrdiff_t>(i));
    }
    triangles.push_back({chain_[0], chain_[1], chain_[2]});
    return triangles;
  }

 private:
  Side side_;
  bool tests_border_;
  std::vector<Vector2<double>> points_;
  std::vector<int> chain_;

  const Vector2<double>& at(int i) const { return points_[static_cast<std::size_t>(i)]; }

  void join(const std::vector<int>& hole) {
    std::size_t from = 0, to = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < hole.size(); ++i) {
      for (std::size_t j = 0; j < chain_.size(); ++j) {
        const double distance = (at(hole[i]) - at(chain_[j])).squaredNorm();
        if (!(distance < least)) continue;
        least = distance;
        from = i;
        to = j;
      }
    }
    std::vector<int> detour;
    for (std::size_t i = 0; i <= hole.size(); ++i) detour.push_back(hole[(from + i) % hole.size()]);
    detour.push_back(chain_[to]);
    chain_.insert(chain_.begin() + static_cast<std::ptrdiff_t>(to) + 1, detour.begin(),
                  detour.end());
  }

  bool is_ear(std::size_t i) const {
    const std::size_t n = chain_.size();
    const Vector2<double>&a = at(chain_[(i + n - 1) % n]), &b = at(chain_[i]),
          &c = at(chain_[(i + 1) % n]);
    if (side_(a, b, c) <= 0) return false;
    const int least = tests_border_ ? 0 : 1;
    return std::none_of(chain_.begin(), chain_.end(), [&](int v) {
      const Vector2<double>& p = at(v);
      return p != a && p != b && p != c && side_(a, b, p) >= least && side_(b, c, p) >= least &&
             side_(c, a, p) >= least;
    });
  }
};

inline Triangles fan(const Rings& rings) {
  Triangles triangles;
  const int n = static_cast<int>(rings[0].size());
  for (int i = 1; i + 1 < n; ++i) {
    triangles.push_back({0, i, i + 1});
    if (contact::doubled_area<double>(rings[0]) < 0) triangles.back() = {0, i + 1, i};
  }
  return triangles;
}

/// Right: the rings are refused if they have to be, and else covered once.
inline bool right(const Case& c, const std::optional<Triangles>& got, const Json& answer) {
  if (got.has_value() != answer.at("valid").get<bool>()) return false;
  return !got || triangulate_truth::Region<Rational>(rings_of(c)).fault(*got).empty();
}

// ---------------------------------------------------------------- checks as they are often written

using Edge = std::pair<int, int>;

/// How many triangles each edge has, without its direction.
inline bool every_edge_twice(const Mesh<double>& mesh) {
  std::map<Edge, int> count;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++count[std::minmax(t[k], t[(k + 1) % 3])];
  }
  return !count.empty() &&
         std::all_of(count.begin(), count.end(), [](const auto& e) { return e.second == 2; });
}

/// Each edge once in each direction.
inline bool paired_edges(const Mesh<double>& mesh) {
  std::map<Edge, int> count;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++count[{t[k], t[(k + 1) % 3]}];
  }
  return !count.empty() && std::all_of(count.begin(), count.end(), [&count](const auto& e) {
    return e.second == 1 && count.count({e.first.second, e.first.first}) != 0;
  });
}

inline bool by_euler(const Mesh<double>& mesh) {
  std::set<Edge> edges;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
  }
  return mesh.vertices.size() + mesh.triangles.size() == edges.size() + 2;
}

inline bool by_rounded_volume(const Mesh<double>& mesh) {
  double six_volumes = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const contact::Triangle<double> t = triangle_of(mesh, i);
    six_volumes += t.a.dot(t.b.cross(t.c));
  }
  return paired_edges(mesh) && six_volumes > 0;
}

/// Merges vertices that are equal by a test, each with the first such.
template <class Equal>
Mesh<double> merged(Mesh<double> mesh, const Equal& equal) {
  for (auto& t : mesh.triangles) {
    for (int& v : t) {
      for (int w = 0; w < v; ++w) {
        if (!equal(mesh.vertices[static_cast<std::size_t>(v)],
                   mesh.vertices[static_cast<std::size_t>(w)])) {
          continue;
        }
        v = w;
        break;
      }
    }
  }
  return mesh;
}
inline bool same_bits(const Vector3<double>& v, const Vector3<double>& w) {
  for (int k = 0; k < 3; ++k) {
    if (std::bit_cast<std::uint64_t>(v[k]) != std::bit_cast<std::uint64_t>(w[k])) return false;
  }
  return true;
}
inline bool within_a_millionth(const Vector3<double>& v, const Vector3<double>& w) {
  return (v - w).cwiseAbs().maxCoeff() <= 1e-6;
}

// ---------------------------------------------------------------- questions

inline Json solid_answer(const Mesh<double>& mesh) {
  const mesh_check_truth::Truth right = mesh_check_truth::truth(mesh);
  Json answer{{"class", "a"}, {"solid", right.solid}};
  if (!right.solid) return answer;
  std::vector<int> all;
  for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i) all.push_back(i);
  const double volume = oracle::nearest(Rational(mesh_check_truth::six_volumes(mesh, all) / 6));
  if (std::isnormal(volume)) answer["volume"] = hard_cases::hex(volume);
  return answer;
}
/// The book's report, and its volume within the bound.
inline bool right_solid(const Mesh<double>& mesh, const Json& answer) {
  const contact::MeshReport report = contact::check_mesh(mesh);
  if (report.bounds_solid() != answer.at("solid").get<bool>()) return false;
  if (!answer.contains("volume")) return true;
  const contact::Bounded volume = contact::mesh_volume(mesh);
  const double exact = hard_cases::unhex(answer, "volume");
  const double room = volume.bound + std::abs(exact) * 0x1p-53 + 0x1p-1074;
  return !(std::abs(volume.value - exact) > room) &&
         contact::mesh_volume_exactly(mesh).nearest() == exact;
}

/// Adds them to a runner.
inline void add_questions(hard_cases::Runner& runner) {
  // Whether rings bound a region, and its triangulation.
  runner.question("triangulation", [](const Case& c) -> Json {
    const triangulate_truth::Region<Rational> region(rings_of(c));
    Json answer{{"class", "a"}, {"valid", region.valid()}};
    if (!region.valid()) return answer;
    answer["triangles"] = region.triangle_count();
    const double area = oracle::nearest(Rational(region.doubled_area() / 2));
    if (std::isnormal(area)) answer["area"] = hard_cases::hex(area);
    return answer;
  });
  runner.method("triangulation", "a fan", [](const Case& c, const Json& answer) {
    return right(c, fan(rings_of(c)), answer);
  });
  runner.method("triangulation", "ears, rounded", [](const Case& c, const Json& answer) {
    return right(c, Ears(rings_of(c), rounded_side, true).clip(), answer);
  });
  runner.method("triangulation", "ears, border not tested", [](const Case& c, const Json& answer) {
    return right(c, Ears(rings_of(c), contact::orient_2d, false).clip(), answer);
  });
  runner.method("triangulation", "ears, shortest bridge", [](const Case& c, const Json& answer) {
    return right(c, Ears(rings_of(c), contact::orient_2d, true).clip(), answer);
  });
  runner.method("triangulation", "the book, exact", [](const Case& c, const Json& answer) {
    const Rings rings = rings_of(c);
    std::optional<Triangles> got;
    try {
      got = contact::triangulate(
          contact::PolygonWithHoles<double>{rings.front(), {rings.begin() + 1, rings.end()}});
    } catch (const std::invalid_argument&) {
    }
    return right(c, got, answer);
  });

  // Whether a mesh bounds a solid, as far as its edges, vertices and volumes say.
  using Says = bool (*)(const Mesh<double>&);
  const auto add_solid = [&runner](const char* name, Says says) {
    runner.method("solid", name, [says](const Case& c, const Json& answer) {
      return says(mesh_of(c)) == answer.at("solid").get<bool>();
    });
  };
  runner.question("solid", [](const Case& c) { return solid_answer(mesh_of(c)); });
  add_solid("every edge twice", every_edge_twice);
  add_solid("edges in pairs", paired_edges);
  add_solid("V - E + F = 2", by_euler);
  add_solid("edges in pairs, rounded volume", by_rounded_volume);
  runner.method("solid", "the book, exact",
                [](const Case& c, const Json& answer) { return right_solid(mesh_of(c), answer); });

  // The same for triangles with vertices of their own.
  runner.question("soup", [](const Case& c) {
    return solid_answer(mesh_check_truth::by_position(soup_of(c)));
  });
  const auto add_soup = [&runner](const char* name, auto merge) {
    runner.method("soup", name, [merge](const Case& c, const Json& answer) {
      return contact::check_mesh(merge(soup_of(c))).bounds_solid() ==
             answer.at("solid").get<bool>();
    });
  };
  add_soup("not merged", [](const Mesh<double>& soup) { return soup; });
  add_soup("merged by bits", [](const Mesh<double>& soup) { return merged(soup, same_bits); });
  add_soup("merged within 1e-6",
           [](const Mesh<double>& soup) { return merged(soup, within_a_millionth); });
  runner.method("soup", "the book, exact", [](const Case& c, const Json& answer) {
    return right_solid(contact::merge_equal_vertices(soup_of(c)), answer);
  });

  // Whether a triangle has area.
  const auto has_area = [](const Case& c, double least) {
    const contact::Triangle<double> t = c.triangle("triangle");
    const Vector3<double> n = Vector3<double>(t.b - t.a).cross(Vector3<double>(t.c - t.a));
    return n.dot(n) > least * least;
  };
  runner.question("area", [](const Case& c) -> Json {
    const contact::Triangle<Rational> t = oracle::exact(c.triangle("triangle"));
    const oracle::Vector n = oracle::Vector(t.b - t.a).cross(oracle::Vector(t.c - t.a));
    return {{"class", "a"}, {"area", n.x() != 0 || n.y() != 0 || n.z() != 0}};
  });
  runner.method("area", "rounded, above 0", [has_area](const Case& c, const Json& answer) {
    return has_area(c, 0) == answer.at("area").get<bool>();
  });
  runner.method("area", "rounded, above 1e-12", [has_area](const Case& c, const Json& answer) {
    return has_area(c, 1e-12) == answer.at("area").get<bool>();
  });
  runner.method("area", "the book, exact", [](const Case& c, const Json& answer) {
    const contact::Triangle<double> t = c.triangle("triangle");
    const Mesh<double> mesh{{t.a, t.b, t.c}, {{0, 1, 2}}};
    return (contact::check_mesh(mesh).count(contact::MeshFaultKind::no_area) == 0) ==
           answer.at("area").get<bool>();
  });
}

}  // namespace hard_mesh_checks
