cmake_minimum_required(VERSION 3.25)

# Bundles the page inside the build folder, so that the source tree stays clean. Without its npm packages the build goes
# on: page.cpp is then the stub. Run as cmake -DSOURCE=... -DWORK=... -DPAGE=... -DNODE=... -P bundle.cmake
# npm starts the first node in PATH: this one.
cmake_path(GET NODE PARENT_PATH node_folder)
set(ENV{PATH} "${node_folder}:$ENV{PATH}")

function(without_page reason)
  message(WARNING "Plumb is built without its page: ${reason}. To try again, delete ${PAGE} and build.")
  configure_file(${SOURCE}/no_page.cpp ${PAGE} COPYONLY)
  file(TOUCH ${PAGE})
endfunction()

file(REMOVE_RECURSE ${WORK}/src ${WORK}/pictures)
file(COPY ${SOURCE}/src ${SOURCE}/pictures ${SOURCE}/package.json ${SOURCE}/package-lock.json ${SOURCE}/.npmrc ${SOURCE}/build.mjs
  DESTINATION ${WORK})

file(SHA256 ${WORK}/package-lock.json lock)
set(installed "")
if(EXISTS ${WORK}/installed)
  file(READ ${WORK}/installed installed)
endif()
if(NOT installed STREQUAL lock)
  execute_process(COMMAND ${node_folder}/npm ci --ignore-scripts --omit=dev --fetch-retries=1 WORKING_DIRECTORY ${WORK}
    RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(failed)
    message(STATUS "${said}")
    without_page("npm ci failed")
    return()
  endif()
  file(WRITE ${WORK}/installed ${lock})
endif()

execute_process(COMMAND ${NODE} build.mjs ${WORK}/page.html ${PAGE} WORKING_DIRECTORY ${WORK} RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "the page does not build")
endif()
