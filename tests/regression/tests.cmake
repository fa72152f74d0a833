talus_test(regression cli_run PROGRAM LIBRARIES nlohmann_json::nlohmann_json)
talus_test(regression heap_event ROOMS app)
talus_test(regression cli_rheology PROGRAM ROOMS rheology LIBRARIES nlohmann_json::nlohmann_json)
talus_test(regression sweep_collect PROGRAM LIBRARIES nlohmann_json::nlohmann_json PkgConfig::NETCDF)
# These two call GNU parallel and shellcheck (TEST_PACKAGES of the Makefile), and Snakemake (SLOW_PACKAGES).
talus_test(regression sweep_engines PROGRAM LIBRARIES nlohmann_json::nlohmann_json)
talus_test(regression sweep_snakemake PROGRAM LIBRARIES nlohmann_json::nlohmann_json LABELS slow)
talus_test(regression cli_steady PROGRAM ROOMS rheology LIBRARIES nlohmann_json::nlohmann_json PkgConfig::NETCDF)
talus_test(regression cli_hstop PROGRAM LIBRARIES nlohmann_json::nlohmann_json)
add_test(NAME paper COMMAND ${TALUS_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/regression/paper.py $<TARGET_FILE:talus>)
set_tests_properties(paper PROPERTIES LABELS regression-slow)
# Eight members of the sweep of 500.
add_test(NAME heap_slopes COMMAND ${TALUS_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/regression/heap_slopes.py $<TARGET_FILE:talus>)
set_tests_properties(heap_slopes PROPERTIES LABELS regression)
