#include "reference/programs/program_engine.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "reference/programs/protocol.h"
#include "scenarios/scene/json_reader.h"
#include "scenarios/scene/scene_json.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

Json option_as_json(const Option& option) {
  Json json{{"key", option.key}, {"value", option.value}, {"about", option.about}};
  if (option.choices.empty()) {
    json.update({{"min", option.min}, {"max", option.max}, {"whole", option.whole}});
    return json;
  }
  for (const auto& [value, about] : option.choices) json["choices"].push_back({{"value", value}, {"about", about}});
  return json;
}

// Standard output under another number: what the engine prints goes to standard error, and no answer is lost in it.
class Answers {
 public:
  Answers() : file_(fdopen(dup(STDOUT_FILENO), "w")) {
    std::setvbuf(file_, nullptr, _IOFBF, std::size_t{1} << 16);
    std::fflush(stdout);
    dup2(STDERR_FILENO, STDOUT_FILENO);
  }
  Answers(const Answers&) = delete;
  Answers& operator=(const Answers&) = delete;
  ~Answers() { std::fclose(file_); }

  void add(const Json& answer) const { add_line(answer.dump()); }
  void add_line(const std::string& line) const {
    std::fputs(line.c_str(), file_);
    std::fputc('\n', file_);
  }
  void send() const { std::fflush(file_); }

 private:
  std::FILE* file_;
};

class Server {
 public:
  explicit Server(const Engine& engine) : engine_(engine) {}

  void answer(const nlohmann::json& ask) {
    const auto is = [&](const char* what) { return ask.is_object() && ask.contains(what); };
    if (is("hello")) {
      answers_.add(hello());
    } else if (is("stepping")) {
      const auto& how = ask["stepping"];
      answers_.add(
          {{"stepping", protocol::stepping_as_json(engine_.stepping(settings_of(how), how.at("dt").get<double>()))}});
    } else if (is("build")) {
      answers_.add_line(build(ask["build"]));
    } else if (is("step")) {
      for (auto left = ask["step"].at("count").get<std::size_t>(); left > 0; --left) {
        answers_.add_line(step(ask["step"].at("dt").get<double>()));
      }
    } else {
      answers_.add({{"error", "unknown ask"}});
    }
    answers_.send();
  }

  void refuse(const std::string& why) const {
    answers_.add({{"error", printable(why, 400)}});
    answers_.send();
  }

 private:
  Json hello() const {
    Json json{{"plumb-engine", 1},
              {"name", engine_.name},
              {"version", "1"},
              {"about", engine_.about},
              {"source", engine_.source},
              {"language", engine_.language},
              {"execution", name_of(engine_.execution)}};
    if (!engine_.caveats.empty()) json["caveats"] = engine_.caveats;
    for (const Option& option : engine_.options) {
      json["options"].push_back(option_as_json(option));
      for (const WorkLadder& ladder : engine_.ladders) {
        if (ladder.method.empty() && ladder.option == option.key) json["options"].back()["ladder"] = ladder.values;
      }
    }
    return json;
  }

  static std::string not_supported(const std::string& why) {
    return Json{{"notSupported", printable(why, 400)}}.dump();
  }

  Settings settings_of(const nlohmann::json& how) const { return complete(engine_, how.at("options").get<Settings>()); }

  std::string build(const nlohmann::json& how) {
    simulation_.reset();
    steps_ = 0;
    const Settings settings = settings_of(how);
    scene_ = read_scene(how.at("scene").dump(), "the scene").scene;
    const std::string refusal = engine_.unsupported(scene_, settings);
    if (!refusal.empty()) return not_supported(refusal);
    try {
      simulation_ = engine_.build(scene_, settings);
    } catch (const std::domain_error& error) {
      return not_supported(error.what());
    }
    return protocol::write_start(states());
  }

  std::string step(double dt) {
    if (!simulation_) throw std::logic_error("nothing is built");
    const auto began = Clock::now();
    simulation_->step(dt);
    const auto spent = std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - began);
    contacts_.clear();
    simulation_->read_contacts(contacts_);
    return protocol::write_step(++steps_, spent.count(), states(), contacts_);
  }

  std::span<const BodyState> states() {
    states_.resize(scene_.bodies.size());
    simulation_->read(states_);
    return states_;
  }

  const Engine& engine_;
  Answers answers_;
  Scene scene_;
  std::unique_ptr<Simulation> simulation_;
  std::size_t steps_ = 0;
  std::vector<BodyState> states_;
  std::vector<ContactState> contacts_;
};

}  // namespace

int serve(const Engine& engine) {
  Server server(engine);
  for (std::string line; std::getline(std::cin, line);) {
    try {
      const nlohmann::json ask = parse_json(line, "the ask");
      if (ask.is_object() && ask.contains("end")) return 0;
      server.answer(ask);
    } catch (const std::exception& error) {
      server.refuse(error.what());
    }
  }
  return 0;
}

}  // namespace plumb
