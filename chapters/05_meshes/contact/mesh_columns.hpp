/// @file
/// Columns over a closed mesh: most points are located by comparing a few coordinates, the rest by
/// a few triangles, without error.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/exact_ray_triangle.hpp>
#include <contact/locate_in_mesh.hpp>
#include <contact/mesh.hpp>
#include <contact/mesh_tree.hpp>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace contact {

// [mesh-columns]
/// A closed and oriented mesh with a grid of vertical columns, built once, for many points.
///
/// The box of the mesh is divided along x and y into about half as many columns as there are
/// triangles. A column lists the triangles whose boxes meet it, in *layers*: intervals of z that
/// contain the boxes of some of them, with gaps between. In the gap between two layers a column has
/// no point of the surface, and this part of it is convex, so the winding number is the same at all
/// its points: it is computed once. A point in a gap is located by comparing its z with the layers'
/// ends, and a point in a layer by the triangles of this layer above it and the winding number of
/// the gap above. In a layer of more than 32 triangles the tree locates it.
///
/// Nothing depends on the rounding of the grid. A coordinate has the column
/// floor((x − low)·scale), and the rounded expression is monotonic: x between a triangle's smallest
/// and largest x has a column between theirs. So a triangle is listed in the columns of all points
/// below and above it, and in all columns it meets.
///
/// Limits: if most triangles are as large as the mesh, columns are few, and the tree does the work.
/// Memory: at most 16 entries of 4 bytes for each triangle, 32 bytes for each layer and 4 bytes for
/// each column, besides the tree.
template <FloatOrDouble S>
class MeshColumns {
 public:
  /// Builds the tree and the columns. A triangle with a coordinate that is not finite is left out.
  /// @throws std::invalid_argument if a triangle names a vertex that does not exist
  explicit MeshColumns(Mesh<S> mesh) : MeshColumns(MeshTree<S>(std::move(mesh))) {}
  /// The same, of a tree that is there.
  explicit MeshColumns(MeshTree<S> tree) : tree_(std::move(tree)) {
    if (tree_.boxes().nodes.empty()) return;
    box_ = tree_.boxes().nodes[0].box;
    choose_grid();
    list_triangles();
  }

  /// The tree over the same mesh.
  const MeshTree<S>& tree() const { return tree_; }

  /// As `locate_in_mesh`.
  MeshLocation locate(const Vector3<S>& point, Rule rule) const;

 private:
  static constexpr int crowded = 32;

  /// An interval of z in a column, with its triangles.
  struct Layer {
    S low, high;
    int first = 0, count = 0;  ///< in listed_; count −1 means that the tree has to be asked
    int winding_below = 0;     ///< in the gap below; 0 below the lowest layer
  };
  /// A triangle in a column while its layers are found.
  struct Listed {
    S low, high;
    int triangle;
  };
  /// The columns of an axis.
  struct Axis {
    double half_low = 0, scale = 0;
    int count = 1;

    int column(double x) const {
      return std::min(static_cast<int>((x / 2 - half_low) * scale), count - 1);
    }
  };

  MeshTree<S> tree_;
  Aabb<S> box_;
  std::array<Axis, 2> axes_;
  std::vector<int> first_layer_;  ///< of each column, and their number
  std::vector<Layer> layers_;     ///< in each column from the lowest to the highest
  std::vector<int> listed_;       ///< triangles

  std::size_t column(int i, int j) const {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(axes_[1].count) +
           static_cast<std::size_t>(j);
  }
  Triangle<double> triangle(int i) const {
    return in_double(triangle_of(tree_.mesh(), static_cast<std::size_t>(i)));
  }
  Axis axis(int k, int count) const {
    Axis made;
    made.half_low = static_cast<double>(box_.low(k)) / 2;
    made.scale = count / (static_cast<double>(box_.high(k)) / 2 - made.half_low);
    made.count = count;
    return std::isfinite(made.scale) ? made : Axis{made.half_low, 0, 1};
  }

  /// Calls with_range(triangle, i0, i1, j0, j1) for the columns that a triangle's box meets.
  template <class WithRange>
  void for_each_range(const WithRange& with_range) const {
    for (const int t : tree_.boxes().order) {
      const auto [a, b, c] = triangle(t);
      with_range(t, axes_[0].column(std::min({a.x(), b.x(), c.x()})),
                 axes_[0].column(std::max({a.x(), b.x(), c.x()})),
                 axes_[1].column(std::min({a.y(), b.y(), c.y()})),
                 axes_[1].column(std::max({a.y(), b.y(), c.y()})));
    }
  }

  void choose_grid();
  void list_triangles();
  void add_layers(int i, int j, std::vector<Listed>& column);
};
// [/mesh-columns]

/// The finest of some grids for which the lists are not too long.
template <FloatOrDouble S>
void MeshColumns<S>::choose_grid() {
  const double triangles = static_cast<double>(tree_.boxes().order.size());
  const double x = static_cast<double>(box_.high.x()) / 2 - static_cast<double>(box_.low.x()) / 2;
  const double y = static_cast<double>(box_.high.y()) / 2 - static_cast<double>(box_.low.y()) / 2;
  const double ratio = x > 0 && y > 0 ? std::clamp(x / y, 1e-6, 1e6) : 1;
  const auto count = [](double wanted) {
    return static_cast<int>(std::clamp(wanted, 1.0, 4096.0));
  };
  int along_x = count(std::sqrt(triangles / 2 * ratio));
  int along_y = count(std::sqrt(triangles / 2 / ratio));
  for (;;) {
    axes_ = {axis(0, along_x), axis(1, along_y)};
    double entries = 0;
    for_each_range([&entries](int, int i0, int i1, int j0, int j1) {
      entries += (i1 - i0 + 1.0) * (j1 - j0 + 1.0);
    });
    if (entries <= 16 * triangles || (along_x == 1 && along_y == 1)) return;
    along_x = std::max(along_x / 2, 1);
    along_y = std::max(along_y / 2, 1);
  }
}

/// Lists the triangles of each column, then its layers.
template <FloatOrDouble S>
void MeshColumns<S>::list_triangles() {
  const std::size_t columns = column(axes_[0].count - 1, axes_[1].count - 1) + 1;
  const auto for_each_entry = [this](const auto& use) {
    for_each_range([&](int t, int i0, int i1, int j0, int j1) {
      for (int i = i0; i <= i1; ++i) {
        for (int j = j0; j <= j1; ++j) use(t, column(i, j));
      }
    });
  };
  std::vector<int> first(columns + 1, 0);
  for_each_entry([&](int, std::size_t c) { ++first[c + 1]; });
  for (std::size_t c = 0; c < columns; ++c) first[c + 1] += first[c];
  std::vector<int> entries(static_cast<std::size_t>(first[columns]));
  std::vector<int> next(first.begin(), first.end() - 1);
  for_each_entry([&](int t, std::size_t c) { entries[static_cast<std::size_t>(next[c]++)] = t; });
  listed_.reserve(entries.size());
  first_layer_.reserve(columns + 1);
  std::vector<Listed> list;
  for (int i = 0; i < axes_[0].count; ++i) {
    for (int j = 0; j < axes_[1].count; ++j) {
      const std::size_t c = column(i, j);
      list.clear();
      for (int e = first[c]; e < first[c + 1]; ++e) {
        const int t = entries[static_cast<std::size_t>(e)];
        const auto [p, q, r] = triangle_of(tree_.mesh(), static_cast<std::size_t>(t));
        list.push_back({std::min({p.z(), q.z(), r.z()}), std::max({p.z(), q.z(), r.z()}), t});
      }
      first_layer_.push_back(static_cast<int>(layers_.size()));
      add_layers(i, j, list);
    }
  }
  first_layer_.push_back(static_cast<int>(layers_.size()));
}

// [add-layers]
/// Finds the layers of column i, j, and the winding numbers in its gaps: from the highest to the
/// lowest, by the triangles of one layer above a sample point of the gap.
template <FloatOrDouble S>
void MeshColumns<S>::add_layers(int i, int j, std::vector<Listed>& column) {
  std::sort(column.begin(), column.end(), [](const Listed& a, const Listed& b) {
    return a.low != b.low ? a.low < b.low : a.triangle < b.triangle;
  });
  const auto middle = [](double a, double b) { return a / 2 + b / 2; };
  const std::size_t lowest = layers_.size();
  for (const Listed& one : column) {
    const bool separate = layers_.size() > lowest && layers_.back().high < one.low &&
                          layers_.back().high < middle(layers_.back().high, one.low) &&
                          middle(layers_.back().high, one.low) < one.low;
    if (separate || layers_.size() == lowest) {
      layers_.push_back({one.low, one.high, static_cast<int>(listed_.size()), 0, 0});
    }
    Layer& layer = layers_.back();
    layer.high = std::max(layer.high, one.high);
    ++layer.count;
    listed_.push_back(one.triangle);
  }
  const auto sample = [&](int k, int index) {
    const Axis& axis = axes_[static_cast<std::size_t>(k)];
    return axis.scale > 0 ? 2 * (axis.half_low + (index + 0.5) / axis.scale) : 2 * axis.half_low;
  };
  Vector3<double> p(sample(0, i), sample(1, j), 0);
  // Far from the origin a column may be thinner than the spacing of numbers.
  const bool in_column = axes_[0].column(p.x()) == i && axes_[1].column(p.y()) == j;
  int winding = 0;
  for (std::size_t k = layers_.size(); k-- > lowest;) {
    Layer& layer = layers_[k];
    if (k > lowest && in_column) {
      p.z() = middle(layers_[k - 1].high, layer.low);
      const auto first = listed_.begin() + layer.first;
      std::for_each(first, first + layer.count,
                    [&](int t) { winding += mesh_location_detail::crossing(p, triangle(t)).step; });
      layer.winding_below = winding;
    }
    if (layer.count > crowded || !in_column) layer.count = -1;
    if (!in_column) layer.low = k > lowest ? layers_[k - 1].high : layer.low;
  }
}
// [/add-layers]

// [locate-in-columns]
template <FloatOrDouble S>
MeshLocation MeshColumns<S>::locate(const Vector3<S>& point, Rule rule) const {
  using namespace mesh_location_detail;
  for (int k = 0; k < 3; ++k) {
    if (!(box_.low(k) <= point(k) && point(k) <= box_.high(k))) return {};
  }
  if (first_layer_.empty()) return {};
  const std::size_t c = column(axes_[0].column(point.x()), axes_[1].column(point.y()));
  for (int k = first_layer_[c]; k < first_layer_[c + 1]; ++k) {
    const Layer& layer = layers_[static_cast<std::size_t>(k)];
    if (point.z() < layer.low) return off_surface(layer.winding_below, rule);
    if (point.z() > layer.high) continue;
    if (layer.count < 0) return locate_in_mesh(point, tree_, rule);
    int winding =
        k + 1 < first_layer_[c + 1] ? layers_[static_cast<std::size_t>(k) + 1].winding_below : 0;
    const Vector3<double> p = point.template cast<double>();
    for (int e = layer.first; e < layer.first + layer.count; ++e) {
      const Triangle<double> t = triangle(listed_[static_cast<std::size_t>(e)]);
      if (!column_meets(p, t)) continue;
      const Crossing found = crossing(p, t);
      if (found.on) return {Where::on, 0};
      winding += found.step;
    }
    return off_surface(winding, rule);
  }
  return {};
}
// [/locate-in-columns]

/// Where a point is, relative to a closed and oriented mesh with columns: the answers of
/// `locate_in_mesh` without them, sooner.
///
/// For a mesh that is not closed the winding number means nothing, and may differ. A point that is
/// not finite: outside.
template <FloatOrDouble S>
MeshLocation locate_in_mesh(const Vector3<S>& point, const MeshColumns<S>& columns,
                            Rule rule = Rule::non_zero) {
  return columns.locate(point, rule);
}

}  // namespace contact
