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

#include "reports/system/files.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

constexpr int results_format = 2;  // version of the results file

// Entries of the environment that describe the machine, not the program.
const std::set<std::string> machine_entries{"system", "processor", "processors"};

// A child process of a run that was just killed may hold its file for a moment longer, so a lock is tried for a second.
// Other errors pass: some file systems of clusters have no locks.
bool locks(int file) {
  constexpr int tries = 100;
  constexpr useconds_t pause = 10'000;  // us
  for (int i = 0; i < tries; ++i) {
    if (flock(file, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return true;
    usleep(pause);
  }
  return false;
}

Json json_of(const ResultsHead& head) {
  return {{"plumb_study", results_format},        {"study", head.study},
          {"configuration", head.configuration},  {"plan", head.plan},
          {"shard", head.shard.name()},           {"jobs", head.jobs},
          {"environment", Json(head.environment)}};
}

ResultsHead parse_head(const std::string& line) {
  try {
    const Json json = Json::parse(line);
    if (json.at("plumb_study") != results_format) {
      throw std::invalid_argument(fmt::format("has format {}, this plumb reads {}: run the study again with --fresh",
                                              json.at("plumb_study").dump(), results_format));
    }
    return {.study = json.at("study"),
            .configuration = json.at("configuration"),
            .plan = json.at("plan"),
            .shard = parse_shard(json.at("shard").get<std::string>()),
            .jobs = json.at("jobs"),
            .environment = json.at("environment")};
  } catch (const Json::exception& error) {
    throw std::invalid_argument(fmt::format("not the head of a study's results ({})", error.what()));
  }
}

std::string environment_difference(const ResultsHead& a, const ResultsHead& b) {
  for (const auto& [key, value] : a.environment) {
    const auto other = b.environment.find(key);
    if (machine_entries.contains(key) || (other != b.environment.end() && other->second == value)) continue;
    return fmt::format("{} \"{}\", not \"{}\"", key, value, other == b.environment.end() ? "" : other->second);
  }
  return "";
}

}  // namespace

std::string ResultsHead::difference_from(const ResultsHead& other) const {
  if (study != other.study) return fmt::format("the study \"{}\", not \"{}\"", study, other.study);
  if (configuration != other.configuration) {
    return fmt::format("the configuration {}, not {}", configuration.dump(), other.configuration.dump());
  }
  if (std::string difference = environment_difference(*this, other); !difference.empty()) return difference;
  return plan == other.plan ? "" : "a different plan of jobs";
}

std::string hash_of_lines(std::span<const std::string> lines) {
  std::uint64_t hash = 14695981039346656037U;
  for (const std::string& line : lines) {
    for (const char letter : line + "\n") hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211U;
  }
  return fmt::format("{:016x}", hash);
}

std::string plan_hash(std::span<const Job> jobs) {
  std::vector<std::string> keys;
  for (const Job& job : jobs) keys.push_back(job.key);
  return hash_of_lines(keys);
}

std::vector<JobResult> in_plan_order(std::span<const Job> jobs, const std::map<std::string, JobResult>& by_key) {
  std::vector<JobResult> results;
  for (const Job& job : jobs) results.push_back(by_key.at(job.key));
  return results;
}

StoredResults read_results(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  const int why = std::filesystem::is_directory(path) ? EISDIR : errno;
  if (!in || why == EISDIR) {
    throw std::invalid_argument(fmt::format("{}: cannot be read: {}", path.string(), std::strerror(why)));
  }
  StoredResults stored;
  std::size_t line_number = 0;
  for (std::string line; std::getline(in, line) && !in.eof();) {
    ++line_number;
    try {
      if (line_number == 1) {
        stored.head = parse_head(line);
      } else {
        JobResult result = from_line(line);
        std::string key = result.key;
        if (!stored.results.emplace(key, std::move(result)).second) {
          throw std::invalid_argument("\"" + key + "\" occurs twice");
        }
      }
    } catch (const std::exception& error) {
      throw std::invalid_argument(fmt::format("{}: line {}: {}", path.string(), line_number, error.what()));
    }
    stored.bytes += line.size() + 1;
  }
  if (line_number == 0) throw std::invalid_argument(path.string() + ": has no complete line");
  return stored;
}

ResultsFile::ResultsFile(const std::filesystem::path& path, std::size_t bytes_to_keep)
    : path_(path), file_(open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666)) {
  const auto refuse = [&](const std::string& why) {
    if (file_ >= 0) close(file_);
    throw std::invalid_argument(fmt::format("{}: {}", path.string(), why));
  };
  if (file_ < 0) refuse(std::string("cannot be written: ") + std::strerror(errno));
  if (!locks(file_)) refuse("another plumb process is writing it");
  if (ftruncate(file_, static_cast<off_t>(bytes_to_keep)) != 0) {
    refuse(std::string("cannot be truncated: ") + std::strerror(errno));
  }
}

ResultsFile ResultsFile::create(const std::filesystem::path& path, const ResultsHead& head) {
  ResultsFile file(path, 0);
  file.write(json_of(head).dump() + "\n");
  return file;
}

ResultsFile ResultsFile::append(const std::filesystem::path& path, const StoredResults& stored) {
  return {path, stored.bytes};
}

ResultsFile::ResultsFile(ResultsFile&& other) noexcept
    : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)) {}

ResultsFile::~ResultsFile() {
  if (file_ >= 0) close(file_);
}

void ResultsFile::add(std::span<const JobResult> results) {
  std::string lines;
  for (const JobResult& result : results) lines += to_line(result);
  write(lines);
}

void ResultsFile::write(const std::string& text) {
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t now = ::write(file_, text.data() + sent, text.size() - sent);
    if (now < 0 && errno == EINTR) continue;
    if (now <= 0) throw FileError(fmt::format("{}: cannot be written: {}", path_.string(), std::strerror(errno)));
    sent += static_cast<std::size_t>(now);
  }
}

}  // namespace plumb
