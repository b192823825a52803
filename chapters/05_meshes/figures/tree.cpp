// A ray through a mesh of 2,304 triangles and a tree of boxes over them: the boxes that the ray is
// compared with, the triangles that are tested, and what a loop over all triangles does.
#include <algorithm>
#include <array>
#include <contact/figure.hpp>
#include <contact/mesh_hits.hpp>
#include <contact/mesh_shapes.hpp>
#include <contact/mesh_tree.hpp>
#include <contact/ray_box.hpp>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

using Vector = contact::Vector3<double>;
using Ray = contact::Ray<double>;

struct Input {
  Vector origin;   // o, start of the ray, m
  Vector through;  // q, to which t = 1 belongs, m
  double query;    // 0 the first hit, 1 any, 2 all
  double level;    // whose boxes are drawn; the root is 0
};

constexpr int around = 48, across = 24;         // vertices around the axis and around the tube
constexpr int drawn_ring = 24, drawn_tube = 8;  // of these the surface is drawn
constexpr std::size_t max_boxes = 96, max_triangles = 256, max_hits = 16;

struct Output {
  double problem;
  std::array<Vector, drawn_ring * drawn_tube> surface;
  double levels;      // the deepest level of the tree
  double boxes_here;  // compared on the chosen level; as many as there is room for are drawn
  std::array<Vector, max_boxes> box_low, box_high;
  std::array<double, max_boxes> box_state;  // 0 not met, 1 opened, 2 met, but behind the first hit
  double boxes, tested;  // compared with the ray, and triangles tested, nearer box first
  std::array<std::array<Vector, 3>, max_triangles> triangle;
  std::array<double, max_triangles> triangle_hit;
  double boxes_in_all, triangles_in_all;
  double loop;                        // triangles that the loop tests
  double wide_boxes, wide_triangles;  // compared and tested by MeshTree, four boxes together
  double hits;                        // of the query
  std::array<Vector, max_hits> at;
  std::array<double, max_hits> t;
  double same;     // 1 if MeshTree and the loop return the same hits
  double next_to;  // goal of a question: the ray meets boxes, but no triangle
};

namespace {

const contact::MeshTree<double>& tree_of_torus() {
  static const contact::MeshTree<double> tree(contact::torus_mesh(1.5, 0.6, around, across));
  return tree;
}

/// What a node's box was found to be.
struct Compared {
  std::size_t node;
  int level;
  double state;
};

/// The walk through the tree of two boxes a node, as the lesson describes it.
class Walk {
 public:
  Walk(const contact::MeshTree<double>& tree, const Ray& ray, int query)
      : tree_(tree), ray_(ray), query_(query) {
    compare(0, 0);
    if (compared_.back().state == 1) open(0, 0);
  }

  const std::vector<Compared>& compared() const { return compared_; }
  const std::vector<int>& tested() const { return tested_; }
  const std::vector<int>& hit() const { return hit_; }

 private:
  /// Where the ray enters the node's box, if it meets it.
  std::optional<double> compare(std::size_t node, int level) {
    const contact::Aabb<double>& box = tree_.boxes().nodes[node].box;
    std::optional<double> entry;
    if (contact::hits_box(ray_, box)) entry = contact::first_hit(ray_, box)->t;
    compared_.push_back({node, level, entry ? 1.0 : 0.0});
    return entry;
  }

  bool ended() const { return query_ == 1 && !hit_.empty(); }

  void open(std::size_t index, int level) {
    const contact::BoxNode<double>& node = tree_.boxes().nodes[index];
    if (node.count > 0) {
      for (int i = node.first; i < node.first + node.count && !ended(); ++i)
        test(tree_.boxes().order[static_cast<std::size_t>(i)]);
      return;
    }
    struct Child {
      std::size_t node, compared;
      double entry;
    };
    std::vector<Child> met;
    for (std::size_t child = std::size_t(node.first); child < std::size_t(node.first) + 2;
         ++child) {
      if (const auto entry = compare(child, level + 1))
        met.push_back({child, compared_.size() - 1, *entry});
    }
    if (met.size() == 2 && met[1].entry < met[0].entry) std::swap(met[0], met[1]);
    for (const Child& child : met) {
      if (ended() || (query_ == 0 && child.entry > first_))
        compared_[child.compared].state = 2;
      else
        open(child.node, level + 1);
    }
  }

  void test(int triangle) {
    tested_.push_back(triangle);
    const auto hit = contact::intersect_exact(
        ray_, contact::triangle_of(tree_.mesh(), static_cast<std::size_t>(triangle)));
    if (!hit) return;
    hit_.push_back(triangle);
    first_ = std::min(first_, hit->t);
  }

  const contact::MeshTree<double>& tree_;
  const Ray& ray_;
  int query_;
  double first_ = std::numeric_limits<double>::infinity();
  std::vector<Compared> compared_;
  std::vector<int> tested_, hit_;
};

int depth_of(const contact::BoxHierarchy<double>& tree, std::size_t node) {
  if (tree.nodes[node].count > 0) return 0;
  const auto first = static_cast<std::size_t>(tree.nodes[node].first);
  return 1 + std::max(depth_of(tree, first), depth_of(tree, first + 1));
}

void draw(const Walk& walk, const contact::MeshTree<double>& tree, int level, Output& out) {
  for (const Compared& compared : walk.compared()) {
    if (compared.level != level) continue;
    const auto k = static_cast<std::size_t>(out.boxes_here);
    ++out.boxes_here;
    if (k >= max_boxes) continue;
    const contact::Aabb<double>& box = tree.boxes().nodes[compared.node].box;
    out.box_low[k] = box.low;
    out.box_high[k] = box.high;
    out.box_state[k] = compared.state;
  }
  for (std::size_t k = 0; k < std::min(max_triangles, walk.tested().size()); ++k) {
    const int tested = walk.tested()[k];
    const auto [a, b, c] = contact::triangle_of(tree.mesh(), static_cast<std::size_t>(tested));
    out.triangle[k] = {a, b, c};
    const auto& hit = walk.hit();
    out.triangle_hit[k] = std::find(hit.begin(), hit.end(), tested) != hit.end() ? 1 : 0;
  }
}

bool same(const contact::MeshHit<double>& x, const contact::MeshHit<double>& y) {
  return x.triangle == y.triangle && x.hit.t == y.hit.t && x.point == y.point;
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  for (const auto* v : {&in.origin, &in.through}) {
    if (v->cwiseAbs().maxCoeff() > 1e6) out.problem = contact::figure::too_large;
  }
  const Ray ray{in.origin, in.through - in.origin};
  if (!(ray.direction.cwiseAbs().maxCoeff() > 1e-6)) out.problem = contact::figure::zero_direction;
  if (out.problem != 0) return out;

  const contact::MeshTree<double>& tree = tree_of_torus();
  const contact::Mesh<double>& mesh = tree.mesh();
  for (int i = 0; i < drawn_ring; ++i) {
    for (int j = 0; j < drawn_tube; ++j) {
      const int vertex = i * (around / drawn_ring) * across + j * (across / drawn_tube);
      out.surface[std::size_t(i * drawn_tube + j)] = mesh.vertices[std::size_t(vertex)];
    }
  }
  out.levels = depth_of(tree.boxes(), 0);
  out.boxes_in_all = double(tree.boxes().nodes.size());
  out.triangles_in_all = double(mesh.triangles.size());

  const int query = in.query == 1 || in.query == 2 ? static_cast<int>(in.query) : 0;
  const Walk walk(tree, ray, query);
  out.boxes = double(walk.compared().size());
  out.tested = double(walk.tested().size());
  draw(walk, tree, static_cast<int>(std::clamp(in.level, 0.0, 100.0)), out);

  contact::TreeCounts counts;
  const auto all = contact::all_mesh_hits(ray, mesh);
  out.loop = out.triangles_in_all;
  const auto show = [&out](double t, const Vector& at) {
    const auto k = static_cast<std::size_t>(out.hits);
    if (k >= max_hits) return;
    ++out.hits;
    out.t[k] = t;
    out.at[k] = at;
  };
  if (query == 2) {
    const auto by_tree = tree.all(ray, &counts);
    out.same = std::equal(all.begin(), all.end(), by_tree.begin(), by_tree.end(), same) ? 1 : 0;
    for (const auto& hit : by_tree) show(hit.hit.t, hit.point);
  } else if (query == 0) {
    const auto by_loop = contact::first_mesh_hit(ray, mesh), by_tree = tree.first(ray, &counts);
    out.same = by_loop.has_value() == by_tree.has_value() && (!by_tree || same(*by_loop, *by_tree));
    if (by_tree) show(by_tree->hit.t, by_tree->point);
  } else {
    const auto in_the_way = [&](int i) {
      return contact::intersect_exact(ray, contact::triangle_of(mesh, std::size_t(i)));
    };
    out.same = tree.any(ray, &counts) == contact::any_mesh_hit(ray, mesh) ? 1 : 0;
    if (!all.empty()) {
      out.loop = 1;
      while (!in_the_way(static_cast<int>(out.loop) - 1)) ++out.loop;
    }
    if (!walk.hit().empty()) {
      const double t = in_the_way(walk.hit()[0])->t;
      show(t, ray.origin + t * ray.direction);
    }
  }
  out.wide_boxes = double(counts.boxes);
  out.wide_triangles = double(counts.triangles);
  out.next_to = out.tested > 0 && all.empty() ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(origin, through, query, level), Output,
       FIELDS(problem, surface, levels, boxes_here, box_low, box_high, box_state, boxes, tested,
              triangle, triangle_hit, boxes_in_all, triangles_in_all, loop, wide_boxes,
              wide_triangles, hits, at, t, same, next_to))
