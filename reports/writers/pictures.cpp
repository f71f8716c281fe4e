#include "reports/writers/pictures.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

#include "reports/judge/overlap.h"
#include "reports/system/files.h"
#include "reports/system/processes.h"
#include "reports/writers/html.h"
#include "scenarios/scene/mass.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

constexpr double picture_width = 720;               // px, of all panels together
constexpr double head = 40;                         // px, above them
constexpr double foot = 24;                         // px, below
constexpr std::array<double, 2> heights{120, 360};  // px, of the panels
constexpr std::array colours{"#0868ac", "#c2500f", "#0b8062", "#9c4a86", "#8a6a00", "#3a8fc4"};  // as on the page

struct Window {
  Vec low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};  // m
};

struct Part {
  std::size_t body;
  bool moves;
  Outline outline;  // about the centre of mass
};

std::vector<Part> parts_of(const Scene& scene) {
  std::vector<Part> parts;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    for (const Shape& shape : body.shapes) {
      parts.push_back({i, body.type == BodyType::dynamic, outline_of(shape.geometry, mass_of(body).center)});
    }
  }
  return parts;
}

// The area that moving bodies cover in a run, with a margin of a tenth.
Window window_of(const RunRecord& run, const std::vector<Part>& parts) {
  Window window;
  for (std::size_t moment = 0; moment < run.trace->size(); ++moment) {
    const auto states = run.trace->states(moment);
    for (const Part& part : parts) {
      if (!part.moves) continue;
      const Outline here = placed(part.outline, states[part.body].position, states[part.body].angle);
      const auto across = range_along({1, 0}, here);
      const auto up = range_along({0, 1}, here);
      if (!across || !up) continue;
      window.low = {std::min(window.low.x, across->low), std::min(window.low.y, up->low)};
      window.high = {std::max(window.high.x, across->high), std::max(window.high.y, up->high)};
    }
  }
  const double room = 0.1 * std::max(window.high.x - window.low.x, window.high.y - window.low.y);
  return {{window.low.x - room, window.low.y - room}, {window.high.x + room, window.high.y + room}};
}

std::string in_svg(const std::string& text) {
  std::string safe;
  for (const char character : text) {
    if (character == '<' || character == '>' || character == '&' || character == '"') {
      safe += fmt::format("&#{};", static_cast<int>(character));
    } else {
      safe += character;
    }
  }
  return safe;
}

// One engine's share of the picture.
class Panel {
 public:
  Panel(const RunRecord& run, const char* colour, double left, double wide, double high, const Window& window)
      : run_(run), parts_(parts_of(*run.scene)), colour_(colour), left_(left), wide_(wide), high_(high) {
    const Vec size = window.high - window.low;
    scale_ = std::min(wide / size.x, high / size.y);
    center_ = {(window.low.x + window.high.x) / 2, (window.low.y + window.high.y) / 2};
  }

  std::string at(double time) const {
    std::string text =
        fmt::format(R"(<svg x="{:.1f}" y="{}" width="{:.1f}" height="{:.1f}">)", left_, head, wide_, high_);
    for (const bool moves : {false, true}) {
      for (const Part& part : parts_) {
        if (part.moves != moves) continue;
        const BodyState state = run_.trace->state_at(part.body, time);
        if (std::isfinite(state.position.x) && std::isfinite(state.position.y) && std::isfinite(state.angle))
          text += drawn(placed(part.outline, state.position, state.angle), moves ? colour_ : "#b9b4a7");
      }
    }
    return text + "</svg>" + line(16, "bold", run_.exact ? "truth" : run_.engine) +
           line(32, "normal",
                (run_.method.empty() ? "" : run_.method + ", ") + (run_.exact ? "exact" : name_of(run_.verdict)));
  }

 private:
  std::string line(double y, const char* weight, const std::string& text) const {
    return fmt::format(R"(<text x="{:.1f}" y="{}" fill="{}" font-weight="{}">{}</text>)", left_ + 6, y, colour_, weight,
                       in_svg(text));
  }

  std::string point(Vec p) const {
    return fmt::format("{:.2f},{:.2f} ", wide_ / 2 + scale_ * (p.x - center_.x),
                       high_ / 2 - scale_ * (p.y - center_.y));
  }

  std::string drawn(const Outline& outline, const char* colour) const {
    std::string points;
    double radius = outline.radius;
    if (outline.halfspace) {
      const double far = 4 * (wide_ + high_) / scale_;  // m, beyond every edge of the panel
      const Vec normal = outline.halfspace->normal;
      const Vec along{-normal.y * far, normal.x * far};
      const Vec foot_point = outline.halfspace->offset * normal;
      const Vec deep = foot_point - far * normal;
      for (const Vec corner : {foot_point + along, foot_point - along, deep - along, deep + along})
        points += point(corner);
    } else {
      for (const Vec corner : outline.points) points += point(corner);
      if (outline.points.size() == 1) points += point(outline.points.front());
    }
    return fmt::format(
        R"(<polygon points="{}" fill="{}" stroke="{}" stroke-width="{:.2f}" stroke-linejoin="round" stroke-linecap="round"/>)",
        points, colour, outline.radius > 0 ? colour : "#ffffff", std::max(1.0, 2 * radius * scale_));
  }

  const RunRecord& run_;
  std::vector<Part> parts_;
  const char* colour_;
  double left_, wide_, high_;  // px
  double scale_ = 1;           // px/m
  Vec center_;                 // m
};

std::vector<const RunRecord*> runs_of(const Report& report) {
  if (report.runs.empty()) throw std::invalid_argument("--preview: nothing was run");
  const RunRecord& first = report.runs.front();
  std::vector<const RunRecord*> runs;
  std::string reasons;
  for (const RunRecord& run : report.runs) {
    if (run.scenario != first.scenario || run.variant != first.variant) continue;
    if (run.status == Status::ok && run.trace && run.trace->size() > 1) {
      runs.push_back(&run);
    } else {
      reasons += fmt::format("\n  {}: {}", run.engine, run.reason);
    }
  }
  if (runs.empty())
    throw std::invalid_argument(
        fmt::format("--preview: no run of {}:{} has anything to show; ask for another case or engine{}", first.scenario,
                    first.variant, reasons));
  return runs;
}

}  // namespace

Preview preview_of(const Report& report) {
  const auto runs = runs_of(report);
  const auto exact = std::find_if(runs.begin(), runs.end(), [](const RunRecord* run) { return run->exact; });
  const RunRecord& leading = exact == runs.end() ? *runs.front() : **exact;
  const Window window = window_of(leading, parts_of(*leading.scene));
  const double each = picture_width / static_cast<double>(runs.size());
  const Vec size = window.high - window.low;
  const double high = std::clamp(each * size.y / size.x, heights.front(), heights.back());
  std::vector<Panel> panels;
  std::size_t engines = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    panels.emplace_back(*runs[i], runs[i]->exact ? "#6f6a5e" : colours[engines++ % colours.size()],
                        each * static_cast<double>(i), each, high, window);
  }
  Preview preview;
  const double end = std::min(Preview::longest, leading.trace->times().back());
  for (std::size_t i = 0; static_cast<double>(i) / Preview::rate <= end; ++i) {
    const double time = static_cast<double>(i) / Preview::rate;
    std::string text = fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0}" height="{1:.0f}" font-family="sans-serif" font-size="12"><rect width="{0}" height="{1:.0f}" fill="#fcfbf8"/>)",
        picture_width, head + high + foot);
    for (const Panel& panel : panels) text += panel.at(time);
    text += fmt::format(R"(<text x="6" y="{:.1f}" fill="#565c64">{}, {:.2f} s</text></svg>)", head + high + 16,
                        in_svg(leading.scenario + ", " + leading.variant), time);
    preview.frames.push_back(text);
  }
  return preview;
}

void check_preview() {
  if (!find_program("ffmpeg")) throw std::invalid_argument("--preview needs ffmpeg: apt-get install ffmpeg");
}

void write_preview(const Preview& preview, const fs::path& file) {
  const fs::path folder = fs::temp_directory_path() / fmt::format("plumb-preview-{}", getpid());
  fs::create_directories(folder);
  std::size_t number = 0;
  for (const std::string& frame : preview.frames) {
    NewFile written(folder / fmt::format("{:04}.svg", number++));
    if (!written.write(frame)) throw FileError("cannot write in \"" + folder.string() + "\"");
    written.put_in_place();
  }
  const std::string made = (folder / "preview.gif").string();
  // With a palette of the animation's own colours.
  const std::vector<std::string> words{"ffmpeg",
                                       "-loglevel",
                                       "error",
                                       "-framerate",
                                       fmt::format("{}", Preview::rate),
                                       "-i",
                                       (folder / "%04d.svg").string(),
                                       "-filter_complex",
                                       "split[a][b];[a]palettegen[p];[b][p]paletteuse",
                                       "-loop",
                                       "0",
                                       made};
  const int code = run_program(words);
  std::error_code error;
  if (code == 0) fs::copy_file(made, file, fs::copy_options::overwrite_existing, error);
  std::error_code ignored;
  fs::remove_all(folder, ignored);
  if (code != 0) throw std::invalid_argument(fmt::format("ffmpeg could not make the preview: exit code {}", code));
  if (error) throw FileError("cannot write \"" + file.string() + "\": " + error.message());
}

void check_pictures() {
  if (picture_program().empty())
    throw std::invalid_argument("--svg: Plumb was built without Node.js, so there is no page to take pictures of");
  if (!find_program("node")) throw std::invalid_argument("--svg needs Node.js 18 or newer: apt-get install nodejs");
}

void take_pictures(const std::filesystem::path& page, const std::filesystem::path& folder) {
  check_pictures();
  NewFile program(std::filesystem::temp_directory_path() / fmt::format("plumb-pictures-{}.cjs", getpid()));
  if (!program.write(std::string(picture_program()))) throw FileError("cannot write a temporary file");
  const auto file = program.put_in_place();
  std::fflush(stdout);
  const int code = run_program({"node", file.string(), page.string(), folder.string()});
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
  if (code != 0)
    throw std::runtime_error(fmt::format("could not write the charts: node ended with exit code {}", code));
}

}  // namespace plumb
