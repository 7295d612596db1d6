// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/geometry/body/layered_ball.h>

#include <deal.II/base/numbers.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria_description.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace contrecoup
{
namespace
{
  using dealii::Point;
  using dealii::Tensor;

  /// Fraction of the core's axes at the corners of the inner cube, and shape
  /// of the cube: 0 flat, 1 a sphere.
  constexpr double cube_size = 0.5, cube_roundness = 0.6;

  /// Radius left out around the axis of a wedge, relative to the cells there.
  constexpr double axis_part = 0.01;

  /// Creates and numbers nodes. (i, j, k) is a position in the grid of the
  /// inner cube; `layer` counts surfaces from the cube outwards.
  class Nodes
  {
  public:
    explicit Nodes(const LayeredBall &ball)
      : ball_(ball)
    {
      if (ball.wedge_axis > 2)
        return;
      std::array<unsigned int, 3> beside;
      beside.fill(ball.cells_along_cube / 2);
      ++beside[ball.across_middle()];
      axis_radius_ = axis_part * position(beside, 0)[ball.across_middle()];
    }

    unsigned int number(const std::array<unsigned int, 3> &place,
                        const unsigned int layer)
    {
      const std::array<unsigned int, 4> key{
        {place[0], place[1], place[2], layer}};
      const auto found = numbers_.find(key);
      if (found != numbers_.end())
        return found->second;
      numbers_[key] = static_cast<unsigned int>(points_.size());
      points_.push_back(ball_.wedge_axis > 2 ? position(place, layer)
                                             : at_side(place, layer));
      return numbers_[key];
    }

    const std::vector<Point<3>> &points() const
    {
      return points_;
    }

    /// Distance of the innermost nodes of a wedge from its axis [m].
    double axis_radius() const
    {
      return axis_radius_;
    }

  private:
    /// Position in the cube or on its surface, in [-1, 1]^3.
    Tensor<1, 3> in_cube(const std::array<unsigned int, 3> &place) const
    {
      Tensor<1, 3> result;
      for (unsigned int d = 0; d < 3; ++d)
        result[d] = 2. * place[d] / ball_.cells_along_cube - 1.;
      return result;
    }

    /// Direction of a cube position, equidistant in angle.
    static Tensor<1, 3> direction(const Tensor<1, 3> &cube)
    {
      Tensor<1, 3> result;
      for (unsigned int d = 0; d < 3; ++d)
        result[d] = std::tan(0.25 * dealii::numbers::PI * cube[d]);
      return result / result.norm();
    }

    static Point<3> scaled(const Tensor<1, 3> &unit,
                           const std::array<double, 3> &axes)
    {
      return {unit[0] * axes[0], unit[1] * axes[1], unit[2] * axes[2]};
    }

    Point<3> position(const std::array<unsigned int, 3> &place,
                      const unsigned int layer) const
    {
      const Tensor<1, 3> cube = in_cube(place);
      const double size =
        std::max({std::abs(cube[0]), std::abs(cube[1]), std::abs(cube[2])});
      if (size == 0.)
        return {};
      const Tensor<1, 3> way = direction(cube / size);
      // Roundness increases towards the surface of the cube.
      const double round = cube_roundness * size;
      const auto &core = ball_.semi_axes.front();
      const Point<3> inside = scaled(
        cube_size * ((1. - round) * cube / 1.3 + round * size * way), core);
      if (layer == 0)
        return inside;
      unsigned int left = layer;
      for (std::size_t i = 0; i < ball_.cells_across.size(); ++i)
      {
        const unsigned int n = ball_.cells_across[i];
        if (left <= n)
        {
          const Point<3> below =
            i == 0 ? inside : scaled(way, ball_.semi_axes[i - 1]);
          const Point<3> above = scaled(way, ball_.semi_axes[i]);
          return below + (above - below) * (double(left) / n);
        }
        left -= n;
      }
      return {};
    }

    /// Node of a wedge. Its two sides are the first two grid positions not
    /// below the middle.
    Point<3> at_side(std::array<unsigned int, 3> place,
                     const unsigned int layer) const
    {
      const unsigned int out = ball_.across_middle(),
                         side = ball_.normal_to_middle();
      const unsigned int middle = ball_.cells_along_cube / 2;
      const double slope =
        place[side] == middle ? -ball_.wedge_slope : ball_.wedge_slope;
      const bool is_on_axis = place[out] == middle;
      place[side] = middle;
      Point<3> result = position(place, layer);
      if (is_on_axis)
        result[out] = axis_radius_;
      result[side] = slope * result[out];
      return result;
    }

    const LayeredBall &ball_;
    double axis_radius_ = 0.;
    std::map<std::array<unsigned int, 4>, unsigned int> numbers_;
    std::vector<Point<3>> points_;
  };

  void check(const LayeredBall &ball)
  {
    const auto require = [](const bool holds, const std::string &what) {
      if (!holds)
        throw InputError("Layered ball: " + what);
    };
    require(!ball.semi_axes.empty() &&
              ball.semi_axes.size() == ball.cells_across.size(),
            "each layer needs its semi-axes and its number of cells");
    require(ball.cells_along_cube >= 2 && ball.cells_along_cube % 2 == 0,
            "the cells along the inner cube must be even and at least 2");
    for (std::size_t i = 0; i < ball.semi_axes.size(); ++i)
    {
      require(ball.cells_across[i] > 0, "each layer needs a cell across it");
      for (unsigned int d = 0; d < 3; ++d)
        require(ball.semi_axes[i][d] > (i == 0 ? 0. : ball.semi_axes[i - 1][d]),
                "semi-axes must be above 0 and grow from layer to layer");
    }
    if (ball.wedge_axis > 2)
      return;
    const unsigned int a = ball.across_middle(), b = ball.normal_to_middle();
    require(ball.is_halved[a] && ball.is_halved[b],
            "a wedge is halved across its axis");
    require(ball.wedge_slope > 0., "the slope of a wedge is above 0");
    for (const auto &axes : ball.semi_axes)
      require(axes[a] == axes[b], "a wedge needs equal semi-axes across");
  }

  /// Range of the cube's grid that is meshed in a direction.
  std::pair<unsigned int, unsigned int> range(const LayeredBall &ball,
                                              const unsigned int direction)
  {
    const unsigned int n = ball.cells_along_cube;
    const unsigned int first = ball.is_halved[direction] ? n / 2 : 0;
    if (ball.wedge_axis < 3 && direction == ball.normal_to_middle())
      return {first, first + 1};
    return {first, n};
  }

  using BallCells = std::vector<dealii::CellData<3>>;

  /// Corner number after cyclic rotation of the cell's directions.
  unsigned int turned(const unsigned int corner, const unsigned int places)
  {
    return (corner << places | corner >> (3 - places)) & 7U;
  }

  void add_cube(const LayeredBall &ball, Nodes &nodes, BallCells &cells)
  {
    const auto x = range(ball, 0), y = range(ball, 1), z = range(ball, 2);
    const unsigned int places = ball.wedge_axis < 3 ? 2 - ball.wedge_axis : 0;
    for (unsigned int k = z.first; k < z.second; ++k)
      for (unsigned int j = y.first; j < y.second; ++j)
        for (unsigned int i = x.first; i < x.second; ++i)
        {
          dealii::CellData<3> cell;
          for (unsigned int v = 0; v < 8; ++v)
            cell.vertices[turned(v, places)] = nodes.number(
              {{i + (v & 1U), j + (v >> 1U & 1U), k + (v >> 2U)}}, 0);
          cell.material_id = 0;
          cells.push_back(cell);
        }
  }

  /// Adds the block outside one face of the cube, through all layers. @param
  /// axis normal of the face
  void add_block(const LayeredBall &ball,
                 const unsigned int axis,
                 const bool is_upper,
                 Nodes &nodes,
                 BallCells &cells)
  {
    const unsigned int n = ball.cells_along_cube;
    // Rotate directions so that cells are not inverted.
    const unsigned int a = (axis + 1) % 3, b = (axis + 2) % 3;
    const auto along_a = range(ball, a), along_b = range(ball, b);
    const unsigned int places =
      ball.wedge_axis < 3 && axis == ball.across_middle() ? 1 : 0;
    unsigned int layer = 0;
    for (std::size_t part = 0; part < ball.cells_across.size(); ++part)
      for (unsigned int m = 0; m < ball.cells_across[part]; ++m, ++layer)
        for (unsigned int j = along_b.first; j < along_b.second; ++j)
          for (unsigned int i = along_a.first; i < along_a.second; ++i)
          {
            dealii::CellData<3> cell;
            for (unsigned int v = 0; v < 8; ++v)
            {
              std::array<unsigned int, 3> place;
              place[axis] = is_upper ? n : 0;
              place[a] = i + (is_upper ? v & 1U : 1U - (v & 1U));
              place[b] = j + (v >> 1U & 1U);
              cell.vertices[turned(v, places)] =
                nodes.number(place, layer + (v >> 2U));
            }
            cell.material_id = static_cast<dealii::types::material_id>(part);
            cells.push_back(cell);
          }
  }

  /// Sets boundary ids of the sides of a wedge and of the prism at its axis.
  template <typename Face>
  void set_wedge_boundary(const LayeredBall &ball,
                          const double axis_radius,
                          const Face &face)
  {
    const unsigned int out = ball.across_middle(),
                       side = ball.normal_to_middle();
    // Absolute tolerance of coordinates on sides and axis.
    constexpr double tolerance = 1e-9;
    double least = std::numeric_limits<double>::max(), most = -least,
           farthest = 0.;
    for (const unsigned int v : face->vertex_indices())
    {
      const auto &vertex = face->vertex(v);
      least = std::min(least, vertex[side] / (ball.wedge_slope * vertex[out]));
      most = std::max(most, vertex[side] / (ball.wedge_slope * vertex[out]));
      farthest = std::max(farthest, vertex[out]);
    }
    if (least > 1. - tolerance || most < -1. + tolerance)
      face->set_boundary_id(side + 1);
    else if (farthest < 2. * axis_radius)
      face->set_boundary_id(out + 1);
  }

  void set_boundaries(const LayeredBall &ball,
                      const double axis_radius,
                      dealii::Triangulation<3> &mesh)
  {
    for (const auto &face : mesh.active_face_iterators())
    {
      if (!face->at_boundary())
        continue;
      face->set_boundary_id(0);
      for (unsigned int d = 0; d < 3; ++d)
      {
        double farthest = 0.;
        for (const unsigned int v : face->vertex_indices())
          farthest = std::max(farthest, std::abs(face->vertex(v)[d]));
        if (ball.is_halved[d] && farthest < 1e-9 * ball.semi_axes.front()[d])
          face->set_boundary_id(d + 1);
      }
      if (ball.wedge_axis < 3)
        set_wedge_boundary(ball, axis_radius, face);
    }
  }
} // namespace


void make_layered_ball(const LayeredBall &ball, dealii::Triangulation<3> &mesh)
{
  check(ball);
  Nodes nodes(ball);
  BallCells cells;
  add_cube(ball, nodes, cells);
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    if (ball.wedge_axis > 2 || axis != ball.normal_to_middle())
      add_block(ball, axis, true, nodes, cells);
    if (!ball.is_halved[axis])
      add_block(ball, axis, false, nodes, cells);
  }
  mesh.create_triangulation(nodes.points(), cells, dealii::SubCellData());
  set_boundaries(ball, nodes.axis_radius(), mesh);
}
} // namespace contrecoup
