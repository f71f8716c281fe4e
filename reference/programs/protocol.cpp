#include "reference/programs/protocol.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "reference/programs/base64.h"
#include "scenarios/scene/json_reader.h"
#include "scenarios/scene/mass.h"
#include "scenarios/scene/scene_json.h"

namespace plumb::protocol {
namespace {

using Json = nlohmann::ordered_json;

constexpr int version = 1;
constexpr std::size_t longest_text = 500;  // bytes
constexpr double largest = std::numeric_limits<double>::max();
constexpr NumberRange any_number{-largest, largest};
constexpr NumberRange not_negative{0, largest};

// JsonReader names this as the place of an error.
constexpr std::string_view place = "its answer";

nlohmann::json parsed(std::string_view answer) { return parse_json(answer, place); }

// A program may answer any ask with {"error": "why"}.
void check_error(const JsonReader& in) {
  if (in.value().is_object() && in.has("error")) {
    throw std::invalid_argument("it says: " + in["error"].text(1, longest_text));
  }
}

std::string text_or(const JsonReader& in, const char* key, const std::string& otherwise) {
  return in.has(key) ? in[key].text(0, longest_text) : otherwise;
}

Option read_option(const JsonReader& in) {
  in.object({"key", "value", "about"}, {"choices", "min", "max", "whole", "ladder"});
  Option option{
      .key = in["key"].text(1, 40), .value = in["value"].text(1, 40), .about = in["about"].text(1, longest_text)};
  if (in.has("choices")) {
    const JsonReader choices = in["choices"];
    for (std::size_t i = 0; i < choices.list(); ++i) {
      const JsonReader choice = choices[i];
      choice.object({"value", "about"});
      option.choices.emplace_back(choice["value"].text(1, 40), choice["about"].text(1, longest_text));
    }
    return option;
  }
  in.must_have("min");
  in.must_have("max");
  option.min = in["min"].number(any_number);
  option.max = in["max"].number({option.min, largest});
  option.whole = in.boolean("whole", false);
  return option;
}

// The values of an option from cheap to expensive, if it trades speed for accuracy.
std::vector<std::string> read_ladder(const JsonReader& in, const Option& option) {
  std::vector<std::string> values;
  if (!in.has("ladder")) return values;
  const JsonReader ladder = in["ladder"];
  for (std::size_t i = 0; i < ladder.list(); ++i) {
    values.push_back(ladder[i].text(1, 40));
    complete({.name = "ladder", .options = {option}}, {{option.key, values.back()}});
  }
  return values;
}

// All numbers of a list of rows, or of base64 of these numbers in turn.
std::vector<double> read_rows(const JsonReader& in, std::size_t width, const char* row) {
  if (in.value().is_string()) {
    const auto numbers = numbers_of_base64(in.value().get_ref<const std::string&>());
    if (!numbers || numbers->size() % width != 0) in.expected("a list, or base64 of rows of " + std::string(row));
    const auto odd = std::ranges::find_if_not(*numbers, [](double number) { return std::isfinite(number); });
    if (odd != numbers->end()) in.refuse(fmt::format("number {} is {}", odd - numbers->begin(), *odd));
    return *numbers;
  }
  std::vector<double> numbers;
  for (std::size_t i = 0; i < in.list(); ++i) {
    const JsonReader one = in[i];
    if (one.list() != width) one.expected(row);
    for (std::size_t k = 0; k < width; ++k) numbers.push_back(one[k].number(any_number));
  }
  return numbers;
}

constexpr std::size_t state_width = 6;
constexpr std::size_t contact_width = 9;

std::vector<BodyState> states_of(std::span<const double> numbers) {
  std::vector<BodyState> states(numbers.size() / state_width);
  for (std::size_t i = 0; i < states.size(); ++i) {
    const double* at = &numbers[i * state_width];
    states[i] = {{at[0], at[1]}, at[2], {at[3], at[4]}, at[5]};
  }
  return states;
}

// `wrong` becomes what is wrong with them, if anything is.
std::vector<ContactState> contacts_of(std::span<const double> numbers, std::size_t bodies, std::string& wrong) {
  std::vector<ContactState> contacts(numbers.size() / contact_width);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const double* at = &numbers[i * contact_width];
    for (const double index : {at[0], at[1]}) {
      if (index >= 0 && index < static_cast<double>(bodies) && index == std::floor(index)) continue;
      wrong = fmt::format("contact {} is of body {}, but there are {}", i, index, bodies);
      return {};
    }
    contacts[i] = {static_cast<std::size_t>(at[0]),
                   static_cast<std::size_t>(at[1]),
                   {at[2], at[3]},
                   {at[4], at[5]},
                   at[6],
                   at[7],
                   at[8]};
    if (std::abs(std::hypot(at[4], at[5]) - 1) > 1e-3) {
      wrong = fmt::format("contact {} needs a normal of length 1", i);
      return {};
    }
  }
  return contacts;
}

std::vector<BodyState> read_states(const JsonReader& in, std::size_t bodies) {
  const auto numbers = read_rows(in, state_width, "6 numbers: x, y, angle, vx, vy, angular velocity");
  if (numbers.size() != state_width * bodies) in.expected("the states of " + std::to_string(bodies) + " bodies");
  return states_of(numbers);
}

std::vector<ContactState> read_contacts(const JsonReader& in, std::size_t bodies) {
  const auto numbers = read_rows(in, contact_width,
                                 "9 numbers: bodies a and b, point x and y, normal x and y, normal impulse, tangent "
                                 "impulse, separation");
  std::string wrong;
  auto contacts = contacts_of(numbers, bodies, wrong);
  if (!wrong.empty()) in.refuse(wrong);
  return contacts;
}

std::string packed(std::span<const BodyState> states) {
  std::vector<double> numbers;
  numbers.reserve(state_width * states.size());
  for (const BodyState& it : states) {
    numbers.insert(numbers.end(),
                   {it.position.x, it.position.y, it.angle, it.velocity.x, it.velocity.y, it.angular_velocity});
  }
  return base64(numbers);
}

Json settings_as_json(const Settings& settings) {
  Json json = Json::object();
  for (const auto& [key, value] : settings) json[key] = value;
  return json;
}

const Word<ExecutionKind> executions[] = {{name_of(ExecutionKind::native), ExecutionKind::native},
                                          {name_of(ExecutionKind::webassembly), ExecutionKind::webassembly},
                                          {name_of(ExecutionKind::jit), ExecutionKind::jit},
                                          {name_of(ExecutionKind::interpreted), ExecutionKind::interpreted}};

}  // namespace

std::string ask_hello() { return Json{{"hello", version}}.dump(); }

Identity read_hello(std::string_view answer) {
  const nlohmann::json json = parsed(answer);
  const JsonReader in(json, place);
  check_error(in);
  in.object({"plumb-engine", "name", "version"}, {"about", "source", "language", "execution", "caveats", "options"});
  if (in["plumb-engine"].number(any_number) != version) in["plumb-engine"].expected("1, the version of the protocol");
  Identity identity{.name = in["name"].text(1, 40),
                    .version = in["version"].text(1, 40),
                    .about = text_or(in, "about", ""),
                    .source = text_or(in, "source", ""),
                    .language = text_or(in, "language", "")};
  if (in.has("execution")) identity.execution = in["execution"].one_of<ExecutionKind>(executions);
  if (identity.name.find_first_of(":,= @|") != std::string::npos) {
    in["name"].refuse("must be a name without space, : , = @ and |");
  }
  for (std::size_t i = 0; in.has("caveats") && i < in["caveats"].list(); ++i) {
    identity.caveats.push_back(in["caveats"][i].text(1, longest_text));
  }
  for (std::size_t i = 0; in.has("options") && i < in["options"].list(); ++i) {
    const Option option = read_option(in["options"][i]);
    std::vector<std::string> ladder = read_ladder(in["options"][i], option);
    if (!ladder.empty()) identity.ladders.push_back({.option = option.key, .values = std::move(ladder)});
    identity.options.push_back(option);
  }
  return identity;
}

std::string ask_stepping(const Settings& settings, double dt) {
  return Json{{"stepping", {{"dt", dt}, {"options", settings_as_json(settings)}}}}.dump();
}

Stepping read_stepping(std::string_view answer, double dt) {
  const nlohmann::json json = parsed(answer);
  const JsonReader top(json, place);
  check_error(top);
  top.object({"stepping"});
  return stepping_of(top["stepping"], dt);
}

std::string ask_build(const Scene& scene, const Settings& settings) {
  Json masses = Json::array();
  for (const Body& body : scene.bodies) {
    const Mass mass = mass_of(body);
    masses.push_back({mass.mass, mass.inertia, mass.center.x, mass.center.y});
  }
  const Json written = Json::parse(write_scene({scene, {}}));
  return Json{{"build", {{"scene", written}, {"masses", masses}, {"options", settings_as_json(settings)}}}}.dump();
}

std::string write_start(std::span<const BodyState> states) { return Json{{"states", packed(states)}}.dump(); }

Answer read_build(std::string_view answer, std::size_t bodies) {
  const nlohmann::json json = parsed(answer);
  const JsonReader in(json, place);
  check_error(in);
  if (in.value().is_object() && in.has("notSupported")) {
    return {.refusal = in["notSupported"].text(1, longest_text), .states = {}, .contacts = {}};
  }
  in.object({"states"});
  return {.refusal = "", .states = read_states(in["states"], bodies), .contacts = {}};
}

std::string ask_steps(std::size_t count, double dt) { return Json{{"step", {{"count", count}, {"dt", dt}}}}.dump(); }

Answer read_step(std::string_view answer, std::size_t bodies, std::size_t number) {
  // The way of every step that nothing is wrong with.
  StepLine line;
  if (scan_step_line(answer, line) && line.step == number && line.states.size() == state_width * bodies) {
    std::string wrong;
    Answer read{.refusal = "", .states = states_of(line.states), .contacts = contacts_of(line.contacts, bodies, wrong)};
    read.seconds = line.nanoseconds * 1e-9;
    if (wrong.empty()) return read;
  }
  const nlohmann::json json = parsed(answer);
  const JsonReader in(json, place);
  check_error(in);
  in.object({"step", "states", "ns"}, {"contacts"});
  if (in["step"].number(any_number) != static_cast<double>(number)) in["step"].expected(std::to_string(number));
  Answer read{.refusal = "", .states = read_states(in["states"], bodies), .contacts = {}};
  if (in.has("contacts")) read.contacts = read_contacts(in["contacts"], bodies);
  read.seconds = in["ns"].number(not_negative) * 1e-9;
  return read;
}

std::string write_step(std::size_t number, std::int64_t nanoseconds, std::span<const BodyState> states,
                       std::span<const ContactState> contacts) {
  std::vector<double> numbers;
  numbers.reserve(contact_width * contacts.size());
  for (const ContactState& it : contacts) {
    numbers.insert(numbers.end(), {static_cast<double>(it.a), static_cast<double>(it.b), it.point.x, it.point.y,
                                   it.normal.x, it.normal.y, it.normal_impulse, it.tangent_impulse, it.separation});
  }
  const std::string met = contacts.empty() ? "" : fmt::format(R"(,"contacts":"{}")", base64(numbers));
  return fmt::format(R"({{"step":{},"ns":{},"states":"{}"{}}})", number, nanoseconds, packed(states), met);
}

std::string ask_end() { return Json{{"end", true}}.dump(); }

}  // namespace plumb::protocol
