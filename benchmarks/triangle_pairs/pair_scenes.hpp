/// @file
/// The pairs of triangles of the comparison with other programs, with the right answers.
#pragma once

#include <06_triangle_pairs/pair_families.hpp>
#include <06_triangle_pairs/pair_truth.hpp>
#include <support/generators.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/exact.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "peers.hpp"

namespace pair_scenes {

using generators::Random;
using Family = pair_families::Family;
using Pair = pair_families::Pair<double>;

struct Pairs {
  std::string name, title;
  std::vector<Pair> pairs;
  std::vector<std::array<peers::Corners, 2>> plain;
  std::vector<char> right;  ///< 1 where they meet

  std::size_t meeting() const {
    return static_cast<std::size_t>(std::count(right.begin(), right.end(), 1));
  }
};

inline peers::Corners plain(const contact::Triangle<double>& t) {
  const auto numbers = [](const contact::Vector3<double>& v) {
    return peers::Numbers{v.x(), v.y(), v.z()};
  };
  return {numbers(t.a), numbers(t.b), numbers(t.c)};
}

inline double size_of(const Pair& pair) {
  double size = 0;
  for (const auto* t : {&pair.first, &pair.second}) {
    for (const auto* v : {&t->a, &t->b, &t->c}) size = std::max(size, v->cwiseAbs().maxCoeff());
  }
  return size;
}
/// Times a power of two, so that its largest coordinate is from 1 to 2 m, or that much smaller.
inline Pair about_a_metre(const Pair& pair, int smaller = 0) {
  const double size = size_of(pair);
  return size > 0 ? pair_families::scaled(pair, -std::ilogb(size) - smaller) : pair;
}

inline void add(Pairs& to, const Pair& pair, bool right) {
  to.pairs.push_back(pair);
  to.plain.push_back({plain(pair.first), plain(pair.second)});
  to.right.push_back(right ? 1 : 0);
}

/// Whether a triangle has an area.
inline bool has_area(const contact::Triangle<double>& t) {
  const auto exact = [](const contact::Vector3<double>& v) {
    return contact::Vector3<contact::Exact>(contact::Exact(v.x()), contact::Exact(v.y()),
                                            contact::Exact(v.z()));
  };
  const contact::Vector3<contact::Exact> a = exact(t.a);
  const contact::Vector3<contact::Exact> normal = (exact(t.b) - a).cross(exact(t.c) - a);
  return normal.x().sign() != 0 || normal.y().sign() != 0 || normal.z().sign() != 0;
}
/// Other programs require that triangles have areas: those without are a family of their own.
inline bool belongs(const Pair& pair, Family family) {
  return family == Family::degenerate || (has_area(pair.first) && has_area(pair.second));
}

/// Pairs at whole numbers, which are then made smaller by a power of two. Those far from the origin
/// stay some metres in size.
inline Pairs whole(Family family, std::string name, std::string title, std::size_t count,
                   int smaller = 0) {
  Random random(static_cast<std::uint64_t>(family) + 1);
  Pairs pairs{std::move(name), std::move(title), {}, {}, {}};
  while (pairs.pairs.size() < count) {
    const Pair pair = pair_families::pair<double>(random, family);
    if (!belongs(pair, family)) continue;
    add(pairs,
        family == Family::far ? pair_families::scaled(pair, -6) : about_a_metre(pair, smaller),
        pair_truth::meet_in_integers(pair.first, pair.second));
  }
  return pairs;
}
/// Pairs of all families, moved and rounded.
inline Pairs rounded(std::size_t count) {
  Random random(100);
  Pairs pairs{"rounded", "all but segments and points, moved and rounded", {}, {}, {}};
  while (pairs.pairs.size() < count) {
    for (const Family family : pair_families::all) {
      const Pair pair = pair_families::rounded_pair<double>(random, family);
      if (family == Family::degenerate || !belongs(pair, family)) continue;
      add(pairs, family == Family::far ? pair_families::scaled(pair, -6) : about_a_metre(pair),
          pair_truth::meet_exactly(pair.first, pair.second));
    }
  }
  return pairs;
}

/// Calls with the pairs of each family, one after the other.
template <class Call>
void each_family(std::size_t count, const Call& call) {
  for (const Family family : pair_families::all) {
    std::string title(pair_families::name(family)), name;
    for (const char c : title) {
      if (c != ',') name += c == ' ' ? '_' : c;
    }
    call(whole(family, name, title, count));
  }
  call(whole(Family::near, "small", "near, of 4 mm", count, 8));
  call(whole(Family::near, "tiny", "near, of 15 micrometres", count, 16));
  call(rounded(count));
}

/// Writes FOLDER/pairs: of each family NAME its NAME.f64 (six vertices of a pair, one after the
/// other) and NAME.right.i8, and families.tsv with names and titles.
inline bool write(const std::filesystem::path& folder, std::size_t count) {
  const std::filesystem::path to = folder / "pairs";
  std::filesystem::create_directories(to);
  std::ofstream list(to / "families.tsv");
  each_family(count, [&](const Pairs& pairs) {
    const auto bytes = [](const auto& numbers) {
      return static_cast<std::streamsize>(numbers.size() * sizeof(numbers.front()));
    };
    std::ofstream(to / (pairs.name + ".f64"), std::ios::binary)
        .write(reinterpret_cast<const char*>(pairs.plain.data()), bytes(pairs.plain));
    std::ofstream(to / (pairs.name + ".right.i8"), std::ios::binary)
        .write(pairs.right.data(), bytes(pairs.right));
    list << pairs.name << "\t" << pairs.title << "\n";
  });
  return list.flush().good();
}

inline std::vector<Pair> read(const std::filesystem::path& folder, const std::string& name) {
  std::ifstream in(folder / (name + ".f64"), std::ios::binary);
  std::vector<Pair> pairs;
  std::array<peers::Numbers, 6> p;
  while (in.read(reinterpret_cast<char*>(p.data()), sizeof p)) {
    const auto at = [&p](std::size_t i) {
      return contact::Vector3<double>(p[i][0], p[i][1], p[i][2]);
    };
    pairs.push_back({{at(0), at(1), at(2)}, {at(3), at(4), at(5)}});
  }
  return pairs;
}

}  // namespace pair_scenes
