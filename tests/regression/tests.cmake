talus_test(regression cli_run LIBRARIES nlohmann_json::nlohmann_json)
add_dependencies(test_cli_run talus)
target_compile_definitions(test_cli_run PRIVATE TALUS_PROGRAM="$<TARGET_FILE:talus>")
talus_test(regression heap_event ROOMS app)
