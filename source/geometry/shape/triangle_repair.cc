// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/shape/triangle_repair.h>

#include <map>
#include <numeric>
#include <set>

namespace contrecoup
{
using dealii::Point;
using dealii::Tensor;

namespace
{
  using Triangle = TriangleMesh::Triangle;
  using Edge = std::pair<std::uint32_t, std::uint32_t>;

  /// A triangle side that uses an edge, with the lower vertex first.
  struct EdgeUse
  {
    Edge edge;
    std::uint32_t triangle;
    bool is_forward; ///< from the lower to the higher vertex

    bool operator<(const EdgeUse &other) const
    {
      return std::tie(edge, triangle) < std::tie(other.edge, other.triangle);
    }
  };

  std::vector<EdgeUse> sorted_edges(const TriangleMesh &mesh)
  {
    std::vector<EdgeUse> uses;
    uses.reserve(3 * mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
      for (unsigned int side = 0; side < 3; ++side)
      {
        const std::uint32_t a = mesh.triangles[t][side];
        const std::uint32_t b = mesh.triangles[t][(side + 1) % 3];
        uses.push_back({std::minmax(a, b), t, a < b});
      }
    std::sort(uses.begin(), uses.end());
    return uses;
  }

  void merge_vertices(TriangleMesh &mesh, RepairReport &report)
  {
    std::vector<std::uint32_t> order(mesh.vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](const std::uint32_t v) {
      const Point<3> &x = mesh.vertices[v];
      return std::make_tuple(x[0], x[1], x[2]);
    };
    std::sort(order.begin(), order.end(), [&](const auto a, const auto b) {
      return key(a) < key(b);
    });
    std::vector<std::uint32_t> number(mesh.vertices.size());
    std::vector<Point<3>> vertices;
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      if (i == 0 || key(order[i]) != key(order[i - 1]))
        vertices.push_back(mesh.vertices[order[i]]);
      number[order[i]] = vertices.size() - 1;
    }
    for (Triangle &triangle : mesh.triangles)
      for (std::uint32_t &vertex : triangle)
        vertex = number[vertex];
    report.n_merged = mesh.vertices.size() - vertices.size();
    mesh.vertices = vertices;
  }

  void drop_degenerate(TriangleMesh &mesh, RepairReport &report)
  {
    std::set<Triangle> known;
    std::vector<Triangle> kept;
    for (const Triangle &triangle : mesh.triangles)
    {
      Triangle sorted = triangle;
      std::sort(sorted.begin(), sorted.end());
      if (mesh.area_vector(triangle).norm() > 0. && known.insert(sorted).second)
        kept.push_back(triangle);
    }
    report.n_degenerate = mesh.triangles.size() - kept.size();
    mesh.triangles = kept;
  }

  /// Neighbours of each triangle across edges of exactly two triangles, and
  /// whether both are consistently oriented.
  struct Neighbors
  {
    std::vector<std::array<std::uint32_t, 3>> triangle;
    std::vector<std::array<bool, 3>> agrees;
    std::vector<unsigned char> count;
  };

  Neighbors find_neighbors(const TriangleMesh &mesh, RepairReport &report)
  {
    Neighbors neighbors;
    neighbors.triangle.resize(mesh.triangles.size());
    neighbors.agrees.resize(mesh.triangles.size());
    neighbors.count.resize(mesh.triangles.size(), 0);
    const std::vector<EdgeUse> uses = sorted_edges(mesh);
    for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end)
    {
      while (end < uses.size() && uses[end].edge == uses[begin].edge)
        ++end;
      if (end - begin > 2)
        ++report.n_branching;
      if (end - begin != 2)
        continue;
      const EdgeUse &a = uses[begin];
      const EdgeUse &b = uses[begin + 1];
      const bool agrees = a.is_forward != b.is_forward;
      for (const auto &[from, to] : {std::make_pair(a.triangle, b.triangle),
                                     std::make_pair(b.triangle, a.triangle)})
      {
        unsigned char &count = neighbors.count[from];
        neighbors.triangle[from][count] = to;
        neighbors.agrees[from][count] = agrees;
        ++count;
      }
    }
    return neighbors;
  }

  void flip(Triangle &triangle)
  {
    std::swap(triangle[1], triangle[2]);
  }

  /// A connected piece of a surface.
  struct Piece
  {
    std::vector<std::uint32_t> triangles;
    std::size_t n_turned = 0;
  };

  /// Reorients triangles to agree with the majority of their piece.
  std::vector<Piece> make_pieces(TriangleMesh &mesh, const Neighbors &neighbors)
  {
    std::vector<Piece> pieces;
    std::vector<signed char> turned(mesh.triangles.size(), -1);
    for (std::uint32_t seed = 0; seed < mesh.triangles.size(); ++seed)
    {
      if (turned[seed] >= 0)
        continue;
      Piece piece;
      piece.triangles.push_back(seed);
      turned[seed] = 0;
      for (std::size_t next = 0; next < piece.triangles.size(); ++next)
      {
        const std::uint32_t t = piece.triangles[next];
        for (unsigned int n = 0; n < neighbors.count[t]; ++n)
        {
          const std::uint32_t other = neighbors.triangle[t][n];
          if (turned[other] >= 0)
            continue;
          turned[other] = neighbors.agrees[t][n] ? turned[t] : 1 - turned[t];
          piece.triangles.push_back(other);
        }
      }
      for (const std::uint32_t t : piece.triangles)
        piece.n_turned += turned[t];
      const bool most = 2 * piece.n_turned > piece.triangles.size();
      if (most)
        piece.n_turned = piece.triangles.size() - piece.n_turned;
      for (const std::uint32_t t : piece.triangles)
        if (turned[t] != (most ? 1 : 0))
          flip(mesh.triangles[t]);
      pieces.push_back(piece);
    }
    return pieces;
  }

  dealii::BoundingBox<3> box_of(const TriangleMesh &mesh, const Piece &piece)
  {
    std::vector<Point<3>> points;
    for (const std::uint32_t t : piece.triangles)
      for (const std::uint32_t vertex : mesh.triangles[t])
        points.push_back(mesh.vertices[vertex]);
    return dealii::BoundingBox<3>(points);
  }

  /// Whether the box of another piece contains that of this piece.
  bool is_enclosed(const std::vector<dealii::BoundingBox<3>> &boxes,
                   const std::size_t piece)
  {
    for (std::size_t other = 0; other < boxes.size(); ++other)
      if (other != piece && boxes[other].point_inside(boxes[piece].vertex(0)) &&
          boxes[other].point_inside(boxes[piece].vertex(7)) &&
          boxes[other].volume() > boxes[piece].volume())
        return true;
    return false;
  }

  void orient(TriangleMesh &mesh, RepairReport &report)
  {
    const Neighbors neighbors = find_neighbors(mesh, report);
    const std::vector<Piece> pieces = make_pieces(mesh, neighbors);
    report.n_pieces = pieces.size();
    std::vector<dealii::BoundingBox<3>> boxes;
    for (const Piece &piece : pieces)
      boxes.push_back(box_of(mesh, piece));
    for (std::size_t p = 0; p < pieces.size(); ++p)
    {
      const Piece &piece = pieces[p];
      report.n_flipped += piece.n_turned;
      double volume = 0.;
      for (const std::uint32_t t : piece.triangles)
        volume += mesh.area_vector(mesh.triangles[t]) *
                  (mesh.vertices[mesh.triangles[t][0]] - boxes[p].center());
      if (volume < 0. && (piece.n_turned > 0 || !is_enclosed(boxes, p)))
      {
        report.n_flipped += piece.triangles.size() - 2 * piece.n_turned;
        for (const std::uint32_t t : piece.triangles)
          flip(mesh.triangles[t]);
      }
    }
  }

  /// Edges with one triangle, directed around holes: successor vertices of
  /// each vertex.
  std::map<std::uint32_t, std::vector<std::uint32_t>>
  find_open_edges(const TriangleMesh &mesh)
  {
    std::map<std::uint32_t, std::vector<std::uint32_t>> next;
    const std::vector<EdgeUse> uses = sorted_edges(mesh);
    for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end)
    {
      while (end < uses.size() && uses[end].edge == uses[begin].edge)
        ++end;
      if (end - begin != 1)
        continue;
      // The new triangle traverses the edge in the opposite direction.
      const auto [low, high] = uses[begin].edge;
      if (uses[begin].is_forward)
        next[high].push_back(low);
      else
        next[low].push_back(high);
    }
    return next;
  }

  void close_hole(const std::vector<std::uint32_t> &loop,
                  TriangleMesh &mesh,
                  RepairReport &report)
  {
    Point<3> middle;
    for (const std::uint32_t vertex : loop)
      middle += Tensor<1, 3>(mesh.vertices[vertex]) / double(loop.size());
    const std::uint32_t tip = mesh.vertices.size();
    if (loop.size() > 3)
      mesh.vertices.push_back(middle);
    const std::size_t before = mesh.triangles.size();
    if (loop.size() == 3)
      mesh.triangles.push_back({{loop[0], loop[1], loop[2]}});
    else
      for (std::size_t i = 0; i < loop.size(); ++i)
        mesh.triangles.push_back({{loop[i], loop[(i + 1) % loop.size()], tip}});
    for (std::size_t t = before; t < mesh.triangles.size(); ++t)
      report.hole_area += mesh.area_vector(mesh.triangles[t]).norm();
    ++report.n_holes;
  }

  void close_holes(TriangleMesh &mesh, RepairReport &report)
  {
    auto next = find_open_edges(mesh);
    while (!next.empty())
    {
      // Follow edges until a vertex recurs; the part in between is a loop.
      std::vector<std::uint32_t> path{next.begin()->first};
      while (true)
      {
        const auto edge = next.find(path.back());
        if (edge == next.end())
        {
          report.n_open_edges += path.size() - 1;
          break;
        }
        const std::uint32_t vertex = edge->second.back();
        edge->second.pop_back();
        if (edge->second.empty())
          next.erase(edge);
        const auto seen = std::find(path.begin(), path.end(), vertex);
        if (seen == path.end())
        {
          path.push_back(vertex);
          continue;
        }
        const std::vector<std::uint32_t> loop(seen, path.end());
        path.erase(seen + 1, path.end());
        if (loop.size() > 2)
          close_hole(loop, mesh, report);
        else
          report.n_open_edges += loop.size();
        if (path.size() == 1)
          break;
      }
    }
  }
} // namespace


std::vector<std::string> RepairReport::lines() const
{
  std::vector<std::string> lines;
  const auto tell = [&](const std::size_t count, const std::string &what) {
    if (count > 0)
      lines.push_back(std::to_string(count) + " " + what);
  };
  tell(n_degenerate, "triangle(s) without area or given twice were dropped");
  tell(n_flipped, "triangle(s) were turned to look outwards");
  tell(n_holes,
       "hole(s) were closed with " + brief(hole_area, 3) +
         " m^2 of new triangles");
  tell(n_open_edges, "edge(s) stay open");
  tell(n_branching, "edge(s) belong to more than two triangles");
  return lines;
}

RepairReport repair(TriangleMesh &mesh)
{
  RepairReport report;
  report.n_triangles = mesh.triangles.size();
  merge_vertices(mesh, report);
  drop_degenerate(mesh, report);
  orient(mesh, report);
  close_holes(mesh, report);
  return report;
}
} // namespace contrecoup
