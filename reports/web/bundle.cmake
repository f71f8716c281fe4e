cmake_minimum_required(VERSION 3.25)

# Bundles the page in the build folder, so that the source tree stays clean. If its npm packages cannot be installed, the
# build continues with no_page.cpp. Run as cmake -DSOURCE=... -DWORK=... -DPAGE=... -DNODE=... -P bundle.cmake
# npm runs the first node in PATH, so that must be this one.
cmake_path(GET NODE PARENT_PATH node_folder)
set(ENV{PATH} "${node_folder}:$ENV{PATH}")

function(without_page reason)
  message(WARNING "Building Plumb without its page: ${reason}. To try again, delete ${PAGE} and build.")
  configure_file(${SOURCE}/no_page.cpp ${PAGE} COPYONLY)
  file(TOUCH ${PAGE})
endfunction()

file(REMOVE_RECURSE ${WORK}/src ${WORK}/pictures)
file(COPY ${SOURCE}/src ${SOURCE}/pictures ${SOURCE}/tsconfig.json ${SOURCE}/package.json ${SOURCE}/package-lock.json ${SOURCE}/.npmrc ${SOURCE}/build.mjs ${SOURCE}/../glossary.md
  DESTINATION ${WORK})

file(SHA256 ${WORK}/package-lock.json lock)
set(installed "")
if(EXISTS ${WORK}/installed)
  file(READ ${WORK}/installed installed)
endif()
if(NOT installed STREQUAL lock)
  execute_process(COMMAND ${node_folder}/npm ci --ignore-scripts --omit=dev --fetch-retries=1 WORKING_DIRECTORY ${WORK}
    RESULT_VARIABLE failed OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(failed)
    message(STATUS "${output}")
    without_page("npm ci failed")
    return()
  endif()
  file(WRITE ${WORK}/installed ${lock})
endif()

execute_process(COMMAND ${NODE} build.mjs ${WORK}/page.html ${PAGE} WORKING_DIRECTORY ${WORK} RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "cannot build the page")
endif()
