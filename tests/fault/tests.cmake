talus_test(fault bad_scene PROGRAM LIBRARIES nlohmann_json::nlohmann_json)
talus_test(fault run_folder PROGRAM LIBRARIES nlohmann_json::nlohmann_json)
talus_test(fault kills PROGRAM LIBRARIES nlohmann_json::nlohmann_json PkgConfig::NETCDF)
talus_test(fault stops PROGRAM LIBRARIES nlohmann_json::nlohmann_json PkgConfig::NETCDF)
add_library(jumping_clock MODULE ${CMAKE_CURRENT_SOURCE_DIR}/fault/jumping_clock.c)
set_target_properties(jumping_clock PROPERTIES COMPILE_OPTIONS "" LINK_OPTIONS "")  # no sanitizer in what is preloaded
add_dependencies(test_stops jumping_clock)
target_compile_definitions(test_stops PRIVATE TALUS_JUMPING_CLOCK="$<TARGET_FILE:jumping_clock>")
talus_test(fault sweep PROGRAM ROOMS output LIBRARIES nlohmann_json::nlohmann_json)
