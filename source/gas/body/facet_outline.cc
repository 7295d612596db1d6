// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/body/facet_outline.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace contrecoup::gas
{
namespace
{
  /// An edge or diagonal between two corners, the lower number first; a corner
  /// twice stands for itself.
  using Node = std::pair<unsigned int, unsigned int>;
  /// Directed pieces of an outline: from each node to the next.
  using Links = std::map<Node, Node>;

  Node node(const unsigned int a, const unsigned int b)
  {
    return {std::min(a, b), std::max(a, b)};
  }


  /// The corners of a face, counter-clockwise seen from outside, the lowest
  /// first.
  std::array<unsigned int, 4> corners_of(const unsigned int face)
  {
    const unsigned int d = face / 2;
    const unsigned int a = 1U << (d + 1) % 3, b = 1U << (d + 2) % 3;
    const unsigned int first = face % 2 << d;
    const bool is_high = face % 2 == 1;
    return {{first,
             first + (is_high ? a : b),
             first + a + b,
             first + (is_high ? b : a)}};
  }


  /// Adds the piece of the outline in a triangle, whose corners are
  /// counter-clockwise: the positive part is to its left.
  template <typename Values>
  void add_piece(const Values &values,
                 const std::array<unsigned int, 3> &triangle,
                 Links &links)
  {
    Node exit, entry;
    bool is_cut = false;
    for (unsigned int i = 0; i < 3; ++i)
    {
      const unsigned int from = triangle[i], to = triangle[(i + 1) % 3];
      if (values[from] > 0. && !(values[to] > 0.))
      {
        exit = node(from, to);
        is_cut = true;
      }
      if (!(values[from] > 0.) && values[to] > 0.)
        entry = node(from, to);
    }
    if (is_cut)
      links[exit] = entry;
  }


  /// Nodes of all pieces in order, those that are closed with their first node
  /// at the end too.
  std::vector<std::vector<Node>> connect(Links links)
  {
    std::set<Node> targets;
    for (const auto &link : links)
      targets.insert(link.second);
    std::vector<Node> begins;
    for (const auto &link : links)
      if (targets.count(link.first) == 0)
        begins.push_back(link.first);
    std::vector<std::vector<Node>> pieces;
    while (!links.empty())
    {
      Node at = links.begin()->first;
      if (!begins.empty())
      {
        at = begins.back();
        begins.pop_back();
      }
      pieces.push_back({at});
      for (auto link = links.find(at); link != links.end();
           link = links.find(at))
      {
        at = link->second;
        pieces.back().push_back(at);
        links.erase(link);
      }
    }
    return pieces;
  }


  template <int dim>
  dealii::Point<dim> corner(const unsigned int number)
  {
    dealii::Point<dim> place;
    for (unsigned int d = 0; d < dim; ++d)
      place[d] = number >> d & 1U;
    return place;
  }


  /// Joins pieces to one outline; @p place gives the position of a node.
  template <int dim, typename Place>
  std::vector<dealii::Point<dim>> join(const Links &links, const Place &place)
  {
    const double same = 1e-12;
    std::vector<dealii::Point<dim>> outline;
    const auto add = [&](const Node &node) {
      const dealii::Point<dim> next = place(node);
      if (outline.empty() || next.distance(outline.back()) > same)
        outline.push_back(next);
    };
    const auto pieces = connect(links);
    for (const auto &piece : pieces)
    {
      const bool is_closed = dim == 3 && piece.size() > 1;
      for (const Node &node : piece)
        add(node);
      // Back to the first piece, along the way from there.
      if (is_closed && &piece != &pieces.front())
        add(pieces.front().front());
    }
    if (dim == 3 && outline.size() > 1 &&
        outline.front().distance(outline.back()) <= same)
      outline.pop_back();
    return outline.size() < dim ? std::vector<dealii::Point<dim>>() : outline;
  }
} // namespace


template <int dim>
std::vector<dealii::Point<dim>>
cut_outline(const std::array<double, (1U << dim)> &distances)
{
  Links links;
  if constexpr (dim == 2)
  {
    add_piece(distances, {{0, 1, 3}}, links);
    add_piece(distances, {{0, 3, 2}}, links);
  }
  else
    for (unsigned int face = 0; face < 6; ++face)
    {
      const auto v = corners_of(face);
      add_piece(distances, {{v[0], v[1], v[2]}}, links);
      add_piece(distances, {{v[0], v[2], v[3]}}, links);
    }
  return join<dim>(links, [&](const Node &node) {
    const double a = distances[node.first], b = distances[node.second];
    const dealii::Point<dim> begin = corner<dim>(node.first);
    return begin + a / (a - b) * (corner<dim>(node.second) - begin);
  });
}


template <int dim>
std::vector<dealii::Point<dim>>
closed_outline(const std::array<bool, 2 * dim> &is_closed)
{
  std::set<std::pair<unsigned int, unsigned int>> edges;
  const auto add = [&](const unsigned int from, const unsigned int to) {
    // Edges between two closed faces cancel.
    if (edges.erase({to, from}) == 0)
      edges.insert({from, to});
  };
  for (unsigned int face = 0; face < 2 * dim; ++face)
  {
    if (!is_closed[face])
      continue;
    if constexpr (dim == 2)
    {
      // Clockwise, so that lines of adjacent faces follow each other.
      const unsigned int d = face / 2;
      const unsigned int first = face % 2 << d, other = first + (2U >> d);
      const bool is_forward = face == 0 || face == 3;
      add(is_forward ? first : other, is_forward ? other : first);
    }
    else
    {
      const auto v = corners_of(face);
      for (unsigned int i = 0; i < 4; ++i)
        add(v[(i + 1) % 4], v[i]);
    }
  }
  Links links;
  for (const auto &[from, to] : edges)
    links[{from, from}] = {to, to};
  return join<dim>(links,
                   [](const Node &node) { return corner<dim>(node.first); });
}


template std::vector<dealii::Point<2>>
cut_outline<2>(const std::array<double, 4> &);
template std::vector<dealii::Point<3>>
cut_outline<3>(const std::array<double, 8> &);
template std::vector<dealii::Point<2>>
closed_outline<2>(const std::array<bool, 4> &);
template std::vector<dealii::Point<3>>
closed_outline<3>(const std::array<bool, 6> &);
} // namespace contrecoup::gas
