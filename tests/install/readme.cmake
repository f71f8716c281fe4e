cmake_minimum_required(VERSION 3.25)

# Shared by the tests of an installed tree, which get PROJECT (source tree), BUILD (build tree), COMPILER and FLAGS (those
# of the build tree).
function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# Writes the first block of a language after a heading of a README into a file.
function(extract readme heading language file)
  file(READ ${PROJECT}/${readme} block)
  foreach(mark "## ${heading}\n" "```${language}\n")
    string(FIND "${block}" "${mark}" start)
    if(start EQUAL -1)
      message(FATAL_ERROR "${readme} has no ${mark} where it should")
    endif()
    string(LENGTH "${mark}" length)
    math(EXPR start "${start} + ${length}")
    string(SUBSTRING "${block}" ${start} -1 block)
  endforeach()
  string(FIND "${block}" "```" end)
  string(SUBSTRING "${block}" 0 ${end} block)
  file(WRITE ${file} "${block}")
endfunction()

# Builds the README's project in `work` against what is installed there.
function(build_example work)
  run(${CMAKE_COMMAND} -S ${work} -B ${work}/build -G Ninja -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_FLAGS=${FLAGS}
      -DCMAKE_PREFIX_PATH=${work}/installed)
  run(${CMAKE_COMMAND} --build ${work}/build)
endfunction()
