// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/polycube/polycube.hpp"

#include "support/random.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/polycube/cells.hpp"
#include "tetrarch/polycube/gaps.hpp"
#include "tetrarch/polycube/map.hpp"
#include "tetrarch/product/polycube.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <stop_token>

using namespace tetrarch;
using namespace tetrarch::polycube;
using namespace tetrarch::numeric;

namespace {

using Cube = std::array<int, 3>;

/// Unit cubes, six tetrahedra each.
product::Solid cubes_solid(const std::vector<Cube>& cubes, double edge = 1) {
  return product::solid_of(product::tetrahedra(product::Polycube{edge, cubes}));
}

std::vector<Cube> block(int x, int y, int z) {
  std::vector<Cube> result;
  for (Cube p{}; p[0] < x; ++p[0])
    for (p[1] = 0; p[1] < y; ++p[1])
      for (p[2] = 0; p[2] < z; ++p[2]) result.push_back(p);
  return result;
}

std::vector<Cube> without(std::vector<Cube> cubes, const std::set<Cube>& gone) {
  cubes.erase(std::remove_if(cubes.begin(), cubes.end(), [&](const Cube& p) { return gone.contains(p); }),
              cubes.end());
  return cubes;
}

/// A ball: the points of a block drawn in so that its squares become spheres.
product::Solid ball(int n) {
  solid::TetMesh mesh = product::tetrahedra(product::Polycube{1, block(n, n, n)});
  for (Point& p : mesh.points) {
    Vector v{};
    double most = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      v[a] = 2 * p[a] / n - 1;
      most = std::max(most, std::abs(v[a]));
    }
    p = most > 0 ? most / norm(v) * v : v;
  }
  return product::solid_of(std::move(mesh));
}

Charts charts_of(const product::Solid& solid, const std::vector<Label>& label) {
  return charts(solid, Facets(solid), label);
}

/// The label whose axis is nearest to each normal.
std::vector<Label> nearest_labels(const product::Solid& solid) {
  std::vector<Label> result;
  for (const Vector& n : Facets(solid).normal) {
    Label best = 0;
    for (Label l = 1; l < labels; ++l)
      if (dot(n, direction_of(l)) > dot(n, direction_of(best))) best = l;
    result.push_back(best);
  }
  return result;
}

double volume_of(const std::vector<Point>& points, const std::array<int, 4>& v) {
  const Vector a = points[v[1]] - points[v[0]];
  const Vector b = points[v[2]] - points[v[0]];
  const Vector c = points[v[3]] - points[v[0]];
  return (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
          a[2] * (b[0] * c[1] - b[1] * c[0])) /
         6;
}

/// No tetrahedron is flipped, triangles lie in planes of integers and face as their labels say.
void require_polycube_map(const LabeledSolid& labeled) {
  double least = 1e300;
  for (const auto& v : labeled.solid.mesh.tetrahedra) least = std::min(least, volume_of(labeled.image, v));
  CHECK(least > 0);
  for (int t = 0; t < labeled.solid.boundary.triangle_count(); ++t) {
    std::array<Point, 3> p;
    for (int c = 0; c < 3; ++c) p[c] = labeled.image[labeled.solid.corner(t, c)];
    const std::size_t axis = axis_of(labeled.label[t]);
    for (int c = 0; c < 3; ++c) CHECK(p[c][axis] == std::round(p[0][axis]));
    CHECK(sign_of(labeled.label[t]) * cross(p[1] - p[0], p[2] - p[0])[axis] > 0);
  }
}

double image_volume(const LabeledSolid& labeled) {
  double sum = 0;
  for (const auto& v : labeled.solid.mesh.tetrahedra) sum += volume_of(labeled.image, v);
  return sum;
}

/// Vertices - edges + faces of the surface.
int euler(const product::HexMesh& mesh) {
  std::set<int> vertices;
  std::set<std::pair<int, int>> edges;
  const auto squares = product::surface_squares(mesh);
  for (const auto& s : squares)
    for (std::size_t k = 0; k < 4; ++k) {
      vertices.insert(s[k]);
      edges.insert(std::minmax(s[k], s[(k + 1) % 4]));
    }
  return static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) +
         static_cast<int>(squares.size());
}

/// Whether all corners are in one plane, or on two parallel lines.
bool must_be_flat(const Planes& planes, const std::array<int, 4>& tet) {
  for (std::size_t a = 0; a < 3; ++a) {
    std::set<int> of_axis;
    std::set<std::pair<int, int>> lines;
    for (const int v : tet) {
      of_axis.insert(planes.holds[v][a]);
      lines.insert({planes.holds[v][(a + 1) % 3], planes.holds[v][(a + 2) % 3]});
    }
    if (of_axis.size() == 1 && *of_axis.begin() >= 0) return true;
    if (lines.size() <= 2 &&
        std::all_of(lines.begin(), lines.end(), [](const auto& l) { return l.first >= 0 && l.second >= 0; }))
      return true;
  }
  return false;
}

struct Known {
  const char* name;
  std::vector<Cube> cubes;
  int charts;
  int corners;
  int lines;
};

/// Counted by hand.
const std::vector<Known>& known_polycubes() {
  static const std::vector<Known> all{
      {"cube", block(1, 1, 1), 6, 8, 12},
      {"L", {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}, 8, 12, 18},
      {"frame", without(block(3, 3, 1), {{1, 1, 0}}), 10, 16, 24},
      {"frame of two holes", without(block(5, 3, 1), {{1, 1, 0}, {3, 1, 0}}), 14, 24, 36},
      {"tripod", {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}}, 12, 17, 27},
      {"seven of eight", without(block(2, 2, 2), {{1, 1, 1}}), 9, 14, 21}};
  return all;
}

} // namespace

TEST_CASE("charts, corners and lines of polycubes are those that one counts", "[polycube]") {
  for (const Known& known : known_polycubes()) {
    INFO(known.name);
    const product::Solid solid = cubes_solid(known.cubes);
    const Charts found = charts_of(solid, labeled(solid, Facets(solid), 0.01));
    CHECK(found.label.size() == known.charts);
    CHECK(found.corners.size() == known.corners);
    CHECK(found.lines.size() == known.lines);
    CHECK(faults(solid, found).empty());
    // A chart of k boundary curves has the Euler characteristic 2 - k.
    int sum = static_cast<int>(found.corners.size()) - static_cast<int>(found.lines.size());
    for (const auto& curves : found.corners_of_curve) sum += 2 - static_cast<int>(curves.size());
    CHECK(sum == 2 - 2 * product::genus(solid));
  }
}

TEST_CASE("corners are those of eight octants", "[polycube]") {
  constexpr Label x = 0;
  constexpr Label minus_x = 1;
  constexpr Label y = 2;
  constexpr Label z = 4;
  // By hand: of a cube, of an L (seen from above: its top, then the wall facing y, then that facing x), and
  // of a tripod between its legs.
  CHECK(is_corner_of_cubes(std::vector<Label>{x, y, z}));
  CHECK(is_corner_of_cubes(std::vector<Label>{z, y, x}));
  CHECK(is_corner_of_cubes(std::vector<Label>{y, z, x, y, z, x}) !=
        is_corner_of_cubes(std::vector<Label>{x, z, y, x, z, y}));
  CHECK_FALSE(is_corner_of_cubes(std::vector<Label>{x, minus_x, y}));
  CHECK_FALSE(is_corner_of_cubes(std::vector<Label>{x, y, x, y}));
  // The lines of a cube's corner go into the cube: between z and x against y, and so on.
  CHECK(is_corner_of_cubes(std::vector<Sector>{{x, 3}, {y, 5}, {z, 1}}));
  CHECK(is_corner_of_cubes(std::vector<Sector>{{x, 2}, {y, 4}, {z, 0}})); // the hollow one
  CHECK_FALSE(is_corner_of_cubes(std::vector<Sector>{{x, 2}, {y, 5}, {z, 1}}));
}

TEST_CASE("random sets of cubes are polycubes without faults", "[polycube]") {
  support::Random random(7);
  int solids = 0;
  int handles = 0;
  for (int trial = 0; trial < 2000 && solids < 60; ++trial) {
    std::vector<Cube> cubes;
    for (const Cube& p : block(3, 3, 2))
      if (random.uniform() < 0.6) cubes.push_back(p);
    std::optional<product::Solid> solid;
    try {
      solid = cubes_solid(cubes);
    } catch (const InputError&) { // they touch in edges, or hang apart
      continue;
    }
    ++solids;
    handles += product::genus(*solid);
    const std::vector<Label> label = nearest_labels(*solid);
    CHECK(faults(*solid, charts_of(*solid, label)).empty());
    const auto framed = frame(*solid, label);
    REQUIRE(framed);
    CHECK(twisted_corners(*framed, framed->places).empty());
    const auto made = polycube::polycube(*framed, 1);
    REQUIRE(made);
    CHECK(made->flipped.empty());
    const Cells found = cells(made->labeled.solid, made->labeled.image);
    CHECK(found.mesh.hexahedra.size() == cubes.size());
    CHECK(found.lost == 0);
    CHECK(product::quality(found.mesh).minimum > 1 - 1e-9);
  }
  CHECK(solids == 60);
  CHECK(handles > 0);
}

TEST_CASE("no triangle alone can lower the energy of labels", "[polycube]") {
  // A block turned by nearly 45 degrees, and rough: alone, each triangle of its sides would go its own way.
  solid::TetMesh bumpy = product::tetrahedra(product::Polycube{1, block(5, 5, 3)});
  support::Random random(3);
  for (Point& p : bumpy.points) {
    p = {0.73 * p[0] - 0.68 * p[1], 0.68 * p[0] + 0.73 * p[1], p[2]};
    for (double& x : p) x += 0.2 * random.uniform();
  }
  const product::Solid solid = product::solid_of(std::move(bumpy));
  const Facets facets(solid);
  const surface::Surface& surface = solid.boundary;
  const auto apart = [](Label a, Label b) { return a == b ? 0 : are_opposite(a, b) ? 2 : 1; };
  std::map<double, std::pair<double, double>> of_smoothness;
  for (const double smoothness : {0.001, 0.02, 0.1}) {
    const std::vector<Label> found = labeled(solid, facets, smoothness);
    const auto cost = [&](int t, Label l) {
      double sum = facets.area[t] * (1 - dot(facets.normal[t], direction_of(l)));
      for (const surface::Side s : surface::sides_of(t)) {
        const int u = surface.mate(s).triangle();
        const double bend = (dot(facets.normal[t], facets.normal[u]) - 1) / 0.25;
        sum +=
            smoothness * std::sqrt(facets.total) *
            distance(solid.point(solid.vertex[surface.from(s)]), solid.point(solid.vertex[surface.to(s)])) *
            std::exp(-bend * bend / 2) * apart(l, found[u]);
      }
      return sum;
    };
    double misfit = 0;
    int seams = 0;
    for (int t = 0; t < surface.triangle_count(); ++t) {
      for (Label l = 0; l < labels; ++l) CHECK(cost(t, l) > cost(t, found[t]) - 1e-9);
      misfit += facets.area[t] * (1 - dot(facets.normal[t], direction_of(found[t])));
      for (const surface::Side s : surface::sides_of(t))
        if (found[surface.mate(s).triangle()] != found[t]) ++seams;
    }
    of_smoothness[smoothness] = {misfit, seams};
  }
  // Smoother labels fit less, and have shorter lines.
  CHECK(of_smoothness[0.001].first <= of_smoothness[0.02].first);
  CHECK(of_smoothness[0.02].first <= of_smoothness[0.1].first);
  CHECK(of_smoothness[0.001].second >= of_smoothness[0.1].second);
}

TEST_CASE("faults of labels are found where they are", "[polycube]") {
  const product::Solid solid = ball(6);
  std::vector<Label> halves;
  for (const Vector& n : Facets(solid).normal) halves.push_back(n[2] > 0 ? 4 : 5);
  const auto opposite = faults(solid, charts_of(solid, halves));
  CHECK(count(opposite, Fault::Kind::opposite) == 1);
  CHECK(count(opposite, Fault::Kind::few_corners) == 2); // no corner at all

  // A cap of another label inside of a chart has no corner, and its rim turns back.
  std::vector<Label> capped = nearest_labels(solid);
  const Facets facets(solid);
  for (std::size_t t = 0; t < capped.size(); ++t)
    if (facets.normal[t][2] > 0.93) capped[t] = 0;
  const auto cap = faults(solid, charts_of(solid, capped));
  CHECK(count(cap, Fault::Kind::few_corners) == 2);
  CHECK(count(cap, Fault::Kind::turning_point) == 2);
  CHECK(faults(solid, charts_of(solid, mended(solid, facets, capped))).empty());

  // A hooked tongue of the top reaches down a side of a block: of the line, 22 long, 3 go back.
  const product::Solid cube = cubes_solid(block(8, 8, 8));
  std::vector<Label> tongue = nearest_labels(cube);
  CHECK(faults(cube, charts_of(cube, tongue)).empty());
  for (int t = 0; t < static_cast<int>(tongue.size()); ++t) {
    Point middle{};
    for (int c = 0; c < 3; ++c) middle = middle + 1.0 / 3 * cube.point(cube.corner(t, c));
    const double y = middle[1];
    if (tongue[t] == 0 && middle[2] > 4 && y < 6 && (y > 4 || (y > 1 && middle[2] < 5))) tongue[t] = 4;
  }
  const auto turning = faults(cube, charts_of(cube, tongue));
  REQUIRE(turning.size() == 2);
  for (const Fault& fault : turning) CHECK(fault.kind == Fault::Kind::turning_point);
  CHECK(std::abs(turning[0].at[1] - turning[1].at[1]) == 3);
}

TEST_CASE("there is room between planes after splitting", "[polycube]") {
  // Of a plate one cube thick, two charts take all vertices.
  const product::Solid solid = cubes_solid(block(2, 2, 1));
  std::vector<Label> label;
  for (int t = 0; t < solid.boundary.triangle_count(); ++t) {
    double x = 0;
    for (int c = 0; c < 3; ++c) x += solid.point(solid.corner(t, c))[0] / 3;
    label.push_back(x < 1 ? 4 : 0);
  }
  const LabeledSolid roomy = with_room({solid, label});
  CHECK(roomy.solid.size() > solid.size());
  CHECK(product::volume(roomy.solid) == Approx(product::volume(solid)));
  std::array<double, labels> before{};
  std::array<double, labels> after{};
  const Facets old(solid);
  const Facets split(roomy.solid);
  for (std::size_t t = 0; t < label.size(); ++t) before[label[t]] += old.area[t];
  for (std::size_t t = 0; t < roomy.label.size(); ++t) after[roomy.label[t]] += split.area[t];
  for (Label l = 0; l < labels; ++l) CHECK(after[l] == Approx(before[l]));
  const auto& tets = roomy.solid.mesh.tetrahedra;
  const Planes held = planes(roomy.solid, charts_of(roomy.solid, roomy.label));
  CHECK(std::none_of(tets.begin(), tets.end(), [&](const auto& tet) { return must_be_flat(held, tet); }));
}

TEST_CASE("a tetrahedron between two parallel lines is split", "[polycube]") {
  // A frame, at whose corner one tetrahedron joins an upright edge outside with one of the hole: a and c. The
  // upper c is moved away a little, so that it has a volume.
  solid::TetMesh mesh = product::tetrahedra(product::Polycube{1, without(block(3, 3, 1), {{1, 1, 0}})});
  const auto at = [&](double x, double y, double z) {
    return static_cast<int>(std::find(mesh.points.begin(), mesh.points.end(), Point{x, y, z}) -
                            mesh.points.begin());
  };
  const std::array<int, 2> a{at(0, 0, 0), at(0, 0, 1)};
  const std::array<int, 2> b{at(1, 0, 0), at(1, 0, 1)};
  const std::array<int, 2> c{at(1, 1, 0), at(1, 1, 1)};
  const std::array<int, 2> d{at(0, 1, 0), at(0, 1, 1)};
  mesh.points[c[1]] = {1.15, 0.85, 1};
  // The first cube is cut otherwise: two prisms beside the tetrahedron.
  const std::vector<std::array<int, 4>> corner{
      {a[0], a[1], c[0], c[1]}, {a[0], b[0], c[0], c[1]}, {a[0], b[0], b[1], c[1]}, {a[0], a[1], b[1], c[1]},
      {d[0], c[0], a[0], a[1]}, {d[0], c[0], c[1], a[1]}, {d[0], d[1], c[1], a[1]}};
  mesh.tetrahedra.erase(mesh.tetrahedra.begin(), mesh.tetrahedra.begin() + 6);
  mesh.tetrahedra.insert(mesh.tetrahedra.begin(), corner.begin(), corner.end());
  for (auto& tet : mesh.tetrahedra)
    if (volume_of(mesh.points, tet) < 0) std::swap(tet[0], tet[1]);
  const product::Solid solid = product::solid_of(std::move(mesh));
  const std::vector<Label> label = nearest_labels(solid);
  const Charts all = charts_of(solid, label);
  CHECK(all.count() == 10);
  CHECK(must_be_flat(planes(solid, all), solid.corners(0)));
  const auto framed = frame(solid, label);
  REQUIRE(framed);
  CHECK(framed->labeled.solid.size() > solid.size());
  for (const auto& tet : framed->labeled.solid.mesh.tetrahedra)
    CHECK_FALSE(must_be_flat(framed->planes, tet));
  const auto made = polycube::polycube(*framed, 0.5);
  REQUIRE(made);
  require_polycube_map(made->labeled);
}

TEST_CASE("rounded gaps are at least 1 and nearly the best", "[polycube]") {
  CHECK_FALSE(rounded_places({0, 1}, {{0, 1, 1, 1}, {1, 0, 1, 1}}));
  // Alone each gap would become 0; together they make the widest one too wide.
  const auto thin = rounded_places({0, 0.2, 0.4}, {{0, 1, 0.2, 1}, {1, 2, 0.2, 1}, {0, 2, 0.4, 1}});
  REQUIRE(thin);
  CHECK((*thin)[1] - (*thin)[0] == 1);
  CHECK((*thin)[2] - (*thin)[1] == 1);

  support::Random random(11);
  int best = 0;
  constexpr int trials = 100;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<double> places;
    std::vector<Gap> gaps;
    for (int k = 0; k < 4; ++k) places.push_back(5 * random.uniform());
    for (int k = 0; k < 4; ++k)
      for (int j = 0; j < 4; ++j)
        if (places[j] > places[k] && random.uniform() < 0.8)
          gaps.push_back({k, j, places[j] - places[k], 0.1 + random.uniform()});
    const auto found = rounded_places(places, gaps);
    REQUIRE(found);
    const auto cost = [&](const std::array<int, 4>& at) {
      double sum = 0;
      for (const Gap& g : gaps) {
        const int width = at[g.high] - at[g.low];
        if (width < 1) return 1e300;
        sum += g.weight * (width - g.width) * (width - g.width);
      }
      return sum;
    };
    double least = 1e300;
    for (std::array<int, 4> at{0, -3, -3, -3}; at[3] < 12;) {
      for (int first = -3; first < 12; ++first) least = std::min(least, cost({first, at[1], at[2], at[3]}));
      for (std::size_t k = 1; k < 4; ++k) {
        if (++at[k] < 12 || k == 3) break;
        at[k] = -3;
      }
    }
    const double mine = cost({(*found)[0], (*found)[1], (*found)[2], (*found)[3]});
    CHECK(mine < 1e300);
    if (mine < least + 1e-9) ++best;
  }
  CHECK(best > 9 * trials / 10);
}

TEST_CASE("a ball becomes a cube without a fold", "[polycube]") {
  const product::Solid solid = ball(6);
  Polycubes polycubes(solid);
  REQUIRE_FALSE(polycubes.labelings().empty());
  CHECK(polycubes.labelings().front().charts == 6);
  CHECK(polycubes.labelings().front().corners == 8);
  for (const double edge : {0.2, 0.45}) {
    const auto found = polycubes.at(edge);
    REQUIRE(found);
    CHECK(found->polycube.flipped.empty());
    CHECK(found->polycube.twisted.empty());
    require_polycube_map(found->polycube.labeled);
    const Cells cubes = cells(found->polycube.labeled.solid, found->polycube.labeled.image);
    CHECK(cubes.lost == 0);
    CHECK(cubes.mesh.hexahedra.size() == Approx(image_volume(found->polycube.labeled)));
    CHECK(euler(cubes.mesh) == 2);
    // Points of the surface lie on the sphere, as far as its triangles do.
    for (const auto& square : product::surface_squares(cubes.mesh))
      for (const int v : square) CHECK(norm(cubes.mesh.points[v]) > 0.9);
  }
}

TEST_CASE("a narrow gap closes, and the cubes beside it stay apart", "[polycube]") {
  // A U whose gap is a hundredth of an edge.
  solid::TetMesh mesh = product::tetrahedra(product::Polycube{1, without(block(3, 2, 1), {{1, 1, 0}})});
  for (Point& p : mesh.points)
    if (p[0] == 2) p[0] = 1.01;
  for (Point& p : mesh.points)
    if (p[0] == 3) p[0] = 2.01;
  const product::Solid solid = product::solid_of(std::move(mesh));
  const auto framed = frame(solid, nearest_labels(solid));
  REQUIRE(framed);
  const auto made = polycube::polycube(*framed, 0.5);
  REQUIRE(made);
  CHECK(made->flipped.empty());
  const Cells cubes = cells(made->labeled.solid, made->labeled.image);
  CHECK(cubes.mesh.hexahedra.size() == Approx(image_volume(made->labeled)));
  CHECK(euler(cubes.mesh) == 2);
  CHECK(product::volume(cubes.mesh) == Approx(product::volume(solid)));
}

TEST_CASE("a step on a wall keeps its width", "[polycube]") {
  // A block with a plate on top that is smaller by a tenth of an edge on all sides.
  std::vector<Cube> cubes = block(3, 3, 1);
  cubes.push_back({1, 1, 1});
  std::sort(cubes.begin(), cubes.end());
  solid::TetMesh mesh = product::tetrahedra(product::Polycube{1, cubes});
  for (Point& p : mesh.points)
    for (std::size_t a = 0; a < 2; ++a) {
      if (p[a] == 1) p[a] = 0.1;
      if (p[a] == 2) p[a] = 2.9;
    }
  const product::Solid solid = product::solid_of(std::move(mesh));
  const auto framed = frame(solid, nearest_labels(solid));
  REQUIRE(framed);
  const auto made = polycube::polycube(*framed, 1);
  REQUIRE(made);
  CHECK(made->flipped.empty());
  require_polycube_map(made->labeled);
  // By hand: steps of 1 on all sides, so 1 + n + 1 along x and y, and the plate n x n.
  const double volume = image_volume(made->labeled);
  const double n = std::round(std::sqrt((volume - 4) / 2 + 1) - 1);
  CHECK(n >= 1);
  CHECK(volume == Approx((n + 2) * (n + 2) + n * n));
}

TEST_CASE("who is no longer wanted stops", "[polycube]") {
  const product::Solid solid = ball(4);
  const std::vector<Label> label = nearest_labels(solid);
  const auto framed = frame(solid, label);
  REQUIRE(framed);
  const auto made = polycube::polycube(*framed, 0.3);
  REQUIRE(made);
  std::stop_source stop;
  stop.request_stop();
  const Progress progress({}, stop.get_token());
  CHECK_THROWS_AS(labelings(solid, progress), Stopped);
  CHECK_THROWS_AS(mended(solid, Facets(solid), label, progress), Stopped);
  CHECK_THROWS_AS(with_room({solid, label}, progress), Stopped);
  CHECK_THROWS_AS(frame(solid, label, progress), Stopped);
  CHECK_THROWS_AS(polycube::polycube(*framed, 0.3, progress), Stopped);
  CHECK_THROWS_AS(cells(made->labeled.solid, made->labeled.image, progress), Stopped);
}
