# The package `plumb`, for programs that bring an engine of their own: plumb::scenarios, plumb::reference (with all
# adapters), plumb::reports, and plumb::main, which is all of them and the command line.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)
set(headers ${CMAKE_INSTALL_INCLUDEDIR}/plumb)  # a file includes "reference/simulation.h" there as it does here
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/plumb)

# Whole archives: entries join their catalogs from files that nothing else asks for.
function(add_part name)
  cmake_parse_arguments(PART "" "" "OBJECTS;USES" ${ARGN})
  set(objects "")
  foreach(library ${PART_OBJECTS})
    list(APPEND objects $<TARGET_OBJECTS:${library}>)
  endforeach()
  add_library(plumb_${name}_archive STATIC ${objects})
  add_library(plumb::${name}_archive ALIAS plumb_${name}_archive)
  set_target_properties(plumb_${name}_archive PROPERTIES EXPORT_NAME ${name}_archive LINKER_LANGUAGE CXX)
  add_library(plumb_${name}_part INTERFACE)
  add_library(plumb::${name} ALIAS plumb_${name}_part)
  set_target_properties(plumb_${name}_part PROPERTIES EXPORT_NAME ${name})
  target_include_directories(plumb_${name}_part INTERFACE $<INSTALL_INTERFACE:${headers}>)
  target_compile_features(plumb_${name}_part INTERFACE cxx_std_20)
  target_link_libraries(plumb_${name}_part INTERFACE $<LINK_LIBRARY:WHOLE_ARCHIVE,plumb::${name}_archive> ${PART_USES})
  install(TARGETS plumb_${name}_part plumb_${name}_archive EXPORT plumb ARCHIVE COMPONENT plumb)
endfunction()

get_property(adapters GLOBAL PROPERTY PLUMB_ADAPTERS)
get_property(engines GLOBAL PROPERTY PLUMB_ENGINES)
add_part(scenarios OBJECTS plumb_scenarios USES nlohmann_json::nlohmann_json)
add_part(reference OBJECTS plumb_reference ${adapters} USES plumb::scenarios fmt::fmt ${engines}
  $<LINK_LIBRARY:WHOLE_ARCHIVE,impulse::impulse_archive,impulse::impulse_double_archive,impulse::impulse_methods_archive,impulse::impulse_methods_double_archive> Threads::Threads)
add_part(reports OBJECTS plumb_reports plumb_page USES plumb::reference CLI11::CLI11 fmt::fmt OpenSSL::Crypto SQLite::SQLite3 ZLIB::ZLIB)
add_part(main OBJECTS plumb_main USES plumb::reports)

# What `cmake --install` needs, without the tests.
add_custom_target(installable DEPENDS plumb plumb_scenarios_archive plumb_reference_archive plumb_reports_archive plumb_main_archive
  impulse_archive impulse_double_archive impulse_methods_archive impulse_methods_double_archive)

foreach(folder scenarios reference reports)
  install(DIRECTORY ${folder} DESTINATION ${headers} COMPONENT plumb
    FILES_MATCHING PATTERN *.h PATTERN adapters EXCLUDE PATTERN web EXCLUDE)
endforeach()
install(TARGETS plumb RUNTIME COMPONENT plumb)
install(EXPORT plumb NAMESPACE plumb:: FILE plumbTargets.cmake DESTINATION ${package} COMPONENT plumb)
get_property(PLUMB_PACKAGES GLOBAL PROPERTY PLUMB_PACKAGES)
list(APPEND PLUMB_PACKAGES impulse/${PROJECT_VERSION} nlohmann_json CLI11 fmt OpenSSL SQLite3 ZLIB)
configure_package_config_file(reports/plumbConfig.cmake.in plumbConfig.cmake INSTALL_DESTINATION ${package}
  NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(plumbConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/plumbConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/plumbConfigVersion.cmake
  reference/adapters/FindChipmunk.cmake DESTINATION ${package} COMPONENT plumb)
