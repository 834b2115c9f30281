// A stack of slices by CGAL: at each orientation the union of the Minkowski sums of all pieces of A and all pieces of -R B, by reduced
// convolution with exact arithmetic. Free faces of consecutive slices are taken for connected where they overlap.
//
// Input: for A, then for B, the number of pieces; for each the number of rings, the outer one first; for each the number of corners and
// their coordinates. Arguments: the number of slices over the turn; seconds after which it gives up and prints nothing; a slice and a
// position in it; the area below which a face is taken for rounding.
// Output: the number of connected regions; of the position 0 for blocked, 1 for connected with the outside, 2 for free and not;
// seconds; seconds for one slice.

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>
#include <CGAL/minkowski_sum_2.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <utility>
#include <vector>

typedef CGAL::Exact_predicates_exact_constructions_kernel Kernel;
typedef CGAL::Polygon_2<Kernel> Ring;
typedef CGAL::Polygon_with_holes_2<Kernel> Piece;
typedef CGAL::Polygon_set_2<Kernel> Set;
typedef std::vector<std::vector<std::vector<std::pair<double, double>>>> Part;

static Part read() {
  Part part;
  std::size_t pieces = 0;
  std::cin >> pieces;
  part.resize(pieces);
  for (auto &piece : part) {
    std::size_t rings = 0;
    std::cin >> rings;
    piece.resize(rings);
    for (auto &ring : piece) {
      std::size_t corners = 0;
      std::cin >> corners;
      ring.resize(corners);
      for (auto &p : ring) std::cin >> p.first >> p.second;
    }
  }
  return part;
}

// The pieces turned by the matrix (cos, -sin; sin, cos).
static std::vector<Piece> placed(const Part &part, double cos, double sin) {
  std::vector<Piece> pieces;
  for (const auto &rings : part) {
    std::vector<Ring> loops;
    for (const auto &ring : rings) {
      Ring loop;
      for (const auto &p : ring)
        loop.push_back(Kernel::Point_2(cos * p.first - sin * p.second, sin * p.first + cos * p.second));
      loops.push_back(loop);
    }
    pieces.push_back(Piece(loops[0], loops.begin() + 1, loops.end()));
  }
  return pieces;
}

// The connected faces of free space.
static std::vector<Piece> faces(const std::vector<Piece> &a, const std::vector<Piece> &b, double least_area) {
  Set blocked;
  for (const auto &p : a)
    for (const auto &q : b) blocked.join(CGAL::minkowski_sum_by_reduced_convolution_2(p, q));
  blocked.complement();
  std::vector<Piece> all, found;
  blocked.polygons_with_holes(std::back_inserter(all));
  for (const auto &face : all)
    if (face.is_unbounded() || CGAL::to_double(face.outer_boundary().area()) > least_area) found.push_back(face);
  return found;
}

static bool overlap(const Piece &a, const Piece &b) {
  if (a.is_unbounded() && b.is_unbounded()) return true;
  if (!a.is_unbounded() && !b.is_unbounded() &&
      !CGAL::do_overlap(a.outer_boundary().bbox(), b.outer_boundary().bbox()))
    return false;
  return CGAL::do_intersect(a, b);
}

static bool contains(const Piece &face, const Kernel::Point_2 &p) {
  if (!face.is_unbounded() && !face.outer_boundary().has_on_bounded_side(p)) return false;
  for (auto hole = face.holes_begin(); hole != face.holes_end(); ++hole) {
    Ring ring = *hole;
    if (ring.has_on_bounded_side(p)) return false;
  }
  return true;
}

static std::size_t root(const std::vector<std::size_t> &parent, std::size_t i) {
  while (parent[i] != i) i = parent[i];
  return i;
}

int main(int count, char **arguments) {
  if (count != 7) return 2;
  const int slices = std::atoi(arguments[1]);
  const double limit = std::atof(arguments[2]);
  const int asked = std::atoi(arguments[3]);
  const Kernel::Point_2 position(std::atof(arguments[4]), std::atof(arguments[5]));
  const double least_area = std::atof(arguments[6]);
  const double pi = std::acos(-1.0);
  const Part a = read(), b = read();
  const auto begin = std::chrono::steady_clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  double of_slices = 0.0;
  const auto slice = [&](int k) {
    const double from = seconds(), theta = -pi + (k + 0.5) * 2.0 * pi / slices;
    auto found = faces(placed(a, 1.0, 0.0), placed(b, -std::cos(theta), -std::sin(theta)), least_area);
    of_slices += seconds() - from;
    return found;
  };

  std::vector<std::size_t> parent;
  const std::size_t nowhere = static_cast<std::size_t>(-1);
  std::size_t open = nowhere, place = nowhere;
  const auto name = [&](int k, const std::vector<Piece> &found) {
    std::vector<std::size_t> names;
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (found[i].is_unbounded() && open == nowhere) open = parent.size();
      if (k == asked && contains(found[i], position)) place = parent.size();
      names.push_back(parent.size());
      parent.push_back(parent.size());
    }
    return names;
  };
  const auto join = [&](const std::vector<Piece> &f, const std::vector<std::size_t> &m, const std::vector<Piece> &g,
                        const std::vector<std::size_t> &n) {
    for (std::size_t i = 0; i < f.size(); ++i)
      for (std::size_t j = 0; j < g.size(); ++j)
        if (root(parent, m[i]) != root(parent, n[j]) && overlap(f[i], g[j]))
          parent[root(parent, m[i])] = root(parent, n[j]);
  };
  const auto first = slice(0);
  const auto first_names = name(0, first);
  auto below = first;
  auto names = first_names;
  for (int k = 1; k < slices; ++k) {
    if (seconds() > limit) return 0;
    auto here = slice(k);
    auto here_names = name(k, here);
    join(below, names, here, here_names);
    below = std::move(here);
    names = std::move(here_names);
  }
  join(below, names, first, first_names);

  std::size_t regions = 0;
  for (std::size_t i = 0; i < parent.size(); ++i) regions += parent[i] == i;
  const int said = place == nowhere ? 0 : root(parent, place) == root(parent, open) ? 1 : 2;
  std::cout << regions << ' ' << said << ' ' << seconds() << ' ' << of_slices / slices << '\n';
  return 0;
}
