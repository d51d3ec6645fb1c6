// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/core/error.hpp"
#include "tetrarch/scene/drawing.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace tetrarch::scene {
namespace {

using Pixel = std::array<double, 2>;

/// What is smaller, in pixels, is not seen.
constexpr double too_small = 0.1;
/// How far a polygon may be from the circle that it stands for, in pixels.
constexpr double chord_error = 0.02;
/// Browsers draw in single precision, in which a circle much larger than the picture is off by pixels; from
/// so many diagonals of the picture on, a circle is drawn as a polygon.
constexpr double large_circle = 16;
/// From here on, in pixels, hundredths do not matter, and writing all digits would take hundreds of them.
constexpr double far_away = 1e9;

/// To a hundredth, without zeros at the end.
void append_hundredths(std::string& out, double x) {
  std::array<char, 32> buffer{};
  char* const begin = buffer.data();
  if (std::abs(x) >= far_away) {
    out.append(begin, std::to_chars(begin, begin + buffer.size(), x, std::chars_format::scientific, 6).ptr);
    return;
  }
  char* end = std::to_chars(begin, begin + buffer.size(), x, std::chars_format::fixed, 2).ptr;
  while (end[-1] == '0') --end;
  if (end[-1] == '.') --end;
  const std::string_view text(begin, static_cast<std::size_t>(end - begin));
  out += text == "-0" ? "0" : text;
}

void append_attribute(std::string& out, std::string_view name, double x) {
  out.append(" ").append(name).append("=\"");
  append_hundredths(out, x);
  out += '"';
}

void append_paint(std::string& out, std::string_view name, const std::optional<Color>& color) {
  out.append(" ").append(name).append("=\"");
  if (!color) {
    out += "none\"";
    return;
  }
  constexpr std::string_view digits = "0123456789abcdef";
  out += '#';
  for (const std::uint8_t part : {color->red, color->green, color->blue}) {
    out += digits[part / 16];
    out += digits[part % 16];
  }
  out += '"';
  if (color->alpha < 255) append_attribute(out, std::string(name) + "-opacity", color->alpha / 255.0);
}

/// As text of an element: no character of it is taken for markup, and none is forbidden in XML.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else {
      out += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
  }
  return out;
}

class SvgWriter {
public:
  SvgWriter(const Drawing& drawing, int width) : lower_(drawing.lower), upper_(drawing.upper) {
    const double across = upper_[0] - lower_[0];
    const double up = upper_[1] - lower_[1];
    if (!(across > 0 && up > 0 && std::isfinite(across) && std::isfinite(up)))
      throw PreconditionError("the window of a drawing has no area");
    if (width <= 0) throw PreconditionError("a drawing has a width of at least one pixel");
    scale_ = width / across;
    size_ = {static_cast<double>(width), up * scale_};
    require_finite(size_[1]);
    diagonal_ = std::hypot(size_[0], size_[1]);
  }

  std::string write(const Drawing& drawing) && {
    out_ = "<svg xmlns=\"http://www.w3.org/2000/svg\"";
    append_attribute(out_, "width", size_[0]);
    append_attribute(out_, "height", size_[1]);
    out_ += " viewBox=\"0 0 ";
    append_hundredths(out_, size_[0]);
    out_ += ' ';
    append_hundredths(out_, size_[1]);
    out_ += "\">\n<title>" + escaped(drawing.title) + "</title>\n";
    for (const Circle& circle : drawing.circles) add(circle);
    for (const Outline& outline : drawing.outlines) add(outline);
    if (ink_) out_ += "</g>\n";
    out_ += "</svg>\n";
    return std::move(out_);
  }

private:
  static double require_finite(double x) {
    if (!std::isfinite(x)) throw PreconditionError("a drawing has a number that is not finite");
    return x;
  }

  Pixel pixel(const Pixel& point) const {
    return {require_finite((point[0] - lower_[0]) * scale_), require_finite((upper_[1] - point[1]) * scale_)};
  }

  /// Whether anything in this box, drawn with the ink, can be seen.
  bool is_visible(const Pixel& least, const Pixel& greatest, const Ink& ink) const {
    if (!(require_finite(ink.width) >= 0)) throw PreconditionError("a stroke has a negative width");
    if (!ink.fill && !ink.stroke) return false;
    const double margin = ink.stroke ? ink.width : 0;
    for (std::size_t i = 0; i < 2; ++i)
      if (greatest[i] < -margin || least[i] > size_[i] + margin) return false;
    return greatest[0] - least[0] >= too_small || greatest[1] - least[1] >= too_small;
  }

  /// Elements of the same ink share a group.
  void use(const Ink& ink) {
    if (ink_ == ink) return;
    if (ink_) out_ += "</g>\n";
    ink_ = ink;
    out_ += "<g";
    append_paint(out_, "fill", ink.fill);
    append_paint(out_, "stroke", ink.stroke);
    if (ink.stroke) append_attribute(out_, "stroke-width", ink.width);
    out_ += ">\n";
  }

  void add(const Circle& circle) {
    const Pixel center = pixel(circle.center);
    const double radius = require_finite(circle.radius * scale_);
    if (!(radius >= 0)) throw PreconditionError("a circle has a negative radius");
    if (!is_visible({center[0] - radius, center[1] - radius}, {center[0] + radius, center[1] + radius},
                    circle.ink))
      return;
    const double reach = diagonal_ + circle.ink.width;
    if (radius > large_circle * reach) return add_large(center, radius, reach, circle.ink);
    const Pixel farthest{std::max(center[0], size_[0] - center[0]),
                         std::max(center[1], size_[1] - center[1])};
    if (!circle.ink.fill && std::hypot(farthest[0], farthest[1]) < radius - circle.ink.width) return;
    use(circle.ink);
    out_ += "<circle";
    append_attribute(out_, "cx", center[0]);
    append_attribute(out_, "cy", center[1]);
    append_attribute(out_, "r", radius);
    out_ += "/>\n";
  }

  /// The part of a large circle near the picture as a polygon: an arc, closed far behind the picture.
  ///
  ///      o----------------o       n leads from the middle + of the picture towards the center of the circle;
  ///      |       n        |       the arc reaches twice `reach` to either side of its point nearest to +.
  ///      |       +        |       What is more than `reach` away from + cannot be seen.
  ///      `-.._________..-'  arc
  void add_large(const Pixel& center, double radius, double reach, const Ink& ink) {
    const Pixel middle{size_[0] / 2, size_[1] / 2};
    const double distance = std::hypot(center[0] - middle[0], center[1] - middle[1]);
    if (distance - radius > reach) return;
    if (radius - distance > reach) {
      if (ink.fill)
        add_polygon({{-reach, -reach}, {-reach, 2 * reach}, {2 * reach, 2 * reach}, {2 * reach, -reach}},
                    true, ink);
      return;
    }
    const Pixel n{(center[0] - middle[0]) / distance, (center[1] - middle[1]) / distance};
    const auto point = [&](double along, double across) {
      return Pixel{middle[0] + (distance - radius + across) * n[0] - along * n[1],
                   middle[1] + (distance - radius + across) * n[1] + along * n[0]};
    };
    const double half_angle = std::asin(2 * reach / radius);
    const int chords = static_cast<int>(std::ceil(2 * half_angle / std::sqrt(8 * chord_error / radius)));
    std::vector<Pixel> points;
    for (int i = 0; i <= chords; ++i) {
      const double angle = half_angle * (2.0 * i / chords - 1);
      const double half = std::sin(angle / 2);
      points.push_back(point(radius * std::sin(angle), 2 * radius * half * half));
    }
    points.push_back(point(2 * reach, 4 * reach));
    points.push_back(point(-2 * reach, 4 * reach));
    add_polygon(points, true, ink);
  }

  void add(const Outline& outline) {
    if (outline.points.empty()) return;
    std::vector<Pixel> points;
    points.reserve(outline.points.size());
    for (const Pixel& point : outline.points) points.push_back(pixel(point));
    Pixel least = points.front();
    Pixel greatest = points.front();
    for (const Pixel& point : points)
      for (std::size_t i = 0; i < 2; ++i) {
        least[i] = std::min(least[i], point[i]);
        greatest[i] = std::max(greatest[i], point[i]);
      }
    if (is_visible(least, greatest, outline.ink)) add_polygon(points, outline.closed, outline.ink);
  }

  void add_polygon(const std::vector<Pixel>& points, bool closed, const Ink& ink) {
    use(ink);
    out_ += closed ? "<polygon points=\"" : "<polyline points=\"";
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i > 0) out_ += ' ';
      append_hundredths(out_, points[i][0]);
      out_ += ',';
      append_hundredths(out_, points[i][1]);
    }
    out_ += "\"/>\n";
  }

  Pixel lower_;
  Pixel upper_;
  double scale_ = 1;
  Pixel size_{};
  double diagonal_ = 0;
  std::optional<Ink> ink_; ///< of the open group
  std::string out_;
};

} // namespace

std::string write_svg(const Drawing& drawing, int width) {
  return SvgWriter(drawing, width).write(drawing);
}

} // namespace tetrarch::scene
