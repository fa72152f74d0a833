# talus_benchmark(<file without .cpp> ROOMS <rooms>...): built and run by the target `bench` alone.
find_package(benchmark REQUIRED)
add_custom_target(bench)

function(talus_benchmark name)
  cmake_parse_arguments(ARG "" "" "ROOMS" ${ARGN})
  list(TRANSFORM ARG_ROOMS PREPEND talus_)
  add_executable(bench_${name} EXCLUDE_FROM_ALL ${CMAKE_CURRENT_SOURCE_DIR}/benchmark/${name}.cpp)
  target_link_libraries(bench_${name} PRIVATE ${ARG_ROOMS} benchmark::benchmark_main)
  add_custom_target(run_bench_${name} COMMAND bench_${name} --benchmark_min_time=0.2 DEPENDS bench_${name} VERBATIM USES_TERMINAL)
  add_dependencies(bench run_bench_${name})
endfunction()

talus_benchmark(dual ROOMS core rheology)
talus_benchmark(sparse_pattern ROOMS core)
