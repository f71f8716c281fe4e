#include "reports/study/results_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <set>
#include <stdexcept>
#include <utility>

namespace plumb {
namespace {

// What a run that was killed had just begun may hold its file for a moment longer. Some file systems of clusters have
// no locks.
bool locks(int file) {
  constexpr int tries = 100;
  constexpr useconds_t pause = 10'000;  // us
  for (int i = 0; i < tries; ++i) {
    if (flock(file, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return true;
    usleep(pause);
  }
  return false;
}

using Json = nlohmann::ordered_json;

constexpr int results_format = 1;  // of a results file

// These tell where points were found out, and not what.
const std::set<std::string> of_the_place{"system", "processor", "processors"};

Json json_of(const ResultsHead& head) {
  return {{"plumb_study", results_format},        {"study", head.study},
          {"configuration", head.configuration},  {"plan", head.plan},
          {"shard", head.shard.name()},           {"points", head.points},
          {"environment", Json(head.environment)}};
}

ResultsHead head_of(const std::string& line) {
  const Json json = Json::parse(line);
  if (json.at("plumb_study") != results_format) {
    throw std::invalid_argument(
        fmt::format("is of results_format {}, not {}", json.at("plumb_study").dump(), results_format));
  }
  return {.study = json.at("study"),
          .configuration = json.at("configuration"),
          .plan = json.at("plan"),
          .shard = parse_shard(json.at("shard").get<std::string>()),
          .points = json.at("points"),
          .environment = json.at("environment")};
}

std::string environment_apart(const ResultsHead& a, const ResultsHead& b) {
  for (const auto& [key, value] : a.environment) {
    const auto other = b.environment.find(key);
    if (of_the_place.contains(key) || (other != b.environment.end() && other->second == value)) continue;
    return fmt::format("{} \"{}\", not \"{}\"", key, value, other == b.environment.end() ? "" : other->second);
  }
  return "";
}

}  // namespace

std::string ResultsHead::foreign_to(const ResultsHead& other) const {
  if (study != other.study) return fmt::format("the study \"{}\", not \"{}\"", study, other.study);
  if (configuration != other.configuration) {
    return fmt::format("the configuration {}, not {}", configuration.dump(), other.configuration.dump());
  }
  if (const std::string apart = environment_apart(*this, other); !apart.empty()) return apart;
  return plan == other.plan ? "" : "another plan of points";
}

// FNV-1a, 64 bits: to tell plans apart, not to keep secrets.
std::string plan_hash(std::span<const Point> points) {
  std::uint64_t hash = 14695981039346656037U;
  for (const Point& point : points) {
    for (const char letter : point.key + "\n") hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211U;
  }
  return fmt::format("{:016x}", hash);
}

KeptResults read_results(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  const int why = std::filesystem::is_directory(path) ? EISDIR : errno;
  if (!in || why == EISDIR) {
    throw std::invalid_argument(fmt::format("{}: cannot be read: {}", path.string(), std::strerror(why)));
  }
  KeptResults kept;
  std::size_t line_number = 0;
  for (std::string line; std::getline(in, line) && !in.eof();) {
    ++line_number;
    try {
      if (line_number == 1) {
        kept.head = head_of(line);
      } else {
        PointResult result = from_line(line);
        std::string key = result.key;
        if (!kept.results.emplace(key, std::move(result)).second) {
          throw std::invalid_argument("\"" + key + "\" is there twice");
        }
      }
    } catch (const std::exception& error) {
      throw std::invalid_argument(
          fmt::format("{}: line {}: {}", path.string(), line_number,
                      line_number == 1 ? fmt::format("not the beginning of a study's results ({})", error.what())
                                       : std::string(error.what())));
    }
    kept.whole += line.size() + 1;
  }
  if (line_number == 0) throw std::invalid_argument(path.string() + ": has not even a first line");
  return kept;
}

ResultsFile::ResultsFile(const std::filesystem::path& path, std::size_t keep)
    : path_(path), file_(open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666)) {
  const auto refuse = [&](const std::string& why) {
    if (file_ >= 0) close(file_);
    throw std::invalid_argument(fmt::format("{}: {}", path.string(), why));
  };
  if (file_ < 0) refuse(std::string("cannot be written: ") + std::strerror(errno));
  if (!locks(file_)) refuse("another plumb is writing it");
  if (ftruncate(file_, static_cast<off_t>(keep)) != 0) refuse(std::string("cannot be cut: ") + std::strerror(errno));
}

ResultsFile ResultsFile::begin(const std::filesystem::path& path, const ResultsHead& head) {
  ResultsFile file(path, 0);
  file.write(json_of(head).dump() + "\n");
  return file;
}

ResultsFile ResultsFile::go_on(const std::filesystem::path& path, const KeptResults& kept) {
  return {path, kept.whole};
}

ResultsFile::ResultsFile(ResultsFile&& other) noexcept
    : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)) {}

ResultsFile::~ResultsFile() {
  if (file_ >= 0) close(file_);
}

void ResultsFile::add(std::span<const PointResult> results) {
  std::string lines;
  for (const PointResult& result : results) lines += to_line(result);
  write(lines);
}

void ResultsFile::write(const std::string& text) {
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t now = ::write(file_, text.data() + sent, text.size() - sent);
    if (now < 0 && errno == EINTR) continue;
    if (now <= 0)
      throw std::runtime_error(fmt::format("{}: cannot be written: {}", path_.string(), std::strerror(errno)));
    sent += static_cast<std::size_t>(now);
  }
}

}  // namespace plumb
