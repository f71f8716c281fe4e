#pragma once

#include <nlohmann/json.hpp>
#include <string>

/// The shape of Google Benchmark's JSON, which its tools compare. Times in us.
namespace plumb::google_benchmark {

using Json = nlohmann::ordered_json;

/// One entry of a benchmark, so far without times: "iteration" is a repetition, "aggregate" what they come to.
Json entry(const std::string& name, const char* type, int repetitions, int threads, std::size_t iterations);

/// Times in s.
void add_times(Json& to, double wall, double cpu);

/// Makes an entry the median of the benchmark's repetitions.
void name_median(Json& entry);

/// An entry that has no times, and why.
void add_error(Json& to, const std::string& why);

/// The whole file: entries, after what they were made with. `facts` come beside the environment.
std::string text_of(Json entries, const Json& facts = Json::object());

}  // namespace plumb::google_benchmark
