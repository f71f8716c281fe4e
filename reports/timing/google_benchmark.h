#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>

/// The JSON format of Google Benchmark, whose tools compare such files. Times in us.
namespace plumb::google_benchmark {

using Json = nlohmann::ordered_json;

/// An entry without times yet: type "iteration" is a repetition, "aggregate" a statistic of all repetitions.
Json entry(const std::string& name, const char* type, int repetitions, int threads, std::size_t iterations);

/// Adds times, given in s.
void add_times(Json& entry, double wall, double cpu);

/// Makes an entry the median of the benchmark's repetitions.
void name_median(Json& entry);

/// Gives an entry an error in place of times.
void add_error(Json& entry, const std::string& why);

/// The text of a whole file: the entries after their context, which is the environment.
std::string text_of(Json entries);
/// The same with further facts in the context.
std::string text_of(Json entries, const Json& facts);

}  // namespace plumb::google_benchmark
