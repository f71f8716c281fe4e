cmake_minimum_required(VERSION 3.25)

# What the tests of an installed tree share. They are given PROJECT (source tree), BUILD (built tree), COMPILER and FLAGS
# (those of the built tree).
function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# Writes the README's first block of a language after a heading into a file.
function(extract heading language file)
  file(READ ${PROJECT}/README.md block)
  foreach(mark "## ${heading}\n" "```${language}\n")
    string(FIND "${block}" "${mark}" start)
    if(start EQUAL -1)
      message(FATAL_ERROR "README.md has no ${mark} where it should")
    endif()
    string(LENGTH "${mark}" length)
    math(EXPR start "${start} + ${length}")
    string(SUBSTRING "${block}" ${start} -1 block)
  endforeach()
  string(FIND "${block}" "```" end)
  string(SUBSTRING "${block}" 0 ${end} block)
  file(WRITE ${file} "${block}")
endfunction()

# A project in `work` as the README has it, built against what is installed there.
function(build_example work)
  run(${CMAKE_COMMAND} -S ${work} -B ${work}/build -G Ninja -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_FLAGS=${FLAGS}
      -DCMAKE_PREFIX_PATH=${work}/installed)
  run(${CMAKE_COMMAND} --build ${work}/build)
endfunction()
