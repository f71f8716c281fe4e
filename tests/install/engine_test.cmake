# Builds the example engine of reference/README.md, whose friction is wrong, and checks that Plumb says so.
include(${CMAKE_CURRENT_LIST_DIR}/readme.cmake)
set(work ${BUILD}/engine_example)
file(REMOVE_RECURSE ${work})

function(expect what is should)
  if(NOT is STREQUAL should)
    message(FATAL_ERROR "${what}: \"${is}\", should be \"${should}\"")
  endif()
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --component impulse --prefix ${work}/installed)
run(${CMAKE_COMMAND} --install ${BUILD} --component plumb --prefix ${work}/installed)
extract(reference/README.md "Add your engine" cmake ${work}/CMakeLists.txt)
extract(reference/README.md "Add your engine" cpp ${work}/discs.cpp)
build_example(${work})

execute_process(COMMAND ${work}/build/mine run bounce --engine discs --out ${work}/out RESULT_VARIABLE code OUTPUT_QUIET)
expect("exit code of bounce" ${code} 0)
execute_process(COMMAND ${work}/build/mine run slope-disc --engine discs --out ${work}/out
  RESULT_VARIABLE code OUTPUT_VARIABLE said)
expect("exit code of slope-disc" ${code} 1)

# The output that the README shows.
extract(reference/README.md "Add your engine" text ${work}/shown.txt)
file(STRINGS ${work}/shown.txt shown)
foreach(line ${shown})
  string(FIND "${said}" "${line}" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "The README shows\n${line}\nbut the output is:\n${said}")
  endif()
endforeach()

execute_process(COMMAND ${work}/build/mine run bounce slope-disc slope --out ${work}/out OUTPUT_QUIET)
file(READ ${work}/out/report.json report)
string(JSON last LENGTH "${report}" runs)
math(EXPR last "${last} - 1")
set(rivals "")
foreach(i RANGE ${last})
  foreach(field scenario variant engine verdict reason)
    string(JSON ${field} GET "${report}" runs ${i} ${field})
  endforeach()
  if(NOT engine STREQUAL discs)
    list(APPEND rivals ${engine})
    continue()
  endif()
  if(scenario STREQUAL bounce)
    # Its method explains how far off it is: coarse where that is more than 1 %.
    if(NOT verdict MATCHES "^(right|coarse)$")
      message(FATAL_ERROR "${scenario} ${variant}: \"${verdict}\", should be right or coarse")
    endif()
  elseif(variant STREQUAL rolls)
    expect("${scenario} ${variant}" ${verdict} right)
  elseif(scenario STREQUAL slope)
    expect("${scenario} ${variant}" ${verdict} "not supported")
    expect("${scenario} ${variant}" ${reason} "supports only discs on half-spaces")
  else()
    expect("${scenario} ${variant}" ${verdict} wrong)
    string(JSON quantity GET "${report}" runs ${i} truth 3 quantity)
    string(JSON passed GET "${report}" runs ${i} truth 3 passed)
    expect("quantity" ${quantity} angularVelocity)
    expect("${quantity} passed" ${passed} OFF)
  endif()
endforeach()
foreach(rival impulse box2d)
  if(NOT rival IN_LIST rivals)
    message(FATAL_ERROR "${rival} does not run beside the example engine")
  endif()
endforeach()

# The same engine, misbehaving in each of its functions: only its own runs fail, and the report is written.
set(faulty ${BUILD}/faulty_example)
file(REMOVE_RECURSE ${faulty})
file(MAKE_DIRECTORY ${faulty})
file(RENAME ${work}/installed ${faulty}/installed)
file(COPY ${work}/CMakeLists.txt DESTINATION ${faulty})
file(READ ${work}/discs.cpp source)
string(FIND "${source}" "const Catalog<Engine>::Entry entry" entry)
string(SUBSTRING "${source}" 0 ${entry} source)
file(WRITE ${faulty}/discs.cpp "#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>

${source}
void misbehave(const std::string& how) {
  if (how == \"exits\") std::exit(0);
  if (how == \"crashes\") std::raise(SIGSEGV);
  if (how == \"throws\") throw 42;
  if (how == \"bad-utf8\") throw std::runtime_error(\"\\xff\\xfe\");
  if (how == \"hangs\") pause();
}

class Faulty final : public Discs {
 public:
  Faulty(const Scene& scene, std::string how) : Discs(scene), how_(std::move(how)) {}
  void step(double dt) override {
    misbehave(how_);
    Discs::step(dt);
  }
  void read(std::span<BodyState> out) const override {
    Discs::read(out);
    if (how_ == \"nan\") out[0].velocity.x = std::numeric_limits<double>::quiet_NaN();
  }

 private:
  std::string how_;
};

Engine faulty(const std::string& place, const std::string& how) {
  const auto at = [=](const char* here) { if (place == here) misbehave(how); };
  return {.name = place + '-' + how,
          .about = \"misbehaves\",
          .source = \"discs.cpp\",
          .stepping = [=](const Settings& settings, double dt) { at(\"stepping\"); return stepping(settings, dt); },
          .unsupported =
              [=](const Scene& scene, const Settings& settings) {
                at(\"unsupported\");
                return unsupported(scene, settings);
              },
          .build = [=](const Scene& scene, const Settings&) {
            at(\"build\");
            return std::make_unique<Faulty>(scene, place == \"step\" ? how : \"\");
          }};
}

const bool entered = [] {
  const auto enter = [](const char* place, const char* how) { Catalog<Engine>::Entry entry(faulty(place, how)); };
  for (const char* place : {\"stepping\", \"unsupported\", \"build\", \"step\"}) {
    for (const char* how : {\"exits\", \"crashes\", \"throws\", \"bad-utf8\"}) enter(place, how);
  }
  enter(\"step\", \"nan\");
  enter(\"stepping\", \"hangs\");
  return true;
}();
")
build_example(${faulty})
set(exits "ended with exit code 0 although it was not asked to")
set(crashes "ended by signal 11")
set(throws "ended by signal 6")
set(bad-utf8 "it says: ")
set(nan "number 3 is nan")
set(hangs "did not answer within 60 s")
set(engines step-nan stepping-hangs)
foreach(place stepping unsupported build step)
  foreach(how exits crashes throws bad-utf8)
    list(APPEND engines ${place}-${how})
  endforeach()
endforeach()
list(TRANSFORM engines PREPEND "--engine;" OUTPUT_VARIABLE words)
execute_process(COMMAND ${faulty}/build/mine run bounce:e=0.5 --engine impulse ${words} --out ${faulty}/out
  RESULT_VARIABLE code OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(NOT code EQUAL 1)
  message(FATAL_ERROR "exit code of engines that misbehave: ${code}\n${said}")
endif()
file(READ ${faulty}/out/report.json report)
string(JSON last LENGTH "${report}" runs)
math(EXPR last "${last} - 1")
set(failed "")
foreach(i RANGE ${last})
  foreach(field engine verdict reason exact)
    string(JSON ${field} GET "${report}" runs ${i} ${field})
  endforeach()
  if(exact)
    continue()
  endif()
  if(engine STREQUAL impulse)
    expect("impulse beside them" ${verdict} right)
    continue()
  endif()
  string(REGEX REPLACE "^[a-z]+-" "" how ${engine})
  expect("${engine}" ${verdict} failed)
  if(NOT reason MATCHES "${${how}}")
    message(FATAL_ERROR "${engine} failed with \"${reason}\", should be \"${${how}}\"")
  endif()
  list(APPEND failed ${engine})
endforeach()
list(LENGTH engines many)
list(LENGTH failed found)
expect("engines that failed" ${found} ${many})
