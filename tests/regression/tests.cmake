talus_test(regression cli_run PROGRAM LIBRARIES nlohmann_json::nlohmann_json)
talus_test(regression heap_event ROOMS app)
talus_test(regression cli_rheology LIBRARIES nlohmann_json::nlohmann_json ROOMS rheology)
add_dependencies(test_cli_rheology talus)
target_compile_definitions(test_cli_rheology PRIVATE TALUS_PROGRAM="$<TARGET_FILE:talus>")
talus_test(regression sweep_collect PROGRAM LIBRARIES nlohmann_json::nlohmann_json PkgConfig::NETCDF)
# These two call GNU parallel and shellcheck (TEST_PACKAGES of the Makefile), and Snakemake (SLOW_PACKAGES).
talus_test(regression sweep_engines PROGRAM LIBRARIES nlohmann_json::nlohmann_json)
talus_test(regression sweep_snakemake PROGRAM LIBRARIES nlohmann_json::nlohmann_json LABELS slow)
