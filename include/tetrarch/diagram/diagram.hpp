// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Plane diagrams of links and spatial graphs.
///
///        d1                Cut every arc of the diagram in its middle: each half, at its end, is a *dart*.
///     d2 -+- d0            A node lists its darts counterclockwise. At a crossing there are four; darts 0
///        d3                and 2 are one strand, darts 1 and 3 the other, and one of the two passes over.
///                          Any other node is a vertex of the graph, of any valence from 1 up.
///
/// The diagram lies on the sphere, up to a homeomorphism that keeps orientation: the darts and their order
/// determine it. Laws: `opposite` is an involution without fixed points; each dart stands in one place of one
/// node; nodes - arcs + regions = 2 for each part, so that the rotation is one of the sphere. A part is a
/// component of the plane picture; parts lie apart from one another, which says all there is up to isotopy. A
/// circle without crossings has a vertex of valence 2 on it. Source: a rotation system is textbook matter
/// (Heffter, Edmonds); diagrams of spatial graphs, Kauffman, "Invariants of graphs in three-space" (1989).

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace tetrarch::diagram {

/// A crossing, or a vertex of the graph.
struct Node {
  std::vector<int> darts; ///< counterclockwise
  bool crossing = false;
  int over = 0; ///< of a crossing: darts over and over + 2 pass over; 0 or 1
  friend bool operator==(const Node&, const Node&) = default;
};

/// A plane diagram. It never changes: moves make new ones.
class Diagram {
public:
  Diagram() = default;
  /// `opposite[d]` is the other half of dart d's arc. Throws PreconditionError unless the laws hold (the
  /// message is that of `why_not`). O(darts).
  Diagram(std::vector<Node> nodes, std::vector<int> opposite);

  int node_count() const { return static_cast<int>(nodes_.size()); }
  int dart_count() const { return static_cast<int>(opposite_.size()); }
  int arc_count() const { return dart_count() / 2; }
  const Node& node(int n) const { return nodes_[n]; }
  const std::vector<Node>& nodes() const { return nodes_; }
  const std::vector<int>& opposites() const { return opposite_; }

  int opposite(int dart) const { return opposite_[dart]; }
  int node_of(int dart) const { return place_[dart].first; }
  int place_of(int dart) const { return place_[dart].second; }
  bool at_crossing(int dart) const { return nodes_[node_of(dart)].crossing; }
  /// The dart `steps` places further round its node, counterclockwise.
  int turned(int dart, int steps) const;
  /// At a crossing: whether the dart's strand passes over.
  bool is_over(int dart) const { return (place_of(dart) - nodes_[node_of(dart)].over) % 2 == 0; }
  /// Walk along the arc from this dart with a region on the left: the dart that the region's boundary goes on
  /// with.
  int next_on_left(int dart) const { return turned(opposite(dart), -1); }

  friend bool operator==(const Diagram& a, const Diagram& b) {
    return a.nodes_ == b.nodes_ && a.opposite_ == b.opposite_;
  }

private:
  std::vector<Node> nodes_;
  std::vector<int> opposite_;
  std::vector<std::pair<int, int>> place_;
};

/// What is wrong with such data, as a sentence ("the rotation at the nodes is that of a surface of genus 1
/// (expected the plane)"); empty if the laws hold. O(darts).
std::string why_not(const std::vector<Node>& nodes, const std::vector<int>& opposite);

/// A numbering of darts by something that they belong to.
struct Classes {
  int count = 0;
  std::vector<int> of; ///< of each dart
};

/// The region to the left of each dart. O(darts).
Classes regions(const Diagram& diagram);
/// The part of the picture that each dart lies in. O(darts).
Classes parts(const Diagram& diagram);
/// The edge of the graph that each dart lies on: edges run through crossings and end at vertices. A component
/// of a link is an edge, and so is a circle with one vertex of valence 2. O(darts).
Classes edges(const Diagram& diagram);
/// The connected component of the graph (of the link) that each dart lies in. O(darts).
Classes components(const Diagram& diagram);

int crossing_count(const Diagram& diagram);
/// Vertices whose valence is not 2.
int vertex_count(const Diagram& diagram);

/// The mirror image in the plane of the picture: every crossing is changed.
Diagram mirrored(const Diagram& diagram);

/// A circle without crossings.
Diagram circle();

} // namespace tetrarch::diagram
