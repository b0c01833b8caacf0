#include "common/picture/canvas.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <cairo.h>

#include "common/math/repeatable.h"

namespace scanway {
namespace {

constexpr int kMargin = 24;
constexpr int kFooter = 92;
constexpr int kLeastWidth = 760;  // the longest legend fits
constexpr double kTextSize = 17;
constexpr double kTurn = 2 * repeatable::kPi;
constexpr Colour kInk = {40, 40, 40};
constexpr Colour kStart = {22, 150, 72};
constexpr Colour kGoal = {214, 120, 0};

cairo_status_t append(void* text, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

/// The longest of 1, 2 and 5 times a power of ten that is not above `longest`.
double round_length(double longest) {
  double power = 1.0;
  while (power * 10 <= longest) power *= 10;
  while (power > longest) power /= 10;
  for (const double step : {5.0, 2.0}) {
    if (step * power <= longest) return step * power;
  }
  return power;
}

std::string metres_text(double metres, int digits) {
  std::array<char, 32> text{};
  const auto result = std::to_chars(text.begin(), text.end(), metres, std::chars_format::fixed, digits);
  return std::string(text.data(), result.ptr).append(" m");
}

int digits_for(double length) { return length >= 1 ? 0 : length >= 0.1 ? 1 : 2; }

}  // namespace

struct Canvas::Paper {
  explicit Paper(const Raster& raster);
  ~Paper() {
    cairo_destroy(pen);
    cairo_surface_destroy(surface);
  }
  Paper(const Paper&) = delete;
  Paper& operator=(const Paper&) = delete;

  void paint(const Raster& raster) const;
  void colour(Colour c) const { cairo_set_source_rgb(pen, c.red / 255.0, c.green / 255.0, c.blue / 255.0); }
  Eigen::Vector2d pixel(const Eigen::Vector2d& at_m) const {
    const Eigen::Vector2d p = (at_m - corner_m) / metres_per_pixel;
    return {left + p.x(), top + map_height - p.y()};
  }
  void text(double x, double y, const std::string& words) const {
    colour(kInk);
    cairo_move_to(pen, x, y);
    cairo_show_text(pen, words.c_str());
  }
  double text_width(const std::string& words) const {
    cairo_text_extents_t extents;
    cairo_text_extents(pen, words.c_str(), &extents);
    return extents.x_advance;
  }
  /// Writes a legend entry's words behind its symbol and moves on to the next entry.
  void legend_text(double symbol_width, const std::string& words) {
    text(legend_x + symbol_width + 8, legend_y + 6, words);
    legend_x += symbol_width + 8 + text_width(words) + 26;
  }
  void ring(double x, double y, double radius, Colour fill) const;
  void star(double x, double y, double radius, Colour fill) const;
  void scale_bar() const;

  double metres_per_pixel;
  Eigen::Vector2d corner_m;
  int left, top = kMargin, map_width, map_height;
  cairo_surface_t* surface;
  cairo_t* pen;
  double legend_x = kMargin, legend_y;
};

Canvas::Paper::Paper(const Raster& raster)
    : metres_per_pixel(raster.metres_per_pixel),
      corner_m(raster.corner_m),
      map_width(raster.width),
      map_height(raster.height) {
  const int width = std::max(map_width + 2 * kMargin, kLeastWidth);
  left = (width - map_width) / 2;
  surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, top + map_height + kFooter);
  pen = cairo_create(surface);
  legend_y = top + map_height + 66;
  colour({255, 255, 255});
  cairo_paint(pen);
  cairo_select_font_face(pen, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(pen, kTextSize);
  paint(raster);
  scale_bar();
}

void Canvas::Paper::paint(const Raster& raster) const {
  cairo_surface_t* image = cairo_image_surface_create(CAIRO_FORMAT_RGB24, map_width, map_height);
  unsigned char* bytes = cairo_image_surface_get_data(image);
  const int stride = cairo_image_surface_get_stride(image);
  for (int y = 0; y < map_height; ++y) {
    auto* row = reinterpret_cast<std::uint32_t*>(bytes + static_cast<std::ptrdiff_t>(y) * stride);
    for (int x = 0; x < map_width; ++x) {
      const Colour c =
          raster
              .pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(map_width) + static_cast<std::size_t>(x)];
      row[x] = std::uint32_t{c.red} << 16 | std::uint32_t{c.green} << 8 | c.blue;
    }
  }
  cairo_surface_mark_dirty(image);
  cairo_set_source_surface(pen, image, left, top);
  cairo_paint(pen);
  cairo_surface_destroy(image);
  colour({150, 150, 150});
  cairo_set_line_width(pen, 1);
  cairo_rectangle(pen, left - 0.5, top - 0.5, map_width + 1, map_height + 1);
  cairo_stroke(pen);
}

/// A bar of a round length, about a fifth of the map, with its length beside it.
void Canvas::Paper::scale_bar() const {
  const double length_m = round_length(std::max(0.25 * map_width, 120.0) * metres_per_pixel);
  const double length = length_m / metres_per_pixel, x = kMargin + 0.5, y = top + map_height + 26;
  colour(kInk);
  cairo_set_line_width(pen, 1.5);
  cairo_rectangle(pen, x, y - 5, length, 8);
  cairo_stroke(pen);
  for (int quarter = 0; quarter < 4; quarter += 2) {
    cairo_rectangle(pen, x + quarter * length / 4, y - 5, length / 4, 8);
    cairo_fill(pen);
  }
  text(x + length + 10, y + 5, metres_text(length_m, digits_for(length_m)));
}

void Canvas::Paper::ring(double x, double y, double radius, Colour fill) const {
  cairo_new_path(pen);
  cairo_arc(pen, x, y, radius, 0, kTurn);
  colour(fill);
  cairo_fill_preserve(pen);
  colour({255, 255, 255});
  cairo_set_line_width(pen, 2.5);
  cairo_stroke(pen);
}

void Canvas::Paper::star(double x, double y, double radius, Colour fill) const {
  cairo_new_path(pen);
  for (int i = 0; i < 10; ++i) {
    const double r = i % 2 == 0 ? radius : 0.45 * radius, angle = i * kTurn / 10;
    cairo_line_to(pen, x + r * repeatable::sin(angle), y - r * repeatable::cos(angle));
  }
  cairo_close_path(pen);
  colour({255, 255, 255});
  cairo_set_line_width(pen, 4);
  cairo_stroke_preserve(pen);
  colour(fill);
  cairo_fill(pen);
}

Canvas::Canvas(const Raster& raster) : paper_(std::make_unique<Paper>(raster)) {}
Canvas::~Canvas() = default;

void Canvas::polyline(const std::vector<Eigen::Vector2d>& points_m, Colour colour) {
  cairo_t* pen = paper_->pen;
  cairo_save(pen);
  cairo_rectangle(pen, paper_->left, paper_->top, paper_->map_width, paper_->map_height);
  cairo_clip(pen);
  cairo_set_line_join(pen, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(pen, CAIRO_LINE_CAP_ROUND);
  for (const Eigen::Vector2d& point : points_m) {
    const Eigen::Vector2d p = paper_->pixel(point);
    cairo_line_to(pen, p.x(), p.y());
  }
  paper_->colour({255, 255, 255});
  cairo_set_line_width(pen, 6);
  cairo_stroke_preserve(pen);
  paper_->colour(colour);
  cairo_set_line_width(pen, 3.5);
  cairo_stroke(pen);
  cairo_restore(pen);
}

void Canvas::start_mark(const Eigen::Vector2d& at_m) {
  const Eigen::Vector2d p = paper_->pixel(at_m);
  paper_->ring(p.x(), p.y(), 8, kStart);
}

void Canvas::goal_mark(const Eigen::Vector2d& at_m) {
  const Eigen::Vector2d p = paper_->pixel(at_m);
  paper_->star(p.x(), p.y(), 13, kGoal);
}

void Canvas::note(const std::string& words) {
  const double x = paper_->left + (paper_->map_width - paper_->text_width(words)) / 2;
  paper_->text(x, paper_->top + paper_->map_height / 2, words);
}

void Canvas::legend_field(Colour colour, const std::string& words) {
  cairo_t* pen = paper_->pen;
  cairo_rectangle(pen, paper_->legend_x + 0.5, paper_->legend_y - 8.5, 26, 17);
  paper_->colour(colour);
  cairo_fill_preserve(pen);
  paper_->colour({120, 120, 120});
  cairo_set_line_width(pen, 1);
  cairo_stroke(pen);
  paper_->legend_text(26, words);
}

void Canvas::legend_line(Colour colour, const std::string& words) {
  cairo_t* pen = paper_->pen;
  cairo_move_to(pen, paper_->legend_x, paper_->legend_y);
  cairo_line_to(pen, paper_->legend_x + 34, paper_->legend_y);
  paper_->colour(colour);
  cairo_set_line_width(pen, 4);
  cairo_stroke(pen);
  paper_->legend_text(34, words);
}

void Canvas::legend_heights(double lowest_m, double highest_m) {
  constexpr int kLength = 240;
  paper_->text(paper_->legend_x, paper_->legend_y + 6, "height");
  paper_->legend_x += paper_->text_width("height") + 12;
  const std::string low = metres_text(lowest_m, 1), high = metres_text(highest_m, 1);
  paper_->text(paper_->legend_x, paper_->legend_y + 6, low);
  paper_->legend_x += paper_->text_width(low) + 8;
  for (int i = 0; i < kLength; ++i) {
    paper_->colour(height_colour(i / (kLength - 1.0)));
    cairo_rectangle(paper_->pen, std::floor(paper_->legend_x) + i, paper_->legend_y - 8, 1, 16);
    cairo_fill(paper_->pen);
  }
  paper_->legend_text(kLength, high);
}

void Canvas::legend_marks() {
  paper_->ring(paper_->legend_x + 9, paper_->legend_y, 8, kStart);
  paper_->legend_text(18, "start");
  paper_->star(paper_->legend_x + 13, paper_->legend_y, 13, kGoal);
  paper_->legend_text(26, "goal");
}

std::string Canvas::png() {
  std::string bytes;
  cairo_surface_flush(paper_->surface);
  cairo_surface_write_to_png_stream(paper_->surface, append, &bytes);
  return bytes;
}

}  // namespace scanway
